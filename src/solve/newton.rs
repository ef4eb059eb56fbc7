//! Newton's method for one equilibrium under one constraint that picks it from the path.

use super::error::{Quantity, SolveError};
use super::frontal::grip_block::GripBlock;
use super::problem::Problem;
use super::state::{Observables, PathConstraint, State};
use super::system::{Coefficients, CondensedSystem, StepDependence};
use super::workspace::{Pace, Workspace};
use serde::{Deserialize, Serialize};
use std::sync::OnceLock;

/// When Newton's iteration ends.
#[derive(Clone, Copy, Debug)]
pub struct NewtonOptions {
    /// Size of the error wanted, relative as in [`super::System::size`].
    pub tolerance: f64,
    /// A first update above this is refused: the start was too far away.
    pub largest_update: f64,
    /// More are refused
    pub most_iterations: usize,
    /// Whether slopes are taken at the solution itself. Otherwise they come from Newton's last matrix, one update back,
    /// at no cost, with an error of the size of that update.
    pub exact_slope: bool,
}

impl Default for NewtonOptions {
    /// As along a path that is followed at a relative accuracy of 1e-6.
    fn default() -> Self {
        Self { tolerance: 1e-8, largest_update: 0.5, most_iterations: 9, exact_slope: false }
    }
}

/// A converged equilibrium with all that is known about it there.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Solution {
    /// The configuration
    pub at: State,
    /// See [`Solution::aligned`]: made when it is first asked for.
    #[serde(skip)]
    aligned: OnceLock<State>,
    /// Displacement, force and what else measures the path
    pub observables: Observables,
    /// Change of the observables along the path, per unit of the constraint's target.
    pub slope: Observables,
    /// Change of the configuration on its mesh, likewise.
    pub tangent: Tangent,
    /// Π of the system, without that of the grip's spring, aJ
    pub energy: f64,
    /// Negative eigenvalues with the displacement held, and with the force held.
    pub negative: usize,
    /// Those with the force held
    pub negative_load: usize,
    /// Newton iterations that it took
    pub iterations: usize,
    /// Distance from the start to the solution, relative as in [`super::System::size`].
    pub correction: f64,
}

/// Longest step of Newton's method from a start that is no equilibrium, relative as in [`super::System::size`], and the most of
/// them.
const WHOLE: f64 = 0.3;
const MOST_SETTLING: usize = 200;
/// Updates below this that do not fall any more are round-off, even where the problem is not stiff.
const STAGNANT: f64 = 1e-9;
/// The same over the error that was asked for: far from rest, where the strip is long, round-off of its shape moves its gap by more than that.
const STALLED: f64 = 100.0;
/// An update below this leaves the slopes as they are; they change by up to some sixty times its size.
const EXACT: f64 = 1e-12;
/// The last update of any solution: the curve between points is interpolated with their slopes, which are one update back.
const LAST: f64 = 1e-5;

/// Change of a configuration along the path on a fixed mesh.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Tangent {
    /// Of the unknowns
    pub direction: Vec<f64>,
    /// Of the force, nN per unit of the constraint
    pub force: f64,
}

impl Solution {
    /// It on the mesh that it asks for itself: what predictions combine. The mesh of `at` lies where the front was
    /// predicted, and that prediction's error would be noise. `problem` is the one that it solves.
    pub(crate) fn aligned(&self, problem: &Problem) -> &State {
        self.aligned.get_or_init(|| problem.system.aligned(&self.at, self.observables.monitors))
    }

    /// The configuration `ahead` along the tangent, on the same mesh.
    pub fn moved(&self, problem: &Problem, ahead: f64) -> State {
        let mut at = self.at.clone();
        problem.system.retract(&mut at, &self.tangent.direction, ahead);
        at.force += ahead * self.tangent.force;
        at
    }
}

/// How Newton's method goes on by its updates, and by what it ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Updates {
    /// Linear ones that fall quadratically: it ends where the next one would be small.
    Falling,
    /// Linear ones, of which large and small ones may take turns: it ends by their own size alone.
    Wandering,
    /// The same by updates that follow the section force, [`super::System::step`].
    Following,
    /// The same by a part of linear ones: half as much where they do not fall, twice as much where they do. Where much that slides sticks at once, a
    /// whole one overshoots from one side of the corner of the law to the other, and back.
    Damped,
}

/// Most iterations with damped updates, and the least part of one.
const MOST_DAMPED: usize = 40;
const LEAST_PART: f64 = 1.0 / 32.0;

/// Most iterations where updates may wander, and those after which it may stand still.
const MOST_WANDERING: usize = 24;
const WANDERS: usize = 4;

