//! How a path is stepped, why it stops, and by what one that is to go on is kept.

use super::metric::Notice;
use super::near_branch::NearBranch;
use super::predictor::MOST_POINTS;
use crate::solve::error::SolveError;
use crate::solve::newton::{NewtonOptions, Solution, solve};
use crate::solve::problem::Problem;
use crate::solve::state::{Observables, PathConstraint, State};
use crate::solve::workspace::{Pace, Workspace};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// How a path is stepped. Its points follow from this and the problem alone.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PathOptions {
    /// Elements of the chain.
    pub elements: usize,
    /// Error wanted of a prediction, relative as in [`crate::solve::System::size`].
    pub step_tolerance: f64,
    /// Length of a step over that which predictions allow, at most 1.
    pub stride: f64,
    /// Most that the first monitor changes by on a step at a stride of one, as far as the slope tells, in its unit
    #[serde(default)]
    pub longest: Option<f64>,
    /// Error wanted of a solution, likewise.
    pub tolerance: f64,
    /// Most points that a prediction uses: 2 is the secant
    pub prediction: usize,
    /// First displacement, nm (rad where the rotation is driven); its sign is the direction of the path
    pub first_displacement: f64,
    /// What is tried where a step is not made
    pub pace: Pace,
}

impl Default for PathOptions {
    /// How a peel of the paper's strip is followed at a relative accuracy of 1e-6.
    fn default() -> Self {
        Self {
            elements: 16,
            step_tolerance: 1.2e-2,
            stride: 1.0,
            longest: None,
            tolerance: 1e-8,
            prediction: MOST_POINTS,
            first_displacement: 8e-3,
            pace: Pace::Quick,
        }
    }
}

/// Where a path stopped and why.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[error(
    "the path cannot be continued from u = {displacement_nm:.6} nm, P = {force:.6} nN (point {point}): after {tries} ever shorter steps: {cause}"
)]
#[allow(missing_docs)] // the message of each names its numbers
pub struct PathError {
    pub point: usize,
    pub displacement_nm: f64,
    pub force: f64,
    pub tries: usize,
    pub cause: SolveError,
}

/// A point of a path and what the path has learnt there: with the points before, all that it takes to go on.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Waypoint {
    /// The equilibrium
    pub point: Arc<Solution>,
    pub(super) errors: Vec<f64>,
    pub(super) iterations: usize,
    pub(super) careful: bool,
    pub(super) refused: Option<f64>,
    pub(super) branch: Option<NearBranch>,
    #[serde(default)]
    pub(super) notice: Notice,
    /// What the point before it was replaced by on the step to it.
    pub(super) before: Option<Arc<Solution>>,
}

// -- Equilibria at chosen values of one quantity: displacement, force or rotation control --

/// Shortest step, as a share of the way from one target to the next.
const SHORTEST: f64 = 1e-6;
/// Most growth of a step that was taken.
const GROWTH: f64 = 2.0;

/// The equilibria at which `weights` · observables takes the values `targets`, one after the other, from the equilibrium
/// `start` on. In between, steps along the tangent are as long as Newton's method bears; the path must not turn in that
/// quantity. `tolerance` is the error wanted, relative as in [`crate::solve::System::size`].
pub fn controlled(
    problem: &Problem,
    start: State,
    weights: Observables,
    targets: &[f64],
    tolerance: f64,
) -> Result<Vec<Solution>, SolveError> {
    let options = NewtonOptions { tolerance, largest_update: 0.7, most_iterations: 12, exact_slope: false };
    let mut ws = Workspace::default();
    let evaluation = problem.system.evaluate(&start, &vec![0.0; problem.system.unknowns(&start)]).0;
    let mut value = weights.dot(&problem.observables(&start, &evaluation));
    let mut here = solve(problem, start, &PathConstraint { weights, target: value }, &options, &mut ws)?;
    let mut found = Vec::with_capacity(targets.len());
    let remembered = |at: &Solution| problem.system.commit(&at.at);
    let mut history = remembered(&here);
    let mut step = f64::INFINITY;
    for &target in targets {
        let whole = (target - value).abs();
        while value != target {
            let left = target - value;
            let (ahead, next) =
                if left.abs() <= step { (left, target) } else { (step.copysign(left), value + step.copysign(left)) };
            let start = State { history: history.clone(), ..here.moved(problem, ahead) };
            match solve(problem, start, &PathConstraint { weights, target: next }, &options, &mut ws) {
                Ok(solution) => {
                    history = remembered(&solution);
                    here = solution;
                    value = next;
                    step = ahead.abs() * GROWTH;
                }
                Err(error) if ahead.abs() < SHORTEST * whole => return Err(error),
                Err(_) => step = 0.4 * ahead.abs(),
            }
        }
        found.push(here.clone());
    }
    Ok(found)
}
