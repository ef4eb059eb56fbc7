//! The law of a tip: tip_law.csv, its nodes, tip_limits.csv, where its branches end, and the object summary.json. Units stand in the names.

use crate::records::summary::{Found, Summary};
use crate::writing::error::ReportError;
use crate::writing::record::write_table;
use crate::writing::record::{Fields, Record};
use crate::writing::reference::Output;
use peelkit::study::coarsening::{PadEnd, SheetLimit, SheetNode, SheetTable, TipPlace, TipSheet, TipTable};
use peelkit_scene::Scene;
use std::path::{Path, PathBuf};

/// What a branch is called in outputs.
pub(crate) fn sheet_word(sheet: TipSheet) -> &'static str {
    match sheet {
        TipSheet::Attached => "attached",
        TipSheet::Detached => "detached",
    }
}

/// What a pad end is called in outputs.
pub(crate) fn pad_end_word(pad_end: PadEnd) -> &'static str {
    match pad_end {
        PadEnd::Held => "held",
        PadEnd::Sliding => "sliding",
    }
}

const SHEETS: [TipSheet; 2] = [TipSheet::Attached, TipSheet::Detached];

fn other(sheet: TipSheet) -> TipSheet {
    match sheet {
        TipSheet::Attached => TipSheet::Detached,
        TipSheet::Detached => TipSheet::Attached,
    }
}

/// A node of a branch.
struct NodeRow<'a> {
    sheet: TipSheet,
    path: f64,
    lateral: f64,
    rotation: f64,
    node: &'a SheetNode,
}

impl Record for NodeRow<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("branch", "`attached` or `detached`", |row| sheet_word(row.sheet));
        of.field("path", "s: 0 where the branch begins, 1 at its limit point", |row| row.path);
        of.field("lateral_nm", "v: of the end along the substrate, away from the free end of the pad", |row| row.lateral);
        of.field("rotation_rad", "θ: of the end, positive anticlockwise", |row| row.rotation);
        of.field("normal_nm", "u: of the end away from the substrate", |row| row.node.normal);
        of.field("path_slope_nm", "∂u/∂s", |row| row.node.slope);
        of.field("energy_aJ", "E, stored and of adhesion", |row| row.node.energy);
        of.field("normal_force_nN", "∂E/∂u: what holds the end", |row| row.node.force[0]);
        of.field("lateral_force_nN", "∂E/∂v", |row| row.node.force[1]);
        of.field("moment_nN_nm", "∂E/∂θ", |row| row.node.force[2]);
        of.field("adhering_nm", "length of the pad that adheres: energy of adhesion over that of a unit length of the free end at rest", |row| row.node.adhering);
    }
}

/// A limit point of a branch.
struct LimitRow<'a> {
    table: &'a TipTable,
    sheet: TipSheet,
    place: TipPlace,
    node: &'a SheetNode,
}

impl Record for LimitRow<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("branch", "`attached`: here the tip snaps off; `detached`: here it snaps on", |row| sheet_word(row.sheet));
        of.field("lateral_nm", "v", |row| row.place.lateral);
        of.field("rotation_rad", "θ", |row| row.place.rotation);
        of.field("limit_nm", "u of the limit point", |row| row.place.normal);
        of.field("normal_force_nN", "∂E/∂u there", |row| row.node.force[0]);
        of.field("lateral_force_nN", "∂E/∂v there", |row| row.node.force[1]);
        of.field("moment_nN_nm", "∂E/∂θ there", |row| row.node.force[2]);
        of.field("energy_aJ", "E there", |row| row.node.energy);
        of.field("released_aJ", "energy released where the tip goes over to the other branch at the same u, v and θ; empty where the table of that does not reach", |row| row.released());
    }
}

impl LimitRow<'_> {
    /// Where the table of the other branch reaches.
    fn released(&self) -> Option<f64> {
        let other = other(self.sheet);
        let reaches = self.table.contains(other, self.place);
        reaches.then(|| self.node.energy - self.table.response(other, self.place).energy)
    }
}

/// Writes tip_law.csv, one row a node, and tip_limits.csv, one row a limit point.
///
/// Fails with [`ReportError::Write`] where a file cannot be written or a number is not finite.
pub fn write_tip_law(dir: &Path, table: &TipTable) -> Result<Vec<PathBuf>, ReportError> {
    let nodes = SHEETS.iter().flat_map(|&sheet| nodes(sheet, table.sheet(sheet).table()));
    let limits = SHEETS.iter().flat_map(|&sheet| {
        table.sheet(sheet).table().limits().map(move |(place, node)| LimitRow { table, sheet, place, node })
    });
    Ok(vec![write_table(dir, "tip_law.csv", nodes)?, write_table(dir, "tip_limits.csv", limits)?])
}

/// By v, then θ, then s.
fn nodes(sheet: TipSheet, table: &SheetTable) -> impl Iterator<Item = NodeRow<'_>> {
    let rotations = move |v: usize| (0..table.rotation.len()).map(move |t| (v, t));
    let columns = (0..table.lateral.len()).flat_map(rotations);
    columns.flat_map(move |(v, t)| {
        let (lateral, rotation) = (table.lateral[v], table.rotation[t]);
        let nodes = table.path.iter().zip(table.column(v, t));
        nodes.map(move |(&path, node)| NodeRow { sheet, path, lateral, rotation, node })
    })
}

