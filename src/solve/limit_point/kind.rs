//! Which quantity turns at a limit point.

use crate::solve::Observables;

/// Which quantity has a limit point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum LimitPointKind {
    /// du = 0
    Displacement,
    /// dP = 0
    Load,
}

impl LimitPointKind {
    /// The other quantity.
    pub fn other(self) -> Self {
        match self {
            Self::Displacement => Self::Load,
            Self::Load => Self::Displacement,
        }
    }

    /// The quantity.
    pub fn pick(self) -> fn(&Observables) -> f64 {
        match self {
            Self::Displacement => |o| o.displacement,
            Self::Load => |o| o.force,
        }
    }
}
