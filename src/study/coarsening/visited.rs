//! Where outside of a table the tips of a seta have been in equilibrium: it says how far the table has to grow.

use super::branch::TipSheet;
use super::near_end::Source;
use super::options::TipRange;
use super::place::{PadEnd, TipPlace};
use super::table::TipTable;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

/// How far a table grows, over what was asked of it.
const ROOM: f64 = 1.1;

/// Where outside of a table tips have been in equilibrium.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Visited {
    /// The tips that were outside of it, by number
    pub outside: BTreeSet<usize>,
    /// By how much a tip was pressed farther than where the attached branch begins, at most, nm
    pub pressed: f64,
    /// The smallest and the largest v outside of the table, nm; zeros where the pad slides
    pub lateral: [f64; 2],
    /// The smallest and the largest θ outside of the table, rad
    pub rotation: [f64; 2],
    /// The tips that were solved as spatulae
    pub resolved: Resolved,
}

/// Tips that were solved as spatulae near the end of their branch, and what that changed in equilibria of the seta.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Resolved {
    /// The tips, by number
    pub tips: BTreeSet<usize>,
    /// The largest change of the normal force of a tip against its table, nN
    pub force: f64,
    /// The same of the moment, nN·nm
    pub moment: f64,
    /// The tips of which no spatula was found in an equilibrium of the seta: they followed the table there
    pub unsolved: BTreeSet<usize>,
}

impl Visited {
    /// A range that holds what another one does and, with some room, where tips have been.
    pub fn widened(&self, range: &TipRange) -> TipRange {
        let wider = |[from, to]: [f64; 2], [low, high]: [f64; 2]| [from.min(ROOM * low), to.max(ROOM * high)];
        TipRange {
            press: range.press + ROOM * self.pressed,
            lateral: wider(range.lateral, self.lateral),
            rotation: wider(range.rotation, self.rotation),
        }
    }
}

/// The same while a seta is pulled off.
#[derive(Debug, Default)]
pub(super) struct Visits(Mutex<Visited>);

impl Visits {
    /// What is known already.
    pub fn new(visited: Visited) -> Self {
        Self(Mutex::new(visited))
    }

    /// A tip is in equilibrium at a place of a table.
    pub fn note(&self, table: &TipTable, tip: usize, on: TipSheet, place: TipPlace) {
        if table.contains(on, place) {
            return;
        }
        let mut visited = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        visited.outside.insert(tip);
        let widened = |[from, to]: [f64; 2], value: f64| [from.min(value), to.max(value)];
        if table.options.pad_end == PadEnd::Held {
            visited.lateral = widened(visited.lateral, place.lateral);
        }
        visited.rotation = widened(visited.rotation, place.rotation);
        if on == TipSheet::Attached {
            visited.pressed = visited.pressed.max(table.attached.ends(place)[0] - place.normal);
        }
    }

    /// A tip is in equilibrium, and has been solved as a spatula before or not.
    pub fn note_resolved(&self, tip: usize, source: Source, solved: bool) {
        if !solved && source != Source::Unsolved {
            return;
        }
        let resolved = &mut self.0.lock().unwrap_or_else(PoisonError::into_inner).resolved;
        if solved {
            resolved.tips.insert(tip);
        }
        match source {
            Source::Table => {}
            Source::Spatula([force, moment]) => {
                resolved.force = resolved.force.max(force.abs());
                resolved.moment = resolved.moment.max(moment.abs());
            }
            Source::Unsolved => drop(resolved.unsolved.insert(tip)),
        }
    }

    /// What was noted so far.
    pub fn get(&self) -> Visited {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }
}
