//! The plateau of a peel: where the force changes least with the displacement.

use super::Plateau;
use super::follow::Followed;
use crate::solve::{Problem, Solution, Stretch, Workspace, solve_on};
use std::sync::Arc;

/// A plateau is reported where |d ln P / d ln u| is below this.
const FLAT: f64 = 0.01;

/// A steepness below this is round-off.
const ROUND_OFF: f64 = 1e-10;

/// d ln P / d ln u at a solution.
fn steepness(s: &Solution) -> f64 {
    (s.slope.force * s.observables.displacement) / (s.slope.displacement * s.observables.force)
}

/// The plateau between the initiation peak and the snap-off (or the end of the path): the flattest stretch of the curve,
/// and on it the place of least steepness. Load limit points are level too, but only for a moment.
pub(super) fn plateau(problem: &Problem, followed: &Followed, peak_after: usize, snap_after: usize) -> Option<Plateau> {
    let points = &followed.points;
    // between points by differences: slopes at the points are not exact enough to tell one flat place from another
    let between = |i: usize| {
        let (a, b) = (&points[i].observables, &points[i + 1].observables);
        ((b.force / a.force).ln() / (b.displacement / a.displacement).ln()).abs()
    };
    let least = (peak_after + 2..snap_after.saturating_sub(1))
        .filter(|&i| between(i) <= between(i - 1) && between(i) <= between(i + 1))
        .min_by(|&a, &b| between(a).total_cmp(&between(b)))?;
    let best = descend(problem, points, least)?;
    (steepness(&best).abs() < FLAT)
        .then(|| Plateau { displacement: best.observables.displacement, force: best.observables.force })
}

/// Follows the least steepness on the step behind `points[index]` and its neighbours by parabolas through three
/// solutions. It stops at once where the steepness is rounding: on a plateau of many process zones the force does not
/// change and no place on it is special.
fn descend(problem: &Problem, points: &[Arc<Solution>], index: usize) -> Option<Arc<Solution>> {
    let stretch = Stretch::around(problem, points, index);
    let mut work = Workspace::default();
    let mut at = |label: f64| {
        let solution = solve_on(problem, &stretch, label, true, &mut work).ok()?;
        Some((label, steepness(&solution), solution))
    };
    let mut three = vec![at(0.0)?, at(0.5 * stretch.end())?, at(stretch.end())?];
    for _ in 0..8 {
        let best = &three[1];
        if best.1.abs() < ROUND_OFF {
            break;
        }
        let vertex = vertex(&three);
        let (low, high) = (three[0].0, three[2].0);
        if !(vertex > low && vertex < high) || (vertex - best.0).abs() < 1e-4 * (high - low) {
            break;
        }
        let Some(new) = at(vertex) else { break };
        let better = new.1.abs() < best.1.abs();
        let ahead = vertex > best.0;
        match (better, ahead) {
            (true, true) => three = vec![three[1].clone(), new, three[2].clone()],
            (true, false) => three = vec![three[0].clone(), new, three[1].clone()],
            (false, true) => three[2] = new,
            (false, false) => three[0] = new,
        }
    }
    three.into_iter().min_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).map(|best| best.2)
}

/// Vertex of the parabola through three points.
fn vertex(p: &[(f64, f64, Arc<Solution>)]) -> f64 {
    let (a, b) = (p[0].0 - p[1].0, p[2].0 - p[1].0);
    let (f, g) = (p[0].1 - p[1].1, p[2].1 - p[1].1);
    p[1].0 + 0.5 * (a * a * g - b * b * f) / (a * g - b * f)
}
