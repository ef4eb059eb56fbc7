//! Sweeps of pulls at a rate and of setae as tables.

use crate::text_summary::of_many::sweep::{headed, largest, listed, none, pair, title, values};
use crate::text_summary::units::{Unit, Units};
use peelkit::study::SetaMoment;
use peelkit::units::PreferredUnits;
use peelkit_report::{RateRow, SetaRow, SweptKeys};
use peelkit_scene::Scene;
use std::fmt::Write;

/// A sweep of setae as a table, with what is to be said of its rows.
pub fn swept_setae(
    scene: &Scene,
    keys: SweptKeys,
    rows: &[SetaRow],
    remarks: &[String],
    wanted: PreferredUnits,
) -> String {
    let found = || rows.iter().filter_map(|row| row.found.as_ref().ok());
    let sizes = found().map(|found| {
        let at = |moment: Option<SetaMoment>| moment.map_or([0.0; 2], |at| [at.force, at.displacement]);
        let [force, displacement] = at(found.peak);
        [force, displacement, found.work]
    });
    let Units { force, length, work } = Units::fitting(wanted, largest(sizes));
    let mut text = title(scene, keys);
    let _ = writeln!(
        text,
        "{} {:>14} {:>12} {:>8} {:>16} {:>7} {:>12} {:>9} {:>9}  end",
        pair("value", keys.second.map(|_| "value 2")),
        headed("peak", force),
        headed("at u", length),
        "attached",
        headed("first event", length),
        "events",
        headed("work", work),
        "imbalance",
        "ms"
    );
    for row in rows {
        let cell = |number: Option<f64>, unit: Unit| number.map_or_else(none, |it| format!("{:.6}", unit.of(it)));
        let count = |number: Option<usize>| number.map_or_else(none, |number| number.to_string());
        let (found, peak) = (row.found.as_ref().ok(), row.peak());
        let first = found.and_then(|found| found.first_detachment).map(|at| at.displacement);
        let _ = writeln!(
            text,
            "{} {:>14} {:>12} {:>8} {:>16} {:>7} {:>12} {:>9} {:>9.0}  {}",
            values(keys, row.value, row.second),
            cell(peak.map(|at| at.force), force),
            cell(peak.map(|at| at.displacement), length),
            count(peak.map(|at| at.attached)),
            cell(first, length),
            count(found.map(|found| found.events)),
            cell(found.map(|found| found.work), work),
            found.map_or_else(none, |found| format!("{:.0e}", found.imbalance)),
            1e3 * row.solve_s,
            row.end()
        );
    }
    text + &listed(remarks)
}

/// A sweep of pulls at a rate as a table, with what is to be said of its rows.
pub fn swept_rates(
    scene: &Scene,
    keys: SweptKeys,
    rows: &[RateRow],
    remarks: &[String],
    wanted: PreferredUnits,
) -> String {
    let found = || rows.iter().filter_map(|row| row.found.as_ref().ok());
    let sizes = found().map(|found| [found.largest_force, found.displacement, found.work]);
    let Units { force, length, work } = Units::fitting(wanted, largest(sizes));
    let mut text = title(scene, keys);
    let _ = writeln!(
        text,
        "{} {:>18} {:>12} {:>16} {:>16} {:>12} {:>7} {:>9} {:>9}  end",
        pair("value", keys.second.map(|_| "value 2")),
        headed("largest force", force),
        headed("at U", length),
        headed("dissipated", work),
        headed("mean force", force),
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
            "{} {:>18} {:>12} {:>16} {:>16} {:>12} {:>7} {:>9} {:>9.0}  {}",
            values(keys, row.value, row.second),
            cell(found.map(|found| found.largest_force), force),
            cell(found.map(|found| found.displacement), length),
            cell(found.map(|found| found.dissipated), work),
            cell(found.and_then(|found| found.mean_force), force),
            cell(found.map(|found| found.work), work),
            found.map_or_else(none, |found| found.steps.to_string()),
            found.map_or_else(none, |found| format!("{:.0e}", found.imbalance)),
            1e3 * row.solve_s,
            row.end()
        );
    }
    text + &listed(remarks)
}
