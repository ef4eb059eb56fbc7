//! Models for which the stability against leaving the plane is not that of these two fields.

use crate::model::peel::{Hold, PeelModel};

/// Why the stability out of the plane is not computed.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each says it
pub enum NotOutOfPlane {
    #[error("the scene is in space, where the stability of a point is that in every direction")]
    InSpace,
    #[error("grip.rotation is \"fixed\": the moment of such a grip depends on how it holds the end out of the plane")]
    Rotation,
    #[error("drive.steps has steps before the pull, in which the stability out of the plane is not computed")]
    Steps,
    #[error("the substrate is not flat: what it does to a section that leaves the plane is not computed")]
    Ground,
    #[error("there is friction, which has no potential: stability is not that of an energy")]
    Friction,
    #[error(
        "the load has no potential (adhesion.line_load = \"force-only\" or law = \"surface-traction\"): stability \
         is not that of an energy"
    )]
    NoPotential,
}

impl NotOutOfPlane {
    /// What forbids it for a model, if anything does.
    pub fn of(model: &PeelModel) -> Option<Self> {
        if model.space.is_some() && model.in_the_plane().is_none() {
            return Some(Self::InSpace);
        }
        let reasons = [
            (model.grip.rotation == Hold::Fixed, Self::Rotation),
            (!model.steps.is_empty(), Self::Steps),
            (!model.ground.substrate.is_flat(), Self::Ground),
            (model.friction_law().is_some(), Self::Friction),
            (!model.line_law().has_potential(), Self::NoPotential),
        ];
        reasons.into_iter().find(|(holds, _)| *holds).map(|(_, reason)| reason)
    }

    /// What to try: a sentence of its own.
    pub fn remedy(&self) -> String {
        let change = match self {
            Self::InSpace => "remove the keys of space",
            Self::Rotation => "remove grip.rotation",
            Self::Steps => "remove drive.steps",
            Self::Ground => "remove the table [substrate]",
            Self::Friction => "remove the table [friction]",
            Self::NoPotential => "use another line_load or law",
        };
        format!("Omit --out-of-plane, or {change}.")
    }
}
