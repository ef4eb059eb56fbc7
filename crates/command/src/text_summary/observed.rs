//! The summary of a displacement-controlled test.

use super::layout::in_columns;
use super::number::{with_error, work};
use peelkit::study::{Observed, PullOff, TestEnd};
use peelkit_report::{jump_word, test_end_reason, test_end_word};

/// The displacement-controlled test, which took so many seconds.
pub fn observed(test: &Observed, solve_s: f64) -> String {
    let none = || "none".to_owned();
    let largest = |peak: PullOff, until: &str| {
        let force = with_error(peak.force, peak.force_error);
        let adheres = peak.adheres.word();
        format!("{force} nN at U = {:.6} nm, the largest force {until}; adhering: {adheres}", peak.machine)
    };
    let pull_off = test.pull_off.map_or_else(none, |peak| largest(peak, "on the stable retreat"));
    let mut lines = vec![("pull-off force", pull_off)];
    lines.extend(test.before_upright.map(|peak| ("", largest(peak, "before the beam stood on its end"))));
    for jump in &test.jumps {
        let landed = match jump.detached {
            true => "detached".to_owned(),
            false => format!("front at {:.2} nm, adhering: {}", jump.after.front, jump.after.adheres.word()),
        };
        lines.push((
            jump_word(jump.kind),
            format!(
                "U = {} nm, P = {} to {} nN, released {} aJ, {landed}",
                with_error(jump.machine, jump.machine_error),
                with_error(jump.before.force, jump.before.force_error),
                with_error(jump.after.force, jump.after.force_error),
                with_error(jump.released, jump.released_error),
            ),
        ));
    }
    lines.push(("hysteresis", test.hysteresis.map_or_else(none, work)));
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
