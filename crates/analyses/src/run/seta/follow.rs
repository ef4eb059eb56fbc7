//! A pull-off of which what was reached is kept where it takes long: an interrupted run goes on where it stopped.

use super::sampler::Sampler;
use crate::session::Session;
use peelkit::model::{SetaError, SetaModel};
use peelkit::study::coarsening::{TableLaw, TableRound, Visited};
use peelkit::study::{
    self, BeamsProgress, Bound, SetaEnd, SetaLoading, SetaOptions, SetaProgress, SetaPullOff, Stage, StopCriteria,
    StopReason,
};
use peelkit_report::{Journal, JournalKind, ReportError};
use peelkit_scene::{BoundsTable, Scene};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// Points from one state that is seen to the next.
const PIECE: usize = 2;

/// What is kept of a pull-off beside where it stands.
#[derive(Debug, Serialize, Deserialize)]
pub struct Seen {
    sampler: Sampler,
    /// Of tips that follow a table
    table: Option<SeenByTable>,
}

/// What pull-offs by a table that grows have come to.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct SeenByTable {
    /// Of the first table
    pub fingerprint: Option<u32>,
    /// Before the one that is under way
    pub rounds: Vec<TableRound>,
    /// In that one
    visited: Visited,
}

/// Where a pull-off is kept, and from where it goes on.
pub struct KeptSeta {
    journal: Journal,
    reached: Option<(SetaProgress, Seen)>,
    /// The same of a seta whose spatulae are beams
    of_beams: Option<(BeamsProgress, Sampler)>,
    taken: usize,
}

/// Under which what was reached is kept.
const REACHED: &str = "reached";
const OF_BEAMS: &str = "reached of beams";

impl KeptSeta {
    /// Where this session keeps what it finds, with what an earlier run of the scene has left there.
    pub fn open(session: &Session, scene: &Scene, sampler: &Sampler) -> Result<Self, ReportError> {
        // whatever its bounds, a pull-off has the same equilibria
        let unbound = Scene { bounds: BoundsTable::default(), ..scene.clone() };
        let journal = session.open(JournalKind::SETA, &unbound, &[])?;
        // the states that another number of them asks for are not among those that were seen
        let reached = journal.known::<(SetaProgress, Seen)>(&REACHED).filter(|(_, seen)| seen.sampler.is_like(sampler));
        let of_beams = journal.known::<(BeamsProgress, Sampler)>(&OF_BEAMS).filter(|(_, seen)| seen.is_like(sampler));
        let results = [reached.as_ref().map(|own| &own.0.result), of_beams.as_ref().map(|own| &own.0.result)];
        let taken = results.into_iter().flatten().map(|result| result.points.len()).sum();
        Ok(Self { journal, reached, of_beams, taken })
    }

    /// In which it is kept.
    pub fn journal(&self) -> &Journal {
        &self.journal
    }

    /// How many equilibria are those of an earlier run.
    pub fn taken(&self) -> usize {
        self.taken
    }

    /// What an earlier run has come to by a table; nothing where the table was another one, and the pull-off is begun anew.
    pub fn by_table(&mut self, fingerprint: Option<u32>) -> Vec<TableRound> {
        let of = |(_, seen): &(SetaProgress, Seen)| seen.table.as_ref().and_then(|table| table.fingerprint);
        if self.reached.as_ref().is_some_and(|kept| of(kept) != fingerprint) {
            (self.reached, self.taken) = (None, 0);
        }
        let table = self.reached.as_ref().and_then(|(_, seen)| seen.table.as_ref());
        table.map(|table| table.rounds.clone()).unwrap_or_default()
    }

    /// Where the tips have been outside of the table in the pull-off that is gone on with.
    pub fn visited(&self) -> Visited {
        let table = self.reached.as_ref().and_then(|(_, seen)| seen.table.as_ref());
        table.map(|table| table.visited.clone()).unwrap_or_default()
    }

    fn keep(&self, progress: &SetaProgress, seen: &Seen) {
        self.journal.keep(&REACHED, &(progress, seen));
    }

    /// What an earlier run of a seta of beams has come to.
    pub fn take_of_beams(&mut self) -> Option<(BeamsProgress, Sampler)> {
        self.of_beams.take()
    }

    pub fn keep_of_beams(&self, progress: &BeamsProgress, seen: &Sampler) {
        self.journal.keep(&OF_BEAMS, &(progress, seen));
    }
}

/// Whether the same command goes on with a pull-off.
pub fn is_unfinished(pull_off: &SetaPullOff) -> bool {
    matches!(pull_off.end, SetaEnd::Bound(Bound::Time { .. } | Bound::Interrupted))
}

/// The law of the tips as far as it changes with what is followed.
pub struct ByTable<'t> {
    /// Of the first table
    pub fingerprint: Option<u32>,
    /// By the tables before
    pub rounds: &'t [TableRound],
    /// By the table as it is
    pub law: &'t TableLaw,
}

impl ByTable<'_> {
    fn seen(&self) -> SeenByTable {
        let Self { fingerprint, rounds, law } = self;
        SeenByTable { fingerprint: *fingerprint, rounds: rounds.to_vec(), visited: law.visited() }
    }
}

/// The whole pull-off, from what was kept of it. It is followed piece by piece where states are seen or kept: the same to the last bit.
pub fn follow(
    (model, by_table): (&SetaModel, Option<&ByTable>),
    (loading, options): (&SetaLoading, &SetaOptions),
    stop: &StopCriteria,
    mut sampler: Sampler,
    kept: &mut KeptSeta,
    see: &mut dyn FnMut(&study::SetaPoint),
) -> Result<(SetaPullOff, Sampler), SetaError> {
    let mut reached = None;
    if let Some((progress, seen)) = kept.reached.take() {
        (reached, sampler) = (Some(progress), seen.sampler);
    }
    let mut last = Instant::now();
    loop {
        // where a piece ends does not depend on where the run was interrupted
        let before = reached.as_ref().map_or(0, |progress: &SetaProgress| progress.result.points.len());
        let piece = if sampler.sees() { (before / PIECE + 1) * PIECE } else { stop.points };
        let until = StopCriteria { points: piece.min(stop.points), ..stop.clone() };
        let due = Arc::new(AtomicBool::new(false));
        let until = if kept.journal.is_kept() { keeping(until, last, Arc::clone(&due)) } else { until };
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
            progress => {
                let seen = Seen { sampler, table: by_table.map(ByTable::seen) };
                if let Some(progress) = progress.filter(|_| is_unfinished(&pull_off)) {
                    kept.keep(&progress, &seen);
                }
                return Ok((pull_off, seen.sampler));
            }
        };
        if last.elapsed() >= JournalKind::SETA.interval {
            let seen = Seen { sampler, table: by_table.map(ByTable::seen) };
            kept.keep(&progress, &seen);
            sampler = seen.sampler;
            last = Instant::now();
        }
        reached = Some(progress);
    }
}

/// These criteria, and besides: a run is left for a moment when it is time to keep what it has reached.
fn keeping(stop: StopCriteria, last: Instant, due: Arc<AtomicBool>) -> StopCriteria {
    stop.or_when(move |stage| {
        let is_due = stage == Stage::Path && last.elapsed() >= JournalKind::SETA.interval;
        is_due.then(|| due.store(true, Ordering::Relaxed)).map(|()| StopReason::Interrupted)
    })
}
