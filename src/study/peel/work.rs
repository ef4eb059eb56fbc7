//! The work of the grip along a path, of its force, and of its moment where it turns: the energy it changed, or, where the load has no
//! potential, ∫ P du.

use super::Peel;
use super::step_curve::StepCurve;
use crate::model::PlanarProblem;
use crate::solve::{Located, PathSegment, Solution, Workspace};
use std::sync::Arc;

/// Work from rest to each point, aJ.
pub(super) fn works(problem: &PlanarProblem, points: &[Arc<Solution>], ws: &mut Workspace) -> Vec<f64> {
    if !problem.system.is_conservative() {
        return works_of_force(problem, points, ws);
    }
    points.iter().map(|s| energy(problem, s) - energy(problem, &points[0])).collect()
}

/// Work at a located point, aJ; `works` as above.
pub(super) fn work_near(
    problem: &PlanarProblem,
    points: &[Arc<Solution>],
    works: &[f64],
    after: usize,
    located: &Located,
    ws: &mut Workspace,
) -> f64 {
    let s = &located.solution;
    if problem.system.is_conservative() {
        let ahead = power(problem, s) * (located.observables.displacement - s.observables.displacement);
        return energy(problem, s) - energy(problem, &points[0]) + ahead;
    }
    let mut segment = PathSegment::around(problem, points, after);
    let label = segment.insert(s.clone());
    works[after] + StepCurve::until(problem, &segment, label, s, ws).work()
}

/// ∫ P du from rest to each point, aJ, whatever the load.
pub(super) fn works_of_force(problem: &PlanarProblem, points: &[Arc<Solution>], ws: &mut Workspace) -> Vec<f64> {
    let mut works = vec![0.0];
    for i in 0..points.len().saturating_sub(1) {
        works.push(works[i] + StepCurve::behind(problem, points, i, ws).work());
    }
    works
}

/// dΠ/du of an equilibrium, nN: the force along the pull, and of a grip that turns as it goes the work of the moment besides.
pub(in crate::study) fn power(problem: &PlanarProblem, s: &Solution) -> f64 {
    let (force, gear) = (s.at.force, problem.grip.gear);
    if gear == 0.0 { force } else { force + gear * problem.beam.grip_forces(&s.at).moment }
}

/// Stored and adhesion energy, aJ.
pub(super) fn energy(problem: &PlanarProblem, s: &Solution) -> f64 {
    problem.energy(&s.at, s.energy)
}

impl Peel {
    /// ∫ P du from rest to `points[index]`, by quadrature, which knows nothing of energies, and the change of stored and adhesion
    /// energy on that way, both aJ; nothing where the path was not kept. They are equal where the load has a potential and the
    /// grip does not turn.
    pub fn work_and_energy(&self, index: usize) -> Option<(f64, f64)> {
        let trace = self.trace.as_ref()?;
        let points = trace.points.get(..=index)?;
        let work = *works_of_force(&trace.problem, points, &mut Workspace::default()).last()?;
        Some((work, energy(&trace.problem, points.last()?) - energy(&trace.problem, points.first()?)))
    }
}
