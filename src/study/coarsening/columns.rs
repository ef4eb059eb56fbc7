//! The columns of a table that have been computed, and their nodes: each once, many side by side.

use super::held_spatula::{HeldSpatula, HeldState, with_own_mesh};
use super::options::{HeldError, TipPlace};
use super::sheet::SheetNode;
use crate::beam::planar::planar_beam::FRONT;
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::error::SolveError;
use crate::solve::newton::{NewtonOptions, Solution};
use crate::solve::points::locate::Located;
use crate::solve::points::search::LimitPointKind;
use crate::solve::points::tracer::{PathEvent, PathTracer, TraceOptions};
use crate::solve::state::{Observables, PathConstraint};
use crate::solve::workspace::Workspace;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Arc;

/// v and θ, by their bits.
type Key = (u64, u64);

/// The columns of one branch.
pub(super) struct Columns {
    start: BranchStart,
    known: BTreeMap<Key, KnownColumn>,
}

struct KnownColumn {
    column: Column,
    nodes: BTreeMap<u64, SheetNode>,
}

/// Zero has two signs and one key.
fn bits(value: f64) -> u64 {
    (value + 0.0).to_bits()
}

impl Columns {
    /// None yet.
    pub(crate) fn new(start: BranchStart) -> Self {
        Self { start, known: BTreeMap::new() }
    }

    /// Where its branch begins.
    pub(crate) fn start(&self) -> &BranchStart {
        &self.start
    }

    /// The same without the columns.
    pub(crate) fn into_start(self) -> BranchStart {
        self.start
    }

    /// How many have been followed.
    pub(crate) fn len(&self) -> usize {
        self.known.len()
    }

    /// How many equilibria were solved at nodes and between.
    pub(crate) fn nodes(&self) -> usize {
        self.known.values().map(|column| column.nodes.len()).sum()
    }

    /// The largest error of a limit point by the mesh, nm.
    pub(crate) fn mesh_error(&self) -> f64 {
        self.known.values().map(|known| known.column.limit_error).fold(0.0, f64::max)
    }

    /// Computes the nodes `path` of the columns at these v and θ, as far as they are not known.
    pub(crate) fn compute(&mut self, places: &[(f64, f64)], path: &[f64]) -> Result<(), HeldError> {
        let work: Vec<(Key, (f64, f64), Option<KnownColumn>)> = places
            .iter()
            .map(|&(v, t)| ((bits(v), bits(t)), (v, t)))
            .collect::<BTreeMap<_, _>>()
            .into_iter()
            .filter_map(|(key, place)| match self.known.get(&key) {
                Some(known) if path.iter().all(|&s| known.nodes.contains_key(&bits(s))) => None,
                _ => Some((key, place, self.known.remove(&key))),
            })
            .collect();
        let start = &self.start;
        let done: Vec<Result<(Key, KnownColumn), HeldError>> = work
            .into_par_iter()
            .map(|(key, (v, t), known)| {
                let mut known = match known {
                    Some(known) => known,
                    None => KnownColumn { column: start.column(v, t)?, nodes: BTreeMap::new() },
                };
                let mut ws = start.spatula().workspace();
                for &s in path {
                    if !known.nodes.contains_key(&bits(s)) {
                        let node = known.column.node(start.spatula(), s, &mut ws)?;
                        known.nodes.insert(bits(s), node);
                    }
                }
                Ok((key, known))
            })
            .collect();
        let mut first = None;
        for found in done {
            match found {
                Ok((key, known)) => drop(self.known.insert(key, known)),
                Err(why) => first = first.or(Some(why)),
            }
        }
        first.map_or(Ok(()), Err)
    }

    /// A node that has been computed.
    pub(crate) fn node(&self, (v, t): (f64, f64), s: f64) -> Option<&SheetNode> {
        self.known.get(&(bits(v), bits(t)))?.nodes.get(&bits(s))
    }
}

