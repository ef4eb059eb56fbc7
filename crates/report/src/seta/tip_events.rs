//! How tips leave the branches of their law in a pull-off, or in a pull at a rate.

use crate::record::{Fields, Record};
use peelkit::study::TipChange;

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
