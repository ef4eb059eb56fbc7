//! What an analysis gives of a model that it refuses.

use super::accuracy::Accuracy;
use super::peel::assembly::empty;
use super::peel::failure::Failure;
use super::peel::result::{PathEnd, Peel};
use crate::model::check::error::ModelError;
use crate::model::peel::PeelModel;

/// A peel that was not begun.
pub(super) fn peel(model: &PeelModel, accuracy: &Accuracy, error: &ModelError) -> Peel {
    let (end, asked) = (PathEnd::Failed(failure(error)), accuracy.relative);
    Peel { end, asked, choice: accuracy.choice, ..empty(model) }
}

/// That a model is refused.
pub(super) fn failure(error: &ModelError) -> Failure {
    Failure::Refused { key: error.key().into(), found: error.found(), remedy: error.remedy() }
}
