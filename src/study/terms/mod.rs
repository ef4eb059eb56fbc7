//! What each term of a model changes, and which of them a path is computed with.
pub(super) mod effects;
mod section_sampling;
pub(super) mod term_selection;
pub(super) mod warnings;
