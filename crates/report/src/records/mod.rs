//! What is written of each result: its tables and its summary.json.

mod fit;
mod located;
mod model;
mod observed;
mod optimisation;
mod out_of_plane;
mod parameters;
mod path;
mod peel;
mod summary;
mod sweep;
mod tip;
mod uncertainty;

use crate::reference::Output;

pub use fit::{FitSummary, write_fit};
pub use model::{ground_warning, why_kept};
pub use observed::{ObservedSummary, write_observed};
pub use optimisation::{OptimisationSummary, Optimised, write_history};
pub(crate) use parameters::parameters;
pub use path::{GripOfPoint, curve_csv, write_branch, write_curve, write_equilibria, write_limit_points};
pub use peel::{PeelFound, PeelSummary, left_out};
pub use summary::{Found, SCHEMA, Summary, VERSION};
pub(crate) use sweep::write_swept;
pub use sweep::{Sweep, SweepLine, SweepSummary, work_to, write_followed, write_sweep};
pub use tip::{TipFound, TipSummary, write_tip_law};
pub(crate) use tip::{pad_end_word, sheet_word};
pub use uncertainty::{UncertainPeel, UncertaintySummary, write_samples, write_uncertainty};

/// What is written of peels, of their sweeps, and of what is made of many peels.
pub(crate) fn outputs() -> Vec<Output> {
    let peels = [peel::outputs(), path::outputs(), observed::outputs(), sweep::outputs()].concat();
    let of_many = [fit::outputs(), optimisation::outputs(), uncertainty::outputs(), tip::outputs()].concat();
    [peels, of_many].concat()
}
