//! Where a path starts: how the beam comes to lie on its ground, and what the grip does before the pull.
mod error;
mod loading_steps;
mod settled_on_ground;

pub use error::*;

use crate::beam::GripState;
use crate::model::{Discretisation, PeelModel, PlanarProblem};
use crate::solve::ShouldStop;
use std::sync::Arc;

/// A problem whose path can be followed.
#[derive(Clone)]
pub struct Prepared {
    /// With the start of its path
    pub problem: PlanarProblem,
    /// The grip behind each step before the pull, seen from where it took hold.
    pub steps: Vec<GripState>,
}

/// What the solver is given, with the start of its path found: on ground that is not flat the beam has settled there, and the steps
/// before the pull have been taken. The error says which of them has no end.
pub fn prepared(
    model: &PeelModel,
    how: Discretisation,
    should_stop: Option<ShouldStop>,
) -> Result<Prepared, NotPrepared> {
    let mut problem = model
        .discretised(how, |_| {})
        .map_err(|why| NotPrepared { why: NoEquilibrium::Order(why), steps: Vec::new() })?;
    if !model.ground.substrate.is_flat() {
        let at = settled_on_ground::settled_on_ground(&problem, &model.ground, model.contact_extent(), &should_stop)
            .map_err(|why| NotPrepared { why: NoEquilibrium::OnGround(why), steps: Vec::new() })?;
        problem.start_at(Arc::new(at));
    }
    match loading_steps::take(model, &mut problem, should_stop) {
        (steps, Ok(())) => Ok(Prepared { problem, steps }),
        (steps, Err(why)) => Err(NotPrepared { why, steps }),
    }
}
