//! The path of a scene, point by point from what an earlier run has kept of it, and kept as it goes on.

use crate::session::{Progress, Session};
use peelkit::study::Checkpoint;
use peelkit_report::{Journal, JournalKind, ReportError};
use peelkit_scene::{BoundsTable, Scene};

/// Where the points of the path of a scene are kept: whatever its bounds, a path has the same points.
pub(super) fn open(scene: &Scene, session: &Session) -> Result<Journal, ReportError> {
    let (bounds, events) = (BoundsTable::default(), Vec::new());
    let unbound = Scene { bounds, stations: Vec::new(), events, ..scene.clone() };
    session.open(JournalKind::RUN, &unbound, &[])
}

/// What is computed on such a path, whose points the session sees.
pub(super) fn on<T>(journal: &Journal, session: &Session, compute: impl FnOnce(&Checkpoint) -> T) -> T {
    compute(&Checkpoint {
        taken: &|options| journal.sequence(options),
        keep: &|options, waypoint| {
            session.watcher.see(Progress::Point(options, &waypoint));
            journal.append(options, &waypoint);
        },
    })
}
