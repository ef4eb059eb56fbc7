//! Tables in CSV.

mod fit;
mod optimisation;
mod table;
mod tip;
mod uncertainty;

pub use fit::write_fit;
pub use optimisation::write_history;
pub use table::write_table;
pub(crate) use tip::sheet_word;
pub use tip::write_tip_law;
pub use uncertainty::{write_samples, write_uncertainty};
