//! How a seta is followed.

use crate::solve::newton::NewtonOptions;
use serde::{Deserialize, Serialize};

/// How a seta is followed. Points and events follow from this, the model and the loading alone.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetaOptions {
    /// Work and change of energy of a step may differ by this share; a step is shortened until they do not. A step on to another branch shows here.
    pub balance: f64,
    /// Error wanted of a solution, in units of 10 nm and 0.01 rad
    pub tolerance: f64,
    /// First step of the root, nm
    pub first_step: f64,
    /// Longest step of the root, nm
    pub longest_step: f64,
}

impl Default for SetaOptions {
    /// Work and energy to 1e-8.
    fn default() -> Self {
        Self { balance: 1e-8, tolerance: 1e-8, first_step: 5.0, longest_step: 500.0 }
    }
}

impl SetaOptions {
    /// Newton's method from an equilibrium nearby.
    pub(super) fn newton(&self) -> NewtonOptions {
        NewtonOptions { tolerance: self.tolerance, largest_update: 3.0, most_iterations: 10, exact_slope: false }
    }
}
