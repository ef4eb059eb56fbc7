//! A sweep as a table.

use super::number::{in_unit, short};
use peelkit::study::{FollowedSweep, PointKind};
use peelkit_report::{SweepRow, end_word};
use peelkit_scene::{Key, Scene};
use std::fmt::{Display, Write};

/// A sweep as a table, with what is to be said of its rows.
pub fn sweep(scene: &Scene, key: &Key, rows: &[SweepRow], remarks: &[String]) -> String {
    let mut text = format!("{}\n{} varied{}\n\n", scene.title, key.path(), in_unit(key.unit()));
    let missed = rows.iter().filter(|row| row.found.reached.is_some_and(|reached| reached > row.found.asked));
    let missed = missed.count();
    if missed > 0 {
        let _ =
            writeln!(text, "the tolerance was not met at {missed} of {} values: see accuracy_reached\n", rows.len());
    }
    let _ = writeln!(
        text,
        "{:>14} {:>14} {:>9} {:>14} {:>14} {:>12} {:>9}  end",
        "value", "peak nN", "± nN", "plateau nN", "snap-off nm", "work aJ", "ms"
    );
    let cell = |number: Option<f64>| number.map_or_else(|| "-".to_owned(), |number| format!("{number:.8}"));
    for SweepRow { value, found, solve_s, .. } in rows {
        let error = found.peak.map_or_else(|| "-".to_owned(), |at| format!("{:.0e}", at.force_error));
        let mark = if found.snap_off.is_none() { "*" } else { "" };
        let work = found.work.map_or_else(|| "-".to_owned(), |work| format!("{work:.5}{mark}"));
        let snap_off = found.snap_off.map_or_else(|| "-".to_owned(), |at| format!("{:.6}", at.displacement));
        let _ = writeln!(
            text,
            "{:>14} {:>14} {:>9} {:>14} {:>14} {:>12} {:>9.2}  {}",
            short(*value),
            cell(found.peak.map(|at| at.force)),
            error,
            cell(found.plateau.map(|at| at.force)),
            snap_off,
            work,
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
pub fn followed(scene: &Scene, key: &Key, sweep: &FollowedSweep, solve_s: &[f64]) -> String {
    let what = match sweep.kind {
        PointKind::InitiationPeak => "the initiation peak (the first local maximum of the force)",
        PointKind::SnapOff => "the snap-off",
    };
    let mut text = format!("{}\n{} varied{}; {what} followed\n\n", scene.title, key.path(), in_unit(key.unit()));
    let _ = writeln!(
        text,
        "{:>14} {:>14} {:>9} {:>14} {:>9} {:>12} {:>9}",
        "value", "force nN", "± nN", "at u nm", "± nm", "work aJ", "ms"
    );
    for (row, solve_s) in sweep.rows.iter().zip(solve_s) {
        let cell = |number: Option<f64>| number.map_or_else(|| "-".to_owned(), |number| format!("{number:.8}"));
        let error = |number: Option<f64>| number.map_or_else(|| "-".to_owned(), |number| format!("{number:.0e}"));
        let work = row.point.and_then(|at| at.work).map_or_else(|| "-".to_owned(), |work| format!("{work:.5}"));
        let _ = writeln!(
            text,
            "{:>14} {:>14} {:>9} {:>14} {:>9} {work:>12} {:>9.3}",
            short(row.value),
            cell(row.point.map(|at| at.force)),
            error(row.point.map(|at| at.force_error)),
            cell(row.point.map(|at| at.displacement)),
            error(row.point.map(|at| at.displacement_error)),
            1e3 * solve_s,
        );
    }
    text + &listed(&sweep.remarks)
}

/// Remarks below a table.
fn listed<T: Display>(remarks: &[T]) -> String {
    let lines: String = remarks.iter().map(|remark| format!("  remark: {remark}\n")).collect();
    if lines.is_empty() { lines } else { format!("\n{lines}") }
}
