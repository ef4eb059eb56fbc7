//! One path on one mesh: followed to its end, refined where the curve needs it, its limit points located.
mod first_integral;
pub(super) mod follow;
pub(super) mod followed;
mod limit_points;
mod model_end;
pub(crate) mod path_end;
mod path_refinement;
pub(crate) mod point_by_point;
mod slope_polishing;
