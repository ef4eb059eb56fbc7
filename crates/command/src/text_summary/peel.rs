//! The summary of one peel.

use super::derived::derived;
use super::found::{looked_for_text, value_text};
use super::number::in_columns;
use super::stability::{branch_point, out_of_plane};
use super::units::{Units, fitting_text, moment_text};
use peelkit::beam::{ForcesInSpace, GripForces, GripState, PlaceInSpace, StepJump};
use peelkit::model::Step;
use peelkit::solve::Pace;
use peelkit::study::{
    Bound, Contact, EventAt, Events, LargestComputedForce, LeftOut, LimitPoint, LimitPointKind, MissedStation,
    NotOutOfPlane, OutOfPlane, OutOfPlaneBranch, PathEnd, Peak, Peel, Plateau, Sliding, Station, StationQuantity,
    Stations, TermDecisions, TermEffect, WarningKind, Yielded,
};
use peelkit::units::{PreferredUnits, WORKS};
use peelkit_report::{end_reason, end_word, first_jump_word, ground_warning, left_out, why_kept};
use peelkit_scene::Scene;

/// A relative error below this that finer meshes do not reduce is round-off.
const ROUND_OFF: f64 = 2e-8;
/// A number whose error bound is a larger share of it has no digit that is certain.
const NO_ACCURACY: f64 = 0.5;

/// What was asked for beside a path.
#[derive(Clone, Copy, Default)]
pub struct Beside<'a> {
    /// Its stability out of the plane
    pub stability: Option<&'a OutOfPlane>,
    /// The branch that leaves the plane, if there is one
    pub branch: Option<&'a Option<OutOfPlaneBranch>>,
    /// Its equilibria at given values
    pub stations: &'a [Stations],
    /// Where events of the user lie on it
    pub events: &'a [Events],
}

