//! The first point of a path that starts at no equilibrium.

use crate::solve::error::SolveError;
use crate::solve::newton::{NewtonOptions, Solution, settle};
use crate::solve::observables::PathConstraint;
use crate::solve::problem::Problem;
use crate::solve::relax::{Held, RelaxOptions, relax};
use crate::solve::state::State;
use crate::solve::workspace::Workspace;

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
