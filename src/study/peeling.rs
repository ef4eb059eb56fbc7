//! The whole peel of a model, with the terms that are asked for.

use super::{Accuracy, Bounds, Checkpoint, Peel, refused, terms};
use crate::model::{ModelError, PeelModel};

/// Follows the peel from rest to its end. What went wrong on the way stands in [`Peel::end`]: a model or an accuracy that cannot be
/// computed ([`checked`]) ends as failed at once, with what is wrong and what would be right.
pub fn peel<'m, M>(model: &'m M, accuracy: &Accuracy, bounds: &Bounds) -> Peel
where
    PeelModel: From<&'m M>,
{
    peel_on(model, accuracy, bounds, &Checkpoint::NOTHING)
}

/// The same, with the points that an earlier run of the same model and accuracy has kept: bit for bit what [`peel`] finds, but
/// for [`Peel::solve_s`]. Bounds may have changed; `bounds.time_s` begins anew.
pub fn peel_on<'m, M>(model: &'m M, accuracy: &Accuracy, bounds: &Bounds, keeping: &Checkpoint) -> Peel
where
    PeelModel: From<&'m M>,
{
    let model = model.into();
    match checked(&model, accuracy) {
        Ok(()) => terms::run(&model, accuracy, bounds, keeping),
        Err(error) => refused::peel(&model, accuracy, &error),
    }
}

/// Whether a model can be computed to an accuracy: what every analysis asks first.
///
/// # Errors
/// As [`PeelModel::check`] and [`Accuracy::check`].
pub fn checked(model: &PeelModel, accuracy: &Accuracy) -> Result<(), ModelError> {
    model.check()?;
    accuracy.check()
}
