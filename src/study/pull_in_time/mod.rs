//! A pull at a rate, followed in time: inertia, viscous material, and where the work goes.
mod result;
mod run;
mod settings;
pub use result::{InTimeFailure, InTimeFailureKind, InTimePeak, InTimePoint, PullInTime};
pub use run::{PullStart, pull_in_time, pull_in_time_from, pull_start};
pub use settings::{PullRate, TimeAccuracy, Until};
