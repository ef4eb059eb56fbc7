//! What was found as one JSON object: summary.json, and what `--json` prints.

mod accuracy;
mod branch;
mod branch_point;
mod derived;
mod fit;
mod ground;
mod observed;
mod optimisation;
mod origin;
mod out_of_plane;
mod parameters;
mod peel;
mod place;
mod sensitivities;
mod sliding;
mod sweep;
mod term_summary;
mod tip;
mod uncertainty;
mod written;

pub use accuracy::left_out;
pub use fit::FitSummary;
pub use ground::ground_warning;
pub use observed::ObservedSummary;
pub use optimisation::OptimisationSummary;
pub use origin::{SCHEMA, VERSION};
pub(crate) use parameters::Parameters;
pub use peel::PeelSummary;
pub use sweep::SweepSummary;
pub use term_summary::why_kept;
pub use tip::TipSummary;
pub(crate) use tip::pad_end_word;
pub use uncertainty::UncertaintySummary;
pub(crate) use written::written;
