//! Where on the path of a beam a quantity passes a value, and how wrong the other numbers are there: the same equilibrium on half as many elements
//! again says it.

use crate::model::peel::PeelModel;
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::error::SolveError;
use crate::solve::newton::{FINE, NewtonOptions, Solution, on_more_elements, solve};
use crate::solve::path::segment::PathSegment;
use crate::solve::points::passing::SoughtValue;
use crate::solve::state::PathConstraint;
use crate::solve::workspace::Workspace;
use crate::study::asked::error_bounds::{COMPANION_FRACTION, DIFFERENCE_BOUND_FACTOR, ROUND_OFF};
use crate::study::asked::events::{EventAt, EventQuantity, StationQuantity};
use crate::study::asked::measured::{named, number};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Most corrections on more elements.
const MOST_CORRECTIONS: usize = 6;
/// Most times that the elements are made more, by half each time, until the bounds are as small as was asked for.
const MOST_REFINEMENTS: usize = 4;

/// Bounds on the errors of the numbers of a station: that of the quantity asked for is round-off.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct StationErrors {
    /// nm
    pub displacement: f64,
    /// nN
    pub force: f64,
    /// rad
    pub end_rotation: f64,
    /// nm
    pub front: f64,
    /// nm
    pub free_end_gap: f64,
}

/// What is known of the errors of a path.
pub(in crate::study) struct Bounds {
    /// Relative accuracy asked for
    pub asked: f64,
    /// Share of a number that is added to its bound
    pub share: f64,
    /// Whether more elements say how wrong a number is
    pub are_known: bool,
}

/// A value that is sought on the path of a beam.
pub(in crate::study) struct Locator<'p> {
    model: &'p PeelModel,
    problem: &'p BeamProblem,
    points: &'p [Arc<Solution>],
    at: &'p EventAt,
    pub sought: SoughtValue<'p>,
}

impl<'p> Locator<'p> {
    /// Of an event on the points of a path, with the solutions next to its limit points.
    pub(crate) fn new(
        model: &'p PeelModel,
        problem: &'p BeamProblem,
        points: &'p [Arc<Solution>],
        turns: Vec<(usize, Arc<Solution>)>,
        at: &'p EventAt,
    ) -> Self {
        let number = number(model, problem, &at.quantity);
        let sought = SoughtValue::new(number, at.value, at.passing, points).with_turns(turns);
        let sought = match at.quantity.named() {
            Some(quantity) => {
                let tolerance = round_off(quantity, at.value, sought.largest());
                sought.to(tolerance)
            }
            None => sought,
        };
        Self { model, problem, points, at, sought }
    }

    /// The same equilibrium on half as many elements again.
    fn refined(&self, coarse: &Solution, segment: &PathSegment, ws: &mut Workspace) -> Result<Solution, SolveError> {
        let (problem, weights) = (self.problem, segment.weights);
        let options = NewtonOptions { tolerance: FINE, largest_update: 0.5, most_iterations: 10, exact_slope: true };
        let mut solution = on_more_elements(problem, coarse, weights, ws)?;
        for _ in 0..MOST_CORRECTIONS {
            if self.sought.is_met(&solution) {
                return Ok(solution);
            }
            let ahead = -self.sought.above(&solution) / self.sought.number.rate(&solution, segment);
            if ahead.abs() > segment.end() || !ahead.is_finite() {
                return Err(SolveError::LimitPointNotConfirmed);
            }
            let constraint = PathConstraint { weights, target: weights.dot(&solution.observables) + ahead };
            solution = solve(problem, solution.at, &constraint, &options, ws)?;
        }
        Err(SolveError::NotConverged { update: self.sought.above(&solution), iterations: MOST_CORRECTIONS })
    }

    /// An equilibrium that was located, on as many elements as bring its bounds down to what was asked for, and these.
    pub(crate) fn bounded(
        &self,
        found: &Arc<Solution>,
        segment: &PathSegment,
        bounds: &Bounds,
        ws: &mut Workspace,
    ) -> (Arc<Solution>, Option<StationErrors>) {
        let (mut solution, mut errors) = (found.clone(), None);
        for _ in 0..if bounds.are_known { MOST_REFINEMENTS } else { 0 } {
            let Ok(finer) = self.refined(&solution, segment, ws) else { break };
            let own = self.errors(&solution, &finer, bounds.share);
            if errors
                .is_some_and(|known: StationErrors| known.force + known.displacement <= own.force + own.displacement)
            {
                break;
            }
            errors = Some(own);
            let o = &solution.observables;
            if own.force <= bounds.asked * o.force.abs() && own.displacement <= bounds.asked * o.displacement.abs() {
                break;
            }
            solution = Arc::new(finer);
        }
        (solution, errors)
    }

    /// Bounds on the errors of an equilibrium, by the same on more elements.
    fn errors(&self, solution: &Solution, finer: &Solution, share: f64) -> StationErrors {
        let is_asked = |quantity| self.at.quantity == EventQuantity::Named(quantity);
        let measure = |quantity: StationQuantity| named(self.model, self.problem, quantity);
        let at = |quantity: StationQuantity, solution: &Solution| measure(quantity).at(solution);
        let difference = |quantity| (at(quantity, finer) - at(quantity, solution)).abs();
        let relative = |quantity| match is_asked(quantity) {
            true => 0.0,
            false => (difference(quantity) / at(quantity, solution)).abs().min(1.0),
        };
        // of numbers that two meshes have alike by luck no other is
        let companion = relative(StationQuantity::Displacement).max(relative(StationQuantity::Force));
        let bound = |quantity: StationQuantity| {
            let floor = if is_asked(quantity) { 0.0 } else { COMPANION_FRACTION * companion + share };
            let value = at(quantity, solution).abs();
            let own = measure(quantity);
            let largest = self.points.iter().map(|point| own.at(point).abs()).fold(0.0, f64::max);
            let rounded = round_off(quantity, value, largest);
            DIFFERENCE_BOUND_FACTOR * difference(quantity) + floor * value + rounded
        };
        StationErrors {
            displacement: bound(StationQuantity::Displacement),
            force: bound(StationQuantity::Force),
            end_rotation: bound(StationQuantity::EndRotation),
            front: bound(StationQuantity::Front),
            free_end_gap: bound(StationQuantity::FreeEndGap),
        }
    }
}

/// Round-off of a value of a quantity, the `largest` of which on the path is known.
fn round_off(quantity: StationQuantity, value: f64, largest: f64) -> f64 {
    match quantity {
        // counted from where it is zero
        StationQuantity::Displacement => ROUND_OFF * value.abs() + f64::EPSILON * largest,
        _ => ROUND_OFF * largest,
    }
}
