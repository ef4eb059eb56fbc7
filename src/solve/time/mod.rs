//! Motion in time of any [`DynamicSystem`]: the generalised-α rule, steps by their error, by stability and by events.
pub(crate) mod drive;
pub(crate) mod dynamic_system;
pub(crate) mod integrator;
pub(crate) mod rule;
mod step;
pub use drive::{Drive, DriveRates, Ramp};
pub use dynamic_system::{DynamicProblem, DynamicSystem, EnergyBalance, MaterialRate, StepTerms, ViscousPower};
pub use integrator::{Crossing, StepControl, TimeError, TimeIntegrator, TimeOptions};
pub use rule::Motion;
