//! The table of a sweep, sweep.csv. Units stand in the names of the columns.

use super::table::write_table;
use crate::error::ReportError;
use crate::names::end_word;
use crate::number::Finite;
use crate::sweep_row::SweepRow;
use peelkit::study::{self, FollowedRow, FollowedSweep, PointKind};
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
                    ..line
                },
            }
        };
        sweep.rows.iter().zip(solve_s).map(line).collect()
    }
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
        }
    }
}
