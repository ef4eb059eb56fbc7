//! Displacement and force inside one step of a path, from solutions there.
//!
//! Slopes of the path belong to the mesh of a point; between points whose meshes differ they are good to few digits. Here
//! only values count: u and P are polynomials through solutions at Gauss-Lobatto labels.

use crate::beam::Basis;
use crate::solve::{Observables, Problem, ROUGH, Solution, Stretch, Workspace, reach};
use std::sync::Arc;

/// Solutions on a step, its ends among them.
const NODES: usize = 7;

/// u (nm) and P (nN) on a step, as polynomials of a local coordinate on [-1, 1].
pub(super) struct StepCurve {
    basis: Basis<NODES>,
    displacements: [f64; NODES],
    forces: [f64; NODES],
}

impl StepCurve {
    /// The step behind `points[index]`.
    pub fn behind(problem: &Problem, points: &[Arc<Solution>], index: usize, work: &mut Workspace) -> Self {
        let stretch = Stretch::around(problem, points, index);
        Self::until(problem, &stretch, stretch.end(), &points[index + 1], work)
    }

    /// From the first point of a stretch to a solution at the label `to` of it. Where a solution between cannot be found, the
    /// stretch's own interpolants stand in.
    pub fn until(problem: &Problem, stretch: &Stretch, to: f64, end: &Solution, work: &mut Workspace) -> Self {
        let basis = Basis::new();
        let (left, right) = (NODES - 2, NODES - 1);
        let mut at = [(0.0, 0.0); NODES];
        let of = |o: &Observables| (o.displacement, o.force);
        (at[left], at[right]) = (of(&stretch.first().observables), of(&end.observables));
        let (mut known, mut last) = (stretch.clone(), 0.0);
        for (at, node) in at[..left].iter_mut().zip(basis.nodes) {
            let label = 0.5 * (1.0 + node) * to;
            let interpolated = |pick: fn(&Observables) -> f64| stretch.observable(pick, 0.5 * to).at(label).0;
            *at = match reach(problem, &mut known, last, label, ROUGH, work) {
                Ok(solution) => of(&solution.observables),
                Err(_) => (interpolated(|o| o.displacement), interpolated(|o| o.force)),
            };
            last = label;
        }
        Self { basis, displacements: at.map(|pair| pair.0), forces: at.map(|pair| pair.1) }
    }

    /// (u, u', P, P') at a local coordinate.
    pub fn at(&self, place: f64) -> (f64, f64, f64, f64) {
        let (value, slope) = self.basis.sample(place);
        let mixed = |weights: &[f64; NODES], values: &[f64; NODES]| -> f64 {
            weights.iter().zip(values).map(|(weight, value)| weight * value).sum()
        };
        let (u, p) = (&self.displacements, &self.forces);
        (mixed(&value, u), mixed(&slope, u), mixed(&value, p), mixed(&slope, p))
    }

    /// ∫ P du over the step, aJ: exact for the polynomials.
    pub fn work(&self) -> f64 {
        let power = |q: usize| {
            let (_, rise, force, _) = self.at(self.basis.points[q]);
            self.basis.weights[q] * force * rise
        };
        (0..NODES - 1).map(power).sum()
    }
}