/// Solves from the start `at`, at the pace of the workspace.
pub fn solve(
    problem: &Problem,
    at: State,
    constraint: &PathConstraint,
    options: &NewtonOptions,
    ws: &mut Workspace,
) -> Result<Solution, SolveError> {
    match ws.pace() {
        Pace::Quick if problem.system.step_dependence() == StepDependence::Friction => {
            let first = iterate(Updates::Falling, problem, at.clone(), constraint, options, ws);
            match first {
                Err(SolveError::NotConverged { .. }) => {
                    let options = NewtonOptions { most_iterations: MOST_DAMPED, ..*options };
                    iterate(Updates::Damped, problem, at, constraint, &options, ws).or(first)
                }
                first => first,
            }
        }
        Pace::Quick => iterate(Updates::Falling, problem, at, constraint, options, ws),
        Pace::Wary | Pace::Watchful => {
            let first = iterate(Updates::Falling, problem, at.clone(), constraint, options, ws);
            match first {
                Err(SolveError::NotConverged { .. }) => solve_warily(problem, &at, constraint, options, ws).or(first),
                first => first,
            }
        }
    }
}

/// The same where updates may wander: a small one is no sign of an equilibrium if the one before was large.
pub(super) fn solve_warily(
    problem: &Problem,
    at: &State,
    constraint: &PathConstraint,
    options: &NewtonOptions,
    ws: &mut Workspace,
) -> Result<Solution, SolveError> {
    let options = NewtonOptions { most_iterations: MOST_WANDERING, ..*options };
    iterate(Updates::Wandering, problem, at.clone(), constraint, &options, ws)
        .or_else(|_| iterate(Updates::Following, problem, at.clone(), constraint, &options, ws))
}

fn iterate(
    updates: Updates,
    problem: &Problem,
    mut at: State,
    constraint: &PathConstraint,
    options: &NewtonOptions,
    ws: &mut Workspace,
) -> Result<Solution, SolveError> {
    if ws.is_stopped() {
        return Err(SolveError::Stopped);
    }
    let system = &*problem.system;
    let mut update = vec![0.0; system.unknowns(&at)];
    let mut correction = 0.0;
    let (mut previous, mut before) = (f64::INFINITY, f64::INFINITY);
    let stagnant = system.round_off().max(STAGNANT);
    let mut part = 1.0f64;
    for iterations in 1..=options.most_iterations {
        let (root, grip) = factorised(problem, &at, constraint, Coefficients::STATIC, ws)?;
        let step = grip.solve(-1.0)?;
        system.recover(ws, &step.interface, -1.0, &mut update);
        let size = system.size(&update, &at);
        if !(size.is_finite() && step.force.is_finite()) {
            return Err(SolveError::NotFiniteUpdate { quantity: Quantity::NewtonUpdate });
        }
        // an update that takes a section from yielding to unloading is followed by a larger one
        let newest = if system.step_dependence().is_yielding() { previous.max(before) } else { previous };
        let stalls = match updates {
            Updates::Falling => iterations > 2 && size > 0.9 * newest,
            Updates::Wandering | Updates::Following => iterations > WANDERS && size > 0.9 * previous.max(before),
            Updates::Damped => false,
        };
        if updates == Updates::Damped {
            part = if size > 0.9 * previous { (0.5 * part).max(LEAST_PART) } else { (2.0 * part).min(1.0) };
            part = part.min(WHOLE / size);
        }
        let refused = size > options.largest_update && updates != Updates::Damped;
        if refused || (stalls && size > stagnant.max(STALLED * options.tolerance)) {
            return Err(SolveError::NotConverged { update: size, iterations });
        }
        match updates {
            Updates::Falling | Updates::Wandering | Updates::Damped => system.retract(&mut at, &update, part),
            Updates::Following => system.step(&mut at, &update),
        }
        at.force += part * step.force;
        correction += part * size;
        // quadratic convergence: what the next update would be, as far as round-off lets it fall
        let next = if previous.is_finite() { size * (size / previous).powi(2).min(1.0) } else { size };
        let next = next.max(system.round_off());
        let converged = match updates {
            Updates::Falling => size <= options.tolerance || (next <= options.tolerance && size <= LAST),
            // a small one may be the small one of two that take turns
            Updates::Wandering | Updates::Following => size <= options.tolerance && previous <= LAST,
            Updates::Damped => size <= options.tolerance && part == 1.0,
        };
        if converged || stalls || (part == 1.0 && size < stagnant && size > 0.5 * previous) {
            let (root, grip) = if options.exact_slope && size > EXACT {
                factorised(problem, &at, constraint, Coefficients::STATIC, ws)?
            } else {
                (root, grip)
            };
            let tangent = grip.tangent()?;
            system.recover(ws, &tangent.interface, 0.0, &mut update);
            let (evaluation, rates) = system.evaluate(&at, &update);
            let (negative, negative_load) = grip.inertia(root.negative);
            let observables = problem.observables(&at, &evaluation);
            let slope = Observables {
                monitors: rates.monitors,
                displacement: tangent.displacement,
                force: tangent.force,
                recorded: rates.recorded,
                roll: problem.roll(&at).map_or(0.0, |roll| roll.along(&tangent.interface)),
            };
            if !(observables.is_finite() && slope.is_finite()) {
                return Err(SolveError::NotFiniteUpdate { quantity: Quantity::PathTangent });
            }
            return Ok(Solution {
                aligned: OnceLock::new(),
                observables,
                slope,
                tangent: Tangent { direction: update, force: tangent.force },
                energy: evaluation.energy,
                negative,
                negative_load,
                iterations,
                correction,
                at,
            });
        }
        (before, previous) = (previous, size);
    }
    Err(SolveError::NotConverged { update: previous, iterations: options.most_iterations })
}

