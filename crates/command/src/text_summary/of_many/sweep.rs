//! A sweep as a table.

use crate::text_summary::number::{in_unit, short};
use crate::text_summary::units::{Unit, Units};
use peelkit::study::{FollowedSweep, PointKind};
use peelkit::units::PreferredUnits;
use peelkit_report::{SweepRow, SweptKeys, as_given, end_word};
use peelkit_scene::{Key, Scene};
use std::fmt::{Display, Write};

/// A sweep as a table, with what is to be said of its rows.
pub fn sweep(scene: &Scene, keys: SweptKeys, rows: &[SweepRow], remarks: &[String], wanted: PreferredUnits) -> String {
    let Units { force, length, work } = Units::fitting(wanted, sizes(rows));
    let mut text = title(scene, keys);
    let missed = rows.iter().filter(|row| row.found.reached.is_some_and(|reached| reached > row.found.asked));
    let missed = missed.count();
    if missed > 0 {
        let _ =
            writeln!(text, "the tolerance was not met at {missed} of {} values: see accuracy_reached\n", rows.len());
    }
    let _ = writeln!(
        text,
        "{} {:>14} {:>9} {:>14} {:>14} {:>12} {:>9}  end",
        pair("value", keys.second.map(|_| "value 2")),
        headed("peak", force),
        headed("±", force),
        headed("plateau", force),
        headed("snap-off", length),
        headed("work", work),
        "ms"
    );
    let cell = |number: Option<f64>| number.map_or_else(none, |number| format!("{:.8}", force.of(number)));
    for SweepRow { value, second, found, solve_s, .. } in rows {
        let error = found.peak.map_or_else(none, |at| format!("{:.0e}", force.of(at.force_error)));
        let mark = if found.snap_off.is_none() { "*" } else { "" };
        let worked = found.work.map_or_else(none, |worked| format!("{:.5}{mark}", work.of(worked)));
        let snap_off = found.snap_off.map_or_else(none, |at| format!("{:.6}", length.of(at.displacement)));
        let _ = writeln!(
            text,
            "{} {:>14} {:>9} {:>14} {:>14} {:>12} {:>9.2}  {}",
            values(keys, *value, *second),
            cell(found.peak.map(|at| at.force)),
            error,
            cell(found.plateau.map(|at| at.force)),
            snap_off,
            worked,
            1e3 * solve_s,
            end_word(&found.end)
        );
    }
    if rows.iter().any(|row| row.found.snap_off.is_none() && row.found.work.is_some()) {
        text += "\n* work to the end of a path without a jump, which is not the work of peeling\n";
    }
    text + &listed(remarks)
}

/// A sweep that followed one point as a table, with what happened to the point on the way.
pub fn followed(scene: &Scene, key: &Key, sweep: &FollowedSweep, solve_s: &[f64], wanted: PreferredUnits) -> String {
    let points = sweep.rows.iter().filter_map(|row| row.point);
    let sizes = points.map(|at| [at.force, at.displacement, at.work.unwrap_or(0.0)]);
    let Units { force, length, work } = Units::fitting(wanted, largest(sizes));
    let what = match sweep.kind {
        PointKind::InitiationPeak => "the initiation peak (the first local maximum of the force)",
        PointKind::SnapOff => "the snap-off",
    };
    let mut text = format!("{}\n{} varied{}; {what} followed\n\n", scene.title, key.path(), in_unit(key.usual_unit()));
    let _ = writeln!(
        text,
        "{:>14} {:>14} {:>9} {:>14} {:>9} {:>12} {:>9}",
        "value",
        headed("force", force),
        headed("±", force),
        headed("at u", length),
        headed("±", length),
        headed("work", work),
        "ms"
    );
    for (row, solve_s) in sweep.rows.iter().zip(solve_s) {
        let cell =
            |number: Option<f64>, unit: Unit| number.map_or_else(none, |number| format!("{:.8}", unit.of(number)));
        let error =
            |number: Option<f64>, unit: Unit| number.map_or_else(none, |number| format!("{:.0e}", unit.of(number)));
        let worked = row.point.and_then(|at| at.work).map_or_else(none, |worked| format!("{:.5}", work.of(worked)));
        let _ = writeln!(
            text,
            "{:>14} {:>14} {:>9} {:>14} {:>9} {worked:>12} {:>9.3}",
            short(as_given(key, row.value)),
            cell(row.point.map(|at| at.force), force),
            error(row.point.map(|at| at.force_error), force),
            cell(row.point.map(|at| at.displacement), length),
            error(row.point.map(|at| at.displacement_error), length),
            1e3 * solve_s,
        );
    }
    text + &listed(&sweep.remarks)
}

/// The title of a sweep and what is varied in it.
pub(in crate::text_summary) fn title(scene: &Scene, keys: SweptKeys) -> String {
    let varied = |key: &Key| format!("{} varied{}", key.path(), in_unit(key.usual_unit()));
    let second = keys.second.map(|key| format!("; {}", varied(key))).unwrap_or_default();
    format!("{}\n{}{second}\n\n", scene.title, varied(keys.first))
}

/// The cells of the values of one key or two.
pub(in crate::text_summary) fn pair(first: &str, second: Option<&str>) -> String {
    match second {
        None => format!("{first:>14}"),
        Some(second) => format!("{first:>14} {second:>14}"),
    }
}

/// The cells of the values of a row, in the units in which a user gives them.
pub(in crate::text_summary) fn values(keys: SweptKeys, value: f64, second: Option<f64>) -> String {
    let second = keys.second.zip(second).map(|(key, second)| short(as_given(key, second)));
    pair(&short(as_given(keys.first, value)), second.as_deref())
}

/// The head of a column of numbers in a unit.
pub(in crate::text_summary) fn headed(name: &str, unit: Unit) -> String {
    format!("{name} {}", unit.name())
}

/// The cell of a thing that does not occur.
pub(in crate::text_summary) fn none() -> String {
    "-".to_owned()
}

/// The largest force (nN), displacement (nm) and work (aJ) of the rows.
fn sizes(rows: &[SweepRow]) -> [f64; 3] {
    largest(rows.iter().map(|SweepRow { found, .. }| {
        let force = found.peak.map_or(0.0, |at| at.force);
        [force, found.snap_off.map_or(0.0, |at| at.displacement), found.work.unwrap_or(0.0)]
    }))
}

pub(in crate::text_summary) fn largest(sizes: impl Iterator<Item = [f64; 3]>) -> [f64; 3] {
    sizes.fold([0.0; 3], |all, one| std::array::from_fn(|k| all[k].max(one[k].abs())))
}

/// Remarks below a table.
pub(in crate::text_summary) fn listed<T: Display>(remarks: &[T]) -> String {
    let lines: String = remarks.iter().map(|remark| format!("  remark: {remark}\n")).collect();
    if lines.is_empty() { lines } else { format!("\n{lines}") }
}
