//! What a path is measured by: units of its observables.

use crate::solve::{MONITORS, Observables, Problem};

/// Changes of an observable below this share of its scale do not measure a path.
const NOTICED: f64 = 1e-3;

/// Units of the observables that measure the path, from how they change along a segment of it. What does not measure it has an
/// infinite unit.
#[derive(Clone, Copy, Debug)]
pub struct Metric {
    monitors: [f64; MONITORS],
    displacement: f64,
    force: f64,
    roll: f64,
}

impl Metric {
    /// The largest change of each from point to point.
    pub fn of<'a>(problem: &Problem, segment: impl Iterator<Item = &'a Observables>) -> Self {
        let measure = &problem.measure;
        let mut metric = Self {
            monitors: measure.monitors.map(|scale| NOTICED * scale),
            force: NOTICED * measure.force_scale(),
            roll: NOTICED * measure.roll_scale(),
            displacement: NOTICED * problem.grip.displacement_scale(),
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

    /// Weights of the path parameter that is the length along `direction`.
    pub fn weights(&self, direction: &Observables) -> Observables {
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
    pub fn unit(&self, direction: &Observables) -> Observables {
        direction.times(1.0 / self.weights(direction).dot(direction))
    }

    /// Cosine of the angle between two directions.
    pub fn cosine(&self, a: &Observables, b: &Observables) -> f64 {
        let length = self.weights(b).dot(b);
        self.weights(a).dot(b) / length
    }
}
