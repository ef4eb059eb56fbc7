//! How tips leave the branches of their law in a pull-off, or in a pull at a rate.

use peelkit::study::TipChange;
use serde::Serialize;

/// The events of a pull, counted.
#[derive(Clone, Copy, Debug, Serialize)]
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
