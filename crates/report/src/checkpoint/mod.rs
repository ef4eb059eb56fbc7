//! What an unfinished command has found, kept in a file as it comes and taken up by the next one.

mod collection;
mod lines;
mod optimisation;
mod part;
mod run;
mod seta;
mod sweep;
mod uncertainty;

pub use collection::PartialCollection;
pub use optimisation::PartialOptimisation;
pub use part::{DividedSweep, Part, PartAxis, PartHeader, SweepPart};
pub use run::PartialRun;
pub use seta::{PartialSeta, SetaCheckpoint};
pub use sweep::{PartialSweep, Storable};
pub use uncertainty::PartialUncertainty;
