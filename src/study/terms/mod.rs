//! What each term of a model changes, and which of them a path is computed with.
mod decision;
mod effects;
mod first_order_change;
mod section_sampling;
mod term_selection;
pub use decision::{KeptReason, LeftOut, NotEstimated, Term, TermDecisions, Terms};
pub use effects::TermEffect;
pub(super) use term_selection::run;
