//! The work of the grip along a path, of its force, and of its moment where it turns: the energy it changed, or, where the load has no
//! potential, ∫ P du.

use super::peel::Peel;
use super::step_curve::StepCurve;
use crate::solve::{Located, Problem, Solution, Stretch, Workspace};
use std::sync::Arc;

/// Work from rest to each point, aJ.
pub(super) fn works(problem: &Problem, points: &[Arc<Solution>], work: &mut Workspace) -> Vec<f64> {
    if !problem.conservative {
        return works_of_force(problem, points, work);
    }
    points.iter().map(|s| energy(problem, s) - energy(problem, &points[0])).collect()
}

/// Work at a located point, aJ; `works` as above.
pub(super) fn work_near(
    problem: &Problem,
    points: &[Arc<Solution>],
    works: &[f64],
    after: usize,
    located: &Located,
    work: &mut Workspace,
) -> f64 {
    let s = &located.solution;
    if problem.conservative {
        let ahead = problem.power(&s.at) * (located.observables.displacement - s.observables.displacement);
        return energy(problem, s) - energy(problem, &points[0]) + ahead;
    }
    let mut stretch = Stretch::around(problem, points, after);
    let label = stretch.insert(s.clone());
    works[after] + StepCurve::until(problem, &stretch, label, s, work).work()
}

/// ∫ P du from rest to each point, aJ, whatever the load.
pub(super) fn works_of_force(problem: &Problem, points: &[Arc<Solution>], work: &mut Workspace) -> Vec<f64> {
    let mut works = vec![0.0];
    for i in 0..points.len().saturating_sub(1) {
        works.push(works[i] + StepCurve::behind(problem, points, i, work).work());
    }
    works
}

/// Stored and adhesion energy, aJ.
pub(super) fn energy(problem: &Problem, s: &Solution) -> f64 {
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
