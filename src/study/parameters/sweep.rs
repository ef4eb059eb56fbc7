//! One parameter varied, each value peeled from rest to its end.

use crate::study::peel::result::{Effort, LargestComputedForce, PathEnd, Peel, Plateau};
use crate::study::peel::solution_history::{LimitPoint, Peak};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// What a peel found, without its path.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PeelResult {
    /// As of [`Peel`]
    pub initiation_peak: Option<Peak>,
    /// As of [`Peel`]
    pub peak: Option<Peak>,
    /// As of [`Peel`]
    pub largest_computed_force: Option<LargestComputedForce>,
    /// As of [`Peel`]
    pub plateau: Option<Plateau>,
    /// S of the peeling front at the path point nearest to the plateau, nm.
    pub plateau_front: Option<f64>,
    /// As of [`Peel`]
    pub snap_off: Option<LimitPoint>,
    /// As of [`Peel`]
    pub pad_detachment: Option<LimitPoint>,
    /// As of [`Peel`]
    pub detachment: Option<LimitPoint>,
    /// ∫ P du from rest to the snap-off, or to the end of the path where there is none, aJ
    pub work: Option<f64>,
    /// Largest relative error bound, [`Peel::reached_accuracy`].
    pub reached: Option<f64>,
    /// Relative accuracy asked for.
    pub asked: f64,
    /// As of [`Peel`]
    pub end: PathEnd,
    /// As of [`Peel`]
    pub effort: Effort,
}

impl From<&Peel> for PeelResult {
    fn from(peel: &Peel) -> Self {
        Self {
            initiation_peak: peel.initiation_peak,
            peak: peel.peak,
            largest_computed_force: peel.largest_computed_force,
            plateau: peel.plateau,
            plateau_front: peel.plateau.and_then(|plateau| front_at(peel, plateau)),
            snap_off: peel.snap_off,
            pad_detachment: peel.pad_detachment,
            detachment: peel.detachment,
            work: peel.snap_off.map(|at| at.work).or_else(|| peel.points.last().map(|point| point.work)),
            reached: peel.reached_accuracy(),
            asked: peel.asked,
            end: peel.end.clone(),
            effort: peel.effort,
        }
    }
}

/// The front at the path point nearest to a plateau.
fn front_at(peel: &Peel, plateau: Plateau) -> Option<f64> {
    let away =
        |displacement: f64, force: f64| (displacement / plateau.displacement - 1.0).hypot(force / plateau.force - 1.0);
    let nearest =
        peel.points.iter().min_by(|a, b| away(a.displacement, a.force).total_cmp(&away(b.displacement, b.force)));
    nearest.map(|point| point.front)
}

/// Runs the cases on all cores, each by `run`, which may peel it and measure what that takes; the results come back in the order of
/// the cases. `go_on` is asked before each case: once it says no, no other is begun, and the cases that were not begun have no result.
/// Both are called from any thread.
pub fn sweep<C: Sync, R: Send>(
    cases: &[C],
    go_on: &(dyn Fn() -> bool + Sync),
    run: &(dyn Fn(&C) -> R + Sync),
) -> Vec<R> {
    cases.par_iter().filter(|_| go_on()).map(run).collect()
}

// -- A power law through points --

/// c and n of y = c xⁿ, by least squares in logarithms over points with x, y > 0.
pub fn power_law(points: impl IntoIterator<Item = (f64, f64)>) -> (f64, f64) {
    let data: Vec<(f64, f64)> = points.into_iter().map(|(x, y)| (x.ln(), y.ln())).collect();
    let count = data.len() as f64;
    let (x, y) = data.iter().fold((0.0, 0.0), |(x, y), d| (x + d.0 / count, y + d.1 / count));
    let (xy, xx) = data.iter().fold((0.0, 0.0), |(a, b), d| (a + (d.0 - x) * (d.1 - y), b + (d.0 - x).powi(2)));
    let exponent = xy / xx;
    ((y - exponent * x).exp(), exponent)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn finds_the_law_behind_its_points() {
        let (factor, exponent) = power_law([0.1f64, 1.0, 3.0, 70.0].map(|x| (x, 2.5 * x.powf(-0.25))));
        assert_relative_eq!(factor, 2.5, max_relative = 1e-13);
        assert_relative_eq!(exponent, -0.25, max_relative = 1e-13);
    }
}
