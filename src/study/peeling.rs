//! The whole peel of a model, with the terms that are asked for.

use super::accuracy::Accuracy;
use super::checkpoint::Checkpoint;
use super::peel::result::Peel;
use super::refused;
use super::stop_criteria::StopCriteria;
use super::terms::term_selection;
use crate::model::check::error::ModelError;
use crate::model::peel::PeelModel;

/// Follows the peel from rest to its end. What went wrong on the way stands in [`Peel::end`]: a model or an accuracy that cannot be
/// computed ([`checked`]) ends as failed at once, with what is wrong and what would be right.
pub fn peel<'m, M>(model: &'m M, accuracy: &Accuracy, stop: &StopCriteria) -> Peel
where
    PeelModel: From<&'m M>,
{
    peel_on(model, accuracy, stop, &Checkpoint::NOTHING)
}

/// The same, with the points that an earlier run of the same model and accuracy has kept: bit for bit what [`peel`] finds. The stop
/// criteria may have changed.
pub fn peel_on<'m, M>(model: &'m M, accuracy: &Accuracy, stop: &StopCriteria, checkpoint: &Checkpoint) -> Peel
where
    PeelModel: From<&'m M>,
{
    let model: PeelModel = model.into();
    // what stays in the plane is solved there
    let model = model.in_the_plane().unwrap_or(model);
    match checked(&model, accuracy) {
        Ok(()) => term_selection::run(&model, accuracy, stop, checkpoint),
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
