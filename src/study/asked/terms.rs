//! The terms of a model, and what was decided of each.

use serde::{Deserialize, Serialize};

/// A term of the model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Term {
    /// The r2 terms of the adhesion.
    FarFace,
    /// M_c
    ContactMoment,
    /// 1/GA_s
    Shear,
    /// 1/EA
    Extension,
    /// x at every node
    Horizontal,
    /// Heights and curvature of ground that is not flat.
    Ground,
    /// What resists sliding.
    Friction,
}

impl Term {
    /// As a user reads it.
    pub fn word(self) -> &'static str {
        match self {
            Self::FarFace => "far face",
            Self::ContactMoment => "contact moment",
            Self::Shear => "shear",
            Self::Extension => "extension",
            Self::Horizontal => "horizontal unknowns",
            Self::Ground => "shape of the ground",
            Self::Friction => "friction",
        }
    }

    /// The same with what it is, where the word alone does not say it.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::FarFace => "attraction of the upper surface (far face)",
            Self::ContactMoment => "moment of the adhesion about the axis (contact moment)",
            other => other.word(),
        }
    }
}

/// Which terms of the model are computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Terms {
    /// All of them.
    #[default]
    All,
    /// Automatic model reduction to the requested tolerance.
    Auto,
}

/// A term that was left out, and what it would change.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct LeftOut {
    /// Which one
    pub term: Term,
    /// By how much the force (nN) and the displacement (nm) of the initiation peak would change with it; of a path without one, zero
    pub force: f64,
    /// Of the displacement, nm
    pub displacement: f64,
    /// The largest relative change of anything that is reported
    pub largest: f64,
}

/// Why a term was not left out.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum KeptReason {
    /// Neglecting it would change a result by this, relative.
    Matters(f64),
    /// There is nothing less to compute without it.
    NothingSaved,
    /// Its effect cannot be estimated on a path without it; why.
    NotEstimated(NotEstimated),
}

/// Why the effect of a term cannot be estimated on a path without it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, thiserror::Error)]
#[serde(rename_all = "kebab-case")]
#[allow(missing_docs)] // the message of each names its numbers
pub enum NotEstimated {
    #[error("the path without it could not be followed")]
    Failed,
    #[error("with friction")]
    Friction,
    #[error("the ground or friction acts along them")]
    ActsAlong,
    #[error("the law of adhesion has no potential")]
    NoPotential,
    #[error("the grip rotates during the pull")]
    Turning,
    #[error("the path begins after other steps")]
    Steps,
    #[error("it alone holds the beam along the substrate")]
    HoldsAlone,
    #[error("the ground is deeper than a tenth of r0")]
    Deep,
    #[error("the grip constrains the beam in its initial equilibrium")]
    Held,
    #[error("the beam is not straight in its stress-free configuration")]
    Curved,
}

/// What was decided of each term of a model.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct TermDecisions {
    /// With what each would change
    pub left_out: Vec<LeftOut>,
    /// With the reason for each
    pub kept: Vec<(Term, KeptReason)>,
}
