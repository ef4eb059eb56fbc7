//! The table of a sweep, sweep.csv. Units stand in the names of the columns.

use super::table::table_like;
use crate::error::ReportError;
use crate::file::write_whole;
use crate::names::end_word;
use crate::number::Finite;
use crate::sweep_row::SweepRow;
use crate::swept_keys::{SweptKeys, as_given};
use peelkit::study::{self, FollowedRow, FollowedSweep, PeelResult, PointKind};
use peelkit_scene::Key;
use serde::Serialize;
use std::io;
use std::path::{Path, PathBuf};

/// Writes sweep.csv: one row a value, or a pair of values. Behind `value` the same number stands once more in a column that names its key
/// and the unit in which a user gives it: an angle in degrees.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_sweep<'k>(dir: &Path, keys: impl Into<SweptKeys<'k>>, rows: &[SweepRow]) -> Result<PathBuf, ReportError> {
    write_lines(dir, keys.into(), &rows.iter().map(SweepLine::from).collect::<Vec<_>>())
}

/// Writes sweep.csv of a sweep that followed one point, each value in so many seconds: the same columns, empty where nothing was
/// computed.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_followed<'k>(
    dir: &Path,
    keys: impl Into<SweptKeys<'k>>,
    sweep: &FollowedSweep,
    solve_s: &[f64],
) -> Result<PathBuf, ReportError> {
    write_lines(dir, keys.into(), &SweepLine::followed(sweep, solve_s))
}

fn write_lines(dir: &Path, keys: SweptKeys, lines: &[SweepLine]) -> Result<PathBuf, ReportError> {
    let none = SweepLine { second: keys.second.map(|_| Finite(0.0)), ..SweepLine::default() };
    write_with_named_values(dir, keys, &none, lines)
}

/// Writes sweep.csv of lines that begin with the values of the keys; `none` has the columns where there are no lines.
pub(crate) fn write_with_named_values<L: Serialize>(
    dir: &Path,
    keys: SweptKeys,
    none: &L,
    lines: &[L],
) -> Result<PathBuf, ReportError> {
    let path = dir.join("sweep.csv");
    let text =
        with_named_values(keys, none, lines).map_err(|source| ReportError::Write { path: path.clone(), source })?;
    write_whole(&path, &text)?;
    Ok(path)
}

/// The table with the columns of the values once more under the names of their keys.
fn with_named_values<L: Serialize>(keys: SweptKeys, none: &L, lines: &[L]) -> io::Result<Vec<u8>> {
    let plain = table_like(none, lines.iter())?;
    let mut reader = csv::Reader::from_reader(plain.as_slice());
    let mut writer = csv::Writer::from_writer(Vec::new());
    let names = keys.columns();
    let header = reader.headers()?.clone();
    let values = names.len();
    writer.write_record(
        header.iter().take(values).chain(names.iter().map(String::as_str)).chain(header.iter().skip(values)),
    )?;
    for record in reader.records() {
        let record = record?;
        let named: Vec<String> = keys.keys().zip(&record).map(|(key, cell)| cell_as_given(key, cell)).collect();
        let named = named.iter().map(String::as_str);
        writer.write_record(record.iter().take(values).chain(named).chain(record.iter().skip(values)))?;
    }
    writer.into_inner().map_err(|error| error.into_error())
}

/// A cell in the unit in which a user gives the key.
fn cell_as_given(key: &Key, cell: &str) -> String {
    match cell.parse::<f64>() {
        Ok(number) if key.per_usual_unit() != 1.0 => as_given(key, number).to_string(),
        _ => cell.to_owned(),
    }
}

