//! The path of `peel run`, of which every point is kept where it takes long: an interrupted run goes on where it stopped.

use super::progress::RunProgress;
use crate::interrupt::Interrupt;
use crate::output::OutArgs;
use peelkit::study::{self, Checkpoint, Peel};
use peelkit_report::{OutputFolder, PartialFile, PartialRun, ReportError};
use peelkit_scene::Scene;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// What a first Ctrl-C does.
const ANSWER: &str = "stopping at the next point of the path, then locating the limit points of what was reached; Ctrl-C again stops at once";

/// A run whose path points are kept.
pub struct KeptRun {
    folder: PathBuf,
    partial: PartialRun,
    interrupt: Interrupt,
    output: OutputFolder,
    /// Whether it was ended by Ctrl-C.
    pub interrupted: bool,
}

impl KeptRun {
    /// A folder in which a run is unfinished is one to go on with, unless it is begun afresh; any other that holds something is
    /// refused.
    pub fn open(
        out: &OutArgs,
        fresh: bool,
        folder: &Path,
        scene: &Scene,
        progress: &RunProgress,
    ) -> Result<Self, ReportError> {
        // before anything is written; nobody reads a message on a closed standard error
        let above = progress.clone();
        let interrupt = Interrupt::listen(move || above.above(|| drop(writeln!(io::stderr(), "{ANSWER}"))));
        let (partial, output) = out.claim_unfinished(folder, fresh, |dir| PartialRun::open(dir, scene))?;
        Ok(Self { folder: folder.to_path_buf(), partial, interrupt, output, interrupted: false })
    }

    /// Peels the scene, from what an earlier run has kept of it.
    pub fn peel(&mut self, scene: &Scene, progress: &RunProgress) -> Peel {
        let checkpoint = Checkpoint {
            taken: &|options| self.partial.taken(options),
            keep: &|options, waypoint| {
                progress.point(options, &waypoint);
                self.partial.keep(options, waypoint);
            },
        };
        let stop = progress.watch(self.interrupt.ends(scene.bounds.from_now()));
        let peel = study::peel_on(&scene.model, &scene.accuracy, &stop, &checkpoint);
        // nothing of what comes behind the path is kept
        self.interrupted = self.interrupt.quit_next() && peel.unfinished;
        peel
    }

    /// Writes the outputs. Then a run that is finished needs its points no more, and of one that is not all are kept: what is
    /// to be said of that.
    pub fn write(
        &self,
        peel: &Peel,
        write: impl FnOnce(&Path) -> Result<Vec<PathBuf>, ReportError>,
    ) -> (Result<Vec<PathBuf>, ReportError>, Option<String>) {
        let files = self.output.write(write);
        if !peel.unfinished {
            let files = files.and_then(|files| PartialRun::discard(&self.folder).map(|()| files));
            return (files, None);
        }
        match self.partial.write_all() {
            Ok(true) => (files, Some(format!("its points are kept in {}", self.partial.path().display()))),
            Ok(false) => (files, Some("it had no points to keep".into())),
            Err(error) => (files.and(Err(error)), None),
        }
    }

    /// How many points are those of an earlier run.
    pub fn taken(&self) -> usize {
        self.partial.points_taken()
    }
}
