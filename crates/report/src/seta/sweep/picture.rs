//! The picture of a sweep of setae: the peak force, the tips that adhere there, and the work, against the varied value; or maps over two.

use super::row::SetaRow;
use crate::chart::style::colour;
use crate::error::ReportError;
use crate::pictures::swept_pulls::{Quantity, draw_swept_pulls};
use crate::swept_keys::SweptKeys;
use peelkit::study::SetaResult;
use std::path::{Path, PathBuf};

const QUANTITIES: [Quantity<SetaResult>; 3] = [
    Quantity {
        label: "peak force P (nN)",
        of: |row| row.peak().map(|at| at.force),
        colour: colour::BLUE,
        height: 260.0,
        has_map: true,
    },
    Quantity {
        label: "tips attached at the peak",
        of: |row| row.peak().map(|at| at.attached as f64),
        colour: colour::VERMILLION,
        height: 160.0,
        has_map: false,
    },
    Quantity {
        label: "work of the root W (aJ)",
        of: SetaRow::work,
        colour: colour::GREEN,
        height: 160.0,
        has_map: true,
    },
];

/// Draws `sweep.svg` and `sweep.png` into `dir`: of one key the peak force, the tips that adhere there and the work of the root against its values,
/// of two keys maps of peak force and work, on logarithmic axes where `log` is set.
///
/// Fails where no value has a peak, a value has no place on a logarithmic axis ([`ReportError::Draw`]), or a file cannot be written
/// ([`ReportError::Write`]).
pub fn draw_swept_setae(
    dir: &Path,
    keys: SweptKeys,
    rows: &[SetaRow],
    title: &str,
    log: [bool; 2],
) -> Result<Vec<PathBuf>, ReportError> {
    draw_swept_pulls(dir, keys, rows, (&QUANTITIES, "has a peak force"), title, log)
}
