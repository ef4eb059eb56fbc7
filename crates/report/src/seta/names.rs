//! What ends of a pull-off and branches of a tip's law are called in outputs.

use peelkit::model::TipBranch;
use peelkit::study::{SetaEnd, SetaPullOff};

/// The name of the end of a pull-off in outputs.
pub fn seta_end_word(pull_off: &SetaPullOff) -> &'static str {
    end_word(&pull_off.end, pull_off.points.last().map_or(0, |last| last.attached))
}

/// The same of an end at which so many tips adhere.
pub(super) fn end_word(end: &SetaEnd, attached: usize) -> &'static str {
    match end {
        SetaEnd::Completed if attached > 0 => "still-attached",
        SetaEnd::Completed => "detached",
        SetaEnd::Bound(_) => "bound",
        SetaEnd::Failed(_) => "failed",
    }
}

/// Why a pull-off ended where it did, if that was not by itself.
pub fn seta_end_reason(end: &SetaEnd) -> Option<String> {
    match end {
        SetaEnd::Completed => None,
        SetaEnd::Bound(bound) => Some(bound.to_string()),
        SetaEnd::Failed(failure) => Some(failure.to_string()),
    }
}

/// The name of the branch of its law that a tip is on.
pub fn tip_branch_word(on: TipBranch) -> &'static str {
    match on {
        TipBranch::Attached => "attached",
        TipBranch::Detaching => "detaching",
        TipBranch::Detached => "detached",
    }
}
