//! Where a structure goes that has lost its stability: by gradient flow of its energy Π at a fixed displacement or force.
//!
//!   C dq/dt = -∂Π/∂q,  discretised as  (K + C/Δt) δ = -∂Π/∂q
//!
//! C is the damping of the system, in units in which its unknowns count alike and the pseudo-time is of the order of one. It says how
//! fast what moves: not where an equilibrium lies, but where several lie
//! downhill it has a say in which is reached, as friction and inertia would have. A step is repeated with
//! a shorter Δt where it moves too far, where K + C/Δt is not positive (Δt beyond the growth time of an instability) or where
//! the energy does not fall. It ends in a stable equilibrium to which Newton's own method converges from near by, or fails.

use super::error::SolveError;
use super::newton::on_more_elements;
use super::newton::{FINE, NewtonOptions, SINGULAR, Solution, damped_step, solve};
use super::problem::Problem;
use super::state::{Observables, PathConstraint, State};
use super::system::Coefficients;
use super::workspace::Workspace;
use serde::{Deserialize, Serialize};

/// How a structure is relaxed.
#[derive(Clone, Copy, Debug)]
pub struct RelaxOptions {
    /// Most that a step moves, relative as in [`crate::solve::System::size`]; a step that moves by less than a third of it is
    /// followed by a longer one.
    pub largest_update: f64,
    /// Most steps that are taken, and most that are tried, before it is given up.
    pub most_steps: usize,
    /// The energy is known to this share of its own: of a sum of parts that are much larger, more than the machine's.
    pub round_off: f64,
}

impl RelaxOptions {
    /// Steps that move at most so much, and three times as many as a jump has been found to take: 6694, of a spatula that rolls off its edge.
    pub const fn by(largest_update: f64) -> Self {
        Self { largest_update, most_steps: 20_000, round_off: ROUND_OFF }
    }
}

impl Default for RelaxOptions {
    /// Steps of a tenth of the gap, as from a jump.
    fn default() -> Self {
        Self::by(0.1)
    }
}

/// What is held while a structure relaxes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Held {
    /// The displacement, nm.
    Displacement(f64),
    /// The force, nN: what falls is Π - P u.
    Force(f64),
}

impl Held {
    fn constraint(self) -> PathConstraint {
        match self {
            Self::Displacement(target) => PathConstraint { weights: Observables::DISPLACEMENT, target },
            Self::Force(target) => PathConstraint { weights: Observables::FORCE, target },
        }
    }

    /// Of the negative eigenvalues with the displacement held and with the force held, those that count.
    fn negative(self, (displacement, force): (usize, usize)) -> usize {
        match self {
            Self::Displacement(_) => displacement,
            Self::Force(_) => force,
        }
    }
}

/// Where it came to rest, and how.
#[derive(Clone, Debug)]
pub struct Relaxed {
    /// A stable equilibrium.
    pub solution: Solution,
    /// Energies before the first step and after each, aJ; the change by an interpolation to another mesh in it.
    pub energies: Vec<f64>,
    /// Steps taken, and eliminations of all that were tried.
    pub steps: usize,
    /// Eliminations, of steps that were refused as well
    pub eliminations: usize,
}

/// Why it did not come to rest.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum RelaxError {
    /// Steps became too short.
    #[error("after {steps} relaxation steps no shorter one lowers the energy {energy:.9e} aJ: {cause}")]
    Stuck { steps: usize, energy: f64, cause: SolveError },
    /// There were too many.
    #[error("{steps} relaxation steps did not lead to an equilibrium; the energy is {energy:.9e} aJ")]
    Endless { steps: usize, energy: f64 },
    /// The caller has stopped it.
    #[error("stopped after {steps} relaxation steps, at the energy {energy:.9e} aJ")]
    Stopped { steps: usize, energy: f64 },
}

impl RelaxError {
    /// What of it a solver says.
    pub(crate) fn cause(self) -> SolveError {
        match self {
            Self::Stuck { cause, .. } => cause,
            Self::Endless { steps, .. } => SolveError::NotConverged { update: f64::NAN, iterations: steps },
            Self::Stopped { .. } => SolveError::Stopped,
        }
    }
}

