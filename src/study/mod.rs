//! Many runs: the whole peel of one scene, sweeps over a parameter.
mod follow;
mod peel;
mod peel_run;
mod plateau;
mod step_curve;
mod sweep;
mod trace;
pub mod verify;
mod work;
pub use crate::solve::Turn;
pub use peel::*;
pub use sweep::*;
