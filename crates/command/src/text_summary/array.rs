//! The summary of the pull of an array of setae.

use super::number::in_columns;
use super::units::{Units, WantedUnits};
use peelkit::toe::ArrayPull;
use peelkit_report::array_end_word;
use peelkit_scene::{ArrayTable, BandLoad, Scene, array_warnings};

/// The summary of a pull that took so many seconds.
pub fn array(scene: &Scene, table: &ArrayTable, pull: &ArrayPull, seconds: f64, wanted: WantedUnits) -> String {
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
    let total = table.stiffness * table.reach * pull.setae as f64;
    if !moment {
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
