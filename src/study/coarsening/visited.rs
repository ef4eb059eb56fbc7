//! Where in a table the tips of a seta have been in equilibrium: what lies outside says how far the table has to grow.

use super::branch::TipSheet;
use super::place::{PadEnd, TipPlace};
use super::table::TipTable;
use std::sync::{Mutex, PoisonError};

/// Where in a table tips have been in equilibrium.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Visited {
    /// How often a tip was in equilibrium
    pub tips: usize,
    /// How often it was outside of the table
    pub outside: usize,
    /// By how much a tip was pressed farther than where the attached branch begins, at most, nm
    pub pressed: f64,
    /// The smallest and the largest v outside of the table, nm; zeros where the pad slides
    pub lateral: [f64; 2],
    /// The smallest and the largest θ outside of the table, rad
    pub rotation: [f64; 2],
}

/// The same while a seta is pulled off.
#[derive(Debug, Default)]
pub(super) struct Visits(Mutex<Visited>);

impl Visits {
    /// A tip is in equilibrium at a place of a table.
    pub fn note(&self, table: &TipTable, on: TipSheet, place: TipPlace) {
        let mut visited = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        visited.tips += 1;
        if table.contains(on, place) {
            return;
        }
        visited.outside += 1;
        let widened = |[from, to]: [f64; 2], value: f64| [from.min(value), to.max(value)];
        if table.options.pad_end == PadEnd::Held {
            visited.lateral = widened(visited.lateral, place.lateral);
        }
        visited.rotation = widened(visited.rotation, place.rotation);
        if on == TipSheet::Attached {
            visited.pressed = visited.pressed.max(table.attached.ends(place)[0] - place.normal);
        }
    }

    /// What was noted so far.
    pub fn get(&self) -> Visited {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
