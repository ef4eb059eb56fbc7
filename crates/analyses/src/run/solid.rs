//! The peel of the body of a scene as a solid.

use super::asked::{self, Asked};
use super::kept_path;
use crate::outcome::{Analysis, End, Outcome, Refusal, by};
use crate::pulls::solid::peeled_on;
use crate::session::Session;
use peelkit::adhesion::HalfSpace;
use peelkit::model::LongElements;
use peelkit::study::{Checkpoint, SolidPeel, StopCriteria};
use peelkit_report::{self as report, Journal, JournalKind, PassedAt, ReportError, SolidSummary, timed};
use peelkit_scene::{Scene, SolidTable};
use std::io;
use std::path::{Path, PathBuf};

/// The peel of a body as a solid.
pub struct SolidRun<'s> {
    scene: &'s Scene,
    table: &'s SolidTable,
    states: Option<u32>,
}

impl<'s> SolidRun<'s> {
    /// Of a scene with a table `solid`.
    ///
    /// Fails where something is asked for that has no meaning for a solid.
    pub fn of(scene: &'s Scene, asked: Asked) -> Result<Self, Refusal> {
        let options = [
            (
                asked.observed,
                "--observed",
                "its path of equilibria alone is followed; the first jump stands in summary.json",
            ),
            (asked.out_of_plane, "--out-of-plane", "it is plane"),
            (asked.branch, "--branch", "it is plane"),
            (asked.sensitivities, "--sensitivities", "the derivatives of its results are not computed"),
            (asked.animate, "--animate", "beams and setae alone are animated"),
        ];
        asked::refuse(&options, "a solid", ", or remove [solid] from the scene to compute a beam.")?;
        let table = scene.solid.as_ref().ok_or_else(|| Refusal::scene("it has no table [solid]", "Add one."))?;
        Ok(Self { scene, table, states: asked.states })
    }
}

/// The peel of a solid, as far as it went.
pub struct SolidOutcome {
    /// The path
    pub peel: SolidPeel,
    /// Whether its elements are longer than the process zone
    pub long: Option<LongElements>,
    /// That the path and its limit points on a finer mesh took
    pub seconds: f64,
    /// Points that were taken from an earlier, unfinished run
    pub taken: usize,
    ground: HalfSpace,
    states: Option<u32>,
    journal: Journal,
    interrupted: bool,
}

impl Analysis for SolidRun<'_> {
    type Found = SolidOutcome;

    fn journal(&self) -> Option<JournalKind> {
        Some(JournalKind::RUN)
    }

    fn run(&self, session: &Session) -> Result<SolidOutcome, Refusal> {
        let Self { scene, table, states } = *self;
        let journal = kept_path::open(scene, session)?;
        let taken = journal.entries();
        session.stage("path of the solid");
        let stop = StopCriteria { events: scene.looked_for(), ..session.stop(scene) };
        let path = |checkpoint: &Checkpoint| peeled_on(scene, table, stop, checkpoint);
        let (peel, seconds) = timed(|| kept_path::on(&journal, session, path));
        let peel = peel.map_err(|error| Refusal::asked(error.to_string(), error.remedy()))?;
        Ok(SolidOutcome {
            peel,
            long: scene.solid_settings(table).long_elements(&scene.model),
            seconds,
            ground: scene.model.adhesion.half_space(),
            states,
            taken,
            journal,
            interrupted: session.watcher.asked(),
        })
    }
}

impl SolidOutcome {
    fn summary<'a>(&'a self, scene: &'a Scene) -> SolidSummary<'a> {
        SolidSummary::new(scene, &self.peel, self.long, self.seconds)
    }
}

impl Outcome for SolidOutcome {
    fn json(&self, scene: &Scene, command: Option<&str>) -> io::Result<String> {
        by(self.summary(scene), command, SolidSummary::with_command).to_json()
    }

    fn write(&self, scene: &Scene, dir: &Path, command: &str) -> Result<Vec<PathBuf>, ReportError> {
        let Self { peel, ground, .. } = self;
        let mut files = vec![self.summary(scene).with_command(command).write(dir)?];
        files.extend(report::write_solid_tables(dir, peel)?);
        let passed = PassedAt::of_solid(peel, &scene.looked_for());
        if !passed.is_empty() {
            files.push(report::write_passed(dir, &passed)?);
        }
        files.push(report::write_parameters(dir, scene, command)?);
        if peel.points.len() > 1 {
            files.extend(report::draw_solid(dir, (peel, &passed), ground, scene)?);
        }
        if let Some(count) = self.states {
            files.extend(report::write_solid_states(dir, peel, count as usize)?);
        }
        Ok(files)
    }

    fn end(&self) -> End {
        let end = &self.peel.end;
        match report::solid_end_reason(end).filter(|_| end.has_failed()) {
            _ if self.interrupted => End::Interrupted { done: None, short: None },
            Some(why) => End::CutShort(why),
            None => End::Done,
        }
    }

    fn kept(&self) -> Option<(&Journal, bool)> {
        Some((&self.journal, !self.peel.is_unfinished()))
    }
}
