//! Stations of a path: the equilibria at which a quantity has exactly a value that is asked for, on every part of the path that passes it.
//!
//! On a step of the path the quantity is a polynomial through the solutions that are known. Where that passes the value the step is solved at the
//! root, the solution joins those that are known, and so on until the quantity has the value to round-off. The same station on half as many
//! elements again says how wrong the other numbers are.

use crate::beam::planar::planar_beam::FRONT;
use crate::model::problem::beam_problem::{BeamProblem, SpatialGrip};
use crate::solve::error::SolveError;
use crate::solve::newton::{FINE, NewtonOptions, Solution, on_more_elements, solve};
use crate::solve::path::segment::PathSegment;
use crate::solve::points::locate::step_to;
use crate::solve::state::{Observables, PathConstraint};
use crate::solve::workspace::Workspace;
use crate::study::asked::accuracy::{Accuracy, aim};
use crate::study::asked::error_bounds::{COMPANION_FRACTION, DIFFERENCE_BOUND_FACTOR, ROUND_OFF, least};
use crate::study::peel::result::Peel;
use crate::study::peel::solution_history::SolutionHistory;
use crate::study::peel::step_dependence::StepCurve;
use crate::study::peel::work::work_at;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// A quantity that has a value at a station.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum StationQuantity {
    /// u of the grip, nm
    Displacement,
    /// P, nN
    Force,
    /// S of the peeling front, nm
    Front,
    /// θ of the end that is pulled, rad
    EndRotation,
}

impl StationQuantity {
    /// Every one with its name in a scene.
    pub const NAMED: [(&'static str, Self); 4] = [
        ("displacement", Self::Displacement),
        ("force", Self::Force),
        ("front", Self::Front),
        ("end_rotation", Self::EndRotation),
    ];

    /// Its name in a scene.
    pub fn name(self) -> &'static str {
        Self::NAMED.iter().find(|named| named.1 == self).map_or("", |named| named.0)
    }

    /// The number that the solver knows it by.
    fn pick(self) -> fn(&Observables) -> f64 {
        match self {
            Self::Displacement => |o| o.displacement,
            Self::Force => |o| o.force,
            Self::Front => |o| o.monitors[FRONT],
            Self::EndRotation => |o| o.recorded,
        }
    }

    /// Its value where the solver knows it by `number`.
    fn value(self, problem: &BeamProblem, number: f64) -> f64 {
        if self == Self::Front { problem.beam.front_place(number) } else { number }
    }

    fn at(self, problem: &BeamProblem, observed: &Observables) -> f64 {
        self.value(problem, self.pick()(observed))
    }

    /// How fast it changes where its number `number` changes by `rate`.
    fn rate(self, problem: &BeamProblem, number: f64, rate: f64) -> f64 {
        if self != Self::Front {
            return rate;
        }
        let step = BESIDE * problem.measure.monitors[FRONT];
        rate * (self.value(problem, number + step) - self.value(problem, number - step)) / (2.0 * step)
    }
}

/// A value of a quantity at which a path is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct StationAt {
    /// The quantity
    pub quantity: StationQuantity,
    /// Its value, in the unit of the quantity
    pub value: f64,
}

/// An equilibrium of the path at which a quantity has the value that was asked for.
///
/// The bounds hold as those of limit points do. They are none with friction, where a term of the model was left out, and where half as many
/// elements again have no such equilibrium, as next to a limit point of the quantity.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Station {
    /// u of the grip, nm
    pub displacement: f64,
    /// P, nN
    pub force: f64,
    /// θ of the end that is pulled, rad
    pub end_rotation: f64,
    /// S of the peeling front, nm
    pub front: f64,
    /// ∫ P du from where the path begins, aJ; of a grip that turns as it goes ∫ P du + M dθ
    pub work: f64,
    /// Negative eigenvalues of the tangent with the grip held at its displacement: 0 where the equilibrium is stable
    pub negative_eigenvalues: usize,
    /// The same with the force held
    pub negative_eigenvalues_load: usize,
    /// Bounds on the errors of these numbers
    pub errors: Option<StationErrors>,
    /// It lies between `points[after]` and `points[after + 1]` of the path
    pub after: usize,
    /// The grip of a strip in space; none in the plane
    pub in_space: Option<SpatialGrip>,
}

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
}

