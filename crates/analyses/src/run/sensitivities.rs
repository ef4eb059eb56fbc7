//! By which power of each parameter the results of a peel change.

use crate::outcome::Refusal;
use peelkit::study::{Exponent, NoSensitivities, Peel, PeelQuantity, Terms, sensitivities};
use peelkit_scene::{Parameters, Scene};

/// What was found, by parameters with these keys.
pub struct Exponents {
    /// The exponents
    pub found: Vec<Exponent>,
    /// The keys of the parameters
    pub keys: Vec<String>,
    /// Keys by which nothing could be differentiated, with the reason
    pub refused: Vec<(String, String)>,
}

/// Refuses a scene of which there are none.
pub(super) fn refuse(scene: &Scene) -> Result<(), Refusal> {
    if let Some(why) = NoSensitivities::of(&scene.model) {
        let remedy = why.key().map_or_else(String::new, |key| format!("Omit --sensitivities, or `{key}`."));
        return Err(Refusal::asked(format!("there are no sensitivities: {why}"), remedy));
    }
    if scene.accuracy.terms == Terms::Auto {
        return Err(Refusal::asked(
            "sensitivities are those of a model with all of its terms, and the scene has terms = \"auto\"",
            "Omit --sensitivities, or give --set terms=all.",
        ));
    }
    Ok(())
}

impl Exponents {
    /// Of a peel of this scene.
    ///
    /// Fails where they cannot be computed.
    pub fn of(scene: &Scene, peel: &Peel) -> Result<Self, NoSensitivities> {
        let Parameters { variations, fixed } = scene.parameters();
        let found = sensitivities(peel, &PeelQuantity::OF_A_PEEL, &variations)?;
        let refused = found.refused.iter().map(|(k, why)| (variations[*k].key.clone(), why.to_string())).chain(fixed);
        Ok(Self {
            found: found.exponents(peel),
            refused: refused.collect(),
            keys: variations.into_iter().map(|variation| variation.key).collect(),
        })
    }
}
