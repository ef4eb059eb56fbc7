//! The table of a displacement-controlled test: observed.csv. Units stand in the names of the columns.

use super::table::write_table;
use crate::error::ReportError;
use crate::number::Finite;
use peelkit::study::Observed;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Writes observed.csv: one row a point of the test, in its order.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_observed(dir: &Path, test: &Observed) -> Result<PathBuf, ReportError> {
    #[derive(Default, Serialize)]
    struct Line {
        branch: &'static str,
        machine_displacement_nm: Finite,
        displacement_nm: Finite,
        #[serde(rename = "force_nN")]
        force: Finite,
        #[serde(rename = "work_aJ")]
        work: Finite,
        front_nm: Finite,
        jump: bool,
        adheres: &'static str,
    }
    let lines = test.points.iter().map(|point| Line {
        branch: point.way.word(),
        machine_displacement_nm: Finite(point.machine),
        displacement_nm: Finite(point.displacement),
        force: Finite(point.force),
        work: Finite(point.work),
        front_nm: Finite(point.front),
        jump: point.jumped,
        adheres: point.adheres.word(),
    });
    write_table(dir, "observed.csv", lines)
}
