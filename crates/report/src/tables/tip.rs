//! The tables of the law of a tip: tip_law.csv, its nodes, and tip_limits.csv, where its branches end. Units stand in the names of the columns.

use super::table::write_table;
use crate::error::ReportError;
use crate::number::Finite;
use peelkit::study::coarsening::{SheetNode, SheetTable, TipPlace, TipSheet, TipTable};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// What a branch is called in outputs.
pub(crate) fn sheet_word(sheet: TipSheet) -> &'static str {
    match sheet {
        TipSheet::Attached => "attached",
        TipSheet::Detached => "detached",
    }
}

#[derive(Debug, Default, Serialize)]
struct Line {
    branch: &'static str,
    path: Finite,
    lateral_nm: Finite,
    rotation_rad: Finite,
    normal_nm: Finite,
    path_slope_nm: Finite,
    #[serde(rename = "energy_aJ")]
    energy: Finite,
    #[serde(rename = "normal_force_nN")]
    normal_force: Finite,
    #[serde(rename = "lateral_force_nN")]
    lateral_force: Finite,
    #[serde(rename = "moment_nN_nm")]
    moment: Finite,
    adhering_nm: Finite,
}

#[derive(Debug, Default, Serialize)]
struct LimitLine {
    branch: &'static str,
    lateral_nm: Finite,
    rotation_rad: Finite,
    limit_nm: Finite,
    #[serde(rename = "normal_force_nN")]
    normal_force: Finite,
    #[serde(rename = "lateral_force_nN")]
    lateral_force: Finite,
    #[serde(rename = "moment_nN_nm")]
    moment: Finite,
    #[serde(rename = "energy_aJ")]
    energy: Finite,
    #[serde(rename = "released_aJ")]
    released: Option<Finite>,
}

const SHEETS: [TipSheet; 2] = [TipSheet::Attached, TipSheet::Detached];

/// Writes tip_law.csv, one row a node, and tip_limits.csv, one row a limit point.
///
/// Fails with [`ReportError::Write`] where a file cannot be written or a number is not finite.
pub fn write_tip_law(dir: &Path, table: &TipTable) -> Result<Vec<PathBuf>, ReportError> {
    let nodes = SHEETS.iter().flat_map(|&sheet| lines(sheet, table.sheet(sheet).table()));
    let limits = SHEETS.iter().flat_map(|&sheet| {
        table.sheet(sheet).table().limits().map(move |(place, node)| limit(table, sheet, place, node))
    });
    Ok(vec![write_table(dir, "tip_law.csv", nodes)?, write_table(dir, "tip_limits.csv", limits)?])
}

fn lines(sheet: TipSheet, table: &SheetTable) -> impl Iterator<Item = Line> + '_ {
    let line = move |v: usize, t: usize, s: usize| {
        let node = table.column(v, t)[s];
        let [normal_force, lateral_force, moment] = node.force.map(Finite);
        Line {
            branch: sheet_word(sheet),
            path: Finite(table.path[s]),
            lateral_nm: Finite(table.lateral[v]),
            rotation_rad: Finite(table.rotation[t]),
            normal_nm: Finite(node.normal),
            path_slope_nm: Finite(node.slope),
            energy: Finite(node.energy),
            normal_force,
            lateral_force,
            moment,
            adhering_nm: Finite(node.adhering),
        }
    };
    let rotations = move |v: usize| (0..table.rotation.len()).map(move |t| (v, t));
    let columns = (0..table.lateral.len()).flat_map(rotations);
    columns.flat_map(move |(v, t)| (0..table.path.len()).map(move |s| line(v, t, s)))
}

fn limit(table: &TipTable, sheet: TipSheet, place: TipPlace, node: &SheetNode) -> LimitLine {
    let other = match sheet {
        TipSheet::Attached => TipSheet::Detached,
        TipSheet::Detached => TipSheet::Attached,
    };
    let released = table.contains(other, place).then(|| node.energy - table.response(other, place).energy);
    let [normal_force, lateral_force, moment] = node.force.map(Finite);
    LimitLine {
        branch: sheet_word(sheet),
        lateral_nm: Finite(place.lateral),
        rotation_rad: Finite(place.rotation),
        limit_nm: Finite(place.normal),
        normal_force,
        lateral_force,
        moment,
        energy: Finite(node.energy),
        released: released.map(Finite),
    }
}
