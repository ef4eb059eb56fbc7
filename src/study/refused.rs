//! What an analysis gives of a model that it refuses.

use super::Accuracy;
use super::peel::{Failure, PathEnd, Peel, empty};
use crate::model::{ModelError, PeelModel};

/// A peel that was not begun.
pub(super) fn peel(model: &PeelModel, accuracy: &Accuracy, error: &ModelError) -> Peel {
    let (end, asked) = (PathEnd::Failed(failure(error)), accuracy.relative);
    Peel { end, asked, choice: accuracy.choice, ..empty(model) }
}

/// That a model is refused.
pub(super) fn failure(error: &ModelError) -> Failure {
    Failure::Refused { key: error.key().into(), found: error.found(), remedy: error.remedy() }
}