/// What a path has at a value that was asked for.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Stations {
    /// What was asked for
    pub at: StationAt,
    /// In path order; empty where the path does not pass the value
    pub found: Vec<Station>,
    /// The least and the largest value on the path
    pub range: [f64; 2],
    /// Where the path passes the value, and the equilibrium there could not be computed
    pub missed: Vec<MissedStation>,
}

/// A step of a path on which a station could not be computed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, thiserror::Error)]
#[error("between path points {after} and {} (u = {displacement_nm:.6} nm) the station was not located: {cause}", after + 1)]
pub struct MissedStation {
    /// It lies between `points[after]` and `points[after + 1]` of the path
    pub after: usize,
    /// u of the first of these, nm
    pub displacement_nm: f64,
    /// What the solver says
    pub cause: SolveError,
}

/// Pieces of a step in each of which the quantity may pass a value once.
const PIECES: usize = 16;
/// Most solutions until a station is located, and most corrections on more elements.
const MOST_SOLVES: usize = 12;
const MOST_CORRECTIONS: usize = 6;
/// Most times that the elements are made more, by half each time, until the bounds are as small as was asked for.
const MOST_REFINEMENTS: usize = 4;
/// Two stations nearer than this share of a step are one.
const ONE: f64 = 1e-9;
/// Step of a difference of the place of a front, over its scale.
const BESIDE: f64 = 1e-6;

impl Peel {
    /// The equilibria of the path at which a quantity has exactly a value: each is solved there, and its errors are bounded by half as many
    /// elements again, more until the bounds are as small as was asked of the path. Empty where its solutions were dropped.
    pub fn stations(&self, at: StationAt) -> Stations {
        let mut stations = Stations { at, found: Vec::new(), range: [f64::NAN; 2], missed: Vec::new() };
        let Some(trace) = self.trace.as_ref().filter(|trace| !trace.points.is_empty()) else { return stations };
        let search = Search::of(self, trace, at);
        stations.range = search.range;
        let mut ws = Workspace::default().at(self.effort.pace);
        for after in 0..trace.points.len() - 1 {
            match search.on_step(after, &mut ws) {
                Ok(found) => stations.found.extend(found.iter().map(|found| search.reported(after, found, &mut ws))),
                Err(cause) => stations.missed.push(MissedStation {
                    after,
                    displacement_nm: trace.points[after].observables.displacement,
                    cause,
                }),
            }
        }
        stations
    }
}

/// A value that is sought on a path.
struct Search<'p> {
    peel: &'p Peel,
    trace: &'p SolutionHistory,
    at: StationAt,
    range: [f64; 2],
    /// The quantity has the value where it is no farther from it
    tolerance: f64,
}

/// An equilibrium that was located, and the segment that it was located on.
struct Found {
    solution: Arc<Solution>,
    segment: PathSegment,
}

