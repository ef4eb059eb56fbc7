//! What the user asks of the numbers, how far bounds reach, what is looked for on the way, where a path stops.
pub(super) mod accuracy;
pub(super) mod error_bounds;
pub(super) mod events;
pub(super) mod locator;
pub(super) mod measured;
pub(super) mod stop_criteria;
pub(super) mod terms;
