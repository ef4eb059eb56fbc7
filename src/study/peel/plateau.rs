//! The plateau of a peel: where the force changes least with the displacement.

use super::equilibrium_path::Followed;
use super::{Plateau, StepCurve};
use crate::model::PlanarProblem;

/// A plateau is reported where |d ln P / d ln u| is below this.
const FLAT: f64 = 0.01;

/// Samples of a step.
const SAMPLES: usize = 64;

/// The plateau between the initiation peak and the snap-off (or the end of the path): the flattest segment of the curve,
/// and on it the place of least steepness. Load limit points are level too, but only for a moment.
pub(super) fn plateau(
    problem: &PlanarProblem,
    followed: &Followed,
    peak_after: usize,
    snap_after: usize,
) -> Option<Plateau> {
    let points = &followed.points;
    // between points by differences: slopes at the points are not exact enough to tell one flat place from another
    let between = |i: usize| {
        let (a, b) = (&points[i].observables, &points[i + 1].observables);
        ((b.force / a.force).ln() / (b.displacement / a.displacement).ln()).abs()
    };
    let least = (peak_after + 2..snap_after.saturating_sub(1))
        .filter(|&i| between(i) <= between(i - 1) && between(i) <= between(i + 1))
        .min_by(|&a, &b| between(a).total_cmp(&between(b)))?;
    let mut ws = followed.workspace();
    // a step and its neighbours, since the least steepness may lie at an end of it
    let steps = (least - 1..=least + 1).map(|i| StepCurve::behind(problem, points, i, &mut ws));
    let best =
        steps.flat_map(|curve| (0..=SAMPLES).map(move |k| sample(&curve, k))).min_by(|a, b| a.0.total_cmp(&b.0))?;
    (best.0 < FLAT).then_some(best.1)
}

/// |d ln P / d ln u| at one of the samples of a step, and the place.
fn sample(curve: &StepCurve, k: usize) -> (f64, Plateau) {
    let (u, rise, p, fall) = curve.at(2.0 * k as f64 / SAMPLES as f64 - 1.0);
    ((fall * u / (rise * p)).abs(), Plateau { displacement: u, force: p })
}
