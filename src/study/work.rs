//! The work of the grip along a path: the energy it changed, or, where the load has no potential, ∫ P du.

use crate::beam::Basis;
use crate::solve::{Equilibrium, Located, Observables, Problem, Solution, Stretch, Workspace, solve_on};
use std::sync::Arc;

/// Solutions on every step of the path, its ends among them.
const NODES: usize = 5;
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
    works[after] + work_until(problem, &stretch, label, s)
}

/// ∫ P du from rest to each point, aJ, whatever the load.
pub(super) fn works_of_force(problem: &Problem, points: &[Arc<Solution>]) -> Vec<f64> {
    let mut works = vec![0.0];
    for i in 0..points.len().saturating_sub(1) {
        let stretch = Stretch::around(problem, points, i);
        works.push(works[i] + work_until(problem, &stretch, stretch.end(), &points[i + 1]));
    }
    works
}

/// Stored and adhesion energy, aJ. A held grip's multiplier H adds H L.
pub(super) fn energy(problem: &Problem, s: &Solution) -> f64 {
    let border = |at: &Equilibrium| at.border * problem.length;
    s.energy.total + border(&s.at)
}

/// ∫ P du from the first point of a stretch to a solution at the label `to` of it: u and P as polynomials through solutions at
/// Gauss-Lobatto labels. Where one cannot be solved for, the stretch's own interpolants stand in.
fn work_until(problem: &Problem, stretch: &Stretch, to: f64, end: &Solution) -> f64 {
    let basis = Basis::<NODES>::new();
    let mut known = stretch.clone();
    let mut work = Workspace::default();
    let mut at = [(0.0, 0.0); NODES];
    let of = |o: &Observables| (o.displacement, o.force);
    at[NODES - 2] = of(&stretch.first().observables);
    at[NODES - 1] = of(&end.observables);
    let mut last = 0.0;
    for (at, node) in at.iter_mut().zip(basis.nodes).take(NODES - 2) {
        let label = 0.5 * (1.0 + node) * to;
        let interpolated = |pick: fn(&Observables) -> f64| stretch.observable(pick, 0.5 * to).at(label).0;
        *at = match reach(problem, &mut known, last, label, &mut work, MOST_HALVINGS) {
            Some(solution) => of(&solution.observables),
            None => (interpolated(|o| o.displacement), interpolated(|o| o.force)),
        };
        last = label;
    }
    let mixed = |weights: &[f64; NODES], part: fn(&(f64, f64)) -> f64| -> f64 {
        weights.iter().zip(&at).map(|(weight, pair)| weight * part(pair)).sum()
    };
    let power = |q: usize| mixed(&basis.value[q], |pair| pair.1) * mixed(&basis.slope[q], |pair| pair.0);
    (0..NODES - 1).map(|q| basis.weights[q] * power(q)).sum()
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
