//! A hard scene as it was read, and how its path is expected to end.

use peelkit::model::PeelModel;
use peelkit::study::{Accuracy, Bounds, End};

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
    pub fn of(end: &End) -> Self {
        match end {
            End::Detached => Self::Detached,
            End::Pivoting => Self::Pivoting,
            End::TurnedBack => Self::TurnedBack,
            End::Sliding => Self::Sliding,
            End::Snapped => Self::Snapped,
            End::Bound(_) => Self::Bound,
            End::Failed(_) => Self::Refused,
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
