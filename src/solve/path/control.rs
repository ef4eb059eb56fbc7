//! Equilibria at chosen values of one quantity: displacement, force or rotation control.

use crate::solve::error::SolveError;
use crate::solve::newton::{NewtonOptions, Solution, solve};
use crate::solve::observables::{Observables, PathConstraint};
use crate::solve::problem::Problem;
use crate::solve::state::State;
use crate::solve::workspace::Workspace;

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
