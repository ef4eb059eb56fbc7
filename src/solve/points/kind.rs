//! Which quantity turns at a limit point.

use crate::solve::newton::Solution;
use crate::solve::observables::Observables;
use std::fmt;

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

    /// Negative eigenvalues of a solution with this quantity held.
    pub fn negative(self, solution: &Solution) -> usize {
        match self {
            Self::Displacement => solution.negative,
            Self::Load => solution.negative_load,
        }
    }
}

impl fmt::Display for LimitPointKind {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            Self::Displacement => "displacement",
            Self::Load => "force",
        })
    }
}
