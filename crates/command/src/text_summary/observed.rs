//! The summary of a displacement-controlled test.

use super::found::passed_lines;
use super::number::in_columns;
use super::units::Units;
use peelkit::study::{EventAt, Observed, PullOff, TestEnd};
use peelkit::units::PreferredUnits;
use peelkit_report::{PassedAt, jump_title, test_end_reason, test_end_word};

/// Which of two pull-off forces is seen.
const SEEN: &str =
    "an experiment records the larger if the end face is as flat and smooth as here; otherwise the one before";

/// The displacement-controlled test, which took so many seconds.
pub fn observed(test: &Observed, looked_for: &[EventAt], solve_s: f64, wanted: PreferredUnits) -> String {
    let units = Units::fitting(wanted, sizes(test));
    let Units { force, length, work } = units;
    let none = || "none".to_owned();
    let largest = |peak: PullOff, until: &str| {
        let force = force.with_error(peak.force, peak.force_error);
        let (place, adheres) = (length.fixed(peak.machine, 6), peak.adheres.word());
        format!("{force} at U = {place}, the largest force {until}; adhering: {adheres}")
    };
    let pull_off = test.pull_off.map_or_else(none, |peak| largest(peak, "on the stable retreat"));
    let mut lines = vec![("pull-off force", pull_off)];
    lines.extend(test.before_upright.map(|peak| ("", largest(peak, "before the beam stood on its end"))));
    if let (Some(largest), Some(before)) = (test.pull_off, test.before_upright)
        && largest.force > before.force
    {
        lines.push(("", SEEN.to_owned()));
    }
    for (number, jump) in test.jumps.iter().enumerate() {
        let landed = match jump.detached {
            true => "detached".to_owned(),
            false => format!("front at {}, adhering: {}", length.fixed(jump.after.front, 2), jump.after.adheres.word()),
        };
        lines.push((
            jump_title(&test.jumps, number),
            format!(
                "U = {}, P = {} to {}, released {}, {landed}",
                length.with_error(jump.machine, jump.machine_error),
                force.bare_with_error(jump.before.force, jump.before.force_error),
                force.with_error(jump.after.force, jump.after.force_error),
                work.with_error(jump.released, jump.released_error),
            ),
        ));
    }
    lines.extend(passed_lines(&PassedAt::of_test(test, looked_for), looked_for, &units));
    let warnings = test.warnings().into_iter().enumerate();
    lines.extend(warnings.map(|(k, warning)| (if k == 0 { "warnings" } else { "" }, warning.to_string())));
    lines.push(("hysteresis", test.hysteresis.map_or_else(none, |area| work.fixed(area, 6))));
    if let Some(balance) = test.cycle.or(test.retreat) {
        let text =
            format!("work minus change of energy minus released energy: {:.1e} of the largest term", balance.error());
        lines.push(("work balance", text));
    }
    let end = match &test.end {
        TestEnd::Closed => "closed: machine and strip are back in their initial state".to_owned(),
        end => format!("{}: {}", test_end_word(end), test_end_reason(end).unwrap_or_default()),
    };
    lines.push(("end", end));
    let effort = &test.effort;
    lines.push((
        "computational cost",
        format!(
            "{} points, {} Newton iterations, {} relaxation steps, {} elements of order {}, {:.1} ms",
            effort.points,
            effort.newton_iterations,
            effort.relaxation_steps,
            effort.elements,
            effort.order,
            1e3 * solve_s
        ),
    ));
    in_columns("Displacement-controlled test", &lines)
}

/// The largest force (nN), displacement (nm) and work (aJ) of the test.
fn sizes(test: &Observed) -> [f64; 3] {
    let points = test.points.iter().map(|at| [at.force, at.machine, at.work]);
    points.fold([0.0; 3], |sizes, at| std::array::from_fn(|k| sizes[k].max(at[k].abs())))
}