impl<'p> Search<'p> {
    fn of(peel: &'p Peel, trace: &'p SolutionHistory, at: StationAt) -> Self {
        let values = trace.points.iter().chain(&trace.limit_points);
        let values = values.map(|point| at.quantity.at(&trace.problem, &point.observables));
        let range = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| [low.min(v), high.max(v)]);
        let tolerance = round_off(at.quantity, at.value, range[0].abs().max(range[1].abs()));
        Self { peel, trace, at, range, tolerance }
    }

    /// By how much the quantity is above its value.
    fn above(&self, solution: &Solution) -> f64 {
        self.at.quantity.at(&self.trace.problem, &solution.observables) - self.at.value
    }

    /// The equilibria on the step behind a point.
    fn on_step(&self, after: usize, ws: &mut Workspace) -> Result<Vec<Found>, SolveError> {
        let points = &self.trace.points;
        let mut segment = PathSegment::around(&self.trace.problem, points, after);
        let mut known = vec![(0.0, self.above(&points[after])), (segment.end(), self.above(&points[after + 1]))];
        for (turn, solution) in self.peel.limit_points.iter().zip(&self.trace.limit_points) {
            if turn.after == after {
                known.push((segment.insert(solution.clone()), self.above(solution)));
            }
        }
        let ends = [(after == 0, after), (after + 2 == points.len(), after + 1)];
        let at_end = |&(is_end, index): &(bool, usize)| is_end && self.above(&points[index]) == 0.0;
        let mut found: Vec<Found> = Vec::new();
        for &(_, index) in ends.iter().filter(|end| at_end(end)) {
            found.push(Found { solution: points[index].clone(), segment: segment.clone() });
        }
        for bracket in self.brackets(&segment, known) {
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

    /// The pieces of a step in which the quantity passes its value, by what is `known` at labels and by polynomials between.
    fn brackets(&self, segment: &PathSegment, mut known: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
        let (problem, quantity) = (&self.trace.problem, self.at.quantity);
        known.extend((1..PIECES).map(|piece| {
            let label = segment.end() * piece as f64 / PIECES as f64;
            let number = segment.observable(quantity.pick(), label).at(label).0;
            (label, quantity.value(problem, number) - self.at.value)
        }));
        known.sort_by(|a, b| a.0.total_cmp(&b.0));
        let passes = |pair: &&[(f64, f64)]| (pair[0].1 >= 0.0) != (pair[1].1 >= 0.0);
        known.windows(2).filter(passes).map(|pair| (pair[0].0, pair[1].0)).collect()
    }

    /// The equilibrium in a piece of a step: at the root of the polynomial, which takes in one solution after the other.
    fn located(
        &self,
        segment: &mut PathSegment,
        (from, to): (f64, f64),
        ws: &mut Workspace,
    ) -> Result<Arc<Solution>, SolveError> {
        let (problem, quantity) = (&self.trace.problem, self.at.quantity);
        // a polynomial knows where the value is passed no better than it knows the curve
        let reach = [(2.0 * from - to).max(0.0), (2.0 * to - from).min(segment.end())];
        let (mut label, mut known) = (0.5 * (from + to), from);
        let mut off = f64::INFINITY;
        for iterations in 0..MOST_SOLVES {
            for _ in 0..MOST_SOLVES {
                let (number, rate, _) = segment.observable(quantity.pick(), label).at(label);
                let above = quantity.value(problem, number) - self.at.value;
                let ahead = -above / quantity.rate(problem, number, rate);
                let next = (label + ahead).clamp(reach[0], reach[1]);
                if !next.is_finite() || next == label {
                    break;
                }
                label = next;
            }
            let solution = step_to(problem, segment, known, label, FINE, ws)?;
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
        let (problem, quantity, weights) = (&self.trace.problem, self.at.quantity, segment.weights);
        let options = NewtonOptions { tolerance: FINE, largest_update: 0.5, most_iterations: 10, exact_slope: true };
        let mut solution = on_more_elements(problem, coarse, weights, ws)?;
        for _ in 0..MOST_CORRECTIONS {
            let above = self.above(&solution);
            if above.abs() <= self.tolerance {
                return Ok(solution);
            }
            let (number, rate) = (quantity.pick()(&solution.observables), quantity.pick()(&solution.slope));
            let ahead = -above * weights.dot(&solution.slope) / quantity.rate(problem, number, rate);
            if ahead.abs() > segment.end() || !ahead.is_finite() {
                return Err(SolveError::LimitPointNotConfirmed);
            }
            let constraint = PathConstraint { weights, target: weights.dot(&solution.observables) + ahead };
            solution = solve(problem, solution.at, &constraint, &options, ws)?;
        }
        Err(SolveError::NotConverged { update: self.above(&solution), iterations: MOST_CORRECTIONS })
    }

    /// What is reported of an equilibrium, on as many elements as bring its bounds down to what was asked for.
    fn reported(&self, after: usize, found: &Found, ws: &mut Workspace) -> Station {
        let problem = &self.trace.problem;
        let dropped = self.peel.considered.as_ref().is_some_and(|terms| terms.left_out.iter().any(|t| t.largest > 0.0));
        let bounded = !problem.system.has_history() && !dropped;
        let (mut solution, mut errors) = (found.solution.clone(), None);
        for _ in 0..if bounded { MOST_REFINEMENTS } else { 0 } {
            let Ok(finer) = self.refined(&solution, &found.segment, ws) else { break };
            let bounds = self.errors(&solution, &finer);
            if errors.is_some_and(|known: StationErrors| {
                known.force + known.displacement <= bounds.force + bounds.displacement
            }) {
                break;
            }
            errors = Some(bounds);
            if self.is_met(&solution, &bounds) {
                break;
            }
            solution = Arc::new(finer);
        }
        Station { errors, ..self.station(after, &solution, &found.segment, ws) }
    }

    /// Bounds on the errors of an equilibrium, by the same on more elements.
    fn errors(&self, solution: &Solution, finer: &Solution) -> StationErrors {
        let Self { peel, trace: SolutionHistory { problem, .. }, at, .. } = self;
        let (o, finer) = (&solution.observables, &finer.observables);
        let difference = |quantity: StationQuantity| (quantity.at(problem, finer) - quantity.at(problem, o)).abs();
        let relative = |quantity| match quantity == at.quantity {
            true => 0.0,
            false => (difference(quantity) / quantity.at(problem, o)).abs().min(1.0),
        };
        // of numbers that two meshes have alike by luck no other is
        let companion = relative(StationQuantity::Displacement).max(relative(StationQuantity::Force));
        let share = aim(&peel.model, &Accuracy::to(peel.asked)).1.unwrap_or(least(peel.asked));
        let bound = |quantity: StationQuantity| {
            let floor = if quantity == at.quantity { 0.0 } else { COMPANION_FRACTION * companion + share };
            let value = quantity.at(problem, o).abs();
            DIFFERENCE_BOUND_FACTOR * difference(quantity) + floor * value + self.round_off(quantity, value)
        };
        StationErrors {
            displacement: bound(StationQuantity::Displacement),
            force: bound(StationQuantity::Force),
            end_rotation: bound(StationQuantity::EndRotation),
            front: bound(StationQuantity::Front),
        }
    }

    /// Round-off of a number of an equilibrium.
    fn round_off(&self, quantity: StationQuantity, value: f64) -> f64 {
        let values = self.trace.points.iter().map(|point| quantity.at(&self.trace.problem, &point.observables).abs());
        round_off(quantity, value, values.fold(0.0, f64::max))
    }

    /// Whether force and displacement are as accurate as was asked.
    fn is_met(&self, solution: &Solution, errors: &StationErrors) -> bool {
        let (o, asked) = (&solution.observables, self.peel.asked);
        errors.force <= asked * o.force.abs() && errors.displacement <= asked * o.displacement.abs()
    }

    fn station(&self, after: usize, solution: &Arc<Solution>, segment: &PathSegment, ws: &mut Workspace) -> Station {
        let Self { peel, trace: SolutionHistory { problem, points, .. }, .. } = self;
        let o = &solution.observables;
        let work = if problem.system.is_conservative() {
            work_at(problem, &points[0], solution)
        } else {
            let label = segment.label(o);
            peel.points[after].work + StepCurve::until(problem, segment, label, solution, ws).work()
        };
        Station {
            displacement: o.displacement,
            force: o.force,
            end_rotation: o.recorded,
            front: StationQuantity::Front.at(problem, o),
            work,
            negative_eigenvalues: solution.negative,
            negative_eigenvalues_load: solution.negative_load,
            errors: None,
            after,
            in_space: problem.spatial_grip(&solution.at),
        }
    }
}

/// Round-off of a value of a quantity, the `largest` of which on the path is known.
fn round_off(quantity: StationQuantity, value: f64, largest: f64) -> f64 {
    match quantity {
        // counted from where it is zero
        StationQuantity::Displacement => ROUND_OFF * value.abs() + f64::EPSILON * largest,
        StationQuantity::Force | StationQuantity::Front | StationQuantity::EndRotation => ROUND_OFF * largest,
    }
}
