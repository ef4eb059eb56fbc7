//! What an analysis gives of a model that it refuses.

use super::Accuracy;
use super::peel::{End, Peel, empty};
use crate::model::{ModelError, PeelModel};

/// A peel that was not begun.
pub(super) fn peel(model: &PeelModel, accuracy: &Accuracy, error: &ModelError) -> Peel {
    Peel { end: End::Failed(sentences(error)), asked: accuracy.relative, choice: accuracy.choice, ..empty(model) }
}

/// What is wrong, and what would be right.
pub(super) fn sentences(error: &ModelError) -> String {
    format!("{error}. {}", error.remedy())
}
