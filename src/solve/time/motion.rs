//! Where a structure is and how it moves.

use crate::solve::state::State;

/// A state in motion, at one time.
#[derive(Clone, Debug)]
pub struct Motion {
    /// Since the drive began
    pub time: f64,
    /// Where it is, with the force of the grip
    pub at: State,
    /// v, a direction over time
    pub velocity: Vec<f64>,
    /// dv/dt, which satisfies the equation of motion
    pub acceleration: Vec<f64>,
    /// a of the rule, which lags behind that
    pub(super) pseudo: Vec<f64>,
    /// What the material remembers
    pub memory: Vec<f64>,
}

impl Motion {
    /// At rest in an equilibrium, or let go from any state with this velocity and acceleration. `memory`: what the material remembers.
    pub fn new(time: f64, at: State, velocity: Vec<f64>, acceleration: Vec<f64>, memory: Vec<f64>) -> Self {
        Self { time, at, velocity, pseudo: acceleration.clone(), acceleration, memory }
    }
}
