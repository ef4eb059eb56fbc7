//! What a path is measured by: units of its observables.

use crate::solve::problem::Problem;
use crate::solve::state::{MONITORS, Observables};
use serde::{Deserialize, Serialize};

/// Changes of an observable below this share of its scale do not measure a path.
const NOTICED: f64 = 1e-3;
/// The least value that measures one by what is left of it, over its scale.
const LEAST: f64 = 1e-9;
/// Least changes of displacement and force that measure a path, over their values: where a long tape hangs by its edge both turn at once, and steps
/// that are measured by less than that of the displacement never see the front pass the fold.
const OF_VALUE: f64 = 1e-7;
/// Changes that are noticed on a cusp, over those that are elsewhere.
const ON_CUSP: f64 = 1e-2;

/// What changes of an observable are noticed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum Notice {
    /// Those that are no smaller than a share of its scale.
    #[default]
    Scale,
    /// The same of its value, where that is less than its scale: where next to nothing adheres any more, the front still changes by all that is
    /// left of it, and the displacement turns with it.
    Rest,
    /// The same of a hundredth of that: where a tape that its adhesive holds hangs by its edge, the displacement turns on a cusp over which the front
    /// changes by a ten thousandth of what is left of it.
    Cusp,
}

impl Notice {
    /// The least change that is noticed of an observable of this value and scale.
    fn least(self, value: f64, scale: f64) -> f64 {
        match self {
            Self::Scale => NOTICED * scale,
            Self::Rest => NOTICED * value.abs().clamp(LEAST * scale, scale),
            Self::Cusp => ON_CUSP * Self::Rest.least(value, scale),
        }
    }

    /// What is noticed where that does not suffice.
    pub(crate) fn finer(self) -> Option<Self> {
        match self {
            Self::Scale => Some(Self::Rest),
            Self::Rest => Some(Self::Cusp),
            Self::Cusp => None,
        }
    }
}

/// Units of the observables that measure the path, from how they change along a segment of it. What does not measure it has an
/// infinite unit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Metric {
    monitors: [f64; MONITORS],
    displacement: f64,
    force: f64,
    roll: f64,
}

impl Metric {
    /// The largest change of each from point to point, with the least ones those that are noticed at `newest`.
    pub(crate) fn of<'a>(
        problem: &Problem,
        notice: Notice,
        newest: &Observables,
        segment: impl Iterator<Item = &'a Observables>,
    ) -> Self {
        let measure = &problem.measure;
        let least = |value: f64, scale: f64| (NOTICED * scale).max(OF_VALUE * value.abs());
        let mut metric = Self {
            monitors: std::array::from_fn(|k| notice.least(newest.monitors[k], measure.monitors[k])),
            force: least(newest.force, measure.force_scale()),
            roll: NOTICED * measure.roll_scale(),
            displacement: least(newest.displacement, problem.grip.displacement_scale()),
        };
        let mut before: Option<&Observables> = None;
        for here in segment {
            if let Some(before) = before {
                let change = here.since(before);
                for (unit, change) in metric.monitors.iter_mut().zip(change.monitors) {
                    *unit = unit.max(change.abs());
                }
                metric.displacement = metric.displacement.max(change.displacement.abs());
                metric.force = metric.force.max(change.force.abs());
                metric.roll = metric.roll.max(change.roll.abs());
            }
            before = Some(here);
        }
        metric
    }

    /// Whether no monitor has changed by as much as is noticed.
    pub(crate) fn notices_displacement_alone(&self, problem: &Problem) -> bool {
        self.monitors.iter().zip(problem.measure.monitors).all(|(unit, scale)| *unit <= NOTICED * scale)
    }

    /// Weights of the path parameter that is the length along `direction`.
    pub(crate) fn weights(&self, direction: &Observables) -> Observables {
        let dual = Observables {
            monitors: std::array::from_fn(|k| direction.monitors[k] / self.monitors[k].powi(2)),
            displacement: direction.displacement / self.displacement.powi(2),
            force: direction.force / self.force.powi(2),
            recorded: 0.0,
            roll: direction.roll / self.roll.powi(2),
        };
        dual.times(1.0 / dual.dot(direction).sqrt())
    }

    /// A direction with the length one.
    pub(crate) fn unit(&self, direction: &Observables) -> Observables {
        direction.times(1.0 / self.weights(direction).dot(direction))
    }

    /// Cosine of the angle between two directions.
    pub(crate) fn cosine(&self, a: &Observables, b: &Observables) -> f64 {
        let length = self.weights(b).dot(b);
        self.weights(a).dot(b) / length
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Of a front of which a ten thousandth is left, changes of a thousandth of that are noticed; of one that is whole, those of its scale, either way.
    #[test]
    fn what_is_left_is_noticed_by_its_own_size() {
        assert_relative_eq!(Notice::Scale.least(1e-4, 1.0), 1e-3);
        assert_relative_eq!(Notice::Rest.least(-1e-4, 1.0), 1e-7);
        assert_relative_eq!(Notice::Rest.least(50.0, 1.0), Notice::Scale.least(50.0, 1.0));
        assert!(Notice::Rest.least(0.0, 2.0) > 0.0);
        assert_relative_eq!(Notice::Cusp.least(1e-4, 1.0), 1e-9);
    }
}
