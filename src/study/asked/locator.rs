//! Where on a path a quantity passes a value, and how wrong the other numbers are there.
//!
//! On a step of the path the quantity is a polynomial through the solutions that are known, or a number of the state that goes through these. Where
//! that passes the value the step is solved at the root, the solution joins those that are known, and so on until the quantity has the value to
//! round-off. The same equilibrium on half as many elements again says how wrong the other numbers are.

use crate::model::peel::PeelModel;
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::error::{Quantity, SolveError};
use crate::solve::newton::{FINE, NewtonOptions, Solution, on_more_elements, solve};
use crate::solve::path::segment::PathSegment;
use crate::solve::points::locate::step_to;
use crate::solve::state::PathConstraint;
use crate::solve::workspace::Workspace;
use crate::study::asked::error_bounds::{COMPANION_FRACTION, DIFFERENCE_BOUND_FACTOR, ROUND_OFF};
use crate::study::asked::events::{EventAt, EventQuantity, StationQuantity};
use crate::study::asked::measured::Measure;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Pieces of a step in each of which the quantity may pass a value once.
const PIECES: usize = 16;
/// Most solutions until a value is met, and most corrections on more elements.
const MOST_SOLVES: usize = 12;
const MOST_CORRECTIONS: usize = 6;
/// Most times that the elements are made more, by half each time, until the bounds are as small as was asked for.
const MOST_REFINEMENTS: usize = 4;
/// Two equilibria nearer than this share of a step are one.
const ONE: f64 = 1e-9;
/// Round-off of a number of the fields, over the largest on the path: they are read off from nodal values by differences.
const OF_FIELDS: f64 = 1e-9;

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

/// An equilibrium that was located, and the segment that it was located on.
pub(in crate::study) struct Found {
    pub solution: Arc<Solution>,
    pub segment: PathSegment,
}

/// A value that is sought on a path.
pub(in crate::study) struct Locator<'p> {
    model: &'p PeelModel,
    problem: &'p BeamProblem,
    points: &'p [Arc<Solution>],
    /// Solutions next to limit points, each with the point before it
    turns: Vec<(usize, Arc<Solution>)>,
    at: &'p EventAt,
    measure: Measure<'p>,
    /// The least and the largest value on the path
    pub range: [f64; 2],
    /// The quantity has the value where it is no farther from it
    tolerance: f64,
}