/// The summary of one peel, which took so many seconds, with what was asked for beside it.
pub fn peel(
    scene: &Scene,
    peel: &Peel,
    Beside { stability, branch, stations, events }: Beside,
    solve_s: f64,
    wanted: PreferredUnits,
) -> String {
    let units = Units::fitting(wanted, sizes(peel));
    let Units { force, length, work } = units;
    let none = || "none".to_owned();
    let at_peak = |at: Peak| {
        let place = length.with_error(at.displacement, at.displacement_error);
        format!("{} at u = {place}", force.with_error(at.force, at.force_error))
    };
    let fold = |at: LimitPoint| {
        let what = if peel.model.pull.turn == 0.0 { "work" } else { "work of force and moment" };
        let work = at.work_error.map_or_else(|| work.fixed(at.work, 6), |error| work.with_error(at.work, error));
        format!("u = {}, {what} to there {work}", length.with_error(at.displacement, at.displacement_error))
    };
    let plateau = |at: Plateau| {
        let (level, place) = match (at.force_error, at.displacement_error) {
            (Some(error), Some(place)) => {
                (force.with_error(at.force, error), length.with_error(at.displacement, place))
            }
            _ => (force.fixed(at.force, 6), length.fixed(at.displacement, 4)),
        };
        format!("{level} at u = {place}{}", if at.stable { "" } else { ", unstable under displacement control" })
    };
    let mut lines: Vec<(&str, String)> = accuracy(peel).map(|text| ("accuracy", text)).into_iter().collect();
    lines.extend(in_space(scene, peel, stability.is_some()));
    lines.extend(stability.map(|stability| ("out of the plane", out_of_plane(stability, &units))));
    lines.extend(branch.iter().copied().flatten().flat_map(|branch| branch_lines(branch, &units)));
    lines.extend(steps(peel, &units));
    lines.push(("peak force", peel.peak.map_or_else(none, at_peak)));
    lines.extend(peel.largest_computed_force.map(|at| ("largest computed", largest_computed(at, &units))));
    lines.extend([
        ("initiation peak", peel.initiation_peak.map_or_else(none, at_peak)),
        ("plateau", peel.plateau.map_or_else(none, plateau)),
        (first_jump_word(peel), peel.snap_off.map_or_else(none, fold)),
    ]);
    let other = |at: &LimitPoint| peel.snap_off.is_some_and(|first| first.displacement != at.displacement);
    // where the pad is the last to let go there is one line
    let is_last = |at: &LimitPoint| peel.detachment.is_some_and(|last| last.displacement == at.displacement);
    let pad = peel.pad_detachment.filter(|at| other(at) && !is_last(at));
    lines.extend(pad.map(|at| ("pad detachment", fold(at))));
    lines.extend(peel.detachment.filter(other).map(|at| ("detachment", fold(at))));
    if peel.snap_off.is_none()
        && let Some(last) = peel.points.last().filter(|_| peel.points.len() > 1)
    {
        let text =
            format!("{} to the end of the path, which has no jump: not the work of peeling", work.fixed(last.work, 6));
        lines.push(("work", text));
    }
    for (index, at) in peel.limit_points.iter().enumerate() {
        let kind = match at.kind {
            LimitPointKind::Displacement => "displacement limit point",
            LimitPointKind::Load => "load limit point",
        };
        let displacement = length.with_error(at.displacement, at.displacement_error);
        let force = force.with_error(at.force, at.force_error);
        lines.push((
            if index == 0 { "limit points" } else { "" },
            format!("{kind} at u = {displacement}, P = {force}{}", if at.flat { " (flat)" } else { "" }),
        ));
    }
    lines.extend(peel.branch_points.iter().map(|at| ("branch point", branch_point(at, &units))));
    if let Some(left_out) = left_out(peel) {
        lines.push(("", format!("left out: {} {left_out}", peel.ripple)));
    }
    let of_station = |of: &Stations| found_lines(&of.at.into(), (&of.found, &of.missed, of.range), &units);
    let of_event = |of: &Events| found_lines(&of.at, (&of.found, &of.missed, of.range), &units);
    let at_stations = stations.iter().flat_map(of_station);
    lines.extend(at_stations.enumerate().map(|(index, line)| (if index == 0 { "stations" } else { "" }, line)));
    let at_events = events.iter().flat_map(of_event);
    lines.extend(at_events.enumerate().map(|(index, line)| (if index == 0 { "events" } else { "" }, line)));
    lines.extend(derived(scene, &units));
    lines.extend(plane(scene, stability.is_some()));
    lines.extend(terms(peel));
    lines.extend(peel.considered.iter().flat_map(considered));
    lines.extend(peel.sliding_at_peak().iter().map(|sliding| ("friction", slid(sliding))));
    lines.extend(peel.yielded().iter().map(|yielded| ("yielding", yielding(yielded))));
    lines.extend((!scene.model.adhesion.healing).then(|| ("healing", closing(peel, &units))));
    lines.extend(peel.contact(0).iter().flat_map(|contact| on_ground(peel, contact)));
    lines.extend(warnings(peel));
    lines.push(("end", end(&peel.end)));
    let effort = &peel.effort;
    lines.push((
        "computational cost",
        format!(
            "{} points, {} Newton iterations, {} elements of order {}, {:.1} ms{}",
            effort.points,
            effort.newton_iterations,
            effort.elements,
            effort.order,
            1e3 * solve_s,
            match effort.pace {
                Pace::Quick => "",
                Pace::Wary => ", Newton's method begun again where it did not converge",
                Pace::Watchful =>
                    ", Newton's method begun again where it did not converge, the stability of each step checked",
            }
        ),
    ));
    in_columns(&scene.title, &lines)
}

/// The equilibria at a station, or where an event lies, a line each.
fn found_lines(
    at: &EventAt,
    (found, missed, range): (&[Station], &[MissedStation], [f64; 2]),
    units: &Units,
) -> Vec<String> {
    let title = looked_for_text(at, units);
    let line = |station: &Station| {
        let (place, force) = (station.displacement, station.force);
        let (place, force) = match station.errors {
            Some(errors) => {
                (units.length.with_error(place, errors.displacement), units.force.with_error(force, errors.force))
            }
            None => (units.length.fixed(place, 4), units.force.fixed(force, 6)),
        };
        let what = match at.quantity.named() {
            Some(StationQuantity::Displacement) => format!("P = {force}"),
            Some(StationQuantity::Force) => format!("u = {place}"),
            _ => format!("u = {place}, P = {force}"),
        };
        let stable = if station.negative_eigenvalues == 0 { "" } else { ", unstable under displacement control" };
        format!("{title}: {what}{stable}")
    };
    let mut lines: Vec<String> = found.iter().map(line).collect();
    lines.extend(missed.iter().map(|missed| format!("{title}: {missed}")));
    if lines.is_empty() {
        let [least, largest] = range.map(|value| value_text(at, value, units));
        lines.push(format!("{title}: the path does not pass it; it goes from {least} to {largest}"));
    }
    lines
}

