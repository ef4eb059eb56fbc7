//! What an unfinished command has found, kept in a file as it comes and taken up by the next one.

mod lines;
mod run;
mod sweep;
mod uncertainty;

pub use run::PartialRun;
pub use sweep::PartialSweep;
pub use uncertainty::PartialUncertainty;
