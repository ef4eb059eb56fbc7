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
mod refused;
mod rod;
mod sweep;
mod terms;
pub use crate::solve::LimitPointKind as Turn;
/// Order of the elements with which a point is followed.
pub use accuracy::ORDER as FOLLOWED_ORDER;
pub use accuracy::{ACCURACY_NUMBERS, Accuracy, Choice};
pub use checkpoint::Checkpoint as Keeping;
pub use checkpoint::Checkpoint;
pub use displacement_controlled_test::*;
pub use initial::{Prepared, prepared};
pub use limit_point_continuation::*;
pub use peel::*;
pub use peeling::{checked, peel, peel_on};
pub use power_law::power_law;
pub use rod::{RodPath, RodTrouble, RodTurn, follow_rod};
pub use sweep::*;
pub use terms::{KeptReason, LeftOut, NotTold, Term, TermDecisions, TermEffect, Terms};
