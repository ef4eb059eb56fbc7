//! A sweep of peels of solids: its rows, sweep.csv, the same as one object, and the picture.

use super::summary::{solid_end_reason, solid_end_word};
use crate::chart::picture::Heading;
use crate::chart::style::colour;
use crate::pulls::swept_pulls::{Quantity, draw_swept_pulls};
use crate::records::of_many::sweep::{SweepSummary, write_swept};
use crate::swept::{PullRow, SweptKeys};
use crate::writing::error::ReportError;
use crate::writing::record::{Fields, Record};
use peelkit::study::{SolidLimitPoint, SolidPeel};
use peelkit_scene::Scene;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// A limit point of the peel of a solid, with the bound of the error of its force. nN, nm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SolidTurn {
    /// P there
    pub force: f64,
    /// Its bound, where it was solved on a finer mesh
    pub error: Option<f64>,
    /// u there
    pub displacement: f64,
}

impl From<&SolidLimitPoint> for SolidTurn {
    fn from(at: &SolidLimitPoint) -> Self {
        Self { force: at.force, error: at.errors.map(|errors| errors.force), displacement: at.displacement }
    }
}

/// The numbers of the peel of a solid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SolidResult {
    /// The largest force up to the first jump
    pub peak: Option<SolidTurn>,
    /// The first displacement limit point
    pub first_jump: Option<SolidTurn>,
    /// The name of its end
    pub end: String,
    /// Why it ended, if that was not by itself
    pub reason: Option<String>,
    /// Whether the computation stopped short
    pub has_failed: bool,
    /// Points of the path
    pub points: usize,
    /// Newton iterations
    pub newton_iterations: usize,
    /// Unknowns
    pub unknowns: usize,
}

impl From<&SolidPeel> for SolidResult {
    fn from(peel: &SolidPeel) -> Self {
        Self {
            peak: peel.peak().map(SolidTurn::from),
            first_jump: peel.snap_off().map(SolidTurn::from),
            end: solid_end_word(&peel.end).to_owned(),
            reason: solid_end_reason(&peel.end),
            has_failed: peel.end.has_failed(),
            points: peel.points.len(),
            newton_iterations: peel.iterations,
            unknowns: peel.body.unknowns(),
        }
    }
}

/// One value of a sweep of peels of solids.
pub type SolidRow = PullRow<SolidResult>;

// -- The table of a sweep of peels of solids, sweep.csv, and the same as one object --

impl Record for SolidRow {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("value", "the value of the key that was varied", |row| row.value);
        of.sometimes("value_2", "of the second key, where two are varied", |row| row.second);
        of.field("peak_force_nN", "the largest force of a load limit point up to the first jump", |row| row.of(|found| Some(found.peak?.force)));
        of.field("peak_error_nN", "bound of its error, by a finer mesh", |row| row.of(|found| found.peak?.error));
        of.field("peak_displacement_nm", "u there", |row| row.of(|found| Some(found.peak?.displacement)));
        of.field("first_jump_displacement_nm", "u at the first displacement limit point", |row| row.of(|found| Some(found.first_jump?.displacement)));
        of.field("first_jump_force_nN", "P there", |row| row.of(|found| Some(found.first_jump?.force)));
        of.field("end", "as in summary.json of a solid", |row| row.found.as_ref().map_or("failed", |found| found.end.as_str()));
        of.field("solve_s", "wall clock", |row| row.solve_s);
        of.field("points", "points of the path", |row| row.of(|found| Some(found.points)));
        of.field("newton_iterations", "Newton iterations", |row| row.of(|found| Some(found.newton_iterations)));
        of.field("unknowns", "unknowns of the strip in its grip", |row| row.of(|found| Some(found.unknowns)));
    }
}

/// Writes sweep.csv of a sweep of peels of solids: one row a value, or a pair of values.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_swept_solids(dir: &Path, keys: SweptKeys, rows: &[SolidRow]) -> Result<PathBuf, ReportError> {
    write_swept(dir, keys, rows.iter())
}

impl<'a> SweepSummary<'a, &'a SolidRow> {
    /// The summary of rows of peels of solids.
    pub fn of_solids(scene: &'a Scene, keys: SweptKeys<'a>, rows: &'a [SolidRow], remarks: &[String]) -> Self {
        Self::of_rows(scene, keys, rows.iter(), remarks)
    }
}

// -- The picture of a sweep of peels of solids: the peak against the varied value; or a map over two --

const QUANTITIES: [Quantity<SolidResult>; 1] = [Quantity {
    label: "peak force P (nN)",
    of: |row| row.of(|found| Some(found.peak?.force)),
    colour: colour::BLUE,
    height: 280.0,
    has_map: true,
}];

/// Draws `sweep.svg` and `sweep.png` into `dir`, on logarithmic axes where `log` is set.
///
/// Fails where no path has a peak, a value has no place on a logarithmic axis ([`ReportError::Draw`]), or a file cannot be written
/// ([`ReportError::Write`]).
pub fn draw_swept_solids<'h>(
    dir: &Path,
    keys: SweptKeys,
    rows: &[SolidRow],
    heading: impl Into<Heading<'h>>,
    log: [bool; 2],
) -> Result<Vec<PathBuf>, ReportError> {
    draw_swept_pulls(dir, keys, rows, (&QUANTITIES, "has a peak"), heading.into(), log)
}
