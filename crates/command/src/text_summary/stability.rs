//! Where a path is not, or no longer, what a beam does.

use super::units::Units;
use peelkit::study::{BranchPoint, OutOfPlane};

/// A branch point, and what it does to stability.
pub fn branch_point(at: &BranchPoint, units: &Units) -> String {
    let place = units.length.with_error(at.displacement, at.displacement_error);
    let force = units.force.with_error(at.force, at.force_error);
    let what = match at.negative_eigenvalues {
        [0, _] => "stability is lost without a jump, and the path goes on along the unstable branch",
        [_, 0] => "the path is stable again",
        _ => "another branch meets the path",
    };
    format!("at u = {place}, P = {force}: {what}")
}

/// From where on the path is not that of a beam that is free to leave its plane.
pub fn out_of_plane(stability: &OutOfPlane, Units { force, length, .. }: &Units) -> String {
    let Some(at) = stability.first_loss else {
        return "stable on the whole path, of a grip that is free to roll".to_owned();
    };
    if at.after.is_none() {
        return "unstable from the beginning: a strip that is free to roll is not on this path at all".to_owned();
    }
    format!(
        "stable up to u = {}, P = {}: beyond that a strip that is free to roll leaves the plane and this path",
        length.with_error(at.displacement, at.displacement_error),
        force.with_error(at.force, at.force_error)
    )
}
