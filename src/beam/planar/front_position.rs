//! Where the peeling front is when so much of the adhesion is left.

use crate::solve::path::hermite::Hermite;

/// The place of the front along a chain, from the adhesion energy that is left over that of a unit length at the left end.
#[derive(Clone, Debug)]
pub enum FrontPosition {
    /// Every unit of length adheres alike: the two are the same number.
    Even,
    /// (front, S, dS/dfront), ascending: what adheres differs from place to place.
    Table(Vec<(f64, f64, f64)>),
}

/// Panels over which what adheres is summed.
const PANELS: usize = 256;

impl FrontPosition {
    /// From what adheres at each place of a chain when it lies on the substrate, over what adheres at its left end.
    pub fn new(length: f64, adheres: impl Fn(f64) -> f64) -> Self {
        let place = |k: usize| length * k as f64 / PANELS as f64;
        let (mut front, mut here) = (0.0, adheres(0.0));
        let mut table = vec![(front, 0.0, 1.0 / here)];
        for k in 1..=PANELS {
            let (from, to) = (place(k - 1), place(k));
            let (middle, next) = (adheres(0.5 * (from + to)), adheres(to));
            front += (to - from) / 6.0 * (here + 4.0 * middle + next);
            table.push((front, to, 1.0 / next));
            here = next;
        }
        Self::Table(table)
    }

    /// S of a front, nm; an end of the chain for a front beyond it.
    pub fn place(&self, front: f64) -> f64 {
        let Self::Table(table) = self else { return front };
        let before = table.partition_point(|known| known.0 < front).saturating_sub(1);
        match (table.get(before), table.get(before + 1)) {
            (Some(&a), Some(&b)) => Hermite::new(&[a, b]).at(front.max(a.0)).0,
            (Some(last), None) => last.1,
            _ => 0.0,
        }
    }

    /// The front that is not far from a place, nm.
    pub fn near(&self, place: f64) -> f64 {
        let Self::Table(table) = self else { return place };
        table.iter().rev().find(|known| known.1 <= place).map_or(0.0, |known| known.0 + (place - known.1) / known.2)
    }
}
