//! Tables in CSV.

mod curve;
mod fit;
mod optimisation;
mod sweep;
mod table;
mod tip;
mod uncertainty;

pub use curve::{curve_csv, write_branch, write_curve, write_equilibria, write_limit_points, write_observed};
pub use fit::write_fit;
pub use optimisation::write_history;
pub(crate) use sweep::write_with_named_values;
pub use sweep::{SweepLine, work_to, write_followed, write_sweep};
pub use table::write_table;
pub(crate) use tip::sheet_word;
pub use tip::write_tip_law;
pub use uncertainty::{write_samples, write_uncertainty};
