//! A path that has been followed.

use crate::solve::newton::Solution;
use crate::solve::points::kind::LimitPointKind;
use crate::solve::points::locate::Located;
use crate::solve::workspace::{Pace, ShouldStop, Workspace};
use crate::study::peel::failure::PathFailure;
use crate::study::peel::result::PathEnd;
use std::sync::Arc;

/// A path with its limit points.
pub(in crate::study::peel) struct Followed {
    pub points: Vec<Arc<Solution>>,
    /// In path order, each with the index of the point before it.
    pub turns: Vec<(LimitPointKind, usize, Located)>,
    /// Where an eigenvalue passes through zero although the displacement does not turn, likewise.
    pub branch_points: Vec<(usize, Located)>,
    pub end: PathEnd,
    /// Whether time or the user ended it.
    pub cut: bool,
    pub iterations: usize,
    /// Whether it ended with the strip upright, where an eigenvalue is zero by symmetry.
    pub upright: bool,
    /// Load limit points left out because the force hardly changes between them.
    pub ripple: usize,
    /// Whether the first maximum of the force is so level that no place on it has more than others: nothing is missed
    /// where its place is not known.
    pub level: bool,
    /// Largest spread of the first integral along the beam at any point, over the work of adhesion.
    pub spread: f64,
    /// The end that the model gives where the path cannot be continued.
    pub beyond: Option<PathEnd>,
    /// Why the path cannot be used, if it cannot.
    pub trouble: Option<PathFailure>,
    /// At which pace it was followed, and is looked around on.
    pub pace: Pace,
    /// Says when its limit points and its work are no longer to be computed.
    pub(super) should_stop: Option<ShouldStop>,
}

impl Followed {
    /// What looks around on the path with, until it is late.
    pub(in crate::study::peel) fn workspace(&self) -> Workspace {
        Workspace::until(self.should_stop.clone()).at(self.pace)
    }

    /// What came out too late may be a ripple that is a turn, or an interpolant for a solution: to be asked in the end.
    pub(in crate::study::peel) fn late(&self) -> Option<PathFailure> {
        self.workspace().is_stopped().then_some(PathFailure::OutOfTime)
    }
}
