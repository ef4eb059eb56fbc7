//! What was found as one JSON object: summary.json, and what `--json` prints.

mod fit;
mod optimisation;
mod origin;
mod parameters;
mod tip;
mod uncertainty;
mod written;

pub use fit::FitSummary;
pub use optimisation::OptimisationSummary;
pub(crate) use origin::Origin;
pub(crate) use parameters::Parameters;
pub use tip::TipSummary;
pub(crate) use tip::pad_end_word;
pub use uncertainty::UncertaintySummary;
pub(crate) use written::written;
