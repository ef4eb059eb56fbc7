//! What the user asks of the numbers, how far bounds reach, where a path stops.
pub(super) mod accuracy;
pub(super) mod error_bounds;
pub(super) mod stop_criteria;
pub(super) mod terms;
