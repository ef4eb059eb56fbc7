//! Equilibria of a strip in space whose grip is held at a roll, and those of them at which that takes no torque.
//!
//! With its roll held a strip is stable at the branch point as well: these equilibria are regular on either side of it,
//! and for a roll of zero they are the planar path. The torque on the roll a is T(σ, a) = m(σ) a + O(a³) along the path
//! σ, m the moment that rolls the grip by one. So T = 0 has two solutions: a = 0, and the branch, σ = σ* + O(a²).

use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::error::SolveError;
use crate::solve::newton::{NewtonOptions, Solution, solve};
use crate::solve::observables::{Observables, PathConstraint};
use crate::solve::state::State;
use crate::solve::workspace::Workspace;

/// Most solves until the torque is zero.
const MOST_SOLVES: usize = 14;
/// It is zero where what is left to go along the path is this share of the place.
const FOUND: f64 = 1e-13;
/// Where it does not come nearer than this share any more, that is round-off.
const ROUND_OFF: f64 = 1e-9;
/// Error of a solution, relative as in [`crate::solve::System::size`].
const FINE: f64 = 1e-12;

/// A strip whose grip is held at a roll, by a constraint along its path.
pub(super) struct RolledStrip<'p> {
    /// Of a grip whose roll is an unknown
    pub problem: &'p BeamProblem,
    /// Of the path constraint
    pub weights: Observables,
}

/// An equilibrium of it.
pub(super) struct Rolled {
    pub solution: Solution,
    /// What the grip exerts on the roll, nN·nm
    pub torque: f64,
    /// weights · observables
    pub target: f64,
}

impl RolledStrip<'_> {
    /// With the grip held at `roll` (rad), at `target` along the path.
    pub fn held(&self, start: State, roll: f64, target: f64, ws: &mut Workspace) -> Result<Rolled, SolveError> {
        let problem = self.problem.with_roll(Some(roll));
        let options = NewtonOptions { tolerance: FINE, largest_update: 0.5, most_iterations: 14, exact_slope: true };
        let solution = solve(&problem, start, &PathConstraint { weights: self.weights, target }, &options, ws)?;
        let torque = problem.spatial_grip(&solution.at).map_or(f64::NAN, |grip| grip.torque);
        Ok(Rolled { solution, torque, target })
    }

    /// The one next to `start` that takes no torque, by the secant rule; `slope`: dm/dσ.
    pub fn without_torque(
        &self,
        start: State,
        roll: f64,
        target: f64,
        slope: f64,
        ws: &mut Workspace,
    ) -> Result<Rolled, SolveError> {
        let problem = self.problem.with_roll(Some(roll));
        let mut found = self.held(start, roll, target, ws)?;
        let (mut slope, mut before) = (slope * roll, f64::INFINITY);
        for _ in 0..MOST_SOLVES {
            let ahead = -found.torque / slope;
            let share = (ahead / found.target).abs();
            if share <= FOUND || (share <= ROUND_OFF && share >= 0.5 * before) {
                return Ok(found);
            }
            if !ahead.is_finite() {
                break;
            }
            before = share;
            let next = self.held(found.solution.moved(&problem, ahead), roll, found.target + ahead, ws)?;
            // nearer than that the change of the torque is round-off
            slope = if share > ROUND_OFF { (next.torque - found.torque) / ahead } else { slope };
            found = next;
        }
        Err(SolveError::NotConverged { update: before, iterations: MOST_SOLVES })
    }
}
