//! The table of a sweep of pulls at a rate, sweep.csv, and the same as one object.

use super::sweep_row::RateRow;
use crate::error::ReportError;
use crate::record::{Fields, Record};
use crate::records::sweep::{SweepSummary, write_swept};
use crate::swept_keys::SweptKeys;
use peelkit_scene::Scene;
use std::path::{Path, PathBuf};

impl Record for RateRow {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("value", "the value of the key that was varied", |row| row.value);
        of.sometimes("value_2", "of the second key, where two are varied", |row| row.second);
        of.field("largest_force_nN", "the largest force of the pull, as in summary.json", |row| row.of(|found| Some(found.largest_force)));
        of.field("displacement_nm", "of what moves the grip, or the root, there", |row| row.of(|found| Some(found.displacement)));
        of.field("time_s", "since the pull began, there", |row| row.of(|found| Some(found.time)));
        of.field("kinetic_aJ", "kinetic energy at the step next to it", |row| row.of(|found| Some(found.kinetic)));
        of.field("dissipated_aJ", "dissipated up to that step", |row| row.of(|found| Some(found.dissipated)));
        of.field("contact_lost_s", "when nothing adheres any more for the first time; empty where that does not happen", |row| row.of(|found| found.contact_lost));
        of.field("work_aJ", "work of the grip, or of the machine behind its spring, to the end", |row| row.of(|found| Some(found.work)));
        of.field("imbalance", "largest defect of the balance of energies at any step, over the largest work", |row| row.of(|found| Some(found.imbalance)));
        of.field("end", "as in summary.json of a pull at a rate", |row| row.end());
        of.field("solve_s", "wall clock", |row| row.solve_s);
        of.field("steps", "steps in time", |row| row.of(|found| Some(found.steps)));
        of.field("newton_iterations", "Newton iterations", |row| row.of(|found| Some(found.newton_iterations)));
        of.field("elements", "elements of the mesh, which stays", |row| row.of(|found| Some(found.elements)));
    }
}

/// Writes sweep.csv of a sweep of pulls at a rate: one row a value, or a pair of values. Behind `value` the same number stands once more in a column
/// that names its key and unit.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_swept_rates(dir: &Path, keys: SweptKeys, rows: &[RateRow]) -> Result<PathBuf, ReportError> {
    write_swept(dir, keys, rows.iter())
}

impl<'a> SweepSummary<'a, &'a RateRow> {
    /// The summary of rows of pulls at a rate.
    pub fn of_rates(scene: &'a Scene, keys: SweptKeys<'a>, rows: &'a [RateRow], remarks: &[String]) -> Self {
        Self::of_rows(scene, keys, rows.iter(), remarks)
    }
}
