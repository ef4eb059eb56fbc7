//! The branch that leaves the plane, in a summary.

use super::peel::end;
use super::units::Units;
use peelkit::study::{LimitPoint, OutOfPlaneBranch};
use peelkit_report::first_jump_word;

/// Where the branch begins, its peak, its first jump, and where it ends.
pub(super) fn branch_lines(
    branch: &OutOfPlaneBranch,
    Units { force, length, .. }: &Units,
) -> Vec<(&'static str, String)> {
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
