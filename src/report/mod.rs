//! What a user gets: tables, pictures, summaries.
mod chart;
mod error;
mod figure;
mod figure_stiffness;
mod figure_strip;
mod figure_work;
mod file;
mod picture_curve;
mod picture_peel;
mod picture_shapes;
mod picture_sweep;

pub use error::ReportError;
pub use figure::draw_figures;
pub use file::write_whole;
pub use picture_peel::draw_peel;
pub use picture_sweep::draw_sweep;
