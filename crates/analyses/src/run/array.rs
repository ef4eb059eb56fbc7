//! The pull of the array of setae of a scene, event by event.

use super::asked::{self, Asked};
use crate::outcome::{Analysis, End, Outcome, Refusal, by};
use crate::session::Session;
use peelkit::study::Stage;
use peelkit::toe::{ArrayEnd, ArrayPull, SetaArray};
use peelkit_report::{self as report, ArraySummary, ReportError, timed};
use peelkit_scene::{ArrayTable, FittedSeta, Scene};
use std::io;
use std::path::{Path, PathBuf};

/// The pull of an array.
pub struct ArrayRun<'s> {
    scene: &'s Scene,
    table: &'s ArrayTable,
    array: Box<SetaArray>,
}

impl<'s> ArrayRun<'s> {
    /// Of a scene with a table `setae`.
    ///
    /// Fails where something is asked for that has no meaning for an array.
    pub fn of(scene: &'s Scene, asked: Asked) -> Result<Self, Refusal> {
        let options = [
            (asked.observed, "--observed", "curve.csv is already what a lift that only grows shows"),
            (asked.out_of_plane, "--out-of-plane", "its bands bend in their plane alone"),
            (asked.branch, "--branch", "its bands bend in their plane alone"),
            (asked.sensitivities, "--sensitivities", "the derivatives of its results are not computed"),
            (asked.animate, "--animate", "beams and setae alone are animated"),
            (asked.states.is_some(), "--states", "rows.csv has its rows at the peak"),
        ];
        asked::refuse(&options, "an array of setae", ".")?;
        let table = scene.array.as_ref().ok_or_else(|| Refusal::scene("it has no table [setae]", "Add one."))?;
        let array = scene.seta_array(table);
        let array = array.ok_or_else(|| match &table.fitted {
            Some(FittedSeta::Missing { .. }) => {
                Refusal::scene("the law of its setae is not made yet", "`peel run` makes it.")
            }
            _ => Refusal::scene("its setae stand on nothing", "Add [patch] or [lamella]."),
        })?;
        Ok(Self { scene, table, array: Box::new(array) })
    }
}

/// The pull of an array, as far as it went.
pub struct ArrayOutcome {
    /// The setae and what they stand on
    pub table: ArrayTable,
    /// Its events
    pub pull: ArrayPull,
    /// That they took
    pub seconds: f64,
    interrupted: bool,
}

impl Analysis for ArrayRun<'_> {
    type Found = ArrayOutcome;

    fn run(&self, session: &Session) -> Result<ArrayOutcome, Refusal> {
        session.stage("events of the array");
        let stop = session.stop(self.scene);
        let stopped = || stop.should_stop.as_ref().is_some_and(|asked| asked(Stage::Path).is_some());
        let (pull, seconds) = timed(|| self.array.pull(&stopped));
        let pull = pull.map_err(|error| Refusal::asked(error.to_string(), "Change the scene as it says."))?;
        Ok(ArrayOutcome { table: self.table.clone(), pull, seconds, interrupted: session.watcher.asked() })
    }
}

impl Outcome for ArrayOutcome {
    fn json(&self, scene: &Scene, command: Option<&str>) -> io::Result<String> {
        let summary = ArraySummary::new(scene, &self.table, &self.pull, self.seconds);
        by(summary, command, ArraySummary::with_command).to_json()
    }

    fn write(&self, scene: &Scene, dir: &Path, command: &str) -> Result<Vec<PathBuf>, ReportError> {
        let Self { table, pull, seconds, .. } = self;
        let mut files = vec![ArraySummary::new(scene, table, pull, *seconds).with_command(command).write(dir)?];
        files.extend(report::write_array_tables(dir, pull)?);
        files.push(report::write_parameters(dir, scene, command)?);
        if !pull.events.is_empty() {
            files.extend(report::draw_array(dir, table, pull, scene)?);
        }
        Ok(files)
    }

    fn end(&self) -> End {
        if self.pull.end == ArrayEnd::Stopped && self.interrupted {
            return End::Interrupted { done: None, short: None };
        }
        report::array_end_reason(&self.pull).map_or(End::Done, End::CutShort)
    }
}
