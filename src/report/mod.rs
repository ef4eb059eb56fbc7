//! What a user gets: tables, pictures, summaries.
mod chart;
mod error;
mod picture_curve;
mod picture_peel;
mod picture_shapes;
mod picture_sweep;

pub use error::ReportError;
pub use picture_peel::draw_peel;
pub use picture_sweep::draw_sweep;

