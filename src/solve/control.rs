//! Equilibria at chosen values of one quantity: displacement, force or rotation control.

use super::{Condition, Equilibrium, NewtonOptions, Observables, Problem, Solution, SolveError, Workspace, solve};
use std::sync::Arc;

/// Shortest step, as a share of the way from one target to the next.
const SHORTEST: f64 = 1e-6;
/// Most growth of a step that was taken.
const GROWTH: f64 = 2.0;

/// The equilibria at which `weights` · observables takes the values `targets`, one after the other, from the equilibrium
/// `start` on. In between, steps along the tangent are as long as Newton's method bears; the path must not turn in that
/// quantity. `tolerance` is the error wanted, relative as in [`Problem::relative_size`].
pub fn controlled(
    problem: &Problem,
    start: Equilibrium,
    weights: Observables,
    targets: &[f64],
    tolerance: f64,
) -> Result<Vec<Solution>, SolveError> {
    let options = NewtonOptions { tolerance, largest_update: 0.7, most_iterations: 12, exact_slope: false };
    let mut work = Workspace::default();
    let energy = problem.chain.energy(start.configuration(), &start.state).0;
    let mut value = weights.dot(&super::observables(problem, &start, energy));
    let mut here = solve(problem, start, &Condition { weights, target: value }, &options, &mut work)?;
    let mut found = Vec::with_capacity(targets.len());
    let remembered = |at: &Solution| problem.chain.slid(at.at.configuration()).map(Arc::new);
    let mut slips = remembered(&here);
    let mut step = f64::INFINITY;
    for &target in targets {
        let whole = (target - value).abs();
        while value != target {
            let left = target - value;
            let (ahead, next) =
                if left.abs() <= step { (left, target) } else { (step.copysign(left), value + step.copysign(left)) };
            let start = Equilibrium { slips: slips.clone(), ..here.moved(ahead) };
            match solve(problem, start, &Condition { weights, target: next }, &options, &mut work) {
                Ok(solution) => {
                    slips = remembered(&solution);
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
