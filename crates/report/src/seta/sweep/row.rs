//! One value of a sweep of setae.

use crate::pull_row::PullRow;
use crate::seta::names::end_word;
use peelkit::study::{SetaMoment, SetaResult};

/// One value of a sweep of setae: forces in nN, displacements in nm, works in aJ.
pub type SetaRow = PullRow<SetaResult>;

impl SetaRow {
    /// Its peak, if it was reached.
    pub fn peak(&self) -> Option<SetaMoment> {
        self.found.as_ref().ok()?.peak
    }

    /// The name of its end in outputs.
    pub fn end(&self) -> &'static str {
        self.found.as_ref().map_or("failed", |found| end_word(&found.end, found.attached))
    }

    /// Work of the root, of a pull-off that was computed to its end, aJ.
    pub(super) fn work(&self) -> Option<f64> {
        self.found.as_ref().ok().filter(|found| !found.end.is_cut_short()).map(|found| found.work)
    }
}
