//! A point followed without interruption, value by value, and what more elements said of it on the way.

use super::continuation::{Known, problem, search};
use super::result::{PointKind, Remark};
use super::values::Sweep;
use crate::beam::planar::planar_beam::FRONT;
use crate::solve::error::SolveError;
use crate::solve::points::locate::Located;
use crate::solve::points::search::BendRule;
use crate::solve::state::{Mesh, Observables};
use crate::solve::workspace::Workspace;
use crate::study::asked::accuracy::{ORDER, Resolution};
use crate::study::asked::error_bounds::FOLLOWED_BOUND_FACTOR;

/// A value's error bound is the largest difference at this many checks on either side of it.
pub(super) const NEIGHBOURS: usize = 3;

/// Relative differences of displacement and force to more elements.
#[derive(Clone, Copy)]
pub(super) struct Difference {
    pub displacement: f64,
    pub force: f64,
}

impl Difference {
    pub(crate) fn of(known: &Known, finer: &Observables) -> Self {
        let (o, n) = (&known.observables, &known.neglected);
        let relative = |fine: f64, here: f64, neglected: f64| ((fine - here).abs() + neglected) / here.abs();
        Self {
            displacement: relative(finer.displacement, o.displacement, n.displacement),
            force: relative(finer.force, o.force, n.force),
        }
    }

    pub(crate) fn max(self, other: Self) -> Self {
        Self { displacement: self.displacement.max(other.displacement), force: self.force.max(other.force) }
    }

    /// The difference of what is reported of the point.
    pub(crate) fn reported(self, kind: PointKind) -> f64 {
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
    pub(crate) fn new(known: &Known, elements: usize, iterations: usize) -> Self {
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
    pub(crate) fn last(&self) -> usize {
        self.first + self.found.len() - 1
    }

    pub(crate) fn at(&self, index: usize) -> &Found {
        &self.found[index - self.first]
    }

    pub(crate) fn elements(&self) -> usize {
        self.found[self.found.len() - 1].elements
    }

    /// Drops the values behind the last check, where that found no limit point on more elements.
    pub(crate) fn drop_unbounded(&mut self) {
        while self.checks.len() > 1 && self.checks.last().is_some_and(|(_, difference)| !difference.force.is_finite()) {
            self.checks.pop();
            self.found.truncate(self.last_check() - self.first + 1);
        }
    }

    pub(crate) fn last_check(&self) -> usize {
        self.checks[self.checks.len() - 1].0
    }
}

// -- The elements on which the point is solved for: as few as are good enough --

/// Elements to begin with at the initiation peak, where the free end mostly rests, and the most anywhere.
const FEWEST_ELEMENTS: usize = 10;
pub(super) const MOST_ELEMENTS: usize = 200;
/// A mesh is chosen with this share of the error allowed, so that it lasts for a while.
const MARGIN: f64 = 0.7;

impl Sweep<'_> {
    /// Elements to begin with.
    pub(crate) fn fewest(&self, index: usize) -> usize {
        match self.kind {
            PointKind::InitiationPeak => FEWEST_ELEMENTS,
            PointKind::SnapOff => Resolution::first(&(self.model)(self.values[index]), self.accuracy).elements,
        }
    }

    /// The located point on a mesh of its own.
    pub(crate) fn taken_up(&self, index: usize, located: &Located, elements: usize) -> Result<Known, SolveError> {
        let problem = problem(&(self.model)(self.values[index]), self.kind);
        let (beam, known) = (&problem.beam, &located.solution.at);
        let front = located.observables.monitors[FRONT];
        let mesh = Mesh { focus: known.mesh.focus, ..beam.mesh_at(front, &known.mesh.follows, elements) };
        let at = beam.resampled(known, mesh);
        let sampling = search(&problem, self.kind, 1.0);
        let target = sampling.weights.dot(&located.observables);
        let fold = search(&problem, self.kind, target).run(
            at,
            target,
            BendRule::Difference { neighbour: None },
            &mut Workspace::default(),
        )?;
        Ok(Known::new(&problem, self.kind, self.coordinate(index), &fold))
    }

    /// A known point on another number of elements.
    pub(crate) fn known_on(&self, index: usize, known: &Known, elements: usize) -> Result<Known, SolveError> {
        let problem = problem(&(self.model)(self.values[index]), self.kind);
        let fold = known.on_elements(&problem, self.kind, elements, &mut Workspace::default())?;
        Ok(Known::new(&problem, self.kind, known.at, &fold))
    }

    /// A known point against half as many elements again.
    pub(crate) fn difference(&self, index: usize, known: &Known, elements: usize) -> Result<Difference, SolveError> {
        let finer = self.known_on(index, known, elements + elements.div_ceil(2))?;
        Ok(Difference::of(known, &finer.observables))
    }

    /// The error expected, over the accuracy asked for.
    pub(crate) fn worst(&self, difference: Difference) -> f64 {
        FOLLOWED_BOUND_FACTOR * difference.reported(self.kind) / self.accuracy.relative
    }

    /// The point on the coarsest mesh that is good enough, from `elements` on.
    pub(crate) fn on_fitting_mesh(
        &self,
        index: usize,
        mut elements: usize,
        on_mesh: &dyn Fn(usize) -> Result<Known, SolveError>,
    ) -> Result<(Known, usize, Difference), SolveError> {
        loop {
            let known = on_mesh(elements);
            let tried = known.and_then(|known| Ok((self.difference(index, &known, elements)?, known)));
            let worst = tried.as_ref().map_or(f64::INFINITY, |(difference, _)| self.worst(*difference));
            match tried {
                Ok((difference, known)) if worst <= MARGIN || elements >= MOST_ELEMENTS => {
                    return Ok((known, elements, difference));
                }
                Err(error) if elements >= MOST_ELEMENTS => return Err(error),
                _ => elements = finer(elements, worst / MARGIN),
            }
        }
    }
}

/// More elements, by what the theory of order 2p asks for to reduce an error of `worst` times the wanted one.
pub(super) fn finer(elements: usize, worst: f64) -> usize {
    let growth = (2.0 * worst).powf(0.5 / ORDER as f64).clamp(1.08, 1.6);
    ((elements as f64 * growth).ceil() as usize).min(MOST_ELEMENTS)
}
