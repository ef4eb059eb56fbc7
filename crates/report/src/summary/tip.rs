//! The law of a tip as one JSON object: summary.json of `peel coarsen`, and what `--json` prints.

use super::origin::Origin;
use super::parameters::Parameters;
use super::written::written;
use crate::number::Finite;
use peelkit::study::coarsening::{PadEnd, Sheet, SheetErrors, TipPlace, TipSheet, TipTable};
use peelkit_scene::Scene;

/// A table of a tip as one object. `None` where a thing does not occur.
#[derive(Debug, serde::Serialize)]
pub struct TipSummary {
    #[serde(flatten)]
    origin: Origin,
    end: &'static str,
    pad_end: &'static str,
    tolerance: Finite,
    press_nm: Finite,
    lateral_nm: Option<[Finite; 2]>,
    rotation_rad: [Finite; 2],
    #[serde(rename = "largest_force_nN")]
    largest_force: Finite,
    #[serde(rename = "largest_moment_nN_nm")]
    largest_moment: Finite,
    #[serde(rename = "reference_stiffness_nN_per_nm")]
    reference_stiffness: Finite,
    #[serde(rename = "rest_energy_aJ")]
    rest_energy: Finite,
    #[serde(rename = "neglected_force_nN")]
    neglected_force: Finite,
    attached: Branch,
    detached: Branch,
    columns: usize,
    equilibria: usize,
    solve_s: Finite,
    parameters: Parameters,
}

#[derive(Debug, serde::Serialize)]
struct Branch {
    path_nodes: usize,
    lateral_nodes: usize,
    rotation_nodes: usize,
    limit_nm: Finite,
    #[serde(rename = "limit_force_nN")]
    limit_force: Finite,
    #[serde(rename = "released_aJ")]
    released: Finite,
    #[serde(rename = "normal_force_error_nN")]
    normal_force_error: Finite,
    #[serde(rename = "lateral_force_error_nN")]
    lateral_force_error: Finite,
    #[serde(rename = "moment_error_nN_nm")]
    moment_error: Finite,
    limit_error_nm: Finite,
    mesh_error_nm: Finite,
    relative_error: Finite,
    checked: usize,
}

impl Branch {
    fn new(table: &TipTable, on: TipSheet) -> Self {
        let (sheet, errors): (&Sheet, &SheetErrors) = (table.sheet(on), table.errors(on));
        let limit = sheet.limit(TipPlace::default());
        let place = TipPlace { normal: limit.normal, ..TipPlace::default() };
        let other = match on {
            TipSheet::Attached => TipSheet::Detached,
            TipSheet::Detached => TipSheet::Attached,
        };
        let released = limit.energy - table.response(other, place).energy;
        let nodes = sheet.table();
        let [normal_force_error, lateral_force_error, moment_error] = errors.force.map(Finite);
        Self {
            path_nodes: nodes.path.len(),
            lateral_nodes: nodes.lateral.len(),
            rotation_nodes: nodes.rotation.len(),
            limit_nm: Finite(limit.normal),
            limit_force: Finite(limit.force[0]),
            released: Finite(released),
            normal_force_error,
            lateral_force_error,
            moment_error,
            limit_error_nm: Finite(errors.limit),
            mesh_error_nm: Finite(errors.mesh),
            relative_error: Finite(errors.relative),
            checked: errors.checked,
        }
    }
}

/// What a pad end is called in outputs.
pub(crate) fn pad_end_word(pad_end: PadEnd) -> &'static str {
    match pad_end {
        PadEnd::Held => "held",
        PadEnd::Sliding => "sliding",
    }
}

impl TipSummary {
    /// The summary of the table of a scene.
    pub fn new(scene: &Scene, table: &TipTable, solve_s: f64) -> Self {
        let (options, scales) = (&table.options, &table.scales);
        let held = options.pad_end == PadEnd::Held;
        Self {
            origin: Origin::of(scene),
            end: if table.is_met() { "converged" } else { "tolerance-not-met" },
            pad_end: pad_end_word(options.pad_end),
            tolerance: Finite(options.tolerance),
            press_nm: Finite(options.range.press),
            lateral_nm: held.then(|| options.range.lateral.map(Finite)),
            rotation_rad: options.range.rotation.map(Finite),
            largest_force: Finite(scales.force),
            largest_moment: Finite(scales.moment),
            reference_stiffness: Finite(scales.stiffness),
            rest_energy: Finite(table.rest_energy),
            neglected_force: Finite(table.neglected_force),
            attached: Branch::new(table, TipSheet::Attached),
            detached: Branch::new(table, TipSheet::Detached),
            columns: table.columns,
            equilibria: table.equilibria,
            solve_s: Finite(solve_s),
            parameters: Parameters(scene.clone()),
        }
    }
}

written!(TipSummary);
