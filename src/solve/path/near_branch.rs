//! Next to where a path branches, or where branches of it nearly meet: a step must not pass from one to another unnoticed.
//!
//! A pull that is not quite symmetric rounds a bifurcation off. The path from rest turns within a short way, and beside it another branch goes on nearly as
//! before: a step that is too long lands there.

use crate::solve::{Observables, Problem, Solution};
use serde::{Deserialize, Serialize};

/// A step that leads to another branch is shortened by this.
pub const SHORTER: f64 = 0.3;
/// Where it still does when it is this share of the first that did, the path does branch there.
const CROSSES: f64 = 1e-4;
/// Error wanted of a prediction, relative as in [`crate::solve::System::size`]: so little that neither branch can be taken for the other. Without it
/// two of nine strips in space that were drawn at random came to the peak of the branch that is not that of rest.
const TOLERANCE: f64 = 1e-5;
/// How far that reaches, over the first step that led to another branch.
const PAST: f64 = 3.0;
/// The step across a branch point, likewise.
const BEYOND: f64 = 0.1;

/// A place where a step has led to another branch.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct NearBranch {
    /// Where the step began.
    from: Observables,
    /// How far it led.
    first: f64,
}

impl NearBranch {
    /// The place ahead of a step that leads to another branch.
    pub fn ahead(problem: &Problem, newest: &Solution, next: &Solution) -> Self {
        let from = newest.observables;
        Self { from, first: problem.apart(&from, &next.observables) }
    }

    /// Whether a step that leads to another branch is so short that the path itself branches there.
    pub fn is_crossed(&self, problem: &Problem, newest: &Solution, next: &Solution) -> bool {
        problem.apart(&newest.observables, &next.observables) <= CROSSES * self.first
    }

    /// Whether a step leaves it behind.
    pub fn is_behind(&self, problem: &Problem, newest: &Solution, next: &Solution) -> bool {
        changes_branch(problem, newest, next) || problem.apart(&self.from, &next.observables) > PAST * self.first
    }

    /// The step across, along a slope, in what the weights measure: at the branch point itself no equilibrium is certain.
    pub fn step_across(&self, problem: &Problem, weights: &Observables, slope: &Observables) -> f64 {
        BEYOND * self.first * weights.dot(slope) / problem.apart(&Observables::default(), slope)
    }

    /// Error wanted of a prediction where `asked` suffices elsewhere.
    pub fn step_tolerance(near: Option<&Self>, asked: f64) -> f64 {
        near.map_or(asked, |_| asked.min(TOLERANCE))
    }
}

/// Whether a step has gone to another branch. On one branch the number of negative eigenvalues with the displacement held changes by an odd number
/// where the displacement turns, and with the force held where the force does: slopes and numbers come from the same elimination.
pub fn changes_branch(problem: &Problem, newest: &Solution, next: &Solution) -> bool {
    let turns = |before: f64, behind: f64| (before < 0.0) != (behind < 0.0);
    let odd = |before: usize, behind: usize| before.abs_diff(behind) % 2 == 1;
    let (from, to) = (&newest.slope, &next.slope);
    problem.system.is_conservative()
        && (odd(newest.negative, next.negative) != turns(from.displacement, to.displacement)
            || odd(newest.negative_load, next.negative_load) != turns(from.force, to.force))
}
