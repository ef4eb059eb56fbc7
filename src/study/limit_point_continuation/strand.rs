//! A point followed without interruption, value by value, and what more elements said of it on the way.

use super::continuation::Known;
use super::result::{PointKind, Remark};
use crate::solve::observables::Observables;

/// A value's error bound is the largest difference at this many checks on either side of it.
pub(super) const NEIGHBOURS: usize = 3;

/// Relative differences of displacement and force to more elements.
#[derive(Clone, Copy)]
pub(super) struct Difference {
    pub displacement: f64,
    pub force: f64,
}

impl Difference {
    pub fn of(known: &Known, finer: &Observables) -> Self {
        let (o, n) = (&known.observables, &known.neglected);
        let relative = |fine: f64, here: f64, neglected: f64| ((fine - here).abs() + neglected) / here.abs();
        Self {
            displacement: relative(finer.displacement, o.displacement, n.displacement),
            force: relative(finer.force, o.force, n.force),
        }
    }

    pub fn max(self, other: Self) -> Self {
        Self { displacement: self.displacement.max(other.displacement), force: self.force.max(other.force) }
    }

    /// The difference of what is reported of the point.
    pub fn reported(self, kind: PointKind) -> f64 {
        match kind {
            PointKind::InitiationPeak => self.force,
            PointKind::SnapOff => self.displacement,
        }
    }
}

/// The point at one value.
pub(super) struct Found {
    pub observables: Observables,
    pub energy: f64,
    pub elements: usize,
    pub iterations: usize,
}

impl Found {
    pub fn new(known: &Known, elements: usize, iterations: usize) -> Self {
        Self { observables: known.observables, energy: known.energy, elements, iterations }
    }
}

/// A point followed without interruption, from its first value on.
pub(super) struct Strand {
    /// Index of the first value.
    pub first: usize,
    /// What was found, value by value; never empty.
    pub found: Vec<Found>,
    /// The point at the newest value, and at the newest that was found good on more elements.
    pub newest: Known,
    pub good: Known,
    /// Indices of values that were solved for on more elements; never empty.
    pub checks: Vec<(usize, Difference)>,
    /// What happened on the way, and why it ended before the last value.
    pub remarks: Vec<Remark>,
}

impl Strand {
    /// Index of the newest value.
    pub fn last(&self) -> usize {
        self.first + self.found.len() - 1
    }

    pub fn at(&self, index: usize) -> &Found {
        &self.found[index - self.first]
    }

    pub fn elements(&self) -> usize {
        self.found[self.found.len() - 1].elements
    }

    /// Drops the values behind the last check, where that found no limit point on more elements.
    pub fn drop_unbounded(&mut self) {
        while self.checks.len() > 1 && self.checks.last().is_some_and(|(_, difference)| !difference.force.is_finite()) {
            self.checks.pop();
            self.found.truncate(self.last_check() - self.first + 1);
        }
    }

    pub fn last_check(&self) -> usize {
        self.checks[self.checks.len() - 1].0
    }
}
