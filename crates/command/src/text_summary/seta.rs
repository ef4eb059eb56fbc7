//! The summary of the pull-off of a seta.

use super::found::passed_lines;
use super::number::in_columns;
use super::number::short;
use super::units::{Unit, Units};
use peelkit::model::{PullCurve, Seta};
use peelkit::study::coarsening::{GrowingTable, OutsideTable, Resolved, SetaLaw, TableRound, TipRange};
use peelkit::study::{ConvergedPeak, SetaMoment, SetaPullOff, SetaState};
use peelkit::units::PreferredUnits;
use peelkit_report::{PassedAt, SetaLawFound, SetaMotion, TipEvents, seta_end_reason, seta_end_word, tip_peak};
use peelkit_scene::{Scene, SetaTipLaw};

/// A work or a force below this share of the largest is round-off.
const ROUND_OFF: f64 = 1e-12;

/// The summary of a pull-off with its peak on finer meshes, which took so many seconds with the law of its tips.
pub fn seta(
    scene: &Scene,
    (seta, order): (&Seta, usize),
    (tip, table, outside): (&PullCurve, Option<&GrowingTable>, Option<&OutsideTable>),
    (pull_off, converged): (&SetaPullOff, Option<&ConvergedPeak>),
    solve_s: f64,
    wanted: PreferredUnits,
) -> String {
    let largest = |of: fn(&peelkit::study::SetaPoint) -> f64| pull_off.points.iter().map(of).fold(0.0, f64::max);
    let sizes = [
        largest(|point| point.force_along.abs()),
        largest(|point| point.displacement),
        largest(|point| point.work.abs()),
    ];
    let units = Units::fitting(wanted, sizes);
    let Units { force, length, work } = units;
    let tips = seta.tips();
    let counted = if tips == 1 { "1 tip".to_owned() } else { format!("{tips} tips") };
    let at = |moment: Option<SetaMoment>| match moment {
        Some(at) => format!(
            "{} at u = {}, {} of {tips} tips attached",
            force.short(at.force),
            length.short(at.displacement),
            at.attached
        ),
        None => "none".to_owned(),
    };
    let of = |state: &Option<SetaState>| state.as_ref().map(SetaMoment::from);
    let of_tip = tip_peak(tip);
    let events = TipEvents::of(pull_off.events.iter().map(|event| &event.tips[..]));
    let of_beams = scene.seta.as_ref().is_some_and(|table| table.tip_law == SetaTipLaw::Beam);
    let (law, alone) = match (of_beams, scene.model.adhesion.shear_strength) {
        (false, _) => ("law of a tip", ""),
        (true, None) => ("tips", "spatulae that are beams; one alone in the plane: "),
        (true, Some(_)) => ("tips", "spatulae that are beams, held along the ground; one that slides: "),
    };
    let mut lines = vec![
        ("seta", format!("{counted}, {} elements of order {order}", pull_off.effort.elements)),
        (law, format!("{alone}peak {of_tip:.6} nN, snaps off at {:.4} nm", tip.snap_off())),
    ];
    lines.extend(table.into_iter().flat_map(|table| of_table(table, force)));
    lines.extend(before_the_pull(pull_off, force));
    let initial = |stiffness| ("stiffness", format!("{} N/m along the pull, where it begins", short(stiffness)));
    lines.extend(pull_off.initial_stiffness.map(initial));
    lines.extend([
        ("peak force", at(converged.map(|found| found.peak).or_else(|| of(&pull_off.peak)))),
        ("first detachment", at(of(&pull_off.first_detachment))),
        ("last detachment", at(of(&pull_off.last_detachment))),
        (
            "events",
            format!(
                "{}: {} tips detach, {} adhere again, at most {} at once",
                events.count, events.tips_detached, events.tips_adhered, events.most_tips_at_once
            ),
        ),
    ]);
    let looked_for = scene.looked_for();
    lines.extend(passed_lines(&PassedAt::of_pull_off(pull_off, &looked_for), &looked_for, &units));
    if let Some(peak) = &pull_off.peak {
        lines.push(("error of the mesh", mesh_error(converged, peak, (scene.accuracy.relative, of_beams))));
    }
    if let (Some(first), Some(last)) = (pull_off.points.first(), pull_off.points.last()) {
        let largest = largest(|point| point.work.abs());
        let rounded = |of: f64| work.short(if of.abs() <= ROUND_OFF * largest { 0.0 } else { of });
        let text = format!(
            "work {} = energy {} + released {}, to {:.0e}",
            rounded(last.work),
            rounded(last.energy - first.energy),
            rounded(last.released),
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
    lines.extend(outside.map(|outside| ("warnings", outside.to_string())));
    in_columns(&scene.title, &lines)
}

/// What the steps before the last one came to: there a force is along another motion, and the peak is of the last step alone.
fn before_the_pull(pull_off: &SetaPullOff, force: Unit) -> Option<(&'static str, String)> {
    let steps = SetaMotion::of(&pull_off.points);
    let (pull, before) = steps.split_last()?;
    let largest = steps.iter().map(|step| step.largest.abs()).fold(0.0, f64::max);
    let reached = |of: f64| force.short(if of.abs() <= ROUND_OFF * largest { 0.0 } else { of });
    let reported: Vec<String> =
        before.iter().map(|step| format!("{} up to {}", step.name, reached(step.largest))).collect();
    let text = format!(
        "{}; each force is along its own motion, positive where the root is pulled that way; what follows is of the {}",
        reported.join(", "),
        pull.name
    );
    (!before.is_empty()).then_some(("steps before", text))
}

/// What the mesh does to the peak force, and to the curve.
fn mesh_error(converged: Option<&ConvergedPeak>, of_curve: &SetaState, (wanted, of_beams): (f64, bool)) -> String {
    let key = if of_beams { "accuracy.elements" } else { "accuracy.order" };
    let Some(ConvergedPeak { peak, mesh, order, .. }) = converged else {
        return format!("not known: no finer mesh came to this peak, and a larger {key} may");
    };
    let [share, curve] = [mesh.force, of_curve.point.force_along - peak.force].map(|off| (off / peak.force).abs());
    let more = format!(", more than accuracy.relative: a larger {key} has less");
    let more = if share > wanted { more.as_str() } else { "" };
    format!("{share:.0e} of the peak force, of order {order}{more}; {curve:.0e} of that of the curve")
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
        ([_, ..], _) if rounds.iter().all(|round| outside(round) == 0) => "no tip left it".to_owned(),
        ([first, .., last], Some(change)) => format!(
            "{} tips left the first table; {} rows added in {} more pull-offs change the peak by {}; {} tips outside of the last one",
            outside(first),
            growing.added(),
            rounds.iter().filter(|round| round.within.is_none()).count() - 1,
            force.short(change),
            outside(last)
        ),
        _ => format!("{} tips are outside of it, where forces are extrapolated", rounds.last().map_or(0, outside)),
    };
    lines.push(("tips outside of it", grown));
    if let Some((last, within)) = rounds.last().and_then(|last| Some((last, last.within?))) {
        let Resolved { tips, force: change, moment, unsolved } = &last.visited.resolved;
        let mut text = format!(
            "{} within {within:.3} nm of where they snap off: forces change by {change:.1e} nN, moments by {moment:.1e} nN nm at most",
            tips.len()
        );
        if let Some(change) = growing.changed_by_resolved() {
            text += &format!(", the peak by {change:.1e} nN");
        }
        if !unsolved.is_empty() {
            text += &format!("; {} were not solved in an equilibrium, and followed the table there", unsolved.len());
        }
        lines.push(("tips resolved", text));
    }
    lines
}

/// How many equilibria are those of an earlier run.
pub fn equilibria_taken(count: usize) -> String {
    if count == 0 { String::new() } else { format!("\n{count} equilibria taken from an earlier, unfinished run\n") }
}

// -- The law of a seta --

/// Its sheets, by the most tips on each.
fn sheets(law: &SetaLaw) -> String {
    match &law.sheets[..] {
        [_] => format!("a potential of degree {}, up to the first loss of a tip", law.degree),
        all => {
            let tips: Vec<String> = all.iter().map(|sheet| sheet.tips.to_string()).collect();
            format!("{} sheets, of at most {} tips", all.len(), tips.join(", "))
        }
    }
}

/// Its exit, its stiffness and its errors.
pub fn seta_law(title: &str, found: &SetaLawFound) -> String {
    let (law, [soft, stiff]) = (&found.law, found.stiffness());
    let exit = law.first_exit();
    let percent = |share: f64| format!("{:.2} %", 100.0 * share);
    let errors = law.errors;
    let mut lines = vec![
        ("law of a seta", sheets(law)),
        ("first exit", format!("{:.4} nm along {:.3} deg to the ground", exit.distance, exit.angle().to_degrees())),
        ("stiffness", format!("{soft:.5} and {stiff:.5} N/m, across and along the stiff direction")),
        ("largest force", format!("{:.4} nN before the first loss", law.largest_force)),
        ("peak", format!("within {}, {} on a path left out", percent(errors.peak), percent(errors.peak_left_out))),
        ("work", format!("within {}, {} on a path left out", percent(errors.work), percent(errors.work_left_out))),
    ];
    for (degree, errors) in (2..).zip(&found.by_degree) {
        let said = errors.as_ref().map_or_else(
            || "not determined by these paths".to_owned(),
            |errors| {
                format!(
                    "force within {}, {} on a path left out; exit within {}, {}",
                    percent(errors.force),
                    percent(errors.force_left_out),
                    percent(errors.exit),
                    percent(errors.exit_left_out)
                )
            },
        );
        lines.push((["degree 2", "degree 3", "degree 4"][degree - 2], said));
    }
    let equilibria: usize = found.paths.iter().map(|(_, path)| path.points.len()).sum();
    lines.push((
        "computed from",
        format!("{} pulls, {equilibria} equilibria, {:.2} s", found.paths.len(), found.seconds),
    ));
    in_columns(title, &lines)
}