/// First Δt; times grow from there.
const FIRST: f64 = 1e-2;
/// Growth of Δt after a small step, and what is left of it after one that was refused.
const GROWTH: f64 = 2.0;
const SHORTER: f64 = 0.3;
/// Longest Δt: a step of Newton's method.
const LONGEST: f64 = 1e12;
/// Shortest Δt.
const SHORTEST: f64 = 1e-12;
/// Eliminations allowed a step, those of refused steps and of looking for an equilibrium near by among them.
const TRIES: usize = 8;
/// Newton's own step from near an equilibrium: more is too far away.
const NEAR: f64 = 0.2;
/// The energy is known to this share of its largest parts.
const ROUND_OFF: f64 = 1e-13;
/// Size of the disturbance that starts a relaxation, relative as in [`crate::solve::System::size`].
const DISTURBED: f64 = 1e-2;

/// A limit point left a little along its tangent, which is the critical direction there: onward, where the unstable part of the
/// path turns off, because there the energy at the fixed displacement falls.
pub fn disturbed(problem: &Problem, limit: &Solution) -> State {
    limit.moved(problem, DISTURBED / problem.system.size(&limit.tangent.direction, &limit.at))
}

/// An equilibrium disturbed a little, with a part in any critical direction.
pub(crate) fn disturbed_anyhow(problem: &Problem, at: &State) -> State {
    let mut disturbed = at.clone();
    problem.system.retract(&mut disturbed, &problem.system.disturbance(at, DISTURBED), 1.0);
    disturbed
}

/// Relaxes from `start` with the displacement or the force held.
pub fn relax(
    problem: &Problem,
    start: State,
    held: Held,
    options: &RelaxOptions,
    ws: &mut Workspace,
) -> Result<Relaxed, RelaxError> {
    match relax_until(problem, start, held, options, ws, |_| false)? {
        Relaxation::Rest(relaxed) => Ok(*relaxed),
        Relaxation::Left { steps, energy, .. } => Err(RelaxError::Endless { steps, energy }),
    }
}

/// How a relaxation that is watched ends.
#[derive(Clone, Debug)]
pub(crate) enum Relaxation {
    /// In a stable equilibrium.
    Rest(Box<Relaxed>),
    /// On its way, where the watch said so.
    Left {
        /// Where it is, which is no equilibrium
        at: State,
        /// Steps taken
        steps: usize,
        /// Eliminations, of steps that were refused as well
        eliminations: usize,
        /// Π there, aJ
        energy: f64,
    },
}

/// The same up to the first state on the way that `leaves`.
pub(crate) fn relax_until(
    problem: &Problem,
    start: State,
    held: Held,
    options: &RelaxOptions,
    ws: &mut Workspace,
    mut leaves: impl FnMut(&State) -> bool,
) -> Result<Relaxation, RelaxError> {
    let constraint = held.constraint();
    let energy_of = |at: &State| energy_of(problem, at, held);
    let mut at = held_at(problem, start, held);
    let mut energies = vec![energy_of(&at)];
    let (mut time, mut steps, mut eliminations) = (FIRST, 0, 0);
    // where a step is as long as it may be there is no equilibrium near by yet
    let mut is_moving = false;
    while steps < options.most_steps && eliminations < TRIES * options.most_steps {
        let energy = energies[energies.len() - 1];
        // what it may be wrong by
        let slack = options.round_off * (energy.abs() + 1e-3);
        if ws.is_stopped() {
            return Err(RelaxError::Stopped { steps, energy });
        }
        if !is_moving && let Some(solution) = landed(problem, &at, (energy, slack), held, ws, &mut eliminations) {
            return Ok(Relaxation::Rest(Box::new(Relaxed { solution, energies, steps, eliminations })));
        }
        let damping = Coefficients { per_damping: time, ..Coefficients::STATIC };
        let mut next = at.clone();
        eliminations += 1;
        let tried = match damped_step(problem, &mut next, &constraint, damping, f64::INFINITY, ws) {
            Ok((size, negative))
                if held.negative(negative) == 0
                    && size <= options.largest_update
                    && problem.system.is_admissible(&next)
                    && energy_of(&next) <= energy + slack =>
            {
                Ok(size)
            }
            Ok((size, _)) => Err(SolveError::NotConverged { update: size, iterations: 1 }),
            Err(error) => Err(error),
        };
        let size = match tried {
            Ok(size) => size,
            Err(cause) if time < SHORTEST => return Err(RelaxError::Stuck { steps, energy, cause }),
            Err(_) => {
                time *= SHORTER;
                continue;
            }
        };
        steps += 1;
        is_moving = 3.0 * size >= options.largest_update;
        time = (time * if is_moving { 1.0 } else { GROWTH }).min(LONGEST);
        at = next;
        // a mesh on which the energy of this step is lost again is put off
        let moved = problem.system.remeshed(&at).map(|moved| held_at(problem, moved, held));
        if let Some(moved) = moved.filter(|moved| energy_of(moved) < energy) {
            at = moved;
        }
        energies.push(energy_of(&at));
        if leaves(&at) {
            return Ok(Relaxation::Left { at, steps, eliminations, energy: energies[energies.len() - 1] });
        }
    }
    Err(RelaxError::Endless { steps, energy: energies[energies.len() - 1] })
}

