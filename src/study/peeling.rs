//! The whole peel of a model, with the terms that are asked for.

use super::{Accuracy, Bounds, Checkpoint, Peel, terms};
use crate::model::PeelModel;

/// Follows the peel from rest to its end. What went wrong on the way stands in [`Peel::end`].
pub fn peel<'m, M>(model: &'m M, accuracy: &Accuracy, bounds: &Bounds) -> Peel
where
    PeelModel: From<&'m M>,
{
    terms::run(&model.into(), accuracy, bounds, &Checkpoint::NOTHING)
}

/// The same, with the points that an earlier run of the same model and accuracy has kept: bit for bit what [`peel`] finds, but
/// for [`Peel::solve_s`]. Bounds may have changed; `bounds.time_s` begins anew.
pub fn peel_on<'m, M>(model: &'m M, accuracy: &Accuracy, bounds: &Bounds, keeping: &Checkpoint) -> Peel
where
    PeelModel: From<&'m M>,
{
    terms::run(&model.into(), accuracy, bounds, keeping)
}
