//! A sweep of pulls of arrays: its rows, sweep.csv, the same as one object, and the picture.

use super::summary::{array_end_reason, array_end_word};
use crate::chart::picture::Heading;
use crate::chart::style::colour;
use crate::pulls::swept_pulls::{Quantity, draw_swept_pulls};
use crate::records::of_many::sweep::{SweepSummary, write_swept};
use crate::swept::{PullRow, SweptKeys};
use crate::writing::error::ReportError;
use crate::writing::record::{Fields, Record};
use peelkit::toe::ArrayPull;
use peelkit_scene::{ArrayTable, BandLoad, Scene};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// The numbers of the pull of an array. Loads in nN with lifts in nm, or in nN nm with lifts in rad.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ArrayResult {
    /// Whether its load is a moment
    pub is_moment: bool,
    /// The event with the largest load: that load and its lift
    pub peak: Option<[f64; 2]>,
    /// Largest load, between events as well
    pub largest_load: f64,
    /// Load at the first event
    pub first_load: Option<f64>,
    /// Of the load, aJ
    pub work: f64,
    /// In all events, aJ
    pub released: f64,
    /// How many setae there are
    pub setae: usize,
    /// Of these
    pub detached: usize,
    /// Changes of setae
    pub events: usize,
    /// The name of its end
    pub end: String,
    /// Why it ended, if that was not by itself
    pub reason: Option<String>,
}

impl ArrayResult {
    /// Of the pull of the array of a table.
    pub fn new(table: &ArrayTable, pull: &ArrayPull) -> Self {
        let peak = pull.peak.and_then(|peak| pull.events.get(peak));
        Self {
            is_moment: table.lamella.is_some_and(|lamella| lamella.load != BandLoad::Force),
            peak: peak.map(|event| [event.load, event.lift]),
            largest_load: pull.largest_load,
            first_load: pull.events.first().map(|event| event.load),
            work: pull.work,
            released: pull.released,
            setae: pull.setae,
            detached: pull.detached,
            events: pull.events.len(),
            end: array_end_word(pull.end).to_owned(),
            reason: array_end_reason(pull),
        }
    }
}

/// One value of a sweep of pulls of arrays.
pub type SweptArray = PullRow<ArrayResult>;

// -- The table of a sweep of pulls of arrays, sweep.csv, and the same as one object --

impl Record for SweptArray {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("value", "the value of the key that was varied", |row| row.value);
        of.sometimes("value_2", "of the second key, where two are varied", |row| row.second);
        of.field("peak_load", "load at the event with the largest one; nN, of a moment nN nm", |row| row.of(|found| Some(found.peak?[0])));
        of.field("peak_lift", "its lift there; nm, of a moment rad", |row| row.of(|found| Some(found.peak?[1])));
        of.field("largest_load", "largest load, between events as well", |row| row.of(|found| Some(found.largest_load)));
        of.field("first_load", "load at the first event", |row| row.of(|found| found.first_load));
        of.field("work_aJ", "work of the load up to the last event", |row| row.of(|found| Some(found.work)));
        of.field("released_aJ", "energy that all events release", |row| row.of(|found| Some(found.released)));
        of.field("setae", "how many", |row| row.of(|found| Some(found.setae)));
        of.field("detached", "how many of them detach", |row| row.of(|found| Some(found.detached)));
        of.field("events", "changes of setae", |row| row.of(|found| Some(found.events)));
        of.field("end", "as in summary.json of an array", |row| row.found.as_ref().map_or("failed", |found| found.end.as_str()));
        of.field("solve_s", "wall clock", |row| row.solve_s);
    }
}

/// Writes sweep.csv of a sweep of pulls of arrays: one row a value, or a pair of values.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_swept_arrays(dir: &Path, keys: SweptKeys, rows: &[SweptArray]) -> Result<PathBuf, ReportError> {
    write_swept(dir, keys, rows.iter())
}

impl<'a> SweepSummary<'a, &'a SweptArray> {
    /// The summary of rows of pulls of arrays.
    pub fn of_arrays(scene: &'a Scene, keys: SweptKeys<'a>, rows: &'a [SweptArray], remarks: &[String]) -> Self {
        Self::of_rows(scene, keys, rows.iter(), remarks)
    }
}

// -- The picture of a sweep of pulls of arrays: the largest load against the varied value; or a map over two --

const fn largest(label: &'static str) -> [Quantity<ArrayResult>; 1] {
    let of = |row: &SweptArray| row.of(|found| Some(found.largest_load));
    [Quantity { label, of, colour: colour::BLUE, height: 280.0, has_map: true }]
}

const FORCE: [Quantity<ArrayResult>; 1] = largest("largest force P (nN)");
const MOMENT: [Quantity<ArrayResult>; 1] = largest("largest moment M (nN nm)");

/// Draws `sweep.svg` and `sweep.png` into `dir`, on logarithmic axes where `log` is set.
///
/// Fails where no pull has a load, a value has no place on a logarithmic axis ([`ReportError::Draw`]), or a file cannot be written
/// ([`ReportError::Write`]).
pub fn draw_swept_arrays<'h>(
    dir: &Path,
    keys: SweptKeys,
    rows: &[SweptArray],
    heading: impl Into<Heading<'h>>,
    log: [bool; 2],
) -> Result<Vec<PathBuf>, ReportError> {
    let is_moment = rows.iter().any(|row| row.found.as_ref().is_ok_and(|found| found.is_moment));
    let quantities = if is_moment { &MOMENT } else { &FORCE };
    draw_swept_pulls(dir, keys, rows, (quantities, "has a load"), heading.into(), log)
}
