//! Errors of the equilibria of a solid: each is solved again on a finer mesh.
//!
//! The mesh of a solid stays along its path. The finer one has one order more of Q(p,q), half the size of other elements. The difference counts once for
//! a higher order, and twice for half the size, which is enough from an order of convergence of one on. Where the finer mesh has no limit point beside
//! one, that is of the mesh: an element comes off by itself. The difference is then that to the equilibrium on the finer mesh whose front is at the same
//! place.

use crate::solid::body::{FinerBody, SolidBody};
use crate::solve::newton::{NewtonOptions, Solution, settle, solve};
use crate::solve::points::locate::Located;
use crate::solve::points::search::{BendRule, LimitPointKind, LimitPointSearch};
use crate::solve::problem::Problem;
use crate::solve::state::{Observables, PathConstraint, State};
use crate::solve::workspace::{Pace, Workspace};
use std::sync::Arc;

/// Bounds on the errors of an equilibrium, by a finer mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolidErrors {
    /// Of u, nm
    pub displacement: f64,
    /// Of P, nN
    pub force: f64,
    /// Whether the finer mesh has this limit point as well; else it is one of the mesh
    pub confirmed: bool,
}

/// Error of a solution, relative as in [`crate::solve::System::size`].
const TOLERANCE: f64 = 1e-9;

fn newton() -> NewtonOptions {
    NewtonOptions { tolerance: TOLERANCE, largest_update: MOST_UPDATE, most_iterations: 20, exact_slope: true }
}

/// A first update on a finer mesh may be larger than on a path: what it finds is looked at.
const MOST_UPDATE: f64 = 2.0;
/// On a finer mesh the front may not be further from where it is than this share of the height of the strip, and a quantity no more than this
/// share of itself: else another point has been found.
const SAME_PLACE: f64 = 0.3;

/// The same body on a finer mesh.
pub(super) struct Finer<'s> {
    coarse: &'s SolidBody,
    fine: SolidBody,
    problem: Problem,
    /// What a difference counts
    factor: f64,
}

impl<'s> Finer<'s> {
    pub(super) fn new(coarse: &'s SolidBody, on_coarse: &Problem) -> Self {
        let FinerBody { body: fine, factor } = coarse.finer();
        let problem = Problem { grip: on_coarse.grip, ..fine.problem() };
        Self { coarse, problem, fine, factor }
    }

    /// Errors of a limit point; `width` is the length over which the front moves on its step.
    pub(super) fn limit_point(&self, kind: LimitPointKind, located: &Located, width: f64) -> Option<SolidErrors> {
        let coarse = &located.observables;
        let at = &located.solution.at;
        let weights = Observables::monitor(0);
        let search = LimitPointSearch { problem: &self.problem, weights, kind, width };
        let start = self.equilibrium(at, coarse, weights)?;
        let target = start.observables.monitors[0];
        let rule = BendRule::Difference { neighbour: None };
        let found = search.run(start.at.clone(), target, rule, &mut Workspace::default());
        let same = found.ok().filter(|found| {
            let (fine, scale) = (&found.observables, SAME_PLACE * self.problem.measure.monitors[0]);
            let near = (fine.monitors[0] - coarse.monitors[0]).abs() <= scale;
            near && (fine.force - coarse.force).abs() <= SAME_PLACE * coarse.force.abs()
        });
        Some(match same {
            Some(found) => self.errors(coarse, &found.observables, true),
            None => self.errors(coarse, &start.observables, false),
        })
    }

    /// Error of the force at a displacement: the largest over the points of the path while the front passes through one element. Along it the
    /// error of a coarse mesh changes its sign.
    pub(super) fn station(&self, solution: &Solution, path: &[Arc<Solution>]) -> Option<f64> {
        let half = 0.5 * self.coarse.longest_column();
        let front = |solution: &Solution| solution.observables.monitors[0];
        let beside = path.iter().filter(|point| (front(point) - front(solution)).abs() <= half);
        let all = beside.map(|point| &**point).chain(std::iter::once(solution));
        let error = |point: &Solution| {
            let fine = self.equilibrium(&point.at, &point.observables, Observables::DISPLACEMENT)?;
            Some(self.errors(&point.observables, &fine.observables, true).force)
        };
        all.map(error).try_fold(0.0, |largest: f64, error| Some(largest.max(error?)))
    }

    fn equilibrium(&self, at: &State, coarse: &Observables, weights: Observables) -> Option<Solution> {
        let start = self.fine.state_of(self.coarse, at)?;
        let constraint = PathConstraint { weights, target: weights.dot(coarse) };
        // what is carried over is no equilibrium yet: its first updates may wander
        let ws = &mut Workspace::default().at(Pace::Wary);
        solve(&self.problem, start.clone(), &constraint, &newton(), ws)
            .or_else(|_| settle(&self.problem, start, &constraint, &newton(), ws))
            .ok()
    }

    fn errors(&self, coarse: &Observables, fine: &Observables, confirmed: bool) -> SolidErrors {
        let change = fine.since(coarse).times(self.factor);
        SolidErrors { displacement: change.displacement.abs(), force: change.force.abs(), confirmed }
    }
}
