//! What a user gets: tables, summaries, pictures.

mod error;
mod file;
mod number;
mod picture;
mod summary;
mod table;

pub use error::ReportError;
pub use file::write_whole;
pub use picture::{draw_figures, draw_peel, draw_sweep};
pub use summary::{PeelSummary, SweepSummary, end_reason, end_word};
pub use table::{SweepLine, write_curve, write_limit_points, write_sweep};
