//! Next to where a path branches, or where branches of it nearly meet: a step must not pass from one to another unnoticed.
//!
//! A pull that is not quite symmetric rounds a bifurcation off. The path from rest turns within a short way, and beside it another branch goes on nearly as
//! before: a step that is too long lands there.

use crate::solve::error::SolveError;
use crate::solve::newton::{NewtonOptions, Solution, settle};
use crate::solve::problem::Problem;
use crate::solve::relax::{Held, RelaxOptions, relax};
use crate::solve::state::{Observables, PathConstraint, State};
use crate::solve::workspace::{Pace, Workspace};
use nalgebra::DVector;
use serde::{Deserialize, Serialize};

/// A step that leads to another branch is shortened by this.
pub(crate) const SHORTER: f64 = 0.3;
/// Where it still does when it is this share of the first that did, the path does branch there.
const CROSSES: f64 = 1e-5;
/// Error wanted of a prediction, relative as in [`crate::solve::System::size`]: so little that neither branch can be taken for the other. Without it
/// two of nine strips in space that were drawn at random came to the peak of the branch that is not that of rest.
const TOLERANCE: f64 = 1e-5;
/// Most Newton iterations of a step there that is believed: more are taken from between two branches to one of them.
const CERTAIN: usize = 4;
/// A tangent that turns by less is straight; one that turns by more turns too sharply; between, by what cosine it has to turn on as before.
const STRAIGHT: f64 = 0.1;
const SHARP: f64 = 0.6;
const ALIGNED: f64 = 0.7;
/// How far that reaches, over the first step that led to another branch.
const PAST: f64 = 3.0;
/// The step across a branch point, likewise.
const BEYOND: f64 = 0.1;

/// Where a step next to another branch has led.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum StepSeen {
    /// On along the path
    OnPath,
    /// To another branch, or nobody knows where; `across` where the next one is to lead across the branch point.
    #[allow(missing_docs)]
    Elsewhere { across: bool },
}

/// A place where a step has led to another branch.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(crate) struct NearBranch {
    /// Where the step began.
    from: Observables,
    /// How far it led.
    first: f64,
}

impl NearBranch {
    /// The place ahead of a step that leads to another branch.
    pub(crate) fn ahead(problem: &Problem, newest: &Solution, next: &Solution) -> Self {
        let from = newest.observables;
        Self { from, first: problem.apart(&from, &next.observables) }
    }

    /// Where a step has led, on from the two newest points. One whose Newton's method was in doubt between branches, or across which the tangent turns
    /// otherwise than before, says nothing; across the branch point the path goes on along the branch that it is on, whose stability changes.
    pub(crate) fn seen(
        &self,
        problem: &Problem,
        [before, newest]: [&Solution; 2],
        next: &Solution,
        crosses: bool,
    ) -> StepSeen {
        let changed = changes_branch(problem, newest, next);
        let short = problem.apart(&newest.observables, &next.observables) <= CROSSES * self.first;
        match (changed, crosses || short) {
            (true, true) => StepSeen::OnPath,
            (true, false) => StepSeen::Elsewhere { across: false },
            // a step across that has not passed the branch point is one up to it
            (false, _) if next.iterations > CERTAIN || !turns_on(problem, [before, newest, next]) => {
                StepSeen::Elsewhere { across: short && !crosses }
            }
            (false, _) => StepSeen::OnPath,
        }
    }

    /// Whether a step leaves it behind.
    pub(crate) fn is_behind(&self, problem: &Problem, newest: &Solution, next: &Solution) -> bool {
        changes_branch(problem, newest, next) || problem.apart(&self.from, &next.observables) > PAST * self.first
    }

    /// The step across, along a slope, in what the weights measure: at the branch point itself no equilibrium is certain.
    pub(crate) fn step_across(&self, problem: &Problem, weights: &Observables, slope: &Observables) -> f64 {
        BEYOND * self.first * weights.dot(slope) / problem.apart(&Observables::default(), slope)
    }

    /// Whether a step in these units is so short that the path may branch there.
    pub(crate) fn is_short(&self, problem: &Problem, weights: &Observables, slope: &Observables, step: f64) -> bool {
        step <= CROSSES / BEYOND * self.step_across(problem, weights, slope)
    }

    /// Error wanted of a prediction where `asked` suffices elsewhere.
    pub(crate) fn step_tolerance(near: Option<&Self>, asked: f64) -> f64 {
        near.map_or(asked, |_| asked.min(TOLERANCE))
    }
}

