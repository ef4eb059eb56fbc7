//! The table of a pull at a rate, curve.csv. Units stand in the names of the columns.

use super::S_PER_NS;
use crate::error::ReportError;
use crate::number::Finite;
use crate::tables::write_table;
use peelkit::study::{InTimePoint, PullInTime};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Writes curve.csv: one row a step in time, from rest on.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_rate_curve(dir: &Path, pulled: &PullInTime) -> Result<PathBuf, ReportError> {
    #[derive(Default, Serialize)]
    struct Line {
        time_s: Finite,
        displacement_nm: Finite,
        #[serde(rename = "force_nN")]
        force: Finite,
        front_nm: Finite,
        #[serde(rename = "work_aJ")]
        work: Finite,
        #[serde(rename = "stored_aJ")]
        stored: Finite,
        #[serde(rename = "adhesion_aJ")]
        adhesion: Finite,
        #[serde(rename = "spring_aJ")]
        spring: Finite,
        #[serde(rename = "kinetic_aJ")]
        kinetic: Finite,
        #[serde(rename = "dissipated_aJ")]
        dissipated: Finite,
    }
    let line = |point: &InTimePoint| Line {
        time_s: Finite(S_PER_NS * point.time),
        displacement_nm: Finite(point.displacement),
        force: Finite(point.force),
        front_nm: Finite(point.front),
        work: Finite(point.balance.work),
        stored: Finite(point.balance.stored),
        adhesion: Finite(point.balance.adhesion),
        spring: Finite(point.balance.spring),
        kinetic: Finite(point.balance.kinetic),
        dissipated: Finite(point.balance.dissipated),
    };
    write_table(dir, "curve.csv", pulled.points.iter().map(line))
}
