//! The elements on which the point is solved for: as few as are good enough.

use super::continuation::{Known, problem, search};
use super::result::PointKind;
use super::strand::Difference;
use super::values::Sweep;
use crate::beam::planar::planar_beam::FRONT;
use crate::solve::error::SolveError;
use crate::solve::points::locate::Located;
use crate::solve::points::search::BendRule;
use crate::solve::state::Mesh;
use crate::solve::workspace::Workspace;
use crate::study::accuracy::{ORDER, Resolution};
use crate::study::error_bounds::FOLLOWED_BOUND_FACTOR;

/// Elements to begin with at the initiation peak, where the free end mostly rests, and the most anywhere.
const FEWEST_ELEMENTS: usize = 10;
pub(super) const MOST_ELEMENTS: usize = 200;
/// A mesh is chosen with this share of the error allowed, so that it lasts for a while.
const MARGIN: f64 = 0.7;

impl Sweep<'_> {
    /// Elements to begin with.
    pub fn fewest(&self, index: usize) -> usize {
        match self.kind {
            PointKind::InitiationPeak => FEWEST_ELEMENTS,
            PointKind::SnapOff => Resolution::first(&(self.model)(self.values[index]), self.accuracy).elements,
        }
    }

    /// The located point on a mesh of its own.
    pub fn taken_up(&self, index: usize, located: &Located, elements: usize) -> Result<Known, SolveError> {
        let problem = problem(&(self.model)(self.values[index]), self.kind);
        let (beam, known) = (&problem.beam, &located.solution.at);
        let front = located.observables.monitors[FRONT];
        let mesh = Mesh { focus: known.mesh.focus, ..beam.mesh_at(front, known.mesh.edges, elements) };
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
    pub fn known_on(&self, index: usize, known: &Known, elements: usize) -> Result<Known, SolveError> {
        let problem = problem(&(self.model)(self.values[index]), self.kind);
        let fold = known.on_elements(&problem, self.kind, elements, &mut Workspace::default())?;
        Ok(Known::new(&problem, self.kind, known.at, &fold))
    }

    /// A known point against half as many elements again.
    pub fn difference(&self, index: usize, known: &Known, elements: usize) -> Result<Difference, SolveError> {
        let finer = self.known_on(index, known, elements + elements.div_ceil(2))?;
        Ok(Difference::of(known, &finer.observables))
    }

    /// The error expected, over the accuracy asked for.
    pub fn worst(&self, difference: Difference) -> f64 {
        FOLLOWED_BOUND_FACTOR * difference.reported(self.kind) / self.accuracy.relative
    }

    /// The point on the coarsest mesh that is good enough, from `elements` on.
    pub fn on_fitting_mesh(
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
