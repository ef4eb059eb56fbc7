//! Beams in space.

mod bend;
mod buckling;
mod convergence;
mod density;
mod helix;
mod invariance;
mod peels;
mod plane;
pub mod setup;
mod spring;
mod tangents;
mod turns;