/// The system factorised at a state, with the block of its grip.
pub(super) fn factorised<'p>(
    problem: &'p Problem,
    at: &State,
    constraint: &PathConstraint,
    coefficients: Coefficients,
    ws: &mut Workspace,
) -> Result<(CondensedSystem, GripBlock<'p>), SolveError> {
    let root = problem.system.factorise(at, coefficients, constraint.weights.monitors, ws)?;
    let observed = problem.observables(at, &root.evaluation);
    let grip = GripBlock::new(problem, &root, at, constraint, &observed);
    Ok((root, grip))
}

/// Solves from a start that is no equilibrium: Newton's method with shortened steps, then [`solve`].
pub fn settle(
    problem: &Problem,
    mut at: State,
    constraint: &PathConstraint,
    options: &NewtonOptions,
    ws: &mut Workspace,
) -> Result<Solution, SolveError> {
    let mut size = f64::INFINITY;
    for iterations in 0..MOST_SETTLING {
        if size < WHOLE {
            let solved = solve(problem, at, constraint, options, ws)?;
            return Ok(Solution { iterations: solved.iterations + iterations, ..solved });
        }
        size = damped_step(problem, &mut at, constraint, Coefficients::STATIC, WHOLE, ws)?.0;
    }
    Err(SolveError::NotConverged { update: size, iterations: MOST_SETTLING })
}

/// A step of Newton's method with the tangent K + `coefficients`, shortened to `most`: how large it was before, relative as in
/// [`super::System::size`], and the negative eigenvalues of that tangent with the displacement held, and with the force held.
pub(crate) fn damped_step(
    problem: &Problem,
    at: &mut State,
    constraint: &PathConstraint,
    coefficients: Coefficients,
    most: f64,
    ws: &mut Workspace,
) -> Result<(f64, (usize, usize)), SolveError> {
    if ws.is_stopped() {
        return Err(SolveError::Stopped);
    }
    let system = &*problem.system;
    let (root, grip) = factorised(problem, at, constraint, coefficients, ws)?;
    let step = grip.solve(-1.0)?;
    let mut update = vec![0.0; system.unknowns(at)];
    system.recover(ws, &step.interface, -1.0, &mut update);
    let size = system.size(&update, at);
    if !size.is_finite() {
        return Err(SolveError::NotFiniteUpdate { quantity: Quantity::DampedUpdate });
    }
    let part = (most / size).min(1.0);
    system.retract(at, &update, part);
    at.force += part * step.force;
    Ok((size, grip.inertia(root.negative)))
}

/// du/dσ and dP/dσ along the path, per unit of the constraint's target σ, at a configuration on it or beside it.
pub fn slopes(
    problem: &Problem,
    at: &State,
    constraint: &PathConstraint,
    ws: &mut Workspace,
) -> Result<(f64, f64), SolveError> {
    let (_, grip) = factorised(problem, at, constraint, Coefficients::STATIC, ws)?;
    let tangent = grip.tangent()?;
    Ok((tangent.displacement, tangent.force))
}

/// Error of a solution next to a singular point, where round-off leaves no better.
pub(in crate::solve) const SINGULAR: f64 = 1e-5;

/// Error of a solution, relative as in [`crate::solve::System::size`].
pub(crate) const FINE: f64 = 1e-12;

/// The solution on half as many elements again with the same `weights` · observables.
pub(crate) fn on_more_elements(
    problem: &Problem,
    coarse: &Solution,
    weights: Observables,
    ws: &mut Workspace,
) -> Result<Solution, SolveError> {
    let constraint = PathConstraint { weights, target: weights.dot(&coarse.observables) };
    let options = |tolerance| NewtonOptions { tolerance, largest_update: 0.5, most_iterations: 10, exact_slope: true };
    let solved = |tolerance, ws: &mut Workspace| {
        solve(problem, problem.system.refined(&coarse.at), &constraint, &options(tolerance), ws)
    };
    // next to a singular point round-off is larger, and shows in the difference
    solved(FINE, ws).or_else(|_| solved(SINGULAR, ws))
}
