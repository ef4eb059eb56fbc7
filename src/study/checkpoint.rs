//! How a run goes on from another one.
//!
//! The points of a path follow from the scene and the mesh alone: [`StopCriteria`] only say where it is left.
//! So a run that takes an earlier one's points and computes the rest gives what a single one would give, bit for bit.

use super::peel::result::PathEnd;
use super::stop_criteria::{Stage, StopCriteria};
use crate::solve::path::options::{PathOptions, Waypoint};
use crate::solve::workspace::ShouldStop;

/// Where the points of a run's paths come from and go to.
pub struct Checkpoint<'a> {
    /// The first points of the path with these options, as far as an earlier run of the same scene has kept them.
    pub taken: &'a dyn Fn(&PathOptions) -> Vec<Waypoint>,
    /// Is given each point behind those, as soon as it is computed.
    pub keep: &'a dyn Fn(&PathOptions, Waypoint),
}

impl Checkpoint<'_> {
    /// Of a run that begins at rest and keeps nothing.
    pub const NOTHING: Checkpoint<'static> = Checkpoint { taken: &|_| Vec::new(), keep: &|_, _| () };
}

/// What ends a run's paths before their end, and what it goes on from.
pub(super) struct Limits<'a> {
    pub stop: &'a StopCriteria,
    pub checkpoint: &'a Checkpoint<'a>,
}

impl Limits<'_> {
    /// Why a path is to be left where it is, although it goes on.
    pub fn reached(&self) -> Option<PathEnd> {
        self.stop.reached_bound(Stage::Path).map(PathEnd::Bound)
    }

    /// Says when limit points and work are no longer to be computed.
    pub fn should_stop(&self) -> Option<ShouldStop> {
        self.stop.for_solves(Stage::Results)
    }
}
