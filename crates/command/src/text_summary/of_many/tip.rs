//! The law of a tip, laid out for a person.

use peelkit::study::coarsening::{PadEnd, SheetLimit, TipPlace, TipSheet, TipTable};

/// What the table holds, its limits and its errors.
pub fn tip(title: &str, table: &TipTable, solve_s: f64) -> String {
    let range = &table.options.range;
    let [from, to] = range.rotation;
    let mut text =
        format!("{title}\n\nlaw of a tip   pressed by up to {} nm, θ from {from:.4} to {to:.4} rad", range.press);
    text += &match table.options.pad_end {
        PadEnd::Sliding => ", a pad that slides\n".to_owned(),
        PadEnd::Held => {
            let [from, to] = range.lateral;
            format!(", v from {from} to {to} nm\n")
        }
    };
    text += &format!("largest force  {:.6} nN, largest moment {:.4} nN nm\n", table.scales.force, table.scales.moment);
    for (on, name, what) in
        [(TipSheet::Attached, "attached", "snaps off"), (TipSheet::Detached, "detached", "snaps on")]
    {
        let (sheet, errors) = (table.sheet(on), table.errors(on));
        let SheetLimit { normal: limit, force: [force, ..], .. } = sheet.limit(TipPlace::default());
        let nodes = sheet.table();
        text += &format!(
            "{name:<15}{what} at u = {limit:.6} nm (v = 0, θ = 0), with {force:.6} nN\n{:15}errors below {:.1e} nN, {:.1e} nN along the substrate, {:.1e} nN nm, limit {:.1e} nm\n{:15}{} x {} x {} nodes along the branch, of v and of θ; checked at {} places between\n",
            "",
            errors.force[0],
            errors.force[1],
            errors.force[2],
            errors.limit,
            "",
            nodes.path.len(),
            nodes.lateral.len(),
            nodes.rotation.len(),
            errors.checked,
        );
    }
    text += &format!(
        "far away       zero where the substrate attracts the tip by less than {:.1e} nN\n{:15}{} equilibria on {} paths, {solve_s:.2} s\n",
        table.neglected_force, "", table.equilibria, table.columns
    );
    text
}
