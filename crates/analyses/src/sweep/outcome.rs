//! The rows of a sweep, and what is written and said of them.

use super::cases::Cases;
use super::failed::{failed, failed_peels, failed_pulls};
use super::no_effect;
use crate::outcome::{End, Outcome, by};
use peelkit::study::{FollowedSweep, Remark, SetaResult};
use peelkit_report::{
    self as report, Journal, PartHeader, PullRow, RateResult, Record, ReportError, SolidResult, SweepPart, SweepRow,
    SweepSummary, SweptArray, SweptKeys, seta_end_reason,
};
use peelkit_scene::Scene;
use std::io;
use std::path::{Path, PathBuf};

/// The rows of a sweep, by what each value is.
pub enum Rows {
    /// A peel
    Peels(Vec<SweepRow>),
    /// The pull-off of a seta
    Setae(Vec<PullRow<SetaResult>>),
    /// The peel of a solid
    Solids(Vec<PullRow<SolidResult>>),
    /// The pull of an array of setae
    Arrays(Vec<SweptArray>),
    /// A pull at a rate
    Rates(Vec<PullRow<RateResult>>),
    /// A point that is followed, with the seconds that each took
    Followed(FollowedSweep, Vec<f64>),
}

/// What a sweep has found.
pub struct SweepOutcome {
    /// What was varied
    pub keys: SweptKeys<'static>,
    /// Whether the axis of each key is logarithmic
    pub log: [bool; 2],
    /// In the order of the values; where it was asked to stop some are missing
    pub rows: Rows,
    /// What is to be said of the rows
    pub remarks: Vec<String>,
    /// How many values there are
    pub(super) values: usize,
    pub(super) part: Option<PartHeader>,
    pub(super) journal: Option<Journal>,
}

impl SweepOutcome {
    /// Of rows that were found of these cases, with remarks, to which those about the rows come.
    pub fn of(cases: &Cases, rows: Rows, mut remarks: Vec<String>) -> Self {
        let keys = cases.keys;
        remarks.extend(match &rows {
            Rows::Peels(rows) => no_effect::seen(keys, rows),
            Rows::Setae(rows) => no_effect::of_alike(keys, rows.len(), alike(rows)),
            Rows::Solids(rows) => no_effect::of_alike(keys, rows.len(), alike(rows)),
            Rows::Arrays(rows) => no_effect::of_alike(keys, rows.len(), alike(rows)),
            Rows::Rates(rows) => no_effect::of_alike(keys, rows.len(), alike(rows)),
            Rows::Followed(..) => None,
        });
        Self { keys, log: cases.log, rows, remarks, values: cases.all.len(), part: None, journal: None }
    }

    /// Rows that were computed, of so many values.
    fn done(&self) -> [usize; 2] {
        let rows = match &self.rows {
            Rows::Peels(rows) => rows.len(),
            Rows::Setae(rows) => rows.len(),
            Rows::Solids(rows) => rows.len(),
            Rows::Arrays(rows) => rows.len(),
            Rows::Rates(rows) => rows.len(),
            // it is not stopped
            Rows::Followed(..) => self.values,
        };
        [rows, self.values]
    }

    /// The values whose computation stopped short, with their reasons.
    pub fn failed(&self) -> Option<String> {
        match &self.rows {
            Rows::Peels(rows) => failed_peels(self.keys, rows),
            Rows::Setae(rows) => {
                failed_pulls(self.keys, rows, |found| seta_end_reason(&found.end).filter(|_| found.end.is_failure()))
            }
            Rows::Solids(rows) => {
                failed_pulls(self.keys, rows, |found| found.reason.clone().filter(|_| found.has_failed))
            }
            Rows::Arrays(rows) => failed_pulls(self.keys, rows, |_| None),
            Rows::Rates(rows) => failed_pulls(self.keys, rows, |found| found.failed.clone()),
            Rows::Followed(sweep, _) => {
                let lost = |remark: &&Remark| matches!(remark, Remark::NotFound { .. });
                let reasons: Vec<String> = sweep.remarks.iter().filter(lost).map(ToString::to_string).collect();
                failed(&reasons, sweep.rows.len())
            }
        }
    }

