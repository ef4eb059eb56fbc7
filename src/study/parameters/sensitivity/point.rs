//! An equilibrium with the multipliers that make of a change of its residual a change of its force or of its displacement.

use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::error::SolveError;
use crate::solve::linear::{Bordered, Tangents};
use crate::solve::newton::{NewtonOptions, Solution, solve};
use crate::solve::state::{Observables, PathConstraint, State};
use crate::solve::workspace::Workspace;

/// What is held while a parameter changes; the other of the two is what is differentiated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Held {
    Displacement,
    Force,
}

impl Held {
    fn weights(self) -> Observables {
        match self {
            Self::Displacement => Observables::DISPLACEMENT,
            Self::Force => Observables::FORCE,
        }
    }

    /// Change of what is not held, per unit of what is.
    pub(crate) fn slope(self, solution: &Solution) -> f64 {
        match self {
            Self::Displacement => solution.slope.force,
            Self::Force => solution.slope.displacement,
        }
    }
}

/// An equilibrium and its multipliers: what is not held changes by λ·∂R/∂x + μ ∂u/∂x, with the changes of the residual and of the grip's way along
/// the drive at a state that stays.
#[derive(Clone, Debug)]
pub(super) struct Adjoint {
    pub at: State,
    /// λ, with the rows turned into the direction of the drive
    pub multipliers: Vec<f64>,
    /// μ
    pub of_displacement: f64,
}

/// Error of the equilibria, relative as in [`crate::solve::System::size`].
const TOLERANCE: f64 = 1e-12;
/// First step to a turn that is looked for again, over the place where it was, how near is near enough, the longest step, by how much each is
/// shorter than the one before, and most of them.
const BESIDE: f64 = 1e-5;
const NEAR: f64 = 1e-11;
const FAR: f64 = 1e-3;
const CLOSING_IN: f64 = 0.5;
const MOST_SECANTS: usize = 4;

/// The equilibrium at which what is held takes a value, from one next to it.
pub(super) fn solved(
    problem: &BeamProblem,
    start: State,
    held: Held,
    target: f64,
    ws: &mut Workspace,
) -> Result<Solution, SolveError> {
    let options = NewtonOptions { tolerance: TOLERANCE, largest_update: 0.5, most_iterations: 12, exact_slope: true };
    solve(problem, start, &PathConstraint { weights: held.weights(), target }, &options, ws)
}

impl Adjoint {
    /// At an equilibrium of this problem; one transposed solve.
    pub(crate) fn new(problem: &BeamProblem, at: &State, held: Held, ws: &mut Workspace) -> Result<Self, SolveError> {
        let (system, grip) = (&*problem.system, &problem.grip);
        let constraint = PathConstraint { weights: held.weights(), target: 0.0 };
        let tangents = Tangents::new(problem, at, &constraint, ws)?;
        let mut right = Bordered { direction: vec![0.0; system.unknowns(at)], last: 0.0 };
        match held {
            Held::Displacement => right.last = 1.0,
            Held::Force => {
                right.last = grip.compliance;
                right.direction = grip.displacement_gradient(system, at);
            }
        }
        let solved = tangents.solve_transposed(&right, ws)?;
        let mut multipliers = solved.direction;
        multipliers.iter_mut().for_each(|multiplier| *multiplier *= -1.0);
        grip.turn_rows(system, at, &mut multipliers);
        let of_displacement = if held == Held::Force { 1.0 } else { -solved.last };
        Ok(Self { at: at.clone(), multipliers, of_displacement })
    }
}

/// The equilibrium at which what is not held turns, from one next to it, with where what is held is there: by the secant rule for its slope.
pub(super) fn turned(
    problem: &BeamProblem,
    start: State,
    held: Held,
    target: f64,
    ws: &mut Workspace,
) -> Result<(Solution, f64), SolveError> {
    let mut at = target;
    let mut here = solved(problem, start, held, at, ws)?;
    let mut ahead = BESIDE * target;
    for secant in 0..MOST_SECANTS {
        let next = solved(problem, here.moved(problem, ahead), held, at + ahead, ws)?;
        let (before, slope) = (held.slope(&here), held.slope(&next));
        (here, at) = (next, at + ahead);
        let further = -ahead * slope / (slope - before);
        // round-off once it does not close in any more
        let closes_in = further.abs() < CLOSING_IN * ahead.abs() || secant == 0;
        if !(closes_in && further.abs() > NEAR * target.abs() && further.abs() < FAR * target.abs()) {
            break;
        }
        ahead = further;
    }
    Ok((here, at))
}
