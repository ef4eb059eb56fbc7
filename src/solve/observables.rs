//! The numbers that tell where on a path an equilibrium lies, and linear conditions on them.

use serde::{Deserialize, Serialize};

/// How many numbers of its own a system may measure a path by.
pub const MONITORS: usize = 2;

/// The numbers that tell where on the path an equilibrium lies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Observables {
    /// Numbers of the system, as [`super::System::evaluate`] gives them.
    pub monitors: [f64; MONITORS],
    /// u of the drive, nm (rad where that is a rotation); of the far end of its spring where it has one
    pub displacement: f64,
    /// P that does work on u, nN (nN·nm where that is a rotation)
    pub force: f64,
    /// A further number of the system, for the record; no constraint weighs it.
    pub recorded: f64,
    /// The roll of the driven end, rad, where it measures the path: see [`super::MeasuredBeside::Roll`]
    pub roll: f64,
}

impl Observables {
    const NOTHING: Self = Self { monitors: [0.0; MONITORS], displacement: 0.0, force: 0.0, recorded: 0.0, roll: 0.0 };
    /// Weights of displacement control.
    pub const DISPLACEMENT: Self = Self { displacement: 1.0, ..Self::NOTHING };
    /// Weights of a held force.
    pub const FORCE: Self = Self { force: 1.0, ..Self::NOTHING };

    /// Weights of a held monitor.
    pub const fn monitor(index: usize) -> Self {
        let mut monitors = [0.0; MONITORS];
        monitors[index] = 1.0;
        Self { monitors, ..Self::NOTHING }
    }

    /// Sum of the products of what a constraint can weigh.
    pub fn dot(&self, other: &Self) -> f64 {
        self.monitors[0] * other.monitors[0]
            + self.displacement * other.displacement
            + self.monitors[1] * other.monitors[1]
            + self.force * other.force
            + self.roll * other.roll
    }

    /// Whether every component is a finite number.
    pub fn is_finite(&self) -> bool {
        let Self { monitors: [first, second], displacement, force, recorded, roll } = *self;
        [first, second, displacement, force, recorded, roll].iter().all(|number| number.is_finite())
    }

    /// Each component times a number.
    pub fn times(&self, factor: f64) -> Self {
        Self {
            monitors: self.monitors.map(|monitor| factor * monitor),
            displacement: factor * self.displacement,
            force: factor * self.force,
            recorded: factor * self.recorded,
            roll: factor * self.roll,
        }
    }

    /// The sum with another.
    pub fn plus(&self, other: &Self) -> Self {
        self.since(&other.times(-1.0))
    }

    /// The difference to an earlier point.
    pub fn since(&self, earlier: &Self) -> Self {
        Self {
            monitors: std::array::from_fn(|k| self.monitors[k] - earlier.monitors[k]),
            displacement: self.displacement - earlier.displacement,
            force: self.force - earlier.force,
            recorded: self.recorded - earlier.recorded,
            roll: self.roll - earlier.roll,
        }
    }
}

/// weights · observables = target: displacement control, force control, or a step along the path.
#[derive(Clone, Copy, Debug)]
pub struct PathConstraint {
    /// One for each observable
    pub weights: Observables,
    /// In the unit of weights times observables
    pub target: f64,
}
