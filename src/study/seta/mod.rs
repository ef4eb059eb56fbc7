//! A seta pulled off the ground: the stable branches between the events at which tips detach or adhere again.
//!
//! Quasi-static: the root moves so slowly that the seta is in equilibrium but for the moments at which its equilibrium loses its stability.
//! Between events the work of the root is the change of the energy; at an event energy is released at a root that stands still.
mod advance;
pub(super) mod converged_peak;
#[cfg(test)]
mod gradient_flow;
mod knot;
pub(super) mod loading;
mod loss;
pub(super) mod of_beams;
pub(super) mod rest;
pub(super) mod result;
pub(super) mod run;
pub(super) mod spatula_curve;
pub(super) mod standing;
