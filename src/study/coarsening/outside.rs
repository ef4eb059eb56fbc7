//! What is known of a pull-off in which tips have been outside of their table, and the table does not grow any more.
//!
//! A seta whose tips slide remembers nothing but which of them adhere. So an equilibrium in which all tips are within the table is one of the
//! seta, with these tips; which tips adhere there is known as far as the tips that were outside before have kept their hold, or lost it, as
//! those of the extrapolation did.

use super::error::CoarseningError;
use super::options::TipRange;
use super::visited::Visited;
use crate::study::seta::result::{SetaPoint, SetaPullOff};
use serde::{Deserialize, Serialize};
use std::fmt;

/// Why a table does not grow any more.
#[derive(Clone, Debug, PartialEq)]
pub enum TableEnd {
    /// As many pull-offs were computed as are.
    Rounds,
    /// The spatula cannot be followed to where tips have been.
    Spatula(CoarseningError),
}

/// Where a tip was outside of its table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutsideAt {
    /// Number of the step of the loading, from 0
    pub step: usize,
    /// How far the root has moved in it, nm
    pub displacement: f64,
}

impl From<&SetaPoint> for OutsideAt {
    fn from(point: &SetaPoint) -> Self {
        Self { step: point.step, displacement: point.displacement }
    }
}

impl fmt::Display for OutsideAt {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{:.1} nm of step {}", self.displacement, self.step + 1)
    }
}

/// Tips that have been outside of their table in the last pull-off.
#[derive(Clone, Debug, PartialEq)]
pub struct OutsideTable {
    /// How many
    pub tips: usize,
    /// How many pull-offs were computed, each with its table
    pub rounds: usize,
    /// By how much one was pressed farther than where the table begins, at most, nm
    pub pressed: f64,
    /// The smallest and the largest θ, rad, where they are outside of the range of the table
    pub rotation: Option<[f64; 2]>,
    /// The first and the last equilibrium with a tip outside
    pub between: Option<[OutsideAt; 2]>,
    /// Whether all tips are within the table at the peak and at the equilibria before and behind it
    pub peak_is_inside: bool,
    /// Why the table does not grow
    pub end: TableEnd,
}

impl OutsideTable {
    /// Of the last of these pull-offs.
    pub(super) fn new(pull_off: &SetaPullOff, rounds: &[TableRound], end: TableEnd) -> Self {
        let (visited, range) = rounds.last().map(|last| (last.visited.clone(), last.range)).unzip();
        let visited = visited.unwrap_or_default();
        let [from, to] = visited.rotation;
        let is_turned = range.is_some_and(|range| from < range.rotation[0] || to > range.rotation[1]);
        let points = &pull_off.points;
        let is_outside = |point: &&SetaPoint| point.outside > 0;
        let first = points.iter().find(is_outside);
        let between = first.zip(points.iter().rfind(is_outside));
        let peak = pull_off.peak.as_ref().and_then(|peak| points.iter().position(|point| *point == peak.point));
        let about = |peak: usize| &points[peak.saturating_sub(1)..(peak + 2).min(points.len())];
        Self {
            tips: visited.outside.len(),
            rounds: rounds.len(),
            pressed: visited.pressed,
            rotation: is_turned.then_some(visited.rotation),
            between: between.map(|(first, last)| [first.into(), last.into()]),
            peak_is_inside: peak.is_some_and(|peak| about(peak).iter().all(|point| point.outside == 0)),
            end,
        }
    }
}

impl OutsideTable {
    /// What outputs call it.
    pub fn code(&self) -> &'static str {
        if self.peak_is_inside { "outside-table" } else { "peak-outside-table" }
    }
}

impl fmt::Display for OutsideTable {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { tips, rounds, pressed, .. } = self;
        write!(f, "{tips} tips were outside of the last of {rounds} tables")?;
        if let Some([first, last]) = &self.between {
            write!(f, ", from {first} to {last}")?;
        }
        if *pressed > 0.0 {
            write!(f, ", up to {pressed:.1} nm below where it begins")?;
        }
        if let Some([from, to]) = self.rotation {
            write!(f, ", with θ from {from:.4} to {to:.4} rad")?;
        }
        f.write_str(": their forces there are extrapolated")?;
        if let TableEnd::Spatula(why) = &self.end {
            write!(f, ", as no wider table can be made: {why}")?;
        }
        f.write_str(match self.peak_is_inside {
            true => ". At the peak all tips are within the table: it is that of the tips that adhere there. Which tips adhere there, and where, is as if those that were outside had kept their hold; that is not known",
            false => ". At the peak, or next to it, there are such tips: it is not known",
        })
    }
}

/// A pull-off by one of the tables.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TableRound {
    /// What the table holds
    pub range: TipRange,
    /// Nodes of the table
    pub rows: usize,
    /// From how far before the end of their branch tips were solved as spatulae, nm; none: all by the table
    pub within: Option<f64>,
    /// Where outside of it the tips have been
    pub visited: Visited,
    /// Largest force along the last step, nN
    pub peak_force: Option<f64>,
}
