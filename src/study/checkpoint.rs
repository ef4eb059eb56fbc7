//! How a run is interrupted, and goes on in another one.
//!
//! The points of a path follow from the scene and the mesh alone: clock, bounds and interruptions only say where it is left.
//! So a run that takes an earlier one's points and computes the rest gives what a single one would give, bit for bit.

use super::{Bounds, End};
use crate::solve::{PathOptions, ShouldStop, Waypoint};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Where the points of a run's paths come from and go to, and whether it is to go on.
pub struct Checkpoint<'a> {
    /// The first points of the path with these options, as far as an earlier run of the same scene has kept them.
    pub taken: &'a dyn Fn(&PathOptions) -> Vec<Waypoint>,
    /// Is given each point behind those, as soon as it is computed.
    pub keep: &'a dyn Fn(&PathOptions, Waypoint),
    /// Is asked before each point; once it says no, the path ends there.
    pub go_on: &'a dyn Fn() -> bool,
}

impl Checkpoint<'_> {
    /// Of a run that begins at rest, keeps nothing and is not interrupted.
    pub const NOTHING: Checkpoint<'static> = Checkpoint { taken: &|_| Vec::new(), keep: &|_, _| (), go_on: &|| true };
}

/// How long a run may take.
pub(super) struct Limits<'a> {
    pub bounds: &'a Bounds,
    pub keeping: &'a Checkpoint<'a>,
    pub started: Instant,
}

impl Limits<'_> {
    /// Why a path is to be left where it is, although it goes on.
    pub fn reached(&self) -> Option<End> {
        let late = self.bounds.time_s.filter(|&most| self.started.elapsed().as_secs_f64() > most);
        match late {
            Some(most) => Some(End::Bound(format!("bounds.time = {most} s"))),
            None if (self.keeping.go_on)() => None,
            None => Some(End::Bound("interrupted".into())),
        }
    }

    /// Says when limit points and work are no longer to be computed: after as long again as the path may take, and a second.
    pub fn should_stop(&self) -> Option<ShouldStop> {
        let most = Duration::try_from_secs_f64(2.0 * self.bounds.time_s? + 1.0).ok()?;
        let deadline = self.started.checked_add(most)?;
        Some(Arc::new(move || Instant::now() > deadline))
    }
}
