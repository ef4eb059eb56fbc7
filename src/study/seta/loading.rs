//! What is done to the root of a seta, as plain data.

use crate::model::seta::check::SetaError;
use crate::solve::newton::NewtonOptions;
use serde::{Deserialize, Serialize};

/// How a seta is loaded: from a start, one step after the other. The root never turns, and moves along each step's direction alone.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetaLoading {
    /// How the seta stands before the first step
    pub start: SetaStart,
    /// In their order
    pub steps: Vec<SetaStep>,
}

/// How the seta stands before the first step.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SetaStart {
    /// With its root where it is when the plane of the tips is the ground; every tip adheres below where it is stress-free.
    Adhering,
    /// Stress-free, higher than that by so much, nm; no tip adheres.
    Above(f64),
}

/// A motion of the root.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetaStep {
    /// Along x, y and z: y is the normal, away from the ground. Its length does not matter.
    pub direction: [f64; 3],
    /// How far
    pub until: StepEnd,
}

/// Where a step ends.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum StepEnd {
    /// After so far, nm
    Travel(f64),
    /// When the root is pushed back along the direction with this force, nN.
    Preload(f64),
    /// When no tip adheres, or after so far, nm.
    Detached(f64),
}

impl SetaLoading {
    /// That it can be done.
    ///
    /// # Errors
    /// No step, a direction that is none, or an amount that is not positive.
    pub fn check(&self) -> Result<(), SetaError> {
        if let SetaStart::Above(height) = self.start
            && !(height >= 0.0 && height.is_finite())
        {
            return Err(SetaError::Above { height });
        }
        if self.steps.is_empty() {
            return Err(SetaError::NoSteps);
        }
        for (step, own) in self.steps.iter().enumerate() {
            let length = own.direction.iter().map(|x| x * x).sum::<f64>();
            let (StepEnd::Travel(amount) | StepEnd::Preload(amount) | StepEnd::Detached(amount)) = own.until;
            if !(length > 0.0 && length.is_finite() && amount > 0.0 && amount.is_finite()) {
                return Err(SetaError::Step { step, direction: own.direction, amount });
            }
        }
        Ok(())
    }

    /// How high the seta starts above where the plane of its tips is the ground, nm.
    pub(super) fn above(&self) -> f64 {
        if let SetaStart::Above(height) = self.start { height } else { 0.0 }
    }

    /// How deep the root of a seta with a brush so high can be pressed, nm.
    pub(super) fn deepest(&self, brush_height: f64) -> f64 {
        self.above() + brush_height
    }

    /// Of a seta that adheres at the start: pulled along a direction until no tip adheres, at most `most` nm.
    pub fn pull(direction: [f64; 3], most: f64) -> Self {
        Self { start: SetaStart::Adhering, steps: vec![SetaStep { direction, until: StepEnd::Detached(most) }] }
    }

    /// As in the experiments: pressed from `above` (nm) on with a preload (nN), dragged along x by so far (nm; negative the other way), and
    /// pulled off along the normal, at most `most` nm.
    pub fn pressed_and_dragged(above: f64, preload: f64, drag: f64, most: f64) -> Self {
        let step = |direction, until| SetaStep { direction, until };
        let mut steps = vec![step([0.0, -1.0, 0.0], StepEnd::Preload(preload))];
        if drag != 0.0 {
            steps.push(step([drag.signum(), 0.0, 0.0], StepEnd::Travel(drag.abs())));
        }
        steps.push(step([0.0, 1.0, 0.0], StepEnd::Detached(most)));
        Self { start: SetaStart::Above(above), steps }
    }
}

// -- How a seta is followed --

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