/// The equilibrium at the displacement of a stable one on half as many elements again: by Newton's method, or relaxed where that leads nowhere from there.
pub(crate) fn relaxed_on_more_elements(
    problem: &Problem,
    coarse: &Solution,
    ws: &mut Workspace,
) -> Result<Solution, SolveError> {
    on_more_elements(problem, coarse, Observables::DISPLACEMENT, ws).or_else(|cause| {
        let held = Held::Displacement(coarse.observables.displacement);
        let relaxed = relax(problem, problem.system.refined(&coarse.at), held, &RelaxOptions::default(), ws);
        relaxed.map(|relaxed| relaxed.solution).map_err(|_| cause)
    })
}

/// The stable equilibrium near by, if the tangent is positive here and Newton's own method goes there without much ado.
fn landed(
    problem: &Problem,
    at: &State,
    (energy, slack): (f64, f64),
    held: Held,
    ws: &mut Workspace,
    eliminations: &mut usize,
) -> Option<Solution> {
    let constraint = &held.constraint();
    let mut probe = at.clone();
    *eliminations += 1;
    let (size, negative) =
        damped_step(problem, &mut probe, constraint, Coefficients::STATIC, f64::INFINITY, ws).ok()?;
    if held.negative(negative) > 0 || size > NEAR {
        return None;
    }
    let solved = |tolerance, ws: &mut Workspace| {
        let newton = NewtonOptions { tolerance, largest_update: NEAR, most_iterations: 10, exact_slope: true };
        solve(problem, at.clone(), constraint, &newton, ws)
    };
    let solution = solved(FINE, ws).or_else(|_| solved(SINGULAR, ws)).ok()?;
    *eliminations += solution.iterations;
    let lower = energy_of(problem, &solution.at, held) <= energy + slack;
    let negative = held.negative((solution.negative, solution.negative_load));
    (negative == 0 && solution.correction <= 2.0 * NEAR && lower).then_some(solution)
}

/// What falls: the energy of a configuration, whether in equilibrium or not, less P u of a held force, aJ.
fn energy_of(problem: &Problem, at: &State, held: Held) -> f64 {
    let direction = vec![0.0; problem.system.unknowns(at)];
    let energy = problem.energy(at, problem.system.evaluate(at, &direction).0.energy);
    match held {
        Held::Displacement(_) => energy,
        Held::Force(force) => energy - force * problem.displacement(at),
    }
}

/// The configuration with the force as held, or with the displacement exactly so: where a spring takes part, its force
/// follows the grip, and otherwise the grip is put there.
fn held_at(problem: &Problem, mut at: State, held: Held) -> State {
    let displacement = match held {
        Held::Displacement(displacement) => displacement,
        Held::Force(force) => return State { force, ..at },
    };
    let missing = displacement - problem.displacement(&at);
    if problem.grip.compliance > 0.0 {
        at.force += missing / problem.grip.compliance;
    } else {
        at = problem.moved(at, missing);
    }
    at
}
