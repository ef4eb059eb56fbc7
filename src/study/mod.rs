//! Many runs: the whole peel of one scene, sweeps over a parameter, a point followed, the path of a rod.
mod anchor;
mod choice;
mod continuation;
mod follow;
mod follow_point;
mod followed;
mod peel;
mod peel_run;
mod plateau;
mod power_law;
mod rod;
mod step_curve;
mod sweep;
mod trace;
pub mod verify;
mod work;
mod work_precision;
pub use crate::solve::Turn;
/// Order of the elements with which a point is followed.
pub use choice::ORDER as FOLLOWED_ORDER;
pub use choice::{Accuracy, Choice};
pub use follow_point::follow_point;
pub use followed::*;
pub use peel::*;
pub use power_law::power_law;
pub use rod::{RodPath, RodTrouble, RodTurn, follow_rod};
pub use sweep::*;
pub use work_precision::{ASKED, Errors, Line, Trial, WorkPrecision, work_precision};
