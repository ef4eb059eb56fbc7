//! One path on one mesh: followed to its end, refined where the curve needs it, its limit points located.
mod event_end;
pub(crate) mod follow;
mod limit_points;
pub(crate) mod path_end;
mod path_refinement;
