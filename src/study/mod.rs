//! Analyses: the whole peel of a model, sweeps over a parameter, tests, limit points followed, the path of a rod.
mod accuracy;
mod checkpoint;
mod displacement_controlled_test;
mod error_bounds;
mod initial;
mod limit_point_continuation;
mod peel;
mod peeling;
mod power_law;
mod rod;
mod stop_criteria;
mod sweep;
mod terms;
pub use crate::solve::LimitPointKind as Turn;
/// Order of the elements with which a point is followed.
pub use accuracy::ORDER as FOLLOWED_ORDER;
pub use accuracy::{Accuracy, Choice};
pub use checkpoint::Checkpoint;
pub use displacement_controlled_test::*;
pub use initial::*;
pub use limit_point_continuation::*;
pub use peel::*;
pub use peeling::{peel, peel_on};
pub use power_law::power_law;
pub use rod::{RodPath, RodTrouble, RodTurn, follow_rod};
pub use stop_criteria::{Bound, Stage, StopCheck, StopCriteria, StopReason};
pub use sweep::*;
pub use terms::{KeptReason, LeftOut, Term, TermDecisions, TermEffect, Terms};
