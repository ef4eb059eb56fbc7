//! The two ways of a test, and what work and energy balance on them.

use serde::{Deserialize, Serialize};

/// Which way the machine moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum LoadingDirection {
    /// Away from the substrate.
    Retreat,
    /// Towards it.
    Approach,
}

impl LoadingDirection {
    /// In words.
    pub fn word(self) -> &'static str {
        match self {
            Self::Retreat => "retreat",
            Self::Approach => "approach",
        }
    }
}

/// Work of the machine against change of energy and energy released, aJ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Balance {
    /// ∫ P dU over the stable pieces
    pub work: f64,
    /// Energy at the end minus energy at the start
    pub energy_change: f64,
    /// Sum over the jumps
    pub released: f64,
    /// The largest of these and of the works of the two ways, without its sign
    pub largest: f64,
}

impl Balance {
    /// What is not accounted for, over the largest term.
    pub fn error(&self) -> f64 {
        (self.work - self.energy_change - self.released).abs() / self.largest.max(f64::MIN_POSITIVE)
    }
}
