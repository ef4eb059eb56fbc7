//! What a user gets: tables, pictures, summaries.

mod accuracy;
mod chart;
mod error;
mod figure;
mod figure_beam;
mod figure_levels;
mod figure_points;
mod figure_speed;
mod figure_stiffness;
mod figure_strip;
mod figure_verification;
mod figure_work;
mod file;
mod number;
mod partial;
mod picture_curve;
mod picture_followed;
mod picture_peel;
mod picture_shapes;
mod picture_sweep;
mod summary;
mod table;
mod verification;
mod work_precision;

pub use accuracy::{left_out, reached_accuracy};
pub use error::ReportError;
pub use figure::draw_figures;
pub use file::write_whole;
pub use partial::PartialSweep;
pub use picture_followed::draw_followed;
pub use picture_peel::draw_peel;
pub use picture_sweep::draw_sweep;
pub use summary::{PeelSummary, SweepSummary, end_reason, end_word};
pub use table::{SweepLine, write_curve, write_followed, write_limit_points, write_sweep};
pub use verification::{check_line, checks_json};
pub use work_precision::{AUTOMATIC, write_work_precision};