/// The largest force (nN), displacement (nm) and work (aJ) that is printed.
fn sizes(peel: &Peel) -> [f64; 3] {
    let limit_points = peel.limit_points.iter().map(|at| [at.force, at.displacement, at.work]);
    let points = peel.points.iter().map(|at| [at.force, at.displacement, at.work]);
    let steps = peel.steps.iter().map(|grip| {
        let GripForces { horizontal, vertical, .. } = grip.forces;
        [horizontal.abs().max(vertical.abs()), grip.x.unwrap_or_default().abs().max(grip.y.abs()), 0.0]
    });
    limit_points
        .chain(points)
        .chain(steps)
        .fold([0.0; 3], |sizes, at| std::array::from_fn(|k| sizes[k].max(at[k].abs())))
}

/// A largest force that is no peak; no more digits than say where it is.
fn largest_computed(at: LargestComputedForce, units: &Units) -> String {
    format!(
        "{} at u = {}: the largest force of the computed curve, no limit point and without an error bound",
        units.force.short(at.force),
        units.length.short(at.displacement)
    )
}

/// What is to be known before any number is read: which numbers are not as accurate as was asked, or that the computation stopped short.
fn accuracy(peel: &Peel) -> Option<String> {
    if let Some(reached) = peel.reached_accuracy().filter(|&reached| reached > peel.asked) {
        let why = match reached < ROUND_OFF {
            true => "limited by round-off, which finer meshes do not reduce".to_owned(),
            false => missing(peel),
        };
        let reached = match reached > NO_ACCURACY {
            true => format!("none: an error bound is {:.0} % of its number", 100.0 * reached),
            false => above(reached, peel.asked),
        };
        return Some(format!("{reached}, requested {:e}: {why}", peel.asked));
    }
    matches!(peel.end, PathEnd::Failed(_)).then(|| "the computation stopped short; see `end`".to_owned())
}

/// A relative error with as many digits as show that it is above what was asked for.
fn above(reached: f64, asked: f64) -> String {
    let mut texts = (0..16).map(|digits| format!("{reached:.digits$e}"));
    let shows = |text: &String| text.parse::<f64>().is_ok_and(|shown| shown > asked);
    texts.find(shows).unwrap_or_else(|| format!("{reached:e}"))
}

/// Most limit points that are named as not accurate enough.
const NAMED: usize = 3;

/// Which limit points are not known as accurately as was asked, and of which of their numbers.
fn missing(peel: &Peel) -> String {
    let misses = |error: f64, value: f64| value != 0.0 && (error / value).abs() > peel.asked;
    let one = |(index, at): (usize, &LimitPoint)| {
        let place = !at.flat && misses(at.displacement_error, at.displacement);
        let numbers = match (place, misses(at.force_error, at.force)) {
            (true, true) => "u and P",
            (true, false) => "u",
            (false, true) => "P",
            (false, false) => return None,
        };
        let is = |place: Option<f64>| place == Some(at.displacement);
        let name = match at.kind {
            LimitPointKind::Load if is(peel.initiation_peak.map(|peak| peak.displacement)) => {
                "the initiation peak".into()
            }
            LimitPointKind::Load if is(peel.peak.map(|peak| peak.displacement)) => "the peak".into(),
            LimitPointKind::Displacement if is(peel.snap_off.map(|at| at.displacement)) => {
                format!("the {}", first_jump_word(peel))
            }
            LimitPointKind::Displacement if is(peel.detachment.map(|at| at.displacement)) => "the detachment".into(),
            _ => format!("limit point {}", index + 1),
        };
        Some(format!("{numbers} of {name}"))
    };
    let missed: Vec<String> = peel.limit_points.iter().enumerate().filter_map(one).collect();
    let others = if missed.len() == peel.limit_points.len() { "" } else { "; the other limit points meet it" };
    match missed.len() {
        count if count > NAMED => format!("missed at {count} of {} limit points{others}", peel.limit_points.len()),
        _ => format!("missed by {}{others}", missed.join(", ")),
    }
}

