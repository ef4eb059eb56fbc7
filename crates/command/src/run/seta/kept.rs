//! A pull-off of which what was reached is kept where it takes long: an interrupted run goes on where it stopped.

use super::sampler::Sampler;
use crate::output::OutArgs;
use peelkit::model::{SetaError, SetaModel};
use peelkit::study::{
    self, Bound, SetaEnd, SetaLoading, SetaOptions, SetaProgress, SetaPullOff, Stage, StopCriteria, StopReason,
};
use peelkit_report::{Existing, OutputFolder, PartialRun, PartialSeta, ReportError, SetaCheckpoint};
use peelkit_scene::Scene;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Nothing is written before a run has lasted so long, and then no oftener.
const INTERVAL: Duration = Duration::from_secs(1);
/// Points from one state that is seen to the next.
const PIECE: usize = 2;

/// Where a pull-off is kept, and from where it goes on.
pub struct KeptSeta {
    folder: PathBuf,
    output: OutputFolder,
    partial: PartialSeta,
    reached: Option<SetaCheckpoint<Sampler>>,
    taken: usize,
    /// Why nothing more is kept
    trouble: Option<ReportError>,
}

impl KeptSeta {
    /// A folder in which a run is unfinished is one to go on with, unless it is begun afresh; any other that holds something is refused.
    pub fn open(
        out: &OutArgs,
        fresh: bool,
        folder: &Path,
        scene: &Scene,
        sampler: &Sampler,
    ) -> Result<Self, ReportError> {
        let output = match PartialRun::is_in(folder) {
            true => OutputFolder::claim(folder, Existing::Replace)?,
            false => out.claim(folder)?,
        };
        if fresh {
            PartialRun::discard(folder)?;
        }
        let (partial, reached) = PartialSeta::open::<Sampler>(folder, scene)?;
        // the states that another number of them asks for are not among those that were seen
        let reached = reached.filter(|kept| kept.seen.is_like(sampler));
        let taken = reached.as_ref().map_or(0, |kept| kept.progress.result.points.len());
        Ok(Self { folder: folder.to_path_buf(), output, partial, reached, taken, trouble: None })
    }

    /// How many equilibria are those of an earlier run.
    pub fn taken(&self) -> usize {
        self.taken
    }

    fn keep(&mut self, progress: &SetaProgress, sampler: &Sampler) {
        if self.trouble.is_none() {
            self.trouble = self.partial.write(progress, sampler).err();
        }
    }

    /// Writes the outputs. Then a run that is finished needs no checkpoint any more; what is to be said of one that is not.
    pub fn write(
        &mut self,
        followed: &Followed,
        write: impl FnOnce(&Path) -> Result<Vec<PathBuf>, ReportError>,
    ) -> (Result<Vec<PathBuf>, ReportError>, Option<String>) {
        let files = self.output.write(write);
        let unfinished = matches!(followed.pull_off.end, SetaEnd::Bound(Bound::Time { .. } | Bound::Interrupted));
        match followed.progress.as_ref().filter(|_| unfinished) {
            None => (files.and_then(|files| PartialRun::discard(&self.folder).map(|()| files)), None),
            Some(progress) => {
                self.keep(progress, &followed.sampler);
                match self.trouble.take() {
                    None => (files, Some(format!("its equilibria are kept in {}", self.partial.path().display()))),
                    Some(error) => (files.and(Err(error)), None),
                }
            }
        }
    }
}

/// A pull-off as far as it goes, and what it takes to go on.
pub struct Followed {
    pub pull_off: SetaPullOff,
    pub progress: Option<SetaProgress>,
    pub sampler: Sampler,
}

/// The whole pull-off, from what was kept of it. It is followed piece by piece where states are seen or kept: the same to the last bit.
pub fn follow(
    model: &SetaModel,
    (loading, options): (&SetaLoading, &SetaOptions),
    stop: &StopCriteria,
    mut sampler: Sampler,
    mut kept: Option<&mut KeptSeta>,
    see: &mut dyn FnMut(&study::SetaPoint),
) -> Result<Followed, SetaError> {
    let mut reached = None;
    if let Some(SetaCheckpoint { progress, seen }) = kept.as_mut().and_then(|kept| kept.reached.take()) {
        (reached, sampler) = (Some(progress), seen);
    }
    let mut last = Instant::now();
    loop {
        // where a piece ends does not depend on where the run was interrupted
        let before = reached.as_ref().map_or(0, |progress: &SetaProgress| progress.result.points.len());
        let piece = if sampler.sees() { (before / PIECE + 1) * PIECE } else { stop.points };
        let until = StopCriteria { points: piece.min(stop.points), ..stop.clone() };
        let due = Arc::new(AtomicBool::new(false));
        let until = match kept {
            None => until,
            Some(_) => keeping(until, last, Arc::clone(&due)),
        };
        let (pull_off, progress) = study::pull_off_from(model, loading, options, &until, reached)?;
        if let Some(point) = pull_off.points.last() {
            see(point);
        }
        let is_seen =
            matches!(pull_off.end, SetaEnd::Bound(Bound::Points(_)) | SetaEnd::Completed | SetaEnd::Failed(_));
        if let Some(state) = pull_off.last.as_ref().filter(|_| is_seen) {
            sampler.see(state);
        }
        let goes_on = match &pull_off.end {
            SetaEnd::Bound(Bound::Points(most)) => *most < stop.points,
            SetaEnd::Bound(Bound::Interrupted) => due.load(Ordering::Relaxed),
            _ => false,
        };
        let progress = match progress {
            Some(progress) if goes_on => progress,
            progress => return Ok(Followed { pull_off, progress, sampler }),
        };
        if last.elapsed() >= INTERVAL {
            if let Some(kept) = &mut kept {
                kept.keep(&progress, &sampler);
            }
            last = Instant::now();
        }
        reached = Some(progress);
    }
}

/// These criteria, and besides: a run is left for a moment when it is time to keep what it has reached.
fn keeping(stop: StopCriteria, last: Instant, due: Arc<AtomicBool>) -> StopCriteria {
    stop.or_when(move |stage| {
        let is_due = stage == Stage::Path && last.elapsed() >= INTERVAL;
        is_due.then(|| due.store(true, Ordering::Relaxed)).map(|()| StopReason::Interrupted)
    })
}
