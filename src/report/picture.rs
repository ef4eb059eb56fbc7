//! Pictures; none yet.

use super::ReportError;
use crate::study::{Peel, SweepRow};
use std::path::{Path, PathBuf};

/// Draws the force-displacement curve and the deformed strip.
pub fn draw_peel(_peel: &Peel, _title: &str, _dir: &Path) -> Result<Vec<PathBuf>, ReportError> {
    Ok(Vec::new())
}

/// Draws the forces and the work of a sweep against the varied key.
pub fn draw_sweep(
    _rows: &[SweepRow],
    _key: &str,
    _title: &str,
    _log: bool,
    _dir: &Path,
) -> Result<Vec<PathBuf>, ReportError> {
    Ok(Vec::new())
}

/// Regenerates every figure.
pub fn draw_figures(_dir: &Path, _progress: &(dyn Fn(usize, usize) + Sync)) -> Result<Vec<PathBuf>, ReportError> {
    Ok(Vec::new())
}