/// Where a scene in space was computed; in the plane, how to see whether it is stable there, unless that was looked at.
fn in_space(scene: &Scene, peel: &Peel, looked_at: bool) -> Option<(&'static str, String)> {
    scene.model.space?;
    let text = match peel.model.space {
        Some(_) => "solved in space",
        None if looked_at || NotOutOfPlane::of(&scene.model).is_some() => {
            "solved in the plane: the solution stays in the vertical plane of the strip"
        }
        None => {
            "solved in the plane: the solution stays in the vertical plane of the strip; whether it is stable there: \
             peel run --out-of-plane"
        }
    };
    Some(("space", text.to_owned()))
}

/// That a grip that is free to roll may leave the plane, of a scene of which that can be computed, unless that was looked at.
fn plane(scene: &Scene, looked_at: bool) -> Option<(&'static str, String)> {
    let is_open = scene.model.space.is_none() && !looked_at && NotOutOfPlane::of(&scene.model).is_none();
    let text = "the grip cannot roll; where one that can would leave the plane: peel run --out-of-plane";
    is_open.then(|| ("plane", text.to_owned()))
}

/// The grip after each step before the pull, and the jumps in it.
fn steps(peel: &Peel, units: &Units) -> Vec<(&'static str, String)> {
    let Units { force, length, .. } = units;
    let place = |grip: &GripState| {
        let x = grip.x.map(|x| format!("x = {}, ", length.fixed(x, 4))).unwrap_or_default();
        format!("{x}y = {}, θ = {:.4} deg", length.fixed(grip.y, 4), grip.rotation.to_degrees())
    };
    let line = |step: &Step, grip: &GripState| {
        let GripForces { horizontal, vertical, moment, in_space } = grip.forces;
        let (horizontal, vertical) = (force.fixed(horizontal, 6), force.fixed(vertical, 6));
        let beside = |(place, forces): (PlaceInSpace, ForcesInSpace)| {
            let (z, lateral) = (length.fixed(place.z, 4), force.fixed(forces.lateral, 6));
            let [roll, yaw] = [place.roll, place.yaw].map(f64::to_degrees);
            let [torque, yaw_moment] = [forces.torque, forces.yaw_moment].map(moment_text);
            format!(
                "; z = {z}, roll {roll:.4} deg, yaw {yaw:.4} deg; sideways {lateral}, on the roll {torque}, on the yaw {yaw_moment}"
            )
        };
        let beside = grip.in_space.zip(in_space).map(beside).unwrap_or_default();
        format!("{step}: {}; H = {horizontal}, V = {vertical}, M = {}{beside}", place(grip), moment_text(moment))
    };
    let jump = |jump: &StepJump| {
        let [before, after] = [jump.before, jump.after].map(|grip| force.fixed(grip.forces.vertical, 6));
        let released = fitting_text(WORKS, jump.released);
        format!("  it jumps at {}: V from {before} to {after}, {released} released", place(&jump.before))
    };
    let mut lines = Vec::new();
    for ((number, step), grip) in (1..).zip(&peel.model.steps).zip(&peel.steps) {
        lines.push(line(step, grip));
        lines.extend(peel.step_jumps.iter().filter(|jump| jump.step == number).map(jump));
    }
    let heads = std::iter::once("steps").chain(std::iter::repeat(""));
    heads.zip(lines).collect()
}

/// Where the model is not to be trusted; sharp ground is reported with the ground.
fn warnings(peel: &Peel) -> Vec<(&'static str, String)> {
    let all = peel.warnings().into_iter().filter(|warning| warning.kind != WarningKind::SharpGround);
    all.enumerate().map(|(index, warning)| (if index == 0 { "warnings" } else { "" }, warning.to_string())).collect()
}

