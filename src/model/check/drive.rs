//! Whether the grip can move as the scene prescribes.

use super::error::{Measured, ModelError, ModelErrorKind};
use crate::model::peel::{Hold, PeelModel};
use crate::model::step::{Moved, Step};

/// Most steps before the pull.
pub const MOST_STEPS: usize = 1000;
/// A pull is along a strip where the sine of its angle is less.
const ALONG: f64 = 1e-9;

/// Every step by itself, and how many there are.
pub(super) fn check_steps(steps: &[Step]) -> Result<(), ModelError> {
    let error = |kind| Err(ModelError::new("drive.steps", kind));
    if steps.len() > MOST_STEPS {
        return error(ModelErrorKind::TooManySteps { found: steps.len(), most: MOST_STEPS });
    }
    for (index, &step) in steps.iter().enumerate() {
        if let Err(wrong) = step.check() {
            return error(ModelErrorKind::Step { number: index + 1, step, wrong });
        }
    }
    Ok(())
}

/// That the grip holds every angle that a step turns, and that a strip in the plane is not moved out of it.
fn check_moved(model: &PeelModel) -> Result<(), ModelError> {
    let error = |kind| Err(ModelError::new("drive.steps", kind));
    for (step, moved) in model.steps.iter().filter_map(|&step| Some((step, step.motion()?.0))) {
        let (held, space) = match (moved, model.space) {
            (Moved::Rotation, _) => (("rotation", model.grip.rotation), model.space),
            (Moved::Roll, Some(space)) => (("roll", space.roll), Some(space)),
            (Moved::Yaw, Some(space)) => (("yaw", space.yaw), Some(space)),
            _ => (("", Hold::Fixed), model.space),
        };
        if moved.leaves_plane() && space.is_none() {
            return error(ModelErrorKind::StepOutOfPlane { step });
        }
        if let (held, Hold::Free) = held {
            return error(ModelErrorKind::StepOfFreeGrip { step, held });
        }
    }
    Ok(())
}

/// That nothing turns the end in a grip that is free to turn, or under a load without a potential, and that a strip is lifted.
pub(super) fn check(model: &PeelModel) -> Result<(), ModelError> {
    let free = model.grip.rotation == Hold::Free;
    let turn = model.pull.turn;
    if turn != 0.0 && free {
        return Err(ModelError::new("drive.turn", ModelErrorKind::TurnOfFreeGrip { turn }));
    }
    if turn != 0.0 && !model.has_potential() {
        let found = Measured { value: turn, unit: "rad/nm" };
        return Err(ModelError::new("drive.turn", ModelErrorKind::TurnWithoutPotential { found }));
    }
    check_moved(model)?;
    let along = model.pull.direction().up.abs() < ALONG;
    if along && model.strip().is_some() && model.tangential_stiffness().is_none() {
        let degrees = model.pull.angle.to_degrees();
        return Err(ModelError::new("drive.angle", ModelErrorKind::AlongStrip { degrees }));
    }
    Ok(())
}
