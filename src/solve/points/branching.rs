//! Where a path loses or regains its stability without turning: a branching point, such as a strip that stands upright and falls to either
//! side. An eigenvalue passes through zero there, which the inertia shows.

use super::locate::Located;
use crate::solve::error::SolveError;
use crate::solve::newton::{NewtonOptions, Solution, solve};
use crate::solve::problem::Problem;
use crate::solve::state::{Observables, PathConstraint, State};
use crate::solve::workspace::Workspace;
use std::sync::Arc;

/// Most solutions until a branching point is located.
const MOST_SOLVES: usize = 80;
/// It is located when it lies between displacements that differ by this share, and no better: round-off is an imperfection that
/// turns the path to one of its branches before or behind it, by a power 2/3 of its size.
const CLOSE: f64 = 1e-7;
/// Where solutions next to it are lost in round-off, it lies between the nearest that are found, if they differ by no more than this share.
const CLOSE_ENOUGH: f64 = 1e-5;
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
    let coarse = bisected(problem, from.at.clone(), to, ws)?;
    let fine = bisected(problem, problem.system.refined(&from.at), to, ws)?;
    let width = coarse.width.max(fine.width);
    let (o, slope) = (coarse.far.observables, coarse.far.slope);
    let mut difference = fine.far.observables.since(&o);
    difference.displacement = difference.displacement.abs() + width;
    difference.force =
        difference.force.abs() + CLOSE * o.force.abs() + (slope.force / slope.displacement).abs() * width;
    Ok(Located {
        observables: o,
        solution: Arc::new(coarse.far),
        difference,
        force_curvature: 0.0,
        flat: false,
        left_out: 0.0,
        iterations: coarse.iterations + fine.iterations,
    })
}

/// Where a branching point was found on one mesh.
struct Bracket {
    /// Its far end
    far: Solution,
    /// Between the displacements of its ends, nm
    width: f64,
    /// Of Newton's method
    iterations: usize,
}

/// The bracket on the mesh of `from`.
fn bisected(problem: &Problem, from: State, to: f64, ws: &mut Workspace) -> Result<Bracket, SolveError> {
    let options = NewtonOptions { tolerance: TOLERANCE, largest_update: 0.5, most_iterations: 12, exact_slope: true };
    let mut solved = |start: State, target: f64| {
        solve(problem, start, &PathConstraint { weights: Observables::DISPLACEMENT, target }, &options, ws)
    };
    let start = problem.displacement(&from);
    let mut near = solved(from, start)?;
    let (negative, mut iterations) = (near.negative, near.iterations);
    // a path that loses its stability on a step shorter than that has a solution behind it all the same
    let reach = (to - start).abs().max(CLOSE_ENOUGH * start.abs()).copysign(to - start);
    let (mut far, mut high, mut longest) = (None, start + reach, f64::INFINITY);
    let mut trouble = SolveError::LimitPointNotConfirmed;
    for _ in 0..MOST_SOLVES {
        let here = near.observables.displacement;
        let is_within = |share: f64| (high - here).abs() <= share * here.abs();
        if is_within(CLOSE) {
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
            Err(_) if far.is_some() && is_within(CLOSE_ENOUGH) => break,
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
    Ok(Bracket { width: (high - near.observables.displacement).abs(), far, iterations })
}

/// How far two states on one mesh are apart, relative as in [`crate::solve::System::size`].
fn gap(problem: &Problem, one: &State, other: &State) -> f64 {
    let mut update = Vec::new();
    problem.system.miss(&one.values, &[&other.values], &[1.0], &mut update);
    problem.system.size(&update, one)
}
