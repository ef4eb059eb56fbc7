//! How much work a path that is lost may take.
//!
//! A path that comes through takes some hundreds of Newton iterations. One that no mesh and no pace carries to its end takes as much as there are
//! meshes and paces to try, and few of those that were not found by then are found at all. So there is a bound on the whole, counted in
//! iterations of the first mesh: iterations on a finer one count for as much as it has more elements. It looks at no clock, so that a result
//! does not depend on the machine.

use super::result::PathEnd;
use crate::solve::path::options::{PathOptions, Waypoint};
use crate::solve::workspace::ShouldStop;
use crate::study::asked::stop_criteria::{Patience, Stage, StopCriteria};

/// Newton iterations on the first mesh that a sampled path takes: the median of strips and tapes is between 300 and 500.
const USUAL: f64 = 400.0;
/// Most work of one peel, over the usual.
const MOST: f64 = 100.0;

/// The work that is left to a peel, in Newton iterations of so many elements; infinite where the user has all the time that it takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Budget {
    elements: f64,
    left: f64,
}

impl Budget {
    /// That of a peel whose first mesh has so many elements.
    pub(crate) fn of(stop: &StopCriteria, elements: usize) -> Self {
        let left = match stop.patience {
            Patience::Usual => MOST * USUAL,
            Patience::Unlimited => f64::INFINITY,
        };
        Self { elements: elements as f64, left }
    }

    /// The Newton iterations that are left on a mesh of so many elements.
    pub(crate) fn iterations(&self, elements: usize) -> f64 {
        self.left * self.elements / elements as f64
    }

    /// Takes off what was done on such a mesh.
    pub(crate) fn spend(&mut self, iterations: usize, elements: usize) {
        self.left -= iterations as f64 * elements as f64 / self.elements;
    }

    /// Whether nothing is left.
    pub(crate) fn is_spent(&self) -> bool {
        self.left <= 0.0
    }
}

// -- How a run goes on from another one --
//
// The points of a path follow from the scene and the mesh alone: [`StopCriteria`] only say where it is left.
// So a run that takes an earlier one's points and computes the rest gives what a single one would give, bit for bit.

/// Where the points of a run's paths come from and go to.
pub struct Checkpoint<'a> {
    /// The first points of the path with these options, as far as an earlier run of the same scene has kept them.
    pub taken: &'a dyn Fn(&PathOptions) -> Vec<Waypoint>,
    /// Is given each point behind those, as soon as it is computed.
    pub keep: &'a dyn Fn(&PathOptions, Waypoint),
}

impl Checkpoint<'_> {
    /// Of a run that begins at rest and keeps nothing.
    pub const NOTHING: Checkpoint<'static> = Checkpoint { taken: &|_| Vec::new(), keep: &|_, _| () };
}

/// What ends a run's paths before their end, and what it goes on from.
pub(in crate::study) struct Limits<'a> {
    pub stop: &'a StopCriteria,
    pub checkpoint: &'a Checkpoint<'a>,
}

impl Limits<'_> {
    /// Why a path is to be left where it is, although it goes on.
    pub(crate) fn reached(&self) -> Option<PathEnd> {
        self.stop.reached_bound(Stage::Path).map(PathEnd::Bound)
    }

    /// Says when limit points and work are no longer to be computed.
    pub(crate) fn should_stop(&self) -> Option<ShouldStop> {
        self.stop.for_solves(Stage::Results)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Twice the elements take twice the work; without a bound nothing is ever spent.
    #[test]
    fn work_counts_by_elements() {
        let mut budget = Budget::of(&StopCriteria::default(), 16);
        let whole = budget.iterations(16);
        assert_eq!((whole, budget.iterations(32)), (MOST * USUAL, 0.5 * MOST * USUAL));
        budget.spend(1000, 64);
        assert_eq!(budget.iterations(16), whole - 4000.0);
        budget.spend(10_000, 64);
        assert!(budget.is_spent());
        let mut unlimited = Budget::of(&StopCriteria { patience: Patience::Unlimited, ..StopCriteria::default() }, 16);
        unlimited.spend(usize::MAX, 400);
        assert!(!unlimited.is_spent());
    }
}
