//! One path on one mesh: followed to its end, refined where the curve needs it, its limit points located.
mod first_integral;
mod follow;
mod followed;
mod limit_points;
mod model_end;
mod path_end;
mod path_refinement;
mod point_by_point;
mod slope_polishing;
pub(super) use follow::follow;
pub(super) use followed::Followed;
pub(in crate::study) use path_end::is_clear;
pub use point_by_point::PathPoints;
