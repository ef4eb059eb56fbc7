//! What ends of a pull-off and branches of a tip's law are called in outputs.

use crate::writing::record::{Fields, Record};
use peelkit::model::TipBranch;
use peelkit::study::{Bound, SetaEnd, SetaPullOff, TipChange};

/// The name of the end of a pull-off in outputs.
pub fn seta_end_word(pull_off: &SetaPullOff) -> &'static str {
    end_word(&pull_off.end, pull_off.points.last().map_or(0, |last| last.attached))
}

/// The same of an end at which so many tips adhere.
pub(super) fn end_word(end: &SetaEnd, attached: usize) -> &'static str {
    match end {
        SetaEnd::Completed if attached > 0 => "still-attached",
        SetaEnd::Completed => "detached",
        SetaEnd::Bound(Bound::Event { .. }) => "event",
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

// -- How tips leave the branches of their law in a pull-off, or in a pull at a rate --

/// The events of a pull, counted.
#[derive(Clone, Copy, Debug)]
pub struct TipEvents {
    /// How many
    pub count: usize,
    /// Tips that detach in all of them
    pub tips_detached: usize,
    /// Tips that adhere again in all of them
    pub tips_adhered: usize,
    /// Changes of tips in the largest one
    pub most_tips_at_once: usize,
}

impl Record for TipEvents {
    fn fields(of: &mut Fields<Self>) {
        of.field("count", "how many", |all| all.count);
        of.field("tips_detached", "tips that detached in all of them", |all| all.tips_detached);
        of.field("tips_adhered", "tips that adhered again in all of them", |all| all.tips_adhered);
        of.field("most_tips_at_once", "changes of tips in the largest event", |all| all.most_tips_at_once);
    }
}

impl TipEvents {
    /// Of the changes of each event.
    pub fn of<'c>(events: impl Iterator<Item = &'c [TipChange]>) -> Self {
        let mut all = Self { count: 0, tips_detached: 0, tips_adhered: 0, most_tips_at_once: 0 };
        for changes in events {
            let adhered = changes.iter().filter(|change| change.to.adheres()).count();
            all.count += 1;
            all.tips_detached += changes.len() - adhered;
            all.tips_adhered += adhered;
            all.most_tips_at_once = all.most_tips_at_once.max(changes.len());
        }
        all
    }
}
