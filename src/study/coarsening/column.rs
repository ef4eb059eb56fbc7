//! The equilibria of one branch at one v and θ: from where the table begins to the limit point in which the branch ends.
//!
//! What goes along them is a mixture of the displacement u and of the length a of the pad that adheres,
//!
//!   s = μ (u - u0)/(u1 - u0) + (1 - μ) (a - a0)/(a1 - a0),  μ = 0.15,
//!
//! 0 at the beginning, 1 at the limit point: where a hardly changes u does. It is a path constraint, in which the limit point is regular. What
//! happens where the front passes a place of the pad lies at nearly the same s for all v and θ.

use super::error::HeldError;
use super::held_spatula::{HeldSpatula, HeldState, with_own_mesh};
use super::place::TipPlace;
use super::sheet_table::SheetNode;
use crate::beam::planar::planar_beam::FRONT;
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::error::SolveError;
use crate::solve::newton::{NewtonOptions, Solution};
use crate::solve::observables::{Observables, PathConstraint};
use crate::solve::points::kind::LimitPointKind;
use crate::solve::points::locate::Located;
use crate::solve::points::tracer::{PathEvent, PathTracer, TraceOptions};
use crate::solve::workspace::Workspace;
use std::sync::Arc;

/// μ
const BY_DISPLACEMENT: f64 = 0.15;
/// Most points of a path to its limit point.
const MOST_POINTS: usize = 2000;
/// Error of a node, relative as in [`crate::solve::System::size`].
const FINE: f64 = 1e-11;
/// Shortest step from a point of the path to a node, over all of the path.
const SHORTEST: f64 = 1e-7;

/// A traced branch at one v and θ.
pub(super) struct Column {
    /// Where it begins
    pub start: TipPlace,
    /// Error of its limit point by more elements, nm
    pub limit_error: f64,
    problem: BeamProblem,
    points: Vec<Arc<Solution>>,
    /// Of s; its target is s + `origin`.
    weights: Observables,
    origin: f64,
}

impl Column {
    /// Follows the equilibria from `start`, upwards or, where `down`, downwards, to the first limit point of the displacement.
    pub fn traced(spatula: &HeldSpatula, start: &HeldState, down: bool) -> Result<Self, HeldError> {
        let problem = spatula.problem_at(start.place);
        let (points, located) = followed(spatula, &problem, start, down)?;
        let (first, limit) = (&points[0].observables, &located.observables);
        let change = limit.since(first);
        let mut weights = Observables { displacement: BY_DISPLACEMENT / change.displacement, ..Observables::default() };
        weights.monitors[FRONT] = (1.0 - BY_DISPLACEMENT) / change.monitors[FRONT];
        if !weights.is_finite() {
            return Err(HeldError::Level { at: start.place });
        }
        let limit_error = located.difference.displacement.abs();
        let grows = |pair: &[Arc<Solution>]| weights.dot(&pair[1].observables) > weights.dot(&pair[0].observables);
        if let Some(pair) = points.windows(2).find(|pair| !grows(pair)) {
            let normal = pair[0].observables.displacement;
            return Err(HeldError::Folded { at: TipPlace { normal, ..start.place } });
        }
        let origin = weights.dot(first);
        Ok(Self { start: start.place, limit_error, problem, points, weights, origin })
    }

    /// u at the limit point, nm.
    pub fn limit(&self) -> f64 {
        self.points[self.points.len() - 1].observables.displacement
    }

    /// The state at a displacement before the limit point, from the nearest point of the path.
    pub fn state(&self, spatula: &HeldSpatula, normal: f64, ws: &mut Workspace) -> Result<HeldState, HeldError> {
        let away = |point: &Solution| (point.observables.displacement - normal).abs();
        let stable = self.points.iter().filter(|point| point.negative == 0);
        let nearest = stable.min_by(|a, b| away(a).total_cmp(&away(b))).unwrap_or(&self.points[0]);
        let place = TipPlace { normal: nearest.observables.displacement, ..self.start };
        let near = HeldState { place, solution: Solution::clone(nearest) };
        spatula.moved(&near, TipPlace { normal, ..self.start }, ws)
    }

