//! A seta pulled off the ground: the stable branches between the events at which tips detach or adhere again.
//!
//! Quasi-static: the root moves so slowly that the seta is in equilibrium but for the moments at which its equilibrium loses its stability.
//! Between events the work of the root is the change of the energy; at an event energy is released at a root that stands still.
mod advance;
mod converged_peak;
mod critical;
mod failure;
#[cfg(test)]
mod gradient_flow;
mod knot;
mod loading;
mod loss;
mod maximum;
mod numbers;
mod options;
mod progress;
mod rest;
mod result;
mod run;
mod sections;
mod spatula_curve;
mod standing;
mod watched;
pub use converged_peak::{ConvergedPeak, converged_peak};
pub use failure::SetaFailure;
pub use loading::{SetaLoading, SetaStart, SetaStep, StepEnd};
pub use numbers::{SetaMoment, SetaResult};
pub use options::SetaOptions;
pub use progress::SetaProgress;
pub(super) use rest::{Rested, come_to_rest, share_of_change};
pub use result::{
    EventCause, JointPlace, LocationError, SetaEffort, SetaEnd, SetaEvent, SetaPoint, SetaPullOff, SetaState,
    TipChange, TipState,
};
pub use run::{pull_off, pull_off_from};
pub use sections::SetaBranch;
pub use spatula_curve::{SpatulaCurveError, tip_curve};
pub(super) use standing::{RootDrive, Standing, TipTangent};
