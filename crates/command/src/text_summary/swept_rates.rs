//! A sweep of pulls at a rate as a table.

use super::sweep::{headed, largest, listed, none, pair, title, values};
use super::units::{Unit, Units, WantedUnits};
use peelkit_report::{RateRow, SweptKeys};
use peelkit_scene::Scene;
use std::fmt::Write;

/// A sweep of pulls at a rate as a table, with what is to be said of its rows.
pub fn swept_rates(
    scene: &Scene,
    keys: SweptKeys,
    rows: &[RateRow],
    remarks: &[String],
    wanted: WantedUnits,
) -> String {
    let found = || rows.iter().filter_map(|row| row.found.as_ref().ok());
    let sizes = found().map(|found| [found.largest_force, found.displacement, found.work]);
    let Units { force, length, work } = Units::fitting(wanted, largest(sizes));
    let mut text = title(scene, keys);
    let _ = writeln!(
        text,
        "{} {:>18} {:>12} {:>16} {:>12} {:>7} {:>9} {:>9}  end",
        pair("value", keys.second.map(|_| "value 2")),
        headed("largest force", force),
        headed("at U", length),
        headed("dissipated", work),
        headed("work", work),
        "steps",
        "imbalance",
        "ms"
    );
    for row in rows {
        let found = row.found.as_ref().ok();
        let cell = |number: Option<f64>, unit: Unit| number.map_or_else(none, |it| format!("{:.6}", unit.of(it)));
        let _ = writeln!(
            text,
            "{} {:>18} {:>12} {:>16} {:>12} {:>7} {:>9} {:>9.0}  {}",
            values(keys, row.value, row.second),
            cell(found.map(|found| found.largest_force), force),
            cell(found.map(|found| found.displacement), length),
            cell(found.map(|found| found.dissipated), work),
            cell(found.map(|found| found.work), work),
            found.map_or_else(none, |found| found.steps.to_string()),
            found.map_or_else(none, |found| format!("{:.0e}", found.imbalance)),
            1e3 * row.solve_s,
            row.end()
        );
    }
    text + &listed(remarks)
}