/// A table of a tip.
#[derive(Clone, Copy, Debug)]
pub struct TipFound<'a> {
    table: &'a TipTable,
    solve_s: f64,
}

/// A table of a tip as one object.
pub type TipSummary<'a> = Summary<'a, TipFound<'a>>;

impl<'a> TipSummary<'a> {
    /// The summary of the table of a scene.
    pub fn new(scene: &'a Scene, table: &'a TipTable, solve_s: f64) -> Self {
        Summary::of(scene, TipFound { table, solve_s })
    }
}

impl Record for TipFound<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("end", "`converged`; `tolerance-not-met`: the table was not refined further, and its errors are above the tolerance", |found| if found.table.is_met() { "converged" } else { "tolerance-not-met" });
        of.field("pad_end", "`sliding`: the pad slides without friction and v changes nothing; `held`: the free end of the pad stays where it adheres", |found| pad_end_word(found.table.options.pad_end));
        of.field("tolerance", "error asked of forces and moment, over the largest of each", |found| found.table.options.tolerance);
        of.field("press_nm", "how far below the height without a normal force the table begins", |found| found.table.options.range.press);
        of.field("lateral_nm", "range of v; null where the pad slides", |found| (found.table.options.pad_end == PadEnd::Held).then_some(found.table.options.range.lateral));
        of.field("rotation_rad", "range of θ", |found| found.table.options.range.rotation);
        of.field("largest_force_nN", "largest normal force of the table: what errors of forces are measured by", |found| found.table.scales.force);
        of.field("largest_moment_nN_nm", "largest moment of the table, without its sign: what errors of the moment are measured by", |found| found.table.scales.moment);
        of.field("reference_stiffness_nN_per_nm", "K0: where the branch is stiffer, an error is K0 times one of the displacement", |found| found.table.scales.stiffness);
        of.field("rest_energy_aJ", "E at rest; zero is the stress-free spatula far from the substrate", |found| found.table.rest_energy);
        of.field("neglected_force_nN", "normal force at which the detached branch begins: farther away it is taken to be zero", |found| found.table.neglected_force);
        of.field("attached", "the branch on which the pad adheres", |found| Branch { table: found.table, on: TipSheet::Attached });
        of.field("detached", "the branch on which it does not", |found| Branch { table: found.table, on: TipSheet::Detached });
        of.field("columns", "pairs of v and θ at which the spatula was followed", |found| found.table.columns);
        of.field("equilibria", "equilibria at nodes and between them", |found| found.table.equilibria);
        of.field("solve_s", "time of the computation", |found| found.solve_s);
    }
}

impl Found for TipFound<'_> {
    const PARAMETERS: &'static str = "the scene as it was computed";
}

/// A branch of the law.
struct Branch<'a> {
    table: &'a TipTable,
    on: TipSheet,
}

impl Record for Branch<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("path_nodes", "nodes along the branch", |found| found.nodes().path.len());
        of.field("lateral_nodes", "nodes of v", |found| found.nodes().lateral.len());
        of.field("rotation_nodes", "nodes of θ", |found| found.nodes().rotation.len());
        of.field("limit_nm", "u of the limit point at v = 0 and θ = 0", |found| found.limit().normal);
        of.field("limit_force_nN", "normal force there", |found| found.limit().force[0]);
        of.field("released_aJ", "energy that is released where it goes over to the other branch there", |found| found.released());
        of.field("normal_force_error_nN", "bound of the error of P: twice the largest that was measured between the nodes", |found| found.table.errors(found.on).force[0]);
        of.field("lateral_force_error_nN", "the same for the force along the substrate", |found| found.table.errors(found.on).force[1]);
        of.field("moment_error_nN_nm", "the same for the moment", |found| found.table.errors(found.on).force[2]);
        of.field("limit_error_nm", "the same for u at the limit point", |found| found.table.errors(found.on).limit);
        of.field("mesh_error_nm", "twice the largest difference of a limit point on half as many elements again", |found| found.table.errors(found.on).mesh);
        of.field("relative_error", "the largest of the errors of forces and moment over what they are measured by", |found| found.table.errors(found.on).relative);
        of.field("checked", "at how many places between the nodes the spatula was solved for them", |found| found.table.errors(found.on).checked);
    }
}

impl Branch<'_> {
    fn nodes(&self) -> &SheetTable {
        self.table.sheet(self.on).table()
    }

    /// Where it ends at v = 0 and θ = 0.
    fn limit(&self) -> SheetLimit {
        self.table.sheet(self.on).limit(TipPlace::default())
    }

    fn released(&self) -> f64 {
        let limit = self.limit();
        let place = TipPlace { normal: limit.normal, ..TipPlace::default() };
        limit.energy - self.table.response(other(self.on), place).energy
    }
}

/// The tables and the object.
pub(crate) fn outputs() -> Vec<Output> {
    vec![
        Output::object("peel coarsen", TipSummary::keys()),
        Output::table("tip_law.csv", NodeRow::keys()),
        Output::table("tip_limits.csv", LimitRow::keys()),
    ]
}
