//! The tables: curve.csv, limit_points.csv, sweep.csv. Units stand in the names of the columns.

use super::ReportError;
use super::file::write_whole;
use super::number::Finite;
use super::summary::{end_word, turn_word};
use crate::study::{self, FollowedRow, FollowedSweep, Peel, PointKind, SweepRow};
use serde::Serialize;
use std::io;
use std::path::{Path, PathBuf};

/// Writes curve.csv: one row a path point.
pub fn write_curve(dir: &Path, peel: &Peel) -> Result<PathBuf, ReportError> {
    #[derive(Default, Serialize)]
    struct Line {
        displacement_nm: Finite,
        #[serde(rename = "force_nN")]
        force: Finite,
        end_rotation_rad: Finite,
        #[serde(rename = "work_aJ")]
        work: Finite,
        negative_eigenvalues: usize,
        negative_eigenvalues_load: usize,
        front_nm: Finite,
        newton_iterations: usize,
    }
    let lines = peel.points.iter().map(|point| Line {
        displacement_nm: Finite(point.displacement),
        force: Finite(point.force),
        end_rotation_rad: Finite(point.end_rotation),
        work: Finite(point.work),
        negative_eigenvalues: point.negative_eigenvalues,
        negative_eigenvalues_load: point.negative_eigenvalues_load,
        front_nm: Finite(point.front),
        newton_iterations: point.iterations,
    });
    write_table(dir, "curve.csv", lines)
}

/// Writes limit_points.csv: one row a limit point, in path order.
pub fn write_limit_points(dir: &Path, peel: &Peel) -> Result<PathBuf, ReportError> {
    #[derive(Default, Serialize)]
    struct Line {
        kind: &'static str,
        displacement_nm: Finite,
        #[serde(rename = "force_nN")]
        force: Finite,
        end_rotation_rad: Finite,
        #[serde(rename = "work_aJ")]
        work: Finite,
        error_nm: Finite,
        #[serde(rename = "error_nN")]
        force_error: Finite,
        flat: bool,
        after_point: usize,
    }
    let lines = peel.limit_points.iter().map(|at| Line {
        kind: turn_word(at.kind),
        displacement_nm: Finite(at.displacement),
        force: Finite(at.force),
        end_rotation_rad: Finite(at.end_rotation),
        work: Finite(at.work),
        error_nm: Finite(at.displacement_error),
        force_error: Finite(at.force_error),
        flat: at.flat,
        after_point: at.after,
    });
    write_table(dir, "limit_points.csv", lines)
}

/// Writes sweep.csv: one row a value.
pub fn write_sweep(dir: &Path, rows: &[SweepRow]) -> Result<PathBuf, ReportError> {
    write_table(dir, "sweep.csv", rows.iter().map(SweepLine::from))
}

/// Writes sweep.csv of a sweep that followed one point: the same columns, empty where nothing was computed.
pub fn write_followed(dir: &Path, sweep: &FollowedSweep) -> Result<PathBuf, ReportError> {
    write_table(dir, "sweep.csv", SweepLine::followed(sweep).into_iter())
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
    /// The values of a sweep that followed one point.
    pub fn followed(sweep: &FollowedSweep) -> Vec<Self> {
        let line = |row: &FollowedRow| {
            let effort = row.point.map(|_| row.elements);
            let line = Self {
                value: Finite(row.value),
                solve_s: Finite(row.solve_s),
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
        sweep.rows.iter().map(line).collect()
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
            solve_s: Finite(found.solve_s),
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

pub(super) fn write_table<T: Serialize + Default>(
    dir: &Path,
    name: &str,
    lines: impl Iterator<Item = T>,
) -> Result<PathBuf, ReportError> {
    let path = dir.join(name);
    let text = table(lines).map_err(|source| ReportError::Write { path: path.clone(), source })?;
    write_whole(&path, &text)?;
    Ok(path)
}

/// The lines below a header; the header alone where there are none.
fn table<T: Serialize + Default>(lines: impl Iterator<Item = T>) -> io::Result<Vec<u8>> {
    let mut header = csv::Writer::from_writer(Vec::new());
    header.serialize(T::default())?;
    let mut text = header.into_inner().map_err(|error| error.into_error())?;
    let header_length = text.iter().position(|&byte| byte == b'\n').map_or(0, |end| end + 1);
    text.truncate(header_length);

    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(text);
    for line in lines {
        writer.serialize(line)?;
    }
    writer.into_inner().map_err(|error| error.into_error())
}
