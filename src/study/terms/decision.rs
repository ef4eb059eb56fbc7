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
}

/// Which terms of the model are computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Terms {
    /// All of them.
    #[default]
    All,
    /// Those that matter at the accuracy asked for.
    Auto,
}

/// A term that was left out, and what it would change.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct LeftOut {
    pub term: Term,
    /// By how much the force (nN) and the displacement (nm) of the initiation peak would change with it; of a path without one, zero
    pub force: f64,
    pub displacement: f64,
    /// The largest relative change of anything that is reported
    pub largest: f64,
}

/// Why a term was not left out.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum KeptReason {
    /// It would change what is reported by this share.
    Matters(f64),
    /// There is nothing less to compute without it.
    NothingSaved,
    /// What it changes cannot be told from a path without it; why.
    NotTold(NotTold),
}

/// Why it cannot be told from a path without a term what that changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, thiserror::Error)]
#[serde(rename_all = "kebab-case")]
pub enum NotTold {
    #[error("the path without it could not be followed")]
    Failed,
    #[error("with friction")]
    Friction,
    #[error("the ground or friction acts along them")]
    ActsAlong,
    #[error("the law of adhesion has no potential")]
    NoPotential,
    #[error("the grip turns as it goes")]
    Turning,
    #[error("the path begins behind other steps")]
    Steps,
    #[error("it alone holds the beam along the substrate")]
    HoldsAlone,
    #[error("the ground is deeper than a tenth of r0")]
    Deep,
    #[error("the grip holds the beam as it has come to lie")]
    Held,
    #[error("the beam is not straight when it is free of stress")]
    Curved,
}

/// What was decided of each term of a model.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct TermDecisions {
    pub left_out: Vec<LeftOut>,
    pub kept: Vec<(Term, KeptReason)>,
}