// -- The equilibria of one branch at one v and θ: from where the table begins to the limit point in which the branch ends --
//
// What goes along them is a mixture of the displacement u and of the length a of the pad that adheres,
//
// s = μ (u - u0)/(u1 - u0) + (1 - μ) (a - a0)/(a1 - a0),  μ = 0.15,
//
// 0 at the beginning, 1 at the limit point: where a hardly changes u does. It is a path constraint, in which the limit point is regular. What
// happens where the front passes a place of the pad lies at nearly the same s for all v and θ.

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
    pub(crate) fn traced(spatula: &HeldSpatula, start: &HeldState, down: bool) -> Result<Self, HeldError> {
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
    pub(crate) fn limit(&self) -> f64 {
        self.points[self.points.len() - 1].observables.displacement
    }

    /// The state at a displacement before the limit point, from the nearest point of the path.
    pub(crate) fn state(&self, spatula: &HeldSpatula, normal: f64, ws: &mut Workspace) -> Result<HeldState, HeldError> {
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
    pub(crate) fn node(&self, spatula: &HeldSpatula, s: f64, ws: &mut Workspace) -> Result<SheetNode, HeldError> {
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
    pub(crate) fn solution(&self, s: f64, ws: &mut Workspace) -> Result<Solution, SolveError> {
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

// -- The two branches of a spatula of which there is a table, and where their equilibria begin --

/// A branch of the law of a tip.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum TipSheet {
    /// The pad adheres, from where the tip is pressed to where it snaps off.
    Attached,
    /// It does not, from where the attraction begins to count to where it snaps on.
    Detached,
}

/// Equilibria of a branch, begun where the table begins.
pub(super) enum BranchStart {
    /// From the state at rest, so far below the height without a normal force, nm.
    Attached { spatula: HeldSpatula, rest: HeldState, press: f64 },
    /// From a state far away, down from where the substrate attracts the spatula with this force, nN.
    Detached { spatula: HeldSpatula, far: HeldState, force: f64 },
}

impl BranchStart {
    /// The spatula that is held.
    pub(crate) fn spatula(&self) -> &HeldSpatula {
        match self {
            Self::Attached { spatula, .. } | Self::Detached { spatula, .. } => spatula,
        }
    }

    /// The normal force with which it begins, nN.
    pub(crate) fn force(&self) -> f64 {
        match self {
            Self::Attached { rest, .. } => rest.solution.at.force,
            Self::Detached { force, .. } => *force,
        }
    }

    /// The normal force at the limit point of a branch from far away, at θ, nN.
    pub(crate) fn force_at_limit(spatula: &HeldSpatula, far: &HeldState, rotation: f64) -> Result<f64, HeldError> {
        let place = TipPlace { rotation, ..far.place };
        let lifted = spatula.moved(far, place, &mut spatula.workspace())?;
        let (_, located) = followed(spatula, &spatula.problem_at(place), &lifted, true)?;
        Ok(located.observables.force)
    }

    /// The branch at v and θ.
    pub(crate) fn column(&self, lateral: f64, rotation: f64) -> Result<Column, HeldError> {
        let mut ws = self.spatula().workspace();
        match self {
            Self::Attached { spatula, rest, press } => {
                let to = TipPlace { lateral, rotation, ..rest.place };
                let unloaded = spatula.under_force(rest, 0.0, to, &mut ws)?;
                let normal = unloaded.place.normal - press;
                let pressed = spatula.moved(&unloaded, TipPlace { normal, ..unloaded.place }, &mut ws)?;
                Column::traced(spatula, &pressed, false)
            }
            Self::Detached { spatula, far, force } => {
                let lifted = spatula.moved(far, TipPlace { lateral, rotation, ..far.place }, &mut ws)?;
                let problem = spatula.problem_at(lifted.place);
                let (points, _) = followed(spatula, &problem, &lifted, true)?;
                let away = |force_here: f64| (force_here.max(f64::MIN_POSITIVE) / force).ln().abs();
                let nearest = points.iter().min_by(|a, b| away(a.at.force).total_cmp(&away(b.at.force)));
                let Some(nearest) = nearest else { return Err(HeldError::Level { at: lifted.place }) };
                let place = TipPlace { normal: nearest.observables.displacement, ..lifted.place };
                let near = HeldState { place, solution: nearest.as_ref().clone() };
                let start = spatula.under_force(&near, *force, place, &mut ws)?;
                Column::traced(spatula, &start, true)
            }
        }
    }
}