impl<'p> Locator<'p> {
    /// Of an event on the points of a path, with the solutions next to its limit points.
    pub fn new(
        model: &'p PeelModel,
        problem: &'p BeamProblem,
        points: &'p [Arc<Solution>],
        turns: Vec<(usize, Arc<Solution>)>,
        at: &'p EventAt,
    ) -> Self {
        let measure = Measure::new(model, problem, at.quantity.clone());
        let values = points.iter().chain(turns.iter().map(|turn| &turn.1)).map(|point| measure.at(point));
        let range = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| [low.min(v), high.max(v)]);
        let tolerance = round_off(&at.quantity, at.value, range[0].abs().max(range[1].abs()));
        Self { model, problem, points, turns, at, measure, range, tolerance }
    }

    /// By how much the quantity is above its value.
    fn above(&self, solution: &Solution) -> f64 {
        self.measure.at(solution) - self.at.value
    }

    /// The equilibria on the step behind a point.
    pub fn on_step(&self, after: usize, ws: &mut Workspace) -> Result<Vec<Found>, SolveError> {
        let points = self.points;
        let mut segment = PathSegment::around(self.problem, points, after);
        let mut known = vec![(0.0, self.above(&points[after])), (segment.end(), self.above(&points[after + 1]))];
        for (_, solution) in self.turns.iter().filter(|turn| turn.0 == after) {
            known.push((segment.insert(solution.clone()), self.above(solution)));
        }
        let mut found: Vec<Found> = Vec::new();
        // the path begins there, or is stopped there
        let begins = after == 0 && known[0].1 == 0.0;
        let ends = after + 2 == points.len() && known[1].1.abs() <= self.tolerance;
        for (_, index) in [(begins, after), (ends, after + 1)].into_iter().filter(|end| end.0) {
            found.push(Found { solution: points[index].clone(), segment: segment.clone() });
        }
        for bracket in self.brackets(&segment, known)? {
            let solution = self.located(&mut segment, bracket, ws)?;
            let label = segment.label(&solution.observables);
            let is_new =
                |other: &Found| (segment.label(&other.solution.observables) - label).abs() > ONE * segment.end();
            if found.iter().all(is_new) {
                found.push(Found { solution, segment: segment.clone() });
            }
        }
        found.sort_by(|a, b| {
            let label = |found: &Found| segment.label(&found.solution.observables);
            label(a).total_cmp(&label(b))
        });
        Ok(found)
    }

    /// How far along the step behind a point the quantity first passes its value, by what is known there; none where it does not. Where the quantity is
    /// no number it passes at once.
    pub fn first_passing(&self, after: usize) -> Option<f64> {
        let segment = PathSegment::around(self.problem, self.points, after);
        let known = vec![(0.0, self.above(&self.points[after])), (segment.end(), self.above(&self.points[after + 1]))];
        match self.brackets(&segment, known) {
            Ok(brackets) => brackets.first().map(|bracket| bracket.0 / segment.end()),
            Err(_) => Some(0.0),
        }
    }

    /// The pieces of a step in which the quantity passes its value in the way that counts, by what is `known` at labels and by polynomials between.
    fn brackets(&self, segment: &PathSegment, mut known: Vec<(f64, f64)>) -> Result<Vec<(f64, f64)>, SolveError> {
        known.extend((1..PIECES).map(|piece| {
            let label = segment.end() * piece as f64 / PIECES as f64;
            (label, self.measure.value_between(segment, label) - self.at.value)
        }));
        if known.iter().any(|known| !known.1.is_finite()) {
            return Err(SolveError::NotFiniteUpdate { quantity: Quantity::EventQuantity });
        }
        known.sort_by(|a, b| a.0.total_cmp(&b.0));
        let passes = |pair: &&[(f64, f64)]| {
            (pair[0].1 >= 0.0) != (pair[1].1 >= 0.0) && self.at.passing.counts(pair[0].1, pair[1].1)
        };
        Ok(known.windows(2).filter(passes).map(|pair| (pair[0].0, pair[1].0)).collect())
    }

    /// The equilibrium in a piece of a step: at the root of the polynomial, which takes in one solution after the other.
    fn located(
        &self,
        segment: &mut PathSegment,
        (from, to): (f64, f64),
        ws: &mut Workspace,
    ) -> Result<Arc<Solution>, SolveError> {
        // a polynomial knows where the value is passed no better than it knows the curve
        let reach = [(2.0 * from - to).max(0.0), (2.0 * to - from).min(segment.end())];
        let (mut label, mut known) = (0.5 * (from + to), from);
        let mut off = f64::INFINITY;
        for iterations in 0..MOST_SOLVES {
            for _ in 0..MOST_SOLVES {
                let (value, rate) = self.measure.between(segment, label);
                let next = (label - (value - self.at.value) / rate).clamp(reach[0], reach[1]);
                if !next.is_finite() || next == label {
                    break;
                }
                label = next;
            }
            let solution = step_to(self.problem, segment, known, label, FINE, ws)?;
            let above = self.above(&solution);
            // what no further solution brings down is round-off
            let settled = above.abs() <= self.tolerance || iterations > 2 && above.abs() >= 0.5 * off;
            if settled && above.abs() <= MOST_SOLVES as f64 * self.tolerance {
                return Ok(solution);
            }
            (known, off) = (label, above.abs());
        }
        Err(SolveError::NotConverged { update: off, iterations: MOST_SOLVES })
    }

    /// The same equilibrium on half as many elements again.
    fn refined(&self, coarse: &Solution, segment: &PathSegment, ws: &mut Workspace) -> Result<Solution, SolveError> {
        let (problem, weights) = (self.problem, segment.weights);
        let options = NewtonOptions { tolerance: FINE, largest_update: 0.5, most_iterations: 10, exact_slope: true };
        let mut solution = on_more_elements(problem, coarse, weights, ws)?;
        for _ in 0..MOST_CORRECTIONS {
            let above = self.above(&solution);
            if above.abs() <= self.tolerance {
                return Ok(solution);
            }
            let ahead = -above / self.measure.rate(&solution, segment);
            if ahead.abs() > segment.end() || !ahead.is_finite() {
                return Err(SolveError::LimitPointNotConfirmed);
            }
            let constraint = PathConstraint { weights, target: weights.dot(&solution.observables) + ahead };
            solution = solve(problem, solution.at, &constraint, &options, ws)?;
        }
        Err(SolveError::NotConverged { update: self.above(&solution), iterations: MOST_CORRECTIONS })
    }

    /// An equilibrium that was located, on as many elements as bring its bounds down to what was asked for, and these.
    pub fn bounded(
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
        let measure = |quantity: StationQuantity| Measure::named(self.model, self.problem, quantity);
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
            let rounded = round_off(&EventQuantity::Named(quantity), value, largest);
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
fn round_off(quantity: &EventQuantity, value: f64, largest: f64) -> f64 {
    match quantity.named() {
        // counted from where it is zero
        Some(StationQuantity::Displacement) => ROUND_OFF * value.abs() + f64::EPSILON * largest,
        Some(_) => ROUND_OFF * largest,
        None => OF_FIELDS * largest,
    }
}
