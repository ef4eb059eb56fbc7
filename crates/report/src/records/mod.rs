//! What is written of each result: its tables and its summary.json.

mod parameters;
pub(crate) mod path;
mod summary;
pub(crate) mod sweep;

pub use path::{curve_csv, write_branch, write_curve, write_equilibria, write_limit_points};
pub use summary::{Found, SCHEMA, Summary, VERSION};
pub(crate) use sweep::write_swept;
pub use sweep::{Sweep, SweepLine, SweepSummary, work_to, write_followed, write_sweep};
