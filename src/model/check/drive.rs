//! Whether the grip can move as the scene prescribes.

use super::{Measured, ModelError, ModelErrorKind};
use crate::model::{Hold, Moved, PeelModel, Step};

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

/// That nothing turns the end in a grip that is free to turn, or under a load without a potential, and that a strip is lifted.
pub(super) fn check(model: &PeelModel) -> Result<(), ModelError> {
    let free = model.grip.rotation == Hold::Free;
    let turn = model.pull.turn;
    if turn != 0.0 && free {
        return Err(ModelError::new("drive.turn", ModelErrorKind::TurnOfFreeGrip { turn }));
    }
    if turn != 0.0 && !model.line_law().has_potential() {
        let found = Measured { value: turn, unit: "rad/nm" };
        return Err(ModelError::new("drive.turn", ModelErrorKind::TurnWithoutPotential { found }));
    }
    if let Some(&step) = model.steps.iter().find(|step| step.moves(Moved::Rotation)).filter(|_| free) {
        return Err(ModelError::new("drive.steps", ModelErrorKind::StepOfFreeGrip { step }));
    }
    let along = model.pull.direction().up.abs() < ALONG;
    if along && model.strip().is_some() && model.friction_law().is_none() {
        let degrees = model.pull.angle.to_degrees();
        return Err(ModelError::new("drive.angle", ModelErrorKind::AlongStrip { degrees }));
    }
    Ok(())
}