/// One value of a sweep in short; `None` where a thing does not occur or was not computed.
#[derive(Debug, Default, Serialize)]
pub struct SweepLine {
    value: Finite,
    /// Of the second key, where two are varied.
    #[serde(rename = "value_2", skip_serializing_if = "Option::is_none")]
    second: Option<Finite>,
    #[serde(rename = "peak_force_nN")]
    peak_force: Option<Finite>,
    #[serde(rename = "peak_error_nN")]
    peak_error: Option<Finite>,
    peak_displacement_nm: Option<Finite>,
    peak_error_nm: Option<Finite>,
    #[serde(rename = "initiation_peak_nN")]
    initiation_peak: Option<Finite>,
    #[serde(rename = "initiation_peak_error_nN")]
    initiation_peak_error: Option<Finite>,
    initiation_peak_displacement_nm: Option<Finite>,
    initiation_peak_error_nm: Option<Finite>,
    #[serde(rename = "plateau_force_nN")]
    plateau_force: Option<Finite>,
    #[serde(rename = "plateau_error_nN")]
    plateau_error: Option<Finite>,
    plateau_displacement_nm: Option<Finite>,
    plateau_error_nm: Option<Finite>,
    snap_off_displacement_nm: Option<Finite>,
    snap_off_error_nm: Option<Finite>,
    #[serde(rename = "snap_off_force_nN")]
    snap_off_force: Option<Finite>,
    #[serde(rename = "snap_off_error_nN")]
    snap_off_force_error: Option<Finite>,
    /// To the snap-off, or to the end of the path where there is none.
    #[serde(rename = "work_aJ")]
    work: Option<Finite>,
    #[serde(rename = "work_error_aJ")]
    work_error: Option<Finite>,
    /// Up to where `work_aJ` goes.
    work_to: Option<&'static str>,
    pad_detachment_displacement_nm: Option<Finite>,
    pad_detachment_error_nm: Option<Finite>,
    #[serde(rename = "pad_detachment_force_nN")]
    pad_detachment_force: Option<Finite>,
    #[serde(rename = "pad_detachment_error_nN")]
    pad_detachment_force_error: Option<Finite>,
    #[serde(rename = "pad_detachment_work_aJ")]
    pad_detachment_work: Option<Finite>,
    #[serde(rename = "pad_detachment_work_error_aJ")]
    pad_detachment_work_error: Option<Finite>,
    detachment_displacement_nm: Option<Finite>,
    detachment_error_nm: Option<Finite>,
    #[serde(rename = "detachment_force_nN")]
    detachment_force: Option<Finite>,
    #[serde(rename = "detachment_error_nN")]
    detachment_force_error: Option<Finite>,
    #[serde(rename = "detachment_work_aJ")]
    detachment_work: Option<Finite>,
    #[serde(rename = "detachment_work_error_aJ")]
    detachment_work_error: Option<Finite>,
    /// Where there is no peak; without an error bound.
    #[serde(rename = "largest_computed_force_nN")]
    largest_computed_force: Option<Finite>,
    end: Option<&'static str>,
    /// Largest relative error bound.
    accuracy_reached: Option<Finite>,
    solve_s: Finite,
    points: Option<usize>,
    newton_iterations: usize,
    elements: Option<usize>,
    order: Option<usize>,
}

