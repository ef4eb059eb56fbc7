//! Motion in time of any [`DynamicSystem`]: the generalised-α rule, steps by their error, by stability and by events.
pub(crate) mod drive;
pub(crate) mod dynamic_system;
pub(crate) mod energy;
mod extrapolation;
pub(crate) mod integrator;
pub(crate) mod motion;
mod rule;
mod step;
pub use drive::{Drive, DriveRates, Ramp};
pub use dynamic_system::{DynamicProblem, DynamicSystem, MaterialRate, StepTerms, ViscousPower};
pub use energy::EnergyBalance;
pub use integrator::{Crossing, StepControl, StepEvent, TimeError, TimeIntegrator, TimeOptions};
pub use motion::Motion;
pub use rule::GeneralisedAlpha;
