//! The summary of the peel of a solid, and a sweep of such peels as a table.

use super::found::passed_lines;
use super::number::in_columns;
use super::units::{Unit, Units};
use crate::text_summary::of_many::sweep::{headed, largest, listed, none, pair, title, values};
use peelkit::model::LongElements;
use peelkit::study::{LimitPointKind, SolidLimitPoint, SolidPeel};
use peelkit::units::PreferredUnits;
use peelkit_report::{PassedAt, SolidRow, SweptKeys, solid_end_reason, solid_end_word, solid_warnings};
use peelkit_scene::Scene;
use std::fmt::Write;

/// Most limit points that are listed.
const LISTED: usize = 12;

/// The summary of the peel of a solid, whose elements may be too long, and which took so many seconds.
pub fn solid(
    scene: &Scene,
    peel: &SolidPeel,
    long: Option<&LongElements>,
    solve_s: f64,
    wanted: PreferredUnits,
) -> String {
    let way = peel.points.iter().map(|at| at.displacement.abs()).fold(0.0, f64::max);
    let force = peel.points.iter().map(|at| at.force.abs()).fold(0.0, f64::max);
    let work = peel.points.iter().filter_map(|at| at.work).map(f64::abs).fold(0.0, f64::max);
    let units = Units::fitting(wanted, [force, way, work]);
    let Units { force, length, work } = units;
    let turn = |at: &SolidLimitPoint| match at.errors {
        Some(errors) => format!(
            "{} at u = {}",
            force.with_error(at.force, errors.force),
            length.with_error(at.displacement, errors.displacement)
        ),
        None => format!("{} at u = {}, without a bound", force.short(at.force), length.short(at.displacement)),
    };
    let or_none = |at: Option<&SolidLimitPoint>| at.map_or_else(|| "none".to_owned(), turn);
    let mut lines = vec![("peak force", or_none(peel.peak())), ("first peak", or_none(peel.initiation_peak()))];
    lines.push(("first jump", or_none(peel.snap_off())));
    lines.extend(
        peel.points
            .last()
            .and_then(|last| last.work)
            .map(|total| ("work", format!("{} to the end", work.short(total)))),
    );
    for (index, at) in peel.limit_points.iter().take(LISTED).enumerate() {
        let kind = match at.kind {
            LimitPointKind::Displacement => "displacement limit point",
            LimitPointKind::Load => "load limit point",
        };
        lines.push((if index == 0 { "limit points" } else { "" }, format!("{kind}: {}", turn(at))));
    }
    if peel.limit_points.len() > LISTED {
        lines.push(("", format!("and {} more: see limit_points.csv", peel.limit_points.len() - LISTED)));
    }
    let looked_for = scene.looked_for();
    lines.extend(passed_lines(&PassedAt::of_solid(peel, &looked_for), &looked_for, &units));
    lines.extend(solid_warnings(peel, long).into_iter().map(|warning| ("warning", warning)));
    let reason = solid_end_reason(&peel.end).map_or(String::new(), |reason| format!(": {reason}"));
    lines.push(("end", format!("{}{reason}", solid_end_word(&peel.end))));
    let cost = format!(
        "{} points, {} Newton iterations, {} elements {}, {} unknowns, {:.0} ms",
        peel.points.len(),
        peel.iterations,
        peel.body.elements(),
        peel.body.element(),
        peel.body.unknowns(),
        1e3 * solve_s
    );
    lines.push(("computational cost", cost));
    in_columns(&scene.title, &lines)
}

/// A sweep of peels of solids as a table, with what is to be said of its rows.
pub fn swept_solids(
    scene: &Scene,
    keys: SweptKeys,
    rows: &[SolidRow],
    remarks: &[String],
    wanted: PreferredUnits,
) -> String {
    let found = || rows.iter().filter_map(|row| row.found.as_ref().ok());
    let sizes = found().filter_map(|found| found.peak).map(|peak| [peak.force, peak.displacement, 0.0]);
    let Units { force, length, .. } = Units::fitting(wanted, largest(sizes));
    let mut text = title(scene, keys);
    let _ = writeln!(
        text,
        "{} {:>16} {:>12} {:>12} {:>16} {:>9} {:>9}  end",
        pair("value", keys.second.map(|_| "value 2")),
        headed("peak force", force),
        headed("±", force),
        headed("at u", length),
        headed("first jump", length),
        "unknowns",
        "ms"
    );
    for row in rows {
        let found = row.found.as_ref().ok();
        let peak = found.and_then(|found| found.peak);
        let cell = |number: Option<f64>, unit: Unit| number.map_or_else(none, |it| format!("{:.6}", unit.of(it)));
        let _ = writeln!(
            text,
            "{} {:>16} {:>12} {:>12} {:>16} {:>9} {:>9.0}  {}",
            values(keys, row.value, row.second),
            cell(peak.map(|peak| peak.force), force),
            cell(peak.and_then(|peak| peak.error), force),
            cell(peak.map(|peak| peak.displacement), length),
            cell(found.and_then(|found| Some(found.first_jump?.displacement)), length),
            found.map_or_else(none, |found| found.unknowns.to_string()),
            1e3 * row.solve_s,
            found.map_or("failed", |found| found.end.as_str())
        );
    }
    text + &listed(remarks)
}