/// Whether the tangent turns little on the last step, or on as it did on the step before: where a path turns from one branch to another, it begins to
/// do so before.
fn turns_on(problem: &Problem, points: [&Solution; 3]) -> bool {
    let [first, second, third] = points.map(|point| unit_tangent(problem, point));
    let (before, turn) = (&second - &first, &third - &second);
    let angle = turn.norm();
    angle <= STRAIGHT || angle <= SHARP && turn.dot(&before) >= ALIGNED * angle * before.norm()
}

/// The tangent of the path at a point, each unknown in its unit, of length one.
fn unit_tangent(problem: &Problem, point: &Solution) -> DVector<f64> {
    let units = problem.system.per_unit(&point.at);
    let scaled = point.tangent.direction.iter().zip(units).map(|(change, per_unit)| change * per_unit);
    DVector::from_iterator(point.tangent.direction.len(), scaled).normalize()
}

/// Whether a step has gone to another branch where branches are looked for: in systems that have such, and on paths that are watched.
pub(crate) fn leads_elsewhere(problem: &Problem, pace: Pace, newest: &Solution, next: &Solution) -> bool {
    let watched = problem.system.has_near_branches() || pace == Pace::Watchful && !is_mirrored(newest, next);
    watched && changes_branch(problem, newest, next)
}

/// Whether displacement and force turn on a step and no eigenvalue changes its sign: so does the path of a structure that passes a symmetric state and
/// goes on as its own mirror image.
pub(crate) fn is_mirrored(newest: &Solution, next: &Solution) -> bool {
    turns(newest, next, |slope| slope.displacement)
        && turns(newest, next, |slope| slope.force)
        && (newest.negative, newest.negative_load) == (next.negative, next.negative_load)
}

/// Whether this number turns on a step.
fn turns(newest: &Solution, next: &Solution, number: fn(&Observables) -> f64) -> bool {
    (number(&newest.slope) < 0.0) != (number(&next.slope) < 0.0)
}

/// Whether a step has gone to another branch. On one branch the number of negative eigenvalues with the displacement held changes by an odd number
/// where the displacement turns, and with the force held where the force does: slopes and numbers come from the same elimination.
fn changes_branch(problem: &Problem, newest: &Solution, next: &Solution) -> bool {
    let odd = |before: usize, behind: usize| before.abs_diff(behind) % 2 == 1;
    problem.system.is_conservative()
        && (odd(newest.negative, next.negative) != turns(newest, next, |slope| slope.displacement)
            || odd(newest.negative_load, next.negative_load) != turns(newest, next, |slope| slope.force))
}

// -- The first point of a path that starts at no equilibrium --

/// Most that a step of settling down moves, relative as in [`crate::solve::System::size`].
const SETTLING: f64 = 0.3;
/// Most meshes on which a structure settles, and by how little, in units of their scales, its monitors move then.
const MOST_REFOCUSED: usize = 8;
const SETTLED: f64 = 0.1;

/// The equilibrium next to a start that is none, on the mesh that its own monitors ask for.
pub(super) fn settled(
    problem: &Problem,
    start: State,
    constraint: &PathConstraint,
    newton: &NewtonOptions,
    ws: &mut Workspace,
) -> Result<Solution, SolveError> {
    let mut found = settled_near(problem, start, constraint, newton, ws)?;
    for _ in 0..MOST_REFOCUSED {
        let at = problem.system.refocused(&found.at, found.observables.monitors);
        let next = settled_near(problem, at, constraint, newton, ws)?;
        let moved = problem.measure.apart(&found.observables, &next.observables);
        found = next;
        if moved < SETTLED {
            break;
        }
    }
    Ok(found)
}

/// The same on the mesh of the start: by Newton's method, or, where that wanders, down the gradient of the energy.
fn settled_near(
    problem: &Problem,
    start: State,
    constraint: &PathConstraint,
    newton: &NewtonOptions,
    ws: &mut Workspace,
) -> Result<Solution, SolveError> {
    let displacement = problem.displacement(&start);
    let settled = settle(problem, start.clone(), constraint, newton, ws);
    // long steps may have gone through an obstacle
    let above = settled.and_then(|solution| {
        let inside = SolveError::NotConverged { update: solution.correction, iterations: solution.iterations };
        if problem.system.is_admissible(&solution.at) { Ok(solution) } else { Err(inside) }
    });
    above.or_else(|error| {
        let options = RelaxOptions::by(SETTLING);
        let relaxed = relax(problem, start, Held::Displacement(displacement), &options, ws);
        relaxed.map(|relaxed| relaxed.solution).map_err(|_| error)
    })
}
