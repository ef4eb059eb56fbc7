//! What an unfinished command has found, kept in a file as it comes and taken up by the next one.

mod collection;
mod damaged;
mod growing_file;
mod lines;
mod optimisation;
mod part;
mod partial_file;
mod run;
mod seta;
mod sweep;
mod uncertainty;

pub use collection::PartialCollection;
pub use damaged::{Damaged, DamagedPart};
pub use optimisation::PartialOptimisation;
pub use part::{DividedSweep, Part, PartAxis, PartHeader, SweepPart};
pub use partial_file::PartialFile;
pub use run::PartialRun;
pub use seta::{PartialSeta, SetaCheckpoint};
pub use sweep::{PartialSweep, Storable};
pub use uncertainty::PartialUncertainty;
