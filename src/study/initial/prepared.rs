//! A problem with the start of its path found.

use super::error::{NoEquilibrium, NotPrepared, UnstableRest};
use super::stability::RelaxedStart;
use crate::beam::grip_state::StepsTaken;
use crate::beam::mesh::MeshKind;
use crate::model::peel::PeelModel;
use crate::model::problem::beam_problem::BeamProblem;
use crate::model::problem::build::Discretisation;
use crate::solve::workspace::ShouldStop;
use crate::study::initial::{loading_steps, settled, stability};
use std::sync::Arc;

/// A problem whose path can be followed.
#[derive(Clone)]
pub struct Prepared {
    /// With the start of its path
    pub problem: BeamProblem,
    /// The grip in the steps before the pull.
    pub steps: StepsTaken,
    /// Where the equilibrium next to the stress-free configuration is unstable: what it took to leave it.
    pub relaxed: Option<RelaxedStart>,
}

/// What the solver is given, with the start of its path found: on ground that is not flat the beam has settled there, from an unstable
/// equilibrium it has been relaxed to a stable one, and the steps before the pull have been taken. The error says which of them has no end,
/// or why the model has no stable state.
pub fn prepared(
    model: &PeelModel,
    how: Discretisation,
    should_stop: Option<ShouldStop>,
) -> Result<Prepared, NotPrepared> {
    let refused = |why: UnstableRest| NotPrepared { why: why.into(), steps: Box::default() };
    stability::check_bonded(model).map_err(refused)?;
    let discretised = |how: Discretisation| {
        let problem = model.discretised(how, |_| {});
        problem.map_err(|why| NotPrepared { why: NoEquilibrium::Order(why), steps: Box::default() })
    };
    let mut problem = discretised(how)?;
    if !model.ground.substrate.is_flat() {
        // it may touch anywhere
        let fixed = discretised(how.on(MeshKind::Graded))?;
        let at = settled::settled_on_ground(&fixed, &model.ground, model.contact_extent(), &should_stop)
            .map_err(|why| NotPrepared { why: NoEquilibrium::OnGround(why), steps: Box::default() })?;
        problem.start_at(Arc::new(at));
    }
    settled::settle_in_space(model, &mut problem, &should_stop);
    let relaxed = stability::stabilise(model, how, &mut problem, &should_stop).map_err(refused)?;
    match loading_steps::take(model, how, &mut problem, should_stop) {
        (steps, Ok(())) => Ok(Prepared { problem, steps, relaxed }),
        (steps, Err(why)) => Err(NotPrepared { why, steps: Box::new(steps) }),
    }
}
