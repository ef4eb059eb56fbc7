//! The files of a sweep of whole paths.

use super::cases::Cases;
use peelkit_report::{self as report, PartHeader, ReportError, SweepPart, SweepRow};
use peelkit_scene::Scene;
use std::path::{Path, PathBuf};

/// Those of a whole sweep: the table, the scene with this command line, the pictures.
pub fn write_all(
    dir: &Path,
    scene: &Scene,
    command: &str,
    cases: &Cases,
    rows: &[SweepRow],
) -> Result<Vec<PathBuf>, ReportError> {
    let Cases { keys, log, .. } = cases;
    let mut files = write_table(dir, scene, command, cases, rows)?;
    if rows.iter().any(|row| row.found.peak.is_some()) {
        files.extend(match keys.second {
            None => report::draw_sweep(rows, &keys.first.path(), &scene.title, log[0], dir)?,
            Some(_) => report::draw_plane(rows, *keys, &scene.title, *log, dir)?,
        });
    }
    Ok(files)
}

/// Those of a part: no pictures, but what `peel collect` needs.
pub fn write_part(
    dir: &Path,
    scene: &Scene,
    command: &str,
    cases: &Cases,
    rows: &[SweepRow],
    header: &PartHeader,
) -> Result<Vec<PathBuf>, ReportError> {
    let mut files = write_table(dir, scene, command, cases, rows)?;
    files.push(SweepPart::write(dir, header, rows)?);
    Ok(files)
}

fn write_table(
    dir: &Path,
    scene: &Scene,
    command: &str,
    cases: &Cases,
    rows: &[SweepRow],
) -> Result<Vec<PathBuf>, ReportError> {
    Ok(vec![report::write_sweep(dir, cases.keys, rows)?, report::write_parameters(dir, scene, command)?])
}
