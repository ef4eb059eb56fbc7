//! The terms of a model, and what was decided of each.

/// A term of the model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Terms {
    /// All of them.
    #[default]
    All,
    /// Automatic model reduction to the requested tolerance.
    Auto,
}

/// A term that was left out, and what it would change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeftOut {
    pub term: Term,
    /// By how much the force (nN) and the displacement (nm) of the initiation peak would change with it; of a path without one, zero
    pub force: f64,
    pub displacement: f64,
    /// The largest relative change of anything that is reported
    pub largest: f64,
}

/// Why a term was not left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum KeptReason {
    /// Neglecting it would change a result by this, relative.
    Matters(f64),
    /// There is nothing less to compute without it.
    NothingSaved,
    /// Its effect cannot be estimated on a path without it; why.
    NotTold(&'static str),
}

/// What was decided of each term of a model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TermDecisions {
    pub left_out: Vec<LeftOut>,
    pub kept: Vec<(Term, KeptReason)>,
}
