//! A seta pulled off the ground: the stable branches between the events at which tips detach or adhere again.
//!
//! Quasi-static: the root moves so slowly that the seta is in equilibrium but for the moments at which its equilibrium loses its stability.
//! Between events the work of the root is the change of the energy; at an event energy is released at a root that stands still.
mod failure;
mod loading;
mod result;
mod sections;
pub use failure::SetaFailure;
pub use loading::{SetaLoading, SetaStart, SetaStep, StepEnd};
pub use result::{JointPlace, SetaEffort, SetaEnd, SetaEvent, SetaPoint, SetaPullOff, SetaState, TipChange, TipState};
pub use sections::SetaBranch;
