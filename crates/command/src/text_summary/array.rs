//! The summary of the pull of an array of setae, and a sweep of such pulls as a table.

use super::number::in_columns;
use super::of_many::sweep::{headed, largest, listed, none, pair, title, values};
use super::units::{Unit, Units};
use peelkit::toe::ArrayPull;
use peelkit::units::PreferredUnits;
use peelkit_report::{ArrayResult, SweptArray, SweptKeys, array_end_word};
use peelkit_scene::{ArrayTable, BandLoad, Scene, array_warnings};
use std::fmt::Write;

/// The summary of a pull that took so many seconds.
pub fn array(scene: &Scene, table: &ArrayTable, pull: &ArrayPull, seconds: f64, wanted: PreferredUnits) -> String {
    let moment = table.lamella.is_some_and(|lamella| lamella.load != BandLoad::Force);
    let way = pull.events.iter().map(|at| at.lift.abs()).fold(0.0, f64::max);
    let Units { force, length, work } = Units::fitting(wanted, [pull.largest_load.abs(), way, pull.work.abs()]);
    let at = |load: f64, lift: f64| match moment {
        true => format!("{:.6e} nN nm at {:.6} rad", load, lift),
        false => format!("{} at a lift of {}", force.short(load), length.short(lift)),
    };
    let mut lines = vec![("setae", format!("{}, of which {} detach", pull.setae, pull.detached))];
    lines.push(("events", format!("{} in {} jumps", pull.events.len(), pull.jumps())));
    if let Some(event) = pull.peak.and_then(|peak| pull.events.get(peak)) {
        let number = pull.peak.map_or(0, |peak| peak + 1);
        lines.push(("peak", format!("{}, event {number}", at(event.load, event.lift))));
    }
    lines.extend(pull.events.first().map(|event| ("first loss", at(event.load, event.lift))));
    if let Some(total) = table.strength().map(|own| own * pull.setae as f64).filter(|_| !moment) {
        let share = 100.0 * pull.largest_load / total;
        lines.push(("equal sharing", format!("{}; the peak is {share:.2} % of it", force.short(total))));
    }
    if let Some(steady) = table.steady_force(scene.model.pull.angle).filter(|_| table.toe.is_none()) {
        lines.push(("steady peel", format!("{} in closed form, of a long tape", force.short(steady))));
    }
    lines.push(("work", format!("{}, released {}", work.short(pull.work), work.short(pull.released))));
    lines.extend(array_warnings(table).into_iter().map(|warning| ("warning", warning)));
    lines.push(("end", array_end_word(pull.end).to_owned()));
    lines.push(("computational cost", format!("{:.0} ms", 1e3 * seconds)));
    in_columns(&scene.title, &lines)
}

/// A sweep of pulls of arrays as a table, with what is to be said of its rows.
pub fn swept_arrays(
    scene: &Scene,
    keys: SweptKeys,
    rows: &[SweptArray],
    remarks: &[String],
    wanted: PreferredUnits,
) -> String {
    let found = || rows.iter().filter_map(|row| row.found.as_ref().ok());
    let is_moment = found().any(|found| found.is_moment);
    let lift = |found: &ArrayResult| found.peak.map_or(0.0, |[_, lift]| lift);
    let sizes = found().filter(|_| !is_moment).map(|found| [found.largest_load, lift(found), found.work]);
    let Units { force, length, work } = Units::fitting(wanted, largest(sizes));
    let mut text = title(scene, keys);
    let loads = if is_moment {
        ["largest (nN nm)", "first loss (nN nm)", "at (rad)"].map(str::to_owned)
    } else {
        [headed("largest load", force), headed("first loss", force), headed("at a lift of", length)]
    };
    let [largest_load, first_loss, at] = loads;
    let _ = writeln!(
        text,
        "{} {largest_load:>18} {at:>18} {first_loss:>18} {:>14} {:>9} {:>9} {:>9}  end",
        pair("value", keys.second.map(|_| "value 2")),
        headed("work", work),
        "detached",
        "events",
        "ms"
    );
    for row in rows {
        let found = row.found.as_ref().ok();
        let plain = |number: f64| format!("{number:.6e}");
        let cell = |number: Option<f64>, unit: Unit| {
            number.map_or_else(none, |it| if is_moment { plain(it) } else { format!("{:.6}", unit.of(it)) })
        };
        let _ = writeln!(
            text,
            "{} {:>18} {:>18} {:>18} {:>14} {:>9} {:>9} {:>9.0}  {}",
            values(keys, row.value, row.second),
            cell(found.map(|found| found.largest_load), force),
            cell(found.and_then(|found| Some(found.peak?[1])), length),
            cell(found.and_then(|found| found.first_load), force),
            found.map_or_else(none, |found| format!("{:.6}", work.of(found.work))),
            found.map_or_else(none, |found| found.detached.to_string()),
            found.map_or_else(none, |found| found.events.to_string()),
            1e3 * row.solve_s,
            found.map_or("failed", |found| found.end.as_str())
        );
    }
    text + &listed(remarks)
}
