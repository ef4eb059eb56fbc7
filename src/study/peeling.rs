//! The whole peel of a model, with the terms that are asked for.

use super::{Accuracy, Checkpoint, Peel, StopCriteria, terms};
use crate::model::PeelModel;

/// Follows the peel from rest to its end. What went wrong on the way stands in [`Peel::end`].
pub fn peel<'m, M>(model: &'m M, accuracy: &Accuracy, stop: &StopCriteria) -> Peel
where
    PeelModel: From<&'m M>,
{
    terms::run(&model.into(), accuracy, stop, &Checkpoint::NOTHING)
}

/// The same, with the points that an earlier run of the same model and accuracy has kept: bit for bit what [`peel`] finds. The stop
/// criteria may have changed.
pub fn peel_on<'m, M>(model: &'m M, accuracy: &Accuracy, stop: &StopCriteria, keeping: &Checkpoint) -> Peel
where
    PeelModel: From<&'m M>,
{
    terms::run(&model.into(), accuracy, stop, keeping)
}
