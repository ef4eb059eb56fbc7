//! The table of a sweep of setae, sweep.csv, and the same as one object.

use super::row::SetaRow;
use crate::error::ReportError;
use crate::number::Finite;
use crate::summary::SweepSummary;
use crate::swept_keys::SweptKeys;
use crate::tables::write_with_named_values;
use peelkit::study::{SetaMoment, SetaResult};
use peelkit_scene::Scene;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// One value in short; `None` where a thing does not occur or was not computed.
#[derive(Debug, Default, Serialize)]
pub struct SetaLine {
    value: Finite,
    /// Of the second key, where two are varied.
    #[serde(rename = "value_2", skip_serializing_if = "Option::is_none")]
    second: Option<Finite>,
    #[serde(rename = "peak_force_nN")]
    peak_force: Option<Finite>,
    peak_displacement_nm: Option<Finite>,
    peak_tips_attached: Option<usize>,
    #[serde(rename = "mesh_error_nN")]
    mesh_error: Option<Finite>,
    #[serde(rename = "first_detachment_force_nN")]
    first_force: Option<Finite>,
    first_detachment_displacement_nm: Option<Finite>,
    #[serde(rename = "last_detachment_force_nN")]
    last_force: Option<Finite>,
    last_detachment_displacement_nm: Option<Finite>,
    events: Option<usize>,
    most_tips_at_once: Option<usize>,
    #[serde(rename = "work_aJ")]
    work: Option<Finite>,
    #[serde(rename = "released_aJ")]
    released: Option<Finite>,
    imbalance: Option<Finite>,
    end: Option<&'static str>,
    solve_s: Finite,
    points: Option<usize>,
    newton_iterations: Option<usize>,
    elements: Option<usize>,
}

impl From<&SetaRow> for SetaLine {
    fn from(row: &SetaRow) -> Self {
        let found = row.found.as_ref().ok();
        let moment = |of: fn(&SetaResult) -> Option<SetaMoment>| found.and_then(of);
        let (peak, first) = (moment(|found| found.peak), moment(|found| found.first_detachment));
        let last = moment(|found| found.last_detachment);
        Self {
            value: Finite(row.value),
            second: row.second.map(Finite),
            peak_force: peak.map(|at| Finite(at.force)),
            peak_displacement_nm: peak.map(|at| Finite(at.displacement)),
            peak_tips_attached: peak.map(|at| at.attached),
            mesh_error: found.and_then(|found| found.mesh_error).map(Finite),
            first_force: first.map(|at| Finite(at.force)),
            first_detachment_displacement_nm: first.map(|at| Finite(at.displacement)),
            last_force: last.map(|at| Finite(at.force)),
            last_detachment_displacement_nm: last.map(|at| Finite(at.displacement)),
            events: found.map(|found| found.events),
            most_tips_at_once: found.map(|found| found.most_at_once),
            work: found.map(|found| Finite(found.work)),
            released: found.map(|found| Finite(found.released)),
            imbalance: found.map(|found| Finite(found.imbalance)),
            end: Some(row.end()),
            solve_s: Finite(row.solve_s),
            points: found.map(|found| found.points),
            newton_iterations: found.map(|found| found.effort.newton_iterations),
            elements: found.map(|found| found.effort.elements),
        }
    }
}

/// Writes sweep.csv of a sweep of setae: one row a value, or a pair of values. Behind `value` the same number stands once more in a column that
/// names its key and unit.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_swept_setae(dir: &Path, keys: SweptKeys, rows: &[SetaRow]) -> Result<PathBuf, ReportError> {
    let lines: Vec<SetaLine> = rows.iter().map(SetaLine::from).collect();
    let none = SetaLine { second: keys.second.map(|_| Finite(0.0)), ..SetaLine::default() };
    write_with_named_values(dir, keys, &none, &lines)
}

impl SweepSummary<SetaLine> {
    /// The summary of rows of setae.
    pub fn of_setae(scene: &Scene, keys: SweptKeys, rows: &[SetaRow], remarks: &[String]) -> Self {
        Self::of(scene, keys, rows.iter().map(SetaLine::from).collect(), remarks.to_vec())
    }
}
