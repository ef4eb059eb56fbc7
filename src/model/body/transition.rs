//! The transition of a quantity from one value to another along a piece of a beam: linear or quintic.

use serde::{Deserialize, Serialize};

/// The course that a quantity takes, with t from 0 to 1 along a piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Transition {
    /// t
    Linear,
    /// s5(t) = t³(10 - 15 t + 6 t²), which is level and without curvature at both ends, and outside
    Smooth,
}

impl Transition {
    /// How much of the way has been gone at t, and its first two derivatives.
    pub fn at(self, t: f64) -> [f64; 3] {
        let rest = 1.0 - t;
        match self {
            Self::Linear => [t, 1.0, 0.0],
            Self::Smooth if t <= 0.0 => [0.0; 3],
            Self::Smooth if t >= 1.0 => [1.0, 0.0, 0.0],
            Self::Smooth => {
                [t * t * t * (10.0 - 15.0 * t + 6.0 * t * t), 30.0 * t * t * rest * rest, 60.0 * t * rest * (rest - t)]
            }
        }
    }
}
