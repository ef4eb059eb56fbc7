//! The summary of the pull-off of a seta.

use super::layout::in_columns;
use super::units::{Unit, Units, WantedUnits};
use peelkit::model::{PullCurve, SetaModel};
use peelkit::study::coarsening::{GrowingTable, TableRound, TipRange};
use peelkit::study::{SetaMoment, SetaPullOff, SetaState};
use peelkit_report::{seta_end_reason, seta_end_word, tip_peak};
use peelkit_scene::Scene;

/// The summary of a pull-off with the same peak on a finer mesh, which took so many seconds with the law of its tips.
pub fn seta(
    scene: &Scene,
    model: &SetaModel,
    (tip, table): (&PullCurve, Option<&GrowingTable>),
    (pull_off, finer): (&SetaPullOff, Option<SetaMoment>),
    solve_s: f64,
    wanted: WantedUnits,
) -> String {
    let largest = |of: fn(&peelkit::study::SetaPoint) -> f64| pull_off.points.iter().map(of).fold(0.0, f64::max);
    let sizes = [
        largest(|point| point.force_along.abs()),
        largest(|point| point.displacement),
        largest(|point| point.work.abs()),
    ];
    let Units { force, length, work } = Units::fitting(wanted, sizes);
    let tips = model.seta.tips();
    let at = |state: &Option<SetaState>| match state {
        Some(SetaState { point, .. }) => format!(
            "{} at u = {}, {} of {tips} tips attached",
            force.short(point.force_along),
            length.short(point.displacement),
            point.attached
        ),
        None => "none".to_owned(),
    };
    let of_tip = tip_peak(tip);
    let changes = || pull_off.events.iter().flat_map(|event| &event.tips);
    let adhered = changes().filter(|change| change.to.adheres()).count();
    let at_once = pull_off.events.iter().map(|event| event.tips.len()).max().unwrap_or(0);
    let mut lines = vec![
        ("seta", format!("{tips} tips, {} elements of order {}", model.mesh.total(), model.mesh.order)),
        ("law of a tip", format!("peak {of_tip:.6} nN, snaps off at {:.4} nm", tip.snap_off())),
    ];
    lines.extend(table.into_iter().flat_map(|table| of_table(table, force)));
    lines.extend([
        ("peak force", at(&pull_off.peak)),
        ("first detachment", at(&pull_off.first_detachment)),
        ("last detachment", at(&pull_off.last_detachment)),
        (
            "events",
            format!(
                "{}: {} tips detach, {adhered} adhere again, at most {at_once} at once",
                pull_off.events.len(),
                changes().count() - adhered
            ),
        ),
    ]);
    if let (Some(SetaState { point, .. }), Some(finer)) = (&pull_off.peak, finer) {
        let error = (point.force_along - finer.force).abs();
        let share = error / finer.force.abs();
        let more = if share > scene.accuracy.relative {
            format!(", more than accuracy.relative: a larger accuracy.order than {} has less", model.mesh.order)
        } else {
            String::new()
        };
        lines.push(("error of the mesh", format!("{} of the peak force, {share:.0e}{more}", force.short(error))));
    }
    if let (Some(first), Some(last)) = (pull_off.points.first(), pull_off.points.last()) {
        let text = format!(
            "work {} = energy {} + released {}, to {:.0e}",
            work.short(last.work),
            work.short(last.energy - first.energy),
            work.short(last.released),
            pull_off.imbalance()
        );
        lines.push(("energy", text));
    }
    let reason = seta_end_reason(&pull_off.end).map(|reason| format!(": {reason}")).unwrap_or_default();
    lines.push(("end", format!("{}{reason}", seta_end_word(pull_off))));
    let effort = format!(
        "{} equilibria, {} Newton iterations, {:.0} ms",
        pull_off.points.len(),
        pull_off.effort.newton_iterations,
        1e3 * solve_s
    );
    lines.push(("computed", effort));
    in_columns(&scene.title, &lines)
}

/// The table that the tips follow, and what it came to that they left it.
fn of_table(growing: &GrowingTable, force: Unit) -> Vec<(&'static str, String)> {
    let (table, rounds) = (growing.table(), growing.rounds());
    let TipRange { press, rotation: [from, to], .. } = table.options.range;
    let mut lines = vec![(
        "table of the tips",
        format!(
            "{} rows, pressed by up to {press:.0} nm, θ from {from:.4} to {to:.4} rad, error below {:.1e} of the largest",
            table.rows(),
            table.relative_error()
        ),
    )];
    let outside = |round: &TableRound| round.visited.outside.len();
    let grown = match (rounds, growing.changed()) {
        ([only], _) if outside(only) == 0 => "no tip left it".to_owned(),
        ([first, .., last], Some(change)) => format!(
            "{} tips left the first table; {} rows added in {} more pull-offs change the peak by {}; {} tips outside of the last one",
            outside(first),
            growing.added(),
            rounds.len() - 1,
            force.short(change),
            outside(last)
        ),
        _ => format!("{} tips are outside of it, where forces are extrapolated", rounds.last().map_or(0, outside)),
    };
    lines.push(("tips outside of it", grown));
    lines
}

/// How many equilibria are those of an earlier run.
pub fn equilibria_taken(count: usize) -> String {
    if count == 0 { String::new() } else { format!("\n{count} equilibria taken from an earlier, unfinished run\n") }
}