    fn path(&self, solution: &Solution) -> f64 {
        self.weights.dot(&solution.observables) - self.origin
    }

    /// The equilibrium at s, with its response.
    pub fn node(&self, spatula: &HeldSpatula, s: f64, ws: &mut Workspace) -> Result<SheetNode, HeldError> {
        let failed = |cause| HeldError::NoNode { at: self.start, share: s, cause };
        let solution = self.solution(s, ws);
        spatula.check_stop()?;
        let solution = solution.map_err(failed)?;
        let response = spatula.response(&solution.at, ws).map_err(failed)?;
        Ok(SheetNode {
            normal: solution.observables.displacement,
            slope: if s == 1.0 { 0.0 } else { solution.slope.displacement },
            energy: response.energy,
            force: response.force,
            adhering: solution.observables.monitors[FRONT],
        })
    }

    /// The equilibrium at s.
    pub fn solution(&self, s: f64, ws: &mut Workspace) -> Result<Solution, SolveError> {
        let nearest = self.points.iter().min_by(|a, b| {
            let away = |point: &Solution| (self.path(point) - s).abs();
            away(a).total_cmp(&away(b))
        });
        let mut here = nearest.map(|point| Solution::clone(point)).ok_or(SolveError::SingularGrip)?;
        let mut at = self.path(&here);
        let mut step = f64::INFINITY;
        let options = NewtonOptions { tolerance: FINE, largest_update: 0.5, most_iterations: 12, exact_slope: true };
        loop {
            let left = s - at;
            let next = if left.abs() <= step { s } else { at + step.copysign(left) };
            let constraint = PathConstraint { weights: self.weights, target: self.origin + next };
            let rate = self.weights.dot(&here.slope);
            let start = here.moved(&self.problem, (next - at) / rate);
            match with_own_mesh(&self.problem, start, &constraint, &options, ws) {
                Ok(solution) if next == s => return Ok(solution),
                Ok(solution) => (here, at) = (solution, next),
                Err(cause) if cause == SolveError::Stopped || (next - at).abs() < SHORTEST => return Err(cause),
                Err(_) => step = 0.4 * (next - at).abs(),
            }
        }
    }
}

/// The points up to the limit point, and that.
pub(super) fn followed(
    spatula: &HeldSpatula,
    problem: &BeamProblem,
    start: &HeldState,
    down: bool,
) -> Result<(Vec<Arc<Solution>>, Located), HeldError> {
    let mut options = spatula.options;
    options.first_displacement = options.first_displacement.copysign(if down { -1.0 } else { 1.0 });
    let path = spatula.path(problem, options, start.solution.at.clone());
    let kinds = &[LimitPointKind::Displacement];
    let mut tracer = PathTracer::new(problem, path, TraceOptions { kinds, branches: true, ..TraceOptions::default() });
    let mut points = Vec::new();
    let from = start.place;
    loop {
        let next = tracer.advance();
        spatula.check_stop()?;
        match next.map_err(|cause| HeldError::Path { from, cause })? {
            PathEvent::Point(point) if points.len() < MOST_POINTS => points.push(point),
            PathEvent::Point(point) => {
                return Err(HeldError::NoLimit { from, points: MOST_POINTS, last: point.observables.displacement });
            }
            PathEvent::LimitPoint { located, .. } => {
                points.push(located.solution.clone());
                return Ok((points, located));
            }
            PathEvent::BranchPoint { located, .. } => {
                return Err(HeldError::Unstable { from, last: located.observables.displacement });
            }
            PathEvent::InertiaChange { .. } => {
                let last = points.last().map_or(from.normal, |point| point.observables.displacement);
                return Err(HeldError::Unstable { from, last });
            }
        }
    }
}
