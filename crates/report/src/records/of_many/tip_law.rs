//! The law of a tip, read back from the folder that `peel coarsen` has written.

use crate::records::of_many::tip::{pad_end_word, sheet_word};
use crate::records::summary::parameters;
use crate::writing::error::ReportError;
use crate::writing::file::read_whole;
use peelkit::study::coarsening::{
    CoarseningOptions, PadEnd, Sheet, SheetErrors, SheetNode, SheetTable, TipRange, TipScales, TipSheet, TipTable,
};
use peelkit_scene::{Scene, body_of};
use serde::Deserialize;
use serde_json::Value;
use std::path::Path;

#[derive(Debug, Deserialize)]
struct Row {
    branch: String,
    path: f64,
    lateral_nm: f64,
    rotation_rad: f64,
    normal_nm: f64,
    path_slope_nm: f64,
    #[serde(rename = "energy_aJ")]
    energy: f64,
    #[serde(rename = "normal_force_nN")]
    normal_force: f64,
    #[serde(rename = "lateral_force_nN")]
    lateral_force: f64,
    #[serde(rename = "moment_nN_nm")]
    moment: f64,
    adhering_nm: f64,
}

/// Reads tip_law.csv and summary.json of a folder: the same table to the last bit.
///
/// Fails with [`ReportError::NoTipLaw`] where a file is missing or is none of this version, with what is wrong.
pub fn read_tip_law(dir: &Path) -> Result<TipTable, ReportError> {
    let summary = dir.join("summary.json");
    let none = |path: &Path, reason: String| ReportError::NoTipLaw { path: path.to_path_buf(), reason };
    let text = read_whole(&summary).map_err(|error| none(&summary, error.to_string()))?;
    let value: Value = serde_json::from_slice(&text).map_err(|error| none(&summary, error.to_string()))?;
    let nodes = dir.join("tip_law.csv");
    let text = read_whole(&nodes).map_err(|error| none(&nodes, error.to_string()))?;
    let mut reader = csv::Reader::from_reader(text.as_slice());
    let rows: Result<Vec<Row>, _> = reader.deserialize().collect();
    let rows = rows.map_err(|error| none(&nodes, error.to_string()))?;
    let sheet = |on: TipSheet| {
        let own: Vec<&Row> = rows.iter().filter(|row| row.branch == sheet_word(on)).collect();
        Sheet::new(table_of(&own))
            .ok_or_else(|| none(&nodes, format!("the nodes of the branch {} are no grid", sheet_word(on))))
    };
    let summary_is = Summary { value: &value, none: &|key| none(&summary, format!("lacks the number {key}")) };
    summary_is.table(sheet(TipSheet::Attached)?, sheet(TipSheet::Detached)?)
}

/// The same for the tips of a seta: what the folder says of its spatula has to be what the scene says of its tips.
///
/// Fails as [`read_tip_law`], and with [`ReportError::OtherTipLaw`] where body, adhesion or pad are others, or the error of the table is above
/// `seta.tip_tolerance`.
pub fn read_tip_law_of(dir: &Path, scene: &Scene, tolerance: f64) -> Result<TipTable, ReportError> {
    let table = read_tip_law(dir)?;
    let path = dir.join("summary.json");
    let none = |reason: String| ReportError::NoTipLaw { path: path.clone(), reason };
    let text = read_whole(&path).map_err(|error| none(error.to_string()))?;
    let written: Value = serde_json::from_slice(&text).map_err(|error| none(error.to_string()))?;
    let wanted = serde_json::to_value(parameters(scene)).map_err(|error| none(error.to_string()))?;
    let other = |key: String, found: String, wanted: String| {
        Err(ReportError::OtherTipLaw { path: path.clone(), key, found, wanted })
    };
    for name in [body_of(scene), "adhesion"] {
        let Some(keys) = wanted[name].as_object() else { continue };
        for (key, value) in keys {
            let found = &written["parameters"][name][key];
            if found != value {
                return other(format!("{name}.{key}"), found.to_string(), value.to_string());
            }
        }
    }
    if table.options.pad_end != PadEnd::Sliding {
        return other(
            "pad_end".to_owned(),
            pad_end_word(PadEnd::Held).to_owned(),
            pad_end_word(PadEnd::Sliding).to_owned(),
        );
    }
    let error = table.relative_error();
    if error > tolerance {
        return other("the error of the table".to_owned(), format!("{error:.1e}"), format!("at most {tolerance:.1e}"));
    }
    Ok(table)
}

/// The grid of the rows of a branch: by v, then θ, then s.
fn table_of(rows: &[&Row]) -> SheetTable {
    let coordinate = |of: fn(&Row) -> f64| {
        let mut values: Vec<f64> = rows.iter().map(|row| of(row)).collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        values
    };
    let node = |row: &&Row| SheetNode {
        normal: row.normal_nm,
        slope: row.path_slope_nm,
        energy: row.energy,
        force: [row.normal_force, row.lateral_force, row.moment],
        adhering: row.adhering_nm,
    };
    SheetTable {
        path: coordinate(|row| row.path),
        lateral: coordinate(|row| row.lateral_nm),
        rotation: coordinate(|row| row.rotation_rad),
        nodes: rows.iter().map(node).collect(),
    }
}

/// The numbers of summary.json.
struct Summary<'a> {
    value: &'a Value,
    none: &'a dyn Fn(&str) -> ReportError,
}

impl Summary<'_> {
    fn number(&self, pointer: &str) -> Result<f64, ReportError> {
        self.value.pointer(pointer).and_then(Value::as_f64).ok_or_else(|| (self.none)(pointer))
    }

    fn pair(&self, pointer: &str) -> Result<[f64; 2], ReportError> {
        Ok([self.number(&format!("{pointer}/0"))?, self.number(&format!("{pointer}/1"))?])
    }

    fn errors(&self, branch: &str) -> Result<SheetErrors, ReportError> {
        let of = |key: &str| self.number(&format!("/{branch}/{key}"));
        Ok(SheetErrors {
            force: [of("normal_force_error_nN")?, of("lateral_force_error_nN")?, of("moment_error_nN_nm")?],
            limit: of("limit_error_nm")?,
            mesh: of("mesh_error_nm")?,
            checked: of("checked")? as usize,
            relative: of("relative_error")?,
        })
    }

    fn table(&self, attached: Sheet, detached: Sheet) -> Result<TipTable, ReportError> {
        let held = self.value["pad_end"] == pad_end_word(PadEnd::Held);
        let pad_end = if held { PadEnd::Held } else { PadEnd::Sliding };
        let lateral = if held { self.pair("/lateral_nm")? } else { [0.0; 2] };
        let range = TipRange { press: self.number("/press_nm")?, lateral, rotation: self.pair("/rotation_rad")? };
        let tolerance = self.number("/tolerance")?;
        Ok(TipTable {
            options: CoarseningOptions { range, tolerance, ..CoarseningOptions::of(pad_end) },
            attached,
            detached,
            attached_errors: self.errors("attached")?,
            detached_errors: self.errors("detached")?,
            scales: TipScales {
                force: self.number("/largest_force_nN")?,
                moment: self.number("/largest_moment_nN_nm")?,
                stiffness: self.number("/reference_stiffness_nN_per_nm")?,
            },
            neglected_force: self.number("/neglected_force_nN")?,
            rest_energy: self.number("/rest_energy_aJ")?,
            columns: self.number("/columns")? as usize,
            equilibria: self.number("/equilibria")? as usize,
        })
    }
}
