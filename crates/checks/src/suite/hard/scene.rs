//! A hard scene as it was read, and how its path is expected to end.

use peelkit::model::PeelModel;
use peelkit::study::{Accuracy, PathEnd};
use peelkit_scene::BoundsTable;

/// How a path is expected to end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// No point of the strip is near the substrate.
    Detached,
    /// At a force of zero, in edge contact.
    Pivoting,
    /// Behind a snap-off where the grip pushes.
    Pushing,
    /// Re-adhered: u has returned to 0.
    TurnedBack,
    /// The whole contact slides.
    Sliding,
    /// At the snap-off, beyond which the path is not determined.
    Snapped,
    /// Beyond its model: what is bonded is unstable, or a section is upright where the law has a pole.
    BeyondModel,
    /// A limit of the scene was reached.
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
            PathEnd::Pushing => Self::Pushing,
            PathEnd::TurnedBack | PathEnd::BackInPlane => Self::TurnedBack,
            PathEnd::Sliding => Self::Sliding,
            PathEnd::Snapped => Self::Snapped,
            PathEnd::BondedPartUnstable(_) | PathEnd::Upright(_) => Self::BeyondModel,
            PathEnd::Bound(_) => Self::Bound,
            PathEnd::Failed(_) => Self::Refused,
        }
    }
}

/// A hard scene, read.
#[derive(Clone, Debug)]
pub struct HardScene {
    /// The name of its file, without the ending.
    pub name: &'static str,
    /// What is peeled.
    pub model: PeelModel,
    /// The accuracy asked for.
    pub accuracy: Accuracy,
    /// Where its path stops.
    pub bounds: BoundsTable,
    /// How its path has to end.
    pub expected: Ending,
}
