//! The picture of a sweep of pulls at a rate: the largest force and what is dissipated up to it, against the varied value; or maps over two.

use super::sweep_row::{RateResult, RateRow};
use crate::chart::style::colour;
use crate::error::ReportError;
use crate::pictures::swept_pulls::{Quantity, draw_swept_pulls};
use crate::swept_keys::SweptKeys;
use std::path::{Path, PathBuf};

const QUANTITIES: [Quantity<RateResult>; 2] = [
    Quantity {
        label: "largest force P (nN)",
        of: |row| row.finished().map(|found| found.largest_force),
        colour: colour::BLUE,
        height: 280.0,
        has_map: true,
    },
    Quantity {
        label: "dissipated up to it (aJ)",
        of: |row| row.finished().map(|found| found.dissipated),
        colour: colour::VERMILLION,
        height: 180.0,
        has_map: true,
    },
];

/// Draws `sweep.svg` and `sweep.png` into `dir`: of one key the largest force and what is dissipated up to it against its values, of two keys maps of
/// both, on logarithmic axes where `log` is set.
///
/// Fails where no pull was followed to its end, a value has no place on a logarithmic axis ([`ReportError::Draw`]), or a file cannot be written
/// ([`ReportError::Write`]).
pub fn draw_swept_rates(
    dir: &Path,
    keys: SweptKeys,
    rows: &[RateRow],
    title: &str,
    log: [bool; 2],
) -> Result<Vec<PathBuf>, ReportError> {
    draw_swept_pulls(dir, keys, rows, (&QUANTITIES, "was pulled to its end"), title, log)
}