/// The relative change of the initiation peak if a term is neglected.
fn terms(peel: &Peel) -> Option<(&'static str, String)> {
    let peak = peel.initiation_peak?.force;
    let effects = peel.terms();
    let one = |effect: &TermEffect| format!("{} {:+.1e}", effect.term.meaning(), effect.force / peak);
    let all = effects.iter().map(one).collect::<Vec<_>>().join(", ");
    (!effects.is_empty())
        .then(|| ("neglected terms", format!("relative change of the initiation peak without a term: {all}")))
}

/// Which terms were left out, and why the others were not.
fn considered(considered: &TermDecisions) -> Vec<(&'static str, String)> {
    let left = considered.left_out.iter().map(|left| {
        let LeftOut { term, force, displacement, largest } = left;
        let word = term.word();
        match largest {
            0.0 => format!("{word}: no result would change at all"),
            _ => format!(
                "{word}: the initiation peak would change by {force:+.1e} nN and move by {displacement:+.1e} nm; the largest relative change of any result is {largest:.1e}"
            ),
        }
    });
    let kept = considered.kept.iter().map(|(term, why)| format!("{}: {}", term.word(), why_kept(why)));
    let named = |name: &'static str, texts: Vec<String>| {
        texts.into_iter().enumerate().map(move |(index, text)| (if index == 0 { name } else { "" }, text))
    };
    named("left out", left.collect()).chain(named("kept", kept.collect())).collect()
}

/// How far the beam has slid at the peak.
fn slid(sliding: &Sliding) -> String {
    format!(
        "at the initiation peak {:.4} nN of at most {:.4} nN; {:.1} of {:.1} nm in contact slide, the free end has slid by {:.4} nm, {:.4} aJ are dissipated",
        sliding.force, sliding.capacity, sliding.sliding, sliding.contact, sliding.free_end, sliding.dissipated
    )
}

/// How a film has yielded.
fn yielding(yielded: &Yielded) -> String {
    let Yielded { work_per_area, length, largest_curvature, permanent_stretch, .. } = *yielded;
    if length == 0.0 {
        return format!("none: at most {largest_curvature:.2} times the curvature at which it begins");
    }
    let left = work_per_area.map(|work| format!("{work:.4} J/m² stay in the film; "));
    format!(
        "{}it is bent to {largest_curvature:.3} times the curvature at which it yields, and stays stretched by at most {:.2} %",
        left.unwrap_or_default(),
        100.0 * permanent_stretch
    )
}

/// Whether what does not heal closes on the way.
fn closing(peel: &Peel, units: &Units) -> String {
    match peel.closing() {
        Some(from) => format!(
            "none: from u = {} on sections that have let go come back, and are held less",
            units.length.fixed(from, 6)
        ),
        None => "none, and nothing that has let go comes back: one that heals has the same results".to_owned(),
    }
}

/// How the beam lies on ground that is not flat, and what is to be said of that ground.
fn on_ground(peel: &Peel, contact: &Contact) -> Vec<(&'static str, String)> {
    let reach = contact
        .penetration
        .map(|reach| format!("; it penetrates to {:.1} % of the depth of the valleys", 100.0 * reach));
    let lies = format!(
        "contact length (gap below 2 r0) {:.1} %, adhesion energy {:.1} % of those on flat ground; gaps from {:.4} to {:.4} nm{}",
        100.0 * contact.adhered_fraction,
        100.0 * contact.energy_fraction,
        contact.least_gap,
        contact.largest_gap,
        reach.unwrap_or_default()
    );
    let mut lines = vec![("at the start", lies)];
    lines.extend(peel.largest_force().map(|force| ("largest force", format!("{force:.6} nN on the whole path"))));
    for (name, radius, error) in [
        ("crests", contact.crest_radius, contact.crest_error),
        ("valleys", contact.valley_radius, contact.valley_error),
    ] {
        let (Some(radius), Some(error)) = (radius, error) else { continue };
        let percent = 100.0 * error;
        lines.push((
            name,
            format!("smallest radius {radius:.2} nm: curvature changes the largest traction by {percent:+.2} %"),
        ));
    }
    lines.extend(ground_warning(contact).map(|warning| ("warning", warning)));
    lines
}

