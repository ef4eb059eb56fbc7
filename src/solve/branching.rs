//! Where a path loses or regains its stability without turning: a branching point, such as a strip that stands upright and falls to either
//! side. An eigenvalue passes through zero there, which the inertia shows.

use super::limit_point::locate::refined;
use super::{
    Located, NewtonOptions, Observables, PathConstraint, Problem, Solution, SolveError, State, Workspace, solve,
};
use std::sync::Arc;

/// Most solutions until a branching point is located.
const MOST_SOLVES: usize = 80;
/// It is located when it lies between displacements that differ by this share, and no better: round-off is an imperfection that
/// turns the path to one of its branches before or behind it, by a power 2/3 of its size.
const CLOSE: f64 = 1e-7;
/// Farther apart, relative as in [`crate::solve::System::size`], solutions on both sides of a branching point lie on two branches that do not meet.
const GAP: f64 = 1e-3;
/// Error of a solution, relative as in [`crate::solve::System::size`].
const TOLERANCE: f64 = 1e-9;

/// The first equilibrium behind `from` that has not as many negative eigenvalues, on its way to the displacement `to`, where there are not as
/// many; its error by the same on half as many elements again. The displacement must not turn between them.
pub fn locate_branching(
    problem: &Problem,
    from: &Solution,
    to: f64,
    ws: &mut Workspace,
) -> Result<Located, SolveError> {
    let (coarse, iterations) = bisected(problem, from.at.clone(), to, ws)?;
    let (fine, more) = bisected(problem, refined(problem, &from.at), to, ws)?;
    let mut difference = fine.observables.since(&coarse.observables);
    difference.displacement = difference.displacement.abs() + CLOSE * coarse.observables.displacement.abs();
    difference.force = difference.force.abs() + CLOSE * coarse.observables.force.abs();
    Ok(Located {
        observables: coarse.observables,
        solution: Arc::new(coarse),
        difference,
        force_curvature: 0.0,
        flat: false,
        left_out: 0.0,
        iterations: iterations + more,
    })
}

/// The far end of the bracket, on the mesh of `from`, and Newton iterations.
fn bisected(problem: &Problem, from: State, to: f64, ws: &mut Workspace) -> Result<(Solution, usize), SolveError> {
    let options = NewtonOptions { tolerance: TOLERANCE, largest_update: 0.5, most_iterations: 12, exact_slope: true };
    let mut solved = |start: State, target: f64| {
        solve(problem, start, &PathConstraint { weights: Observables::DISPLACEMENT, target }, &options, ws)
    };
    let start = problem.displacement(&from);
    let mut near = solved(from, start)?;
    let (negative, mut iterations) = (near.negative, near.iterations);
    let (mut far, mut high, mut longest) = (None, to, f64::INFINITY);
    let mut trouble = SolveError::LimitPointNotConfirmed;
    for _ in 0..MOST_SOLVES {
        let here = near.observables.displacement;
        if (high - here).abs() <= CLOSE * here.abs() {
            break;
        }
        let ahead = 0.5 * (high - here);
        let ahead = ahead.abs().min(longest).copysign(ahead);
        match solved(near.moved(problem, ahead), here + ahead) {
            Ok(next) => {
                iterations += next.iterations;
                if next.negative == negative {
                    near = next;
                } else {
                    high = here + ahead;
                    far = Some(next);
                }
            }
            Err(error) => {
                longest = 0.5 * ahead.abs();
                trouble = error;
            }
        }
    }
    let far = far.ok_or(trouble)?;
    if gap(problem, &near.at, &far.at) > GAP {
        return Err(SolveError::LimitPointNotConfirmed);
    }
    Ok((far, iterations))
}

/// How far two states on one mesh are apart, relative as in [`crate::solve::System::size`].
fn gap(problem: &Problem, one: &State, other: &State) -> f64 {
    let mut update = Vec::new();
    problem.system.miss(&one.values, &[&other.values], &[1.0], &mut update);
    problem.system.size(&update, &one.values)
}
