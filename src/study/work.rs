//! The work of the grip along a path: the energy it changed, or, where the load has no potential, ∫ P du.

use crate::beam::Basis;
use crate::solve::{Equilibrium, Located, Observables, Problem, Solution, Stretch, Workspace, solve_on};
use std::sync::Arc;

/// How often the way to a solution inside a step is halved.
const MOST_HALVINGS: usize = 4;

/// Work from rest to each point, aJ.
pub(super) fn works(problem: &Problem, points: &[Arc<Solution>]) -> Vec<f64> {
    if !problem.conservative {
        return works_of_force(problem, points);
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
) -> f64 {
    let s = &located.solution;
    if problem.conservative {
        let ahead = s.observables.force * (located.observables.displacement - s.observables.displacement);
        return energy(problem, s) - energy(problem, &points[0]) + ahead;
    }
    let mut stretch = Stretch::around(problem, points, after);
    let label = stretch.insert(s.clone());
    works[after] + work_between(problem, &stretch, 0.0, label)
}

/// ∫ P du from rest to each point, aJ, whatever the load.
pub(super) fn works_of_force(problem: &Problem, points: &[Arc<Solution>]) -> Vec<f64> {
    let mut works = vec![0.0];
    for i in 0..points.len().saturating_sub(1) {
        let stretch = Stretch::around(problem, points, i);
        works.push(works[i] + work_between(problem, &stretch, 0.0, stretch.end()));
    }
    works
}

/// Stored and adhesion energy, aJ. A held grip's multiplier H adds H L.
pub(super) fn energy(problem: &Problem, s: &Solution) -> f64 {
    let border = |at: &Equilibrium| at.border * problem.length;
    s.energy.total + border(&s.at)
}

/// ∫ P du between two labels of a stretch: u and P as the polynomials of degree 5 through solutions at Gauss-Lobatto
/// labels. Where one cannot be solved for, the stretch's own interpolants stand in.
fn work_between(problem: &Problem, stretch: &Stretch, from: f64, to: f64) -> f64 {
    let basis = Basis::<6>::new();
    let mut known = stretch.clone();
    let mut work = Workspace::default();
    let mut last = from;
    let at = basis.nodes.map(|node| {
        let label = from + 0.5 * (1.0 + node) * (to - from);
        let observables = match reach(problem, &mut known, last, label, &mut work, MOST_HALVINGS) {
            Some(solution) => (solution.observables.displacement, solution.observables.force),
            None => {
                let middle = 0.5 * (from + to);
                let at = |pick: fn(&Observables) -> f64| stretch.observable(pick, middle).at(label).0;
                (at(|o| o.displacement), at(|o| o.force))
            }
        };
        last = label;
        observables
    });
    let rise = |values: &[f64; 6]| (0..6).map(|a| values[a] * at[a].0).sum::<f64>();
    let force = |values: &[f64; 6]| (0..6).map(|a| values[a] * at[a].1).sum::<f64>();
    (0..5).map(|q| basis.weights[q] * force(&basis.value[q]) * rise(&basis.slope[q])).sum()
}

/// The solution at a label, from what is known of the stretch, which it joins; where the start is too far away, by way of
/// the middle between `from`, where a solution is known, and there.
fn reach(
    problem: &Problem,
    known: &mut Stretch,
    from: f64,
    label: f64,
    work: &mut Workspace,
    halvings: usize,
) -> Option<Arc<Solution>> {
    let mut solved = solve_on(problem, known, label, false, work).ok();
    if solved.is_none() && halvings > 0 {
        let middle = 0.5 * (from + label);
        reach(problem, known, from, middle, work, halvings - 1)?;
        solved = Some(reach(problem, known, middle, label, work, halvings - 1)?);
    }
    known.insert(solved.clone()?);
    solved
}
