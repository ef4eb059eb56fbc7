//! What a user gets: tables, pictures, summaries, and checkpoints of what is not finished.

#![forbid(unsafe_code)]
#![warn(missing_docs)]

mod animation;
pub mod chart;
mod checkpoint;
mod error;
mod file;
mod folder;
mod names;
mod number;
pub mod overlay;
pub mod pictures;
mod summary;
mod sweep_row;
mod tables;
mod timing;

pub use animation::write_animation;
pub use checkpoint::{PartialRun, PartialSweep};
pub use error::ReportError;
pub use file::write_whole;
pub use folder::{Existing, OutputFolder};
pub use names::{end_reason, end_word, form_word, jump_word, test_end_reason, test_end_word};
pub use number::{Finite, to_json};
pub use pictures::{draw_followed, draw_observed, draw_peel, draw_sweep};
pub use summary::{PeelSummary, SweepSummary, ground_warning, left_out, why_kept};
pub use sweep_row::SweepRow;
pub use tables::{
    SweepLine, work_to, write_curve, write_followed, write_limit_points, write_observed, write_sweep, write_table,
};
pub use timing::timed;
