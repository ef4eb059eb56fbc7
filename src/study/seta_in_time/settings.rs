//! How the root of a seta is pulled in time, and how accurately that is followed.

use crate::solve::time::drive::Ramp;
use crate::study::pull_in_time::result::InTimeFailureKind;

/// How the root of a seta that adheres moves: from rest along a direction, at a constant rate, until no tip adheres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SetaPullRate {
    /// Along x, y and z: y is the normal, away from the ground. Its length does not matter.
    pub direction: [f64; 3],
    /// How far at most, nm
    pub most: f64,
    /// nm/ns = m/s
    pub rate: f64,
    /// On how much of the way the root accelerates, nm. A jump in velocity makes a force of its own.
    pub accelerates: f64,
}

impl SetaPullRate {
    /// Along the normal, accelerating on 20 nm.
    pub const fn normal(most: f64, rate: f64) -> Self {
        Self { direction: [0.0, 1.0, 0.0], most, rate, accelerates: 20.0 }
    }

    /// Displacement in time.
    pub(super) fn ramp(&self) -> Ramp {
        Ramp::new(0.0, self.most, self.rate, 2.0 * self.accelerates / self.most)
    }
}

/// How accurately a seta is followed in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SetaTimeAccuracy {
    /// Error of a step in time, in units of 10 nm and 0.01 rad
    pub tolerance: f64,
    /// How near to the end of its branch a tip leaves that, nm
    pub located: f64,
    /// The longest step over the time of the whole way
    pub longest: f64,
    /// Most steps
    pub most_steps: usize,
}

impl Default for SetaTimeAccuracy {
    fn default() -> Self {
        Self { tolerance: 1e-5, located: 1e-3, longest: 0.002, most_steps: 200_000 }
    }
}

pub(super) fn check(pull: &SetaPullRate, accuracy: &SetaTimeAccuracy) -> Result<(), InTimeFailureKind> {
    let length = pull.direction.iter().map(|x| x * x).sum::<f64>();
    let positive = [
        ("the length of the direction of the pull", length),
        ("the end of the pull in nm", pull.most),
        ("the rate of the pull in nm/ns", pull.rate),
        ("the way on which the root accelerates in nm", pull.accelerates),
        ("the tolerance of a step in time", accuracy.tolerance),
        ("the distance in nm within which the end of a branch is found", accuracy.located),
        ("the longest step over the time of the whole way", accuracy.longest),
    ];
    match positive.into_iter().find(|(_, value)| !(*value > 0.0 && value.is_finite())) {
        Some((what, value)) => Err(InTimeFailureKind::OutOfRange { what, value, wanted: "positive" }),
        None => Ok(()),
    }
}
