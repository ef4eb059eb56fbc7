//! Many runs: the whole peel of one scene, sweeps over a parameter, the path of a rod.
mod follow;
mod peel;
mod peel_run;
mod plateau;
mod rod;
mod sweep;
mod trace;
pub mod verify;
pub use crate::solve::Turn;
pub use peel::*;
pub use rod::{RodPath, RodTrouble, RodTurn, follow_rod};
pub use sweep::*;