    fn write_table(&self, dir: &Path) -> Result<PathBuf, ReportError> {
        match &self.rows {
            Rows::Peels(rows) => report::write_sweep(dir, self.keys, rows),
            Rows::Setae(rows) => report::write_swept_setae(dir, self.keys, rows),
            Rows::Solids(rows) => report::write_swept_solids(dir, self.keys, rows),
            Rows::Arrays(rows) => report::write_swept_arrays(dir, self.keys, rows),
            Rows::Rates(rows) => report::write_swept_rates(dir, self.keys, rows),
            Rows::Followed(sweep, seconds) => report::write_followed(dir, self.keys.first, sweep, seconds),
        }
    }

    /// The pictures, where there is something to draw.
    fn draw(&self, dir: &Path, scene: &Scene) -> Result<Vec<PathBuf>, ReportError> {
        let Self { keys, log, .. } = *self;
        let first = keys.first.path();
        match &self.rows {
            Rows::Peels(rows) if rows.iter().any(|row| row.found.peak.is_some()) => match keys.second {
                None => report::draw_sweep(rows, &first, scene, log[0], dir),
                Some(_) => report::draw_plane(rows, keys, scene, log, dir),
            },
            Rows::Setae(rows) if rows.iter().any(|row| row.found.as_ref().is_ok_and(|found| found.peak.is_some())) => {
                report::draw_swept_setae(dir, keys, rows, scene, log)
            }
            Rows::Solids(rows) if rows.iter().any(|row| row.found.as_ref().is_ok_and(|found| found.peak.is_some())) => {
                report::draw_swept_solids(dir, keys, rows, scene, log)
            }
            Rows::Arrays(rows) if rows.iter().any(|row| row.found.is_ok()) => {
                report::draw_swept_arrays(dir, keys, rows, scene, log)
            }
            Rows::Rates(rows)
                if rows.iter().any(|row| row.found.as_ref().is_ok_and(|found| found.failed.is_none())) =>
            {
                report::draw_swept_rates(dir, keys, rows, scene, log)
            }
            Rows::Followed(sweep, _) if sweep.rows.iter().any(|row| row.point.is_some()) => {
                report::draw_followed(sweep, &first, scene, log[0], dir)
            }
            _ => Ok(Vec::new()),
        }
    }
}

/// Whether all values gave the same.
fn alike<F: PartialEq>(rows: &[PullRow<F>]) -> bool {
    rows.len() > 1 && rows.iter().all(|row| row.found.is_ok() && row.found == rows[0].found)
}

fn text<L: Record>(summary: SweepSummary<L>, command: Option<&str>) -> io::Result<String> {
    by(summary, command, SweepSummary::with_command).to_json()
}

impl Outcome for SweepOutcome {
    fn json(&self, scene: &Scene, command: Option<&str>) -> io::Result<String> {
        let (keys, remarks) = (self.keys, &self.remarks);
        match &self.rows {
            Rows::Peels(rows) => text(SweepSummary::new(scene, keys, rows, remarks), command),
            Rows::Setae(rows) => text(SweepSummary::of_setae(scene, keys, rows, remarks), command),
            Rows::Solids(rows) => text(SweepSummary::of_solids(scene, keys, rows, remarks), command),
            Rows::Arrays(rows) => text(SweepSummary::of_arrays(scene, keys, rows, remarks), command),
            Rows::Rates(rows) => text(SweepSummary::of_rates(scene, keys, rows, remarks), command),
            Rows::Followed(sweep, seconds) => text(SweepSummary::followed(scene, keys.first, sweep, seconds), command),
        }
    }

    fn write(&self, scene: &Scene, dir: &Path, command: &str) -> Result<Vec<PathBuf>, ReportError> {
        let mut files = vec![self.write_table(dir)?, report::write_parameters(dir, scene, command)?];
        match (&self.part, &self.rows) {
            // a part has no pictures, but what `peel collect` needs
            (Some(header), Rows::Peels(rows)) => files.push(SweepPart::write(dir, header, rows)?),
            _ => files.extend(self.draw(dir, scene)?),
        }
        Ok(files)
    }

    fn end(&self) -> End {
        End::of_many(self.done(), "values", self.failed())
    }

    fn is_written(&self) -> bool {
        self.done()[0] > 0
    }

    fn kept(&self) -> Option<(&Journal, bool)> {
        let [rows, values] = self.done();
        Some((self.journal.as_ref()?, rows == values))
    }
}
