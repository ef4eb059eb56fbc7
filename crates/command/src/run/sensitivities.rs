//! `peel run --sensitivities`: by which power of each parameter the results change.

use super::RunProgress;
use crate::stop::Stop;
use crate::text_summary;
use peelkit::study::{Exponent, NoSensitivities, Peel, PeelQuantity, Terms, sensitivities};
use peelkit_scene::{Parameters, Scene};

/// What was found, by parameters with these keys.
pub struct Exponents {
    pub found: Vec<Exponent>,
    pub keys: Vec<String>,
    /// Keys by which nothing could be differentiated, with the reason
    refused: Vec<(String, String)>,
}

/// Refuses a scene of which there are none.
pub fn refuse(scene: &Scene) -> Result<(), Stop> {
    if scene.model.friction_law().is_some() {
        let why = NoSensitivities::Friction;
        return Err(Stop::bad_input(
            format!("there are no sensitivities: {why}"),
            "Omit --sensitivities, or [friction].",
        ));
    }
    if scene.accuracy.terms == Terms::Auto {
        return Err(Stop::bad_input(
            "sensitivities are those of a model with all of its terms, and the scene has terms = \"auto\"",
            "Omit --sensitivities, or give --set terms=all.",
        ));
    }
    Ok(())
}

impl Exponents {
    /// Of a peel of this scene.
    pub fn of(scene: &Scene, peel: &Peel, progress: &RunProgress) -> Result<Self, NoSensitivities> {
        progress.stage("sensitivities");
        let Parameters { variations, fixed } = scene.parameters();
        let found = sensitivities(peel, &PeelQuantity::ALL, &variations)?;
        let refused = found.refused.iter().map(|(k, why)| (variations[*k].key.clone(), why.to_string())).chain(fixed);
        Ok(Self {
            found: found.exponents(peel),
            refused: refused.collect(),
            keys: variations.into_iter().map(|variation| variation.key).collect(),
        })
    }

    /// As a person reads it.
    pub fn text(&self) -> String {
        text_summary::sensitivities(&self.found, &self.keys, &self.refused)
    }
}
