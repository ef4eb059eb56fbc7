//! What each term of a model changes, and which of them a path is computed with.
pub(super) mod decision;
pub(super) mod effects;
mod first_order_change;
mod section_sampling;
pub(super) mod term_selection;