/// Of the branch that leaves the plane: where it begins, its peak, its first jump, and where it ends.
fn branch_lines(branch: &OutOfPlaneBranch, Units { force, length, .. }: &Units) -> Vec<(&'static str, String)> {
    let OutOfPlaneBranch { loss, start, peel, rejoins } = branch;
    let at = |limit: &LimitPoint| {
        let roll = limit.in_space.unwrap_or_default().roll.to_degrees();
        format!(
            "P = {} at u = {}, roll {roll:.4} deg",
            force.with_error(limit.force, limit.force_error),
            length.with_error(limit.displacement, limit.displacement_error)
        )
    };
    let stable = match peel.points.first().map_or(0, |point| point.negative_eigenvalues) {
        0 => "stable",
        _ => "unstable",
    };
    let ways = if start.displacement_by_roll > 0.0 { "larger" } else { "smaller" };
    let mut lines = vec![(
        "branch",
        format!(
            "leaves the plane at u = {} to {ways} u, {stable} under displacement control; the other is its mirror image",
            length.with_error(loss.displacement, loss.displacement_error)
        ),
    )];
    lines.push(("", format!("peak force: {}", branch.peak().map_or_else(|| "none".into(), at))));
    lines.extend(peel.snap_off.iter().map(|fold| ("", format!("{}: {}", first_jump_word(peel), at(fold)))));
    let last = rejoins.map_or_else(
        || {
            peel.points.last().map(|point| {
                let grip = point.in_space.unwrap_or_default();
                format!(
                    " at u = {}, P = {}, roll {:.4} deg",
                    length.fixed(point.displacement, 4),
                    force.fixed(point.force, 6),
                    grip.roll.to_degrees()
                )
            })
        },
        |place| {
            let (u, p) = (place.displacement, place.force);
            let (u, p) = (length.with_error(u, place.displacement_error), force.with_error(p, place.force_error));
            Some(format!(" at u = {u}, P = {p}"))
        },
    );
    lines.push(("", format!("end{}: {}", last.unwrap_or_default(), end(&peel.end))));
    lines
}

/// Of a run whose first path points are those of an earlier one.
pub fn taken(points: usize) -> String {
    if points == 0 { String::new() } else { format!("\n{points} path points taken from an earlier, unfinished run\n") }
}

