//! A table where it is good enough, and the spatula itself where it is not: at the tips that ask for a place outside of the table, and at all where
//! its error is above what is allowed.

use super::columns::TipSheet;
use super::options::{CoarseningError, HeldError, TipPlace, TipResponse};
use super::run::Coarsening;
use super::table::TipTable;

/// A table that is backed by its spatula.
pub struct AdaptiveTable {
    coarsening: Coarsening,
    table: TipTable,
    allowed: f64,
    record: ResolvedTips,
    outside: Vec<(TipSheet, TipPlace)>,
}

/// How often the spatula itself was solved, and what that changed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ResolvedTips {
    /// How often a response was asked for
    pub asked: usize,
    /// How often the spatula was solved for it
    pub resolved: usize,
    /// The largest change against the table: of the normal force and of that along the substrate, nN, and of the moment, nN·nm
    pub changed: [f64; 3],
    /// How often the table was made anew
    pub grown: usize,
}

impl AdaptiveTable {
    /// A table, with the relative error that is allowed of it: where its bound is above, the spatula is solved.
    ///
    /// # Errors
    /// Those of the table.
    pub fn new(mut coarsening: Coarsening, allowed: f64) -> Result<Self, CoarseningError> {
        let table = coarsening.table()?;
        Ok(Self { coarsening, table, allowed, record: ResolvedTips::default(), outside: Vec::new() })
    }

    /// The table as it is now.
    pub fn table(&self) -> &TipTable {
        &self.table
    }

    /// What was resolved so far.
    pub fn record(&self) -> ResolvedTips {
        self.record
    }

    /// The response of a tip on a branch.
    ///
    /// # Errors
    /// The spatula had to be solved, and was not.
    pub fn response(&mut self, on: TipSheet, place: TipPlace) -> Result<TipResponse, HeldError> {
        self.record.asked += 1;
        let from_table = self.table.response(on, place);
        let inside = self.table.contains(on, place);
        if inside && self.table.errors(on).relative <= self.allowed {
            return Ok(from_table);
        }
        let solved = self.coarsening.resolve(on, place)?;
        self.record.resolved += 1;
        let changed = &mut self.record.changed;
        (0..3).for_each(|i| changed[i] = changed[i].max((solved.force[i] - from_table.force[i]).abs()));
        if !inside {
            self.outside.push((on, place));
        }
        Ok(solved)
    }

    /// Makes the table anew, as wide as was asked since and as accurate as is allowed.
    ///
    /// # Errors
    /// Those of the table; it stays what it is then.
    pub fn grow(&mut self) -> Result<(), CoarseningError> {
        let mut pressed: f64 = 0.0;
        for (on, place) in self.outside.drain(..) {
            self.coarsening.widen(place);
            if on == TipSheet::Attached {
                pressed = pressed.max(self.table.attached.ends(place)[0] - place.normal);
            }
        }
        self.coarsening.press_farther(pressed);
        self.coarsening.refine_to(self.allowed.min(self.table.options.tolerance));
        self.table = self.coarsening.table()?;
        self.record.grown += 1;
        Ok(())
    }
}
