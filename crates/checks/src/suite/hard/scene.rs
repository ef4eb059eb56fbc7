//! A hard scene as it was read, and how its path is expected to end.

use peelkit::model::PeelModel;
use peelkit::study::{Accuracy, PathEnd};
use peelkit_scene::Bounds;

/// How a path is expected to end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    Detached,
    Pivoting,
    TurnedBack,
    Sliding,
    Snapped,
    Bound,
    /// Stopped short, with a reason.
    Refused,
}

impl Ending {
    /// How a path did end; a refusal must give a reason.
    pub fn of(end: &PathEnd) -> Self {
        match end {
            PathEnd::Detached => Self::Detached,
            PathEnd::Pivoting => Self::Pivoting,
            PathEnd::TurnedBack => Self::TurnedBack,
            PathEnd::Sliding => Self::Sliding,
            PathEnd::Snapped => Self::Snapped,
            PathEnd::Bound(_) => Self::Bound,
            PathEnd::Failed(_) => Self::Refused,
        }
    }
}

/// A hard scene, read.
#[derive(Clone, Debug)]
pub struct HardScene {
    pub name: &'static str,
    pub model: PeelModel,
    pub accuracy: Accuracy,
    pub bounds: Bounds,
    pub expected: Ending,
}