fn end(end: &PathEnd) -> String {
    let word = match end {
        PathEnd::TurnedBack => "re-adhered",
        _ => end_word(end),
    };
    let meaning = match end {
        PathEnd::Detached => "no point of the strip is nearer than the adhesion acts",
        PathEnd::Pivoting => "the force has returned to zero, and the strip is still in edge contact",
        PathEnd::Pushing => "beyond the snap-off the grip pushes, and the force does not return to zero",
        PathEnd::TurnedBack => "u has returned to 0",
        PathEnd::BackInPlane => "the strip has come back into its plane, on the planar path",
        PathEnd::Sliding => "the whole contact slides, at a constant force from here on",
        PathEnd::Snapped => {
            "the strip snaps off; equilibrium does not determine how it slides or yields during the jump"
        }
        PathEnd::BondedPartUnstable(_) => "no stable state is near",
        PathEnd::Upright(_) => "no smooth solution goes on from there",
        PathEnd::Bound(Bound::Until(_)) => "what the scene asks for is behind",
        PathEnd::Bound(Bound::Event { .. }) => "the path is followed no further",
        PathEnd::Bound(_) => "a limit set under [bounds] was reached",
        PathEnd::Failed(failure) if failure.is_refusal() => "the model is not computed",
        PathEnd::Failed(_) => "the computation stopped short",
    };
    let reason = end_reason(end).map(|reason| format!(": {reason}")).unwrap_or_default();
    format!("{word}: {meaning}{reason}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use peelkit::study::{self, Effort, OutOfPlaneLoss};
    use peelkit_scene::BoundsTable;

    #[test]
    fn an_accuracy_that_is_missed_is_not_printed_as_the_one_asked_for() {
        let text = |reached| above(reached, 1e-6);
        assert_eq!(
            [text(3.4e-6), text(1.4e-6), text(1.02e-6), text(1.0000001e-6)],
            ["3e-6", "1.4e-6", "1.02e-6", "1.0000001e-6"]
        );
    }

    #[test]
    fn the_summary_of_a_peel_is_laid_out_in_two_columns() {
        let text = r#"
            strip = { length = "100 nm", height = "10 nm", youngs_modulus = "2 GPa" }
            adhesion = { hamaker_constant = "1e-19 J", equilibrium_distance = "0.4 nm" }
        "#;
        let scene = Scene::parse("short.toml", text, &[]).unwrap();
        let bounds = BoundsTable { points: 1, ..scene.bounds };
        let snap_off = LimitPoint {
            kind: LimitPointKind::Displacement,
            displacement: 48.2156178228,
            force: 0.0375627292,
            end_rotation: 0.9,
            work: 3.25,
            displacement_error: 3e-6,
            force_error: 4e-9,
            work_error: Some(5e-7),
            flat: false,
            after: 0,
            in_space: None,
        };
        let mut made_up = study::peel(&scene.model, &scene.accuracy, &bounds.from_now());
        made_up.limit_points = vec![LimitPoint { kind: LimitPointKind::Load, ..snap_off }, snap_off];
        made_up.initiation_peak = None;
        (made_up.largest_computed_force, made_up.pad_detachment, made_up.detachment) = (None, None, Some(snap_off));
        made_up.peak = Some(Peak {
            displacement: 0.2496,
            force: 0.341121,
            end_rotation: 0.1,
            force_error: 1e-5,
            displacement_error: 1e-3,
        });
        made_up.plateau = None;
        made_up.snap_off = Some(snap_off);
        made_up.end = PathEnd::Bound(Bound::Points(20));
        made_up.effort = Effort { points: 20, newton_iterations: 70, elements: 16, order: 4, pace: Pace::Quick };
        let expected = "\
short

  peak force         0.34112 ± 1e-5 nN at u = 0.250 ± 1e-3 nm
  initiation peak    none
  plateau            none
  snap-off           u = 48.215618 ± 3e-6 nm, work to there 3.2500000 ± 5e-7 aJ
  limit points       load limit point at u = 48.215618 ± 3e-6 nm, P = 0.037562729 ± 4e-9 nN
                     displacement limit point at u = 48.215618 ± 3e-6 nm, P = 0.037562729 ± 4e-9 nN
  adhesion           work of adhesion 0.0306396 J/m², Kendall's force at 90 degrees 0.0306162 nN
  strip              process zone 2.1667 nm, ℓ/h = 0.21667, L/ℓ = 46.1532; EI = 166.667 nN nm²
  plane              the grip cannot roll; where one that can would leave the plane: peel run --out-of-plane
  warnings           the process zone is 0.217 times as long as the section is high, less than 1: sections deform there, and the model keeps them rigid
  end                bound: a limit set under [bounds] was reached: bounds.points = 20
  computational cost 20 points, 70 Newton iterations, 16 elements of order 4, 4.2 ms
";
        assert_eq!(peel(&scene, &made_up, Beside::default(), 0.0042, PreferredUnits::default()), expected);
        let loss = OutOfPlaneLoss {
            displacement: 0.489743876,
            force: 0.312661701,
            displacement_error: 3e-8,
            force_error: 2e-7,
            after: Some(3),
        };
        let from_start = OutOfPlaneLoss { after: None, ..loss };
        for (first_loss, begins) in [
            (Some(loss), "stable up to u = 0.48974388 ± 3e-8 nm, P = 0.3126617 ± 2e-7 nN: beyond that"),
            (Some(from_start), "unstable from the beginning"),
            (None, "stable on the whole path"),
        ] {
            let stability = OutOfPlane { negative_eigenvalues: Vec::new(), first_loss };
            let text = peel(
                &scene,
                &made_up,
                Beside { stability: Some(&stability), ..Beside::default() },
                0.0042,
                PreferredUnits::default(),
            );
            let first = text.lines().nth(2).unwrap_or_default();
            assert!(first.trim_start().starts_with(&format!("out of the plane   {begins}")), "{first}");
        }
    }
}
