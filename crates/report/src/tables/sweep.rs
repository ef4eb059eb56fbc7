//! The table of a sweep, sweep.csv. Units stand in the names of the columns.

use super::table::write_table;
use crate::error::ReportError;
use crate::names::end_word;
use crate::number::Finite;
use crate::sweep_row::SweepRow;
use peelkit::study::{self, FollowedRow, FollowedSweep, PeelResult, PointKind};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Writes sweep.csv: one row a value.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_sweep(dir: &Path, rows: &[SweepRow]) -> Result<PathBuf, ReportError> {
    write_table(dir, "sweep.csv", rows.iter().map(SweepLine::from))
}

/// Writes sweep.csv of a sweep that followed one point, each value in so many seconds: the same columns, empty where nothing was
/// computed.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_followed(dir: &Path, sweep: &FollowedSweep, solve_s: &[f64]) -> Result<PathBuf, ReportError> {
    write_table(dir, "sweep.csv", SweepLine::followed(sweep, solve_s).into_iter())
}

/// One value of a sweep in short; `None` where a thing does not occur or was not computed.
#[derive(Debug, Default, Serialize)]
pub struct SweepLine {
    value: Finite,
    #[serde(rename = "peak_force_nN")]
    peak_force: Option<Finite>,
    #[serde(rename = "peak_error_nN")]
    peak_error: Option<Finite>,
    #[serde(rename = "initiation_peak_nN")]
    initiation_peak: Option<Finite>,
    #[serde(rename = "plateau_force_nN")]
    plateau_force: Option<Finite>,
    snap_off_displacement_nm: Option<Finite>,
    /// To the snap-off, or to the end of the path where there is none.
    #[serde(rename = "work_aJ")]
    work: Option<Finite>,
    solve_s: Finite,
    end: Option<&'static str>,
    points: Option<usize>,
    newton_iterations: usize,
    elements: Option<usize>,
    order: Option<usize>,
    #[serde(rename = "initiation_peak_error_nN")]
    initiation_peak_error: Option<Finite>,
    snap_off_error_nm: Option<Finite>,
    /// Where there is no peak; without an error bound.
    #[serde(rename = "largest_computed_force_nN")]
    largest_computed_force: Option<Finite>,
    peak_displacement_nm: Option<Finite>,
    peak_error_nm: Option<Finite>,
    #[serde(rename = "plateau_error_nN")]
    plateau_error: Option<Finite>,
    #[serde(rename = "snap_off_force_nN")]
    snap_off_force: Option<Finite>,
    #[serde(rename = "snap_off_error_nN")]
    snap_off_force_error: Option<Finite>,
    /// Up to where `work_aJ` goes.
    work_to: Option<&'static str>,
    #[serde(rename = "work_error_aJ")]
    work_error: Option<Finite>,
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
    /// Largest relative error bound.
    accuracy_reached: Option<Finite>,
}

impl SweepLine {
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
                    ..line
                },
                (PointKind::SnapOff, Some(at)) => Self {
                    snap_off_displacement_nm: Some(Finite(at.displacement)),
                    snap_off_error_nm: Some(Finite(at.displacement_error)),
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
        let found = &row.found;
        Self {
            value: Finite(row.value),
            peak_force: found.peak.map(|at| Finite(at.force)),
            peak_error: found.peak.map(|at| Finite(at.force_error)),
            initiation_peak: found.initiation_peak.map(|at| Finite(at.force)),
            plateau_force: found.plateau.map(|at| Finite(at.force)),
            snap_off_displacement_nm: found.snap_off.map(|at| Finite(at.displacement)),
            work: found.work.map(Finite),
            solve_s: Finite(row.solve_s),
            end: Some(end_word(&found.end)),
            points: Some(found.effort.points),
            newton_iterations: found.effort.newton_iterations,
            elements: Some(found.effort.elements),
            order: Some(found.effort.order),
            initiation_peak_error: found.initiation_peak.map(|at| Finite(at.force_error)),
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
}
