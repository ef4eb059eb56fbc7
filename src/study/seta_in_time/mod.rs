//! A seta whose root is pulled at a rate: branches of viscous material, tips that leave their branch at events. With mass or without.
mod events;
mod result;
mod run;
mod settings;
pub use result::{SetaInTime, SetaInTimeEvent, SetaInTimeFailure, SetaInTimeFailureKind, SetaInTimePoint, TipLoss};
pub use run::pull_seta_in_time;
pub use settings::{SetaPullRate, SetaTimeAccuracy};
