//! Where a path starts: how the beam comes to lie on its ground, and what the grip does before the pull.
mod loading_steps;
mod settled_on_ground;

use crate::beam::GripState;
use crate::model::{Discretisation, PeelModel, PlanarProblem};
use crate::solve::{InitialState, ShouldStop};
use std::sync::Arc;

/// A problem whose path can be followed.
#[derive(Clone)]
pub struct Prepared {
    pub problem: PlanarProblem,
    /// The grip behind each step before the pull, as far as they were taken, seen from where it took hold.
    pub steps: Vec<GripState>,
}

/// What the solver is given, with the start of its path found: on ground that is not flat the beam has settled there, and the steps
/// before the pull have been taken. Where one of them has no end, the problem has [`InitialState::NoEquilibrium`], with the reason.
pub fn prepared(model: &PeelModel, how: Discretisation, should_stop: Option<ShouldStop>) -> Prepared {
    let mut problem = model.discretised(how, |_| {});
    if !model.ground.substrate.is_flat() {
        match settled_on_ground::settled_on_ground(&problem, &model.ground, model.reach(), &should_stop) {
            Ok(at) => problem.start_at(Arc::new(at)),
            Err(why) => {
                problem.start = InitialState::NoEquilibrium(format!(
                    "no equilibrium of the beam without a grip was found on the substrate: {why}. Try another substrate.start, or a \
                     stiffer beam"
                ));
            }
        }
    }
    let steps = loading_steps::take(model, &mut problem, should_stop);
    Prepared { problem, steps }
}
