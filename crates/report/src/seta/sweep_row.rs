//! One value of a sweep of setae.

use super::names::end_word;
use peelkit::study::{SetaMoment, SetaResult};

/// One value of a sweep and what the pull-off of its seta found.
#[derive(Clone, Debug)]
pub struct SetaRow {
    /// The value of the varied parameter, in its own unit.
    pub value: f64,
    /// The value of the second one, where two are varied.
    pub second: Option<f64>,
    /// Forces in nN, displacements in nm, works in aJ; or why there is no pull-off.
    pub found: Result<SetaResult, String>,
    /// Wall clock that it took, s.
    pub solve_s: f64,
}

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
