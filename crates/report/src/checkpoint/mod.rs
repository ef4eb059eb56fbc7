//! What an unfinished command has found, kept in a file as it comes and taken up by the next one.

mod run;
mod sweep;

pub use run::PartialRun;
pub use sweep::PartialSweep;
