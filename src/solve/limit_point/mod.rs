//! Limit points of a path: which steps hold them, where they are, how wrong that may be.
mod bracket;
mod kind;
pub(super) mod locate;
pub(super) mod search;
pub use bracket::brackets;
pub use kind::LimitPointKind;
pub use locate::{Located, ROUGH, difference_on_more_elements, locate, on_more_elements, solve_on, step_to, unlocated};
pub use search::{BendRule, Bends, FoundLimitPoint, LimitPointSearch};
