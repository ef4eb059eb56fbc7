//! How a beam of varying outline comes to lie on flat ground in space.
//!
//! Where its section is wide at the peeling front, the equilibrium in its vertical plane may be unstable: it leans to one side. So it is
//! relaxed without a force on the grip, from the stress-free configuration turned a little to the side to which it is pulled: a
//! mirror image of the pull leads to the mirror image of the peel.

use super::loading_steps::elements;
use crate::model::peel::PeelModel;
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::problem::InitialState;
use crate::solve::relax::{Held, RelaxOptions, disturbed_anyhow, relax};
use crate::solve::state::State;
use crate::solve::workspace::{ShouldStop, Workspace};
use std::sync::Arc;

/// Most that a step of relaxation moves, relative as in [`crate::solve::System::size`], and most steps.
const RELAXING: f64 = 0.3;
const MOST_STEPS: usize = 1000;
/// Elements of the steps before the pull, over those on which it comes to rest: the path, or the first step, begins with Newton's method on its own.
const COARSER: usize = 2;

/// Lets a path in space that would have to settle start in the stable equilibrium to which the beam relaxes; displacements count from
/// there. Where it does not come to rest the path settles by Newton's method, and says what is wrong if that fails too.
pub(super) fn settle(model: &PeelModel, problem: &mut BeamProblem, should_stop: &Option<ShouldStop>) {
    if problem.beam.spatial().is_none() || !matches!(problem.start, InitialState::Settling) {
        return;
    }
    let options = RelaxOptions { largest_update: RELAXING, most_steps: MOST_STEPS };
    let mut ws = Workspace::until(should_stop.clone());
    let elements = elements(model, problem);
    // on half as many elements first: on the others it is then next to where it comes to rest
    let leaning = |coarser: usize| disturbed_anyhow(problem, &problem.initial(elements / coarser));
    let mut relaxed = |from: State| relax(problem, from, Held::Force(0.0), &options, &mut ws);
    let roughly =
        relaxed(leaning(2 * COARSER)).map(|rest| problem.system.on_elements(&rest.solution.at, elements / COARSER));
    let at_rest = roughly.and_then(&mut relaxed).or_else(|_| relaxed(leaning(COARSER)));
    if let Ok(relaxed) = at_rest {
        let at = problem.system.on_elements(&relaxed.solution.at, elements);
        problem.start_at(Arc::new(at));
    }
}
