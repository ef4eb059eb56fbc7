//! What is known of the stability of a planar path against leaving its plane.

use crate::model::peel::{Hold, PeelModel};
use crate::solve::error::SolveError;

/// The stability of the points of a planar path against leaving the plane.
#[derive(Clone, Debug, PartialEq)]
pub struct OutOfPlane {
    /// Negative eigenvalues out of the plane at each point of the path, in the order of [`crate::study::Peel::points`].
    /// They are the same whether displacement or force is held.
    pub negative_eigenvalues: Vec<usize>,
    /// Where the path loses its stability first; nothing where all of it is stable
    pub first_loss: Option<OutOfPlaneLoss>,
}

/// The first loss of stability out of the plane: behind it a beam that is free to does not stay in its plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfPlaneLoss {
    /// u, nm
    pub displacement: f64,
    /// P, nN
    pub force: f64,
    /// Bound on the error of the displacement, nm
    pub displacement_error: f64,
    /// Bound on the error of the force, nN
    pub force_error: f64,
    /// It lies between `points[after]` and `points[after + 1]` of the path; nothing where the path is unstable from its
    /// beginning on, the place given.
    pub after: Option<usize>,
}

impl OutOfPlane {
    /// The most negative eigenvalues of a point of the path; a loss between two of them counts as one.
    pub fn most(&self) -> usize {
        self.negative_eigenvalues.iter().copied().chain(self.first_loss.map(|_| 1)).max().unwrap_or(0)
    }

    /// How many points of the path are unstable.
    pub fn unstable_points(&self) -> usize {
        self.negative_eigenvalues.iter().filter(|&&negative| negative > 0).count()
    }
}

/// Why the stability out of the plane is not known.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum OutOfPlaneError {
    /// The model is not one that it is computed for.
    #[error("{0}")]
    Refused(#[from] NotOutOfPlane),
    /// The peel has no solutions behind its points.
    #[error("the path has no solutions to look at")]
    NoSolutions,
    /// Something overflowed.
    #[error("the stability out of the plane is not finite at u = {displacement:.6} nm")]
    NotFinite { displacement: f64 },
    /// It was lost somewhere, but where was not found.
    #[error("the loss of stability out of the plane between u = {from:.6} nm and {to:.6} nm was not located: {cause}")]
    NotLocated { from: f64, to: f64, cause: SolveError },
    /// The planar path is stable nowhere where the branch comes back.
    #[error(
        "the branch out of the plane comes back into it at u = {displacement:.6} nm, P = {force:.6} nN, and the planar path \
         regains its stability nowhere"
    )]
    NotRegained { displacement: f64, force: f64 },
    /// The body has no one width.
    #[error("the widths at which the planar path is stable are those of a strip, and this body is none")]
    NoStrip,
}

// -- Models for which the stability against leaving the plane is not that of these two fields --

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
        "adhesion.shear_strength holds the strip along the substrate, and what it does out of the plane is not computed"
    )]
    Shear,
    #[error("adhesion.healing is false, and what such an adhesion does out of the plane is not computed")]
    Healing,
    #[error("strip.yield_strength is given, and what a film that yields does out of the plane is not computed")]
    Yielding,
    #[error("strip.stretch is not linear, and what such a strip does out of the plane is not computed")]
    Stretch,
    #[error(
        "strip.layers make the section one of several materials, and what it does out of the plane is not computed"
    )]
    Layers,
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
            (model.adhesion.shear_strength.is_some(), Self::Shear),
            (!model.adhesion.healing, Self::Healing),
            (model.yields(), Self::Yielding),
            (!model.material().stretch.is_linear(), Self::Stretch),
            (model.has_layers(), Self::Layers),
            (!model.has_potential(), Self::NoPotential),
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
            Self::Shear => "remove adhesion.shear_strength",
            Self::Healing => "remove adhesion.healing",
            Self::Yielding => "remove strip.yield_strength",
            Self::Stretch => "remove strip.stretch",
            Self::Layers => "remove strip.layers",
            Self::NoPotential => "use another line_load or law",
        };
        format!("Omit --out-of-plane, or {change}.")
    }
}