impl SweepLine {
    /// What a peel found at a value, or a pair of them, in so many seconds.
    pub fn new(value: f64, second: Option<f64>, found: &PeelResult, solve_s: f64) -> Self {
        Self {
            value: Finite(value),
            second: second.map(Finite),
            peak_force: found.peak.map(|at| Finite(at.force)),
            peak_error: found.peak.map(|at| Finite(at.force_error)),
            initiation_peak: found.initiation_peak.map(|at| Finite(at.force)),
            plateau_force: found.plateau.map(|at| Finite(at.force)),
            snap_off_displacement_nm: found.snap_off.map(|at| Finite(at.displacement)),
            work: found.work.map(Finite),
            solve_s: Finite(solve_s),
            end: Some(end_word(&found.end)),
            points: Some(found.effort.points),
            newton_iterations: found.effort.newton_iterations,
            elements: Some(found.effort.elements),
            order: Some(found.effort.order),
            initiation_peak_error: found.initiation_peak.map(|at| Finite(at.force_error)),
            initiation_peak_displacement_nm: found.initiation_peak.map(|at| Finite(at.displacement)),
            initiation_peak_error_nm: found.initiation_peak.map(|at| Finite(at.displacement_error)),
            plateau_displacement_nm: found.plateau.map(|at| Finite(at.displacement)),
            plateau_error_nm: found.plateau.and_then(|at| at.displacement_error).map(Finite),
            snap_off_error_nm: found.snap_off.map(|at| Finite(at.displacement_error)),
            largest_computed_force: found.largest_computed_force.map(|at| Finite(at.force)),
            peak_displacement_nm: found.peak.map(|at| Finite(at.displacement)),
            peak_error_nm: found.peak.map(|at| Finite(at.displacement_error)),
            plateau_error: found.plateau.and_then(|at| at.force_error).map(Finite),
            snap_off_force: found.snap_off.map(|at| Finite(at.force)),
            snap_off_force_error: found.snap_off.map(|at| Finite(at.force_error)),
            work_to: work_to(found),
            work_error: found.snap_off.and_then(|at| at.work_error).map(Finite),
            pad_detachment_displacement_nm: found.pad_detachment.map(|at| Finite(at.displacement)),
            pad_detachment_error_nm: found.pad_detachment.map(|at| Finite(at.displacement_error)),
            pad_detachment_force: found.pad_detachment.map(|at| Finite(at.force)),
            pad_detachment_force_error: found.pad_detachment.map(|at| Finite(at.force_error)),
            pad_detachment_work: found.pad_detachment.map(|at| Finite(at.work)),
            pad_detachment_work_error: found.pad_detachment.and_then(|at| at.work_error).map(Finite),
            detachment_displacement_nm: found.detachment.map(|at| Finite(at.displacement)),
            detachment_error_nm: found.detachment.map(|at| Finite(at.displacement_error)),
            detachment_force: found.detachment.map(|at| Finite(at.force)),
            detachment_force_error: found.detachment.map(|at| Finite(at.force_error)),
            detachment_work: found.detachment.map(|at| Finite(at.work)),
            detachment_work_error: found.detachment.and_then(|at| at.work_error).map(Finite),
            accuracy_reached: found.reached.map(Finite),
        }
    }

    /// The values of a sweep that followed one point, each in so many seconds.
    pub fn followed(sweep: &FollowedSweep, solve_s: &[f64]) -> Vec<Self> {
        let line = |(row, &solve_s): (&FollowedRow, &f64)| {
            let effort = row.point.map(|_| row.elements);
            let line = Self {
                value: Finite(row.value),
                solve_s: Finite(solve_s),
                newton_iterations: row.newton_iterations,
                elements: effort,
                order: effort.map(|_| study::FOLLOWED_ORDER),
                ..Self::default()
            };
            match (sweep.kind, row.point) {
                (_, None) => line,
                (PointKind::InitiationPeak, Some(at)) => Self {
                    initiation_peak: Some(Finite(at.force)),
                    initiation_peak_error: Some(Finite(at.force_error)),
                    initiation_peak_displacement_nm: Some(Finite(at.displacement)),
                    initiation_peak_error_nm: Some(Finite(at.displacement_error)),
                    ..line
                },
                (PointKind::SnapOff, Some(at)) => Self {
                    snap_off_displacement_nm: Some(Finite(at.displacement)),
                    snap_off_error_nm: Some(Finite(at.displacement_error)),
                    snap_off_force: Some(Finite(at.force)),
                    snap_off_force_error: Some(Finite(at.force_error)),
                    work: at.work.map(Finite),
                    work_to: at.work.map(|_| "first jump"),
                    ..line
                },
            }
        };
        sweep.rows.iter().zip(solve_s).map(line).collect()
    }
}

/// Up to where the work of a row goes: where there is no first jump, that is not the work of peeling.
pub fn work_to(found: &PeelResult) -> Option<&'static str> {
    let end = || found.work.map(|_| "end of path");
    found.snap_off.map(|_| "first jump").or_else(end)
}

impl From<&SweepRow> for SweepLine {
    fn from(row: &SweepRow) -> Self {
        Self::new(row.value, row.second, &row.found, row.solve_s)
    }
}
