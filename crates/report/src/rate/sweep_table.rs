//! The table of a sweep of pulls at a rate, sweep.csv, and the same as one object.

use super::sweep_row::{RateResult, RateRow};
use crate::error::ReportError;
use crate::number::Finite;
use crate::summary::SweepSummary;
use crate::swept_keys::SweptKeys;
use crate::tables::write_with_named_values;
use peelkit_scene::Scene;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// One value in short; `None` where a thing does not occur or was not computed.
#[derive(Debug, Default, Serialize)]
pub struct RateLine {
    value: Finite,
    /// Of the second key, where two are varied.
    #[serde(rename = "value_2", skip_serializing_if = "Option::is_none")]
    second: Option<Finite>,
    #[serde(rename = "largest_force_nN")]
    force: Option<Finite>,
    displacement_nm: Option<Finite>,
    time_s: Option<Finite>,
    #[serde(rename = "kinetic_aJ")]
    kinetic: Option<Finite>,
    #[serde(rename = "dissipated_aJ")]
    dissipated: Option<Finite>,
    contact_lost_s: Option<Finite>,
    #[serde(rename = "work_aJ")]
    work: Option<Finite>,
    imbalance: Option<Finite>,
    end: Option<&'static str>,
    solve_s: Finite,
    steps: Option<usize>,
    newton_iterations: Option<usize>,
    elements: Option<usize>,
}

impl From<&RateRow> for RateLine {
    fn from(row: &RateRow) -> Self {
        let found = row.found.as_ref().ok();
        let number = |of: fn(&RateResult) -> f64| found.map(|found| Finite(of(found)));
        Self {
            value: Finite(row.value),
            second: row.second.map(Finite),
            force: number(|found| found.largest_force),
            displacement_nm: number(|found| found.displacement),
            time_s: number(|found| found.time),
            kinetic: number(|found| found.kinetic),
            dissipated: number(|found| found.dissipated),
            contact_lost_s: found.and_then(|found| found.contact_lost).map(Finite),
            work: number(|found| found.work),
            imbalance: number(|found| found.imbalance),
            end: Some(row.end()),
            solve_s: Finite(row.solve_s),
            steps: found.map(|found| found.steps),
            newton_iterations: found.map(|found| found.newton_iterations),
            elements: found.map(|found| found.elements),
        }
    }
}

/// Writes sweep.csv of a sweep of pulls at a rate: one row a value, or a pair of values. Behind `value` the same number stands once more in a column
/// that names its key and unit.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_swept_rates(dir: &Path, keys: SweptKeys, rows: &[RateRow]) -> Result<PathBuf, ReportError> {
    let lines: Vec<RateLine> = rows.iter().map(RateLine::from).collect();
    let none = RateLine { second: keys.second.map(|_| Finite(0.0)), ..RateLine::default() };
    write_with_named_values(dir, keys, &none, &lines)
}

impl SweepSummary<RateLine> {
    /// The summary of rows of pulls at a rate.
    pub fn of_rates(scene: &Scene, keys: SweptKeys, rows: &[RateRow], remarks: &[String]) -> Self {
        Self::of(scene, keys, rows.iter().map(RateLine::from).collect(), remarks.to_vec())
    }
}
