//! What is written of each result: its tables and its summary.json.

mod located;
mod model;
pub(crate) mod observed;
mod out_of_plane;
mod parameters;
pub(crate) mod path;
pub(crate) mod peel;
mod summary;
pub(crate) mod sweep;

pub use model::{ground_warning, why_kept};
pub use observed::{ObservedSummary, write_observed};
pub use path::{curve_csv, write_branch, write_curve, write_equilibria, write_limit_points};
pub use peel::{PeelFound, PeelSummary, left_out};
pub use summary::{Found, SCHEMA, Summary, VERSION};
pub(crate) use sweep::write_swept;
pub use sweep::{Sweep, SweepLine, SweepSummary, work_to, write_followed, write_sweep};
