//! The least squares of some coordinates, the others held, by Levenberg and Marquardt's method; and profiles, which hold one at values around it.

use super::residuals::{Evaluator, Trial, Weights};
use super::result::{NoFit, Profile};
use super::statistics::Covariance;
use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::storage::Owned;
use nalgebra::{DMatrix, DVector, Dyn};
use std::cell::RefCell;
use std::sync::Arc;
use std::sync::atomic::Ordering;

/// A set of parameters whose path was not computed counts as residuals this many times as large as the first ones.
const BAD: f64 = 1e3;
/// The search ends where a step would reduce the sum of squares by this share of it.
const SUM_TOLERANCE: f64 = 1e-9;
/// Or where a step is this small, over the coordinates.
const STEP_TOLERANCE: f64 = 1e-8;
/// Most residuals evaluated, over the number of coordinates and one.
const PATIENCE: usize = 40;
/// Where paths beside its end could not be computed, a search is at a minimum if a step by the derivatives would reduce the sum of squares by less than
/// this share. So it is where a step would do so by less than this: errors are far larger then.
const LEFT: f64 = 1e-3;
/// Added to the coordinates z, which lie between -π/2 and π/2, for the method: it takes its first step, and the steps that it ends at, over the
/// size of its coordinates, which may not vanish.
const SHIFT: f64 = 2.0;
/// First step over that size: of the logarithm of a parameter with the bounds that it has if none are given, 0.9.
const FIRST_STEP: f64 = 0.1;

/// What a search found.
pub(super) struct Found {
    /// The best set of parameters that was computed
    pub best: Arc<Trial>,
    /// Its sum of squares
    pub sum: f64,
    /// Why the search did not converge, if it did not
    pub trouble: Option<String>,
}

/// Begins at a trial and lets the coordinates `free` go.
pub(super) fn search(evaluator: &Evaluator, weights: &Weights, start: &Arc<Trial>, free: &[usize]) -> Found {
    let residuals = evaluator.residuals(start, weights);
    let sum = residuals.norm_squared();
    if free.is_empty() {
        return Found { best: start.clone(), sum, trouble: None };
    }
    let z =
        DVector::from_iterator(free.len(), free.iter().map(|&k| SHIFT + evaluator.coordinates[k].inner(start.x[k])));
    let bad = BAD * (1.0 + residuals.amax());
    let problem = Search {
        evaluator,
        weights,
        free,
        base: start.x.clone(),
        z,
        now: Some(start.clone()),
        known: vec![start.clone()],
        best: (start.clone(), sum),
        bad,
        data: residuals.len(),
        trouble: RefCell::new(None),
        refused: None,
    };
    let method = LevenbergMarquardt::new()
        .with_ftol(SUM_TOLERANCE)
        .with_xtol(STEP_TOLERANCE)
        .with_gtol(SUM_TOLERANCE)
        .with_stepbound(FIRST_STEP)
        .with_patience(PATIENCE);
    let (problem, report) = method.minimize(problem);
    use levenberg_marquardt::TerminationReason as Reason;
    let trouble = match report.termination {
        Reason::ResidualsZero | Reason::Orthogonal | Reason::Converged { .. } | Reason::NoImprovementPossible(_) => {
            problem.stalled()
        }
        Reason::LostPatience => Some(format!("it has not converged in {} evaluations", report.number_of_evaluations)),
        _ if evaluator.counted.interrupted.load(Ordering::Relaxed) => Some("it was interrupted".to_owned()),
        other => Some(match problem.trouble.borrow().as_ref() {
            Some(error) => error.to_string(),
            None => format!("{other:?}"),
        }),
    };
    Found { best: problem.best.0, sum: problem.best.1, trouble }
}

struct Search<'a> {
    evaluator: &'a Evaluator<'a>,
    weights: &'a Weights,
    free: &'a [usize],
    /// All coordinates; those that are free are replaced
    base: DVector<f64>,
    z: DVector<f64>,
    /// At `z`; none where the path was not computed
    now: Option<Arc<Trial>>,
    /// The last ones, to which the method may come back
    known: Vec<Arc<Trial>>,
    best: (Arc<Trial>, f64),
    bad: f64,
    data: usize,
    trouble: RefCell<Option<NoFit>>,
    /// Why the path of the last trial was not computed that had none, and at which values
    refused: Option<(Vec<f64>, NoFit)>,
}

impl Search<'_> {
    /// Why the end of the search is no minimum: it has shrunk its steps beside trials whose paths could not be computed.
    fn stalled(&self) -> Option<String> {
        let (values, why) = self.refused.as_ref()?;
        let (best, sum) = &self.best;
        let derivatives = self.evaluator.derivatives(best).ok()?;
        let is_inside = |k: &usize| self.evaluator.coordinates[*k].at_bound(best.x[*k]).is_none();
        let inside: Vec<usize> = self.free.iter().copied().filter(is_inside).collect();
        if inside.is_empty() {
            return None;
        }
        let jacobian = self.evaluator.jacobian(&derivatives, self.weights).select_columns(&inside);
        let residuals = self.evaluator.residuals(best, self.weights);
        let reduced = jacobian.svd(true, false).u.map_or(0.0, |u| u.tr_mul(&residuals).norm_squared());
        let list = self.evaluator.problem.parameters.iter().zip(values);
        let list: Vec<String> = list.map(|(parameter, value)| format!("{} = {value:.6}", parameter.key)).collect();
        (reduced > LEFT * sum.max(1.0)).then(|| {
            let (share, list) = (100.0 * reduced / sum, list.join(", "));
            let why = if let NoFit::NoStart(why) = why { why.clone() } else { why.to_string() };
            format!(
                "where it ends a step would still reduce the sum of squares by {share:.1} %, but the curve was not computed there: with {list}, {why}"
            )
        })
    }
}

/// Trials that are remembered.
const REMEMBERED: usize = 3;

impl LeastSquaresProblem<f64, Dyn, Dyn> for Search<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, z: &DVector<f64>) {
        self.z = z.clone();
        let mut x = self.base.clone();
        for (&k, &z) in self.free.iter().zip(z.iter()) {
            x[k] = self.evaluator.coordinates[k].outer(z - SHIFT);
        }
        if let Some(known) = self.known.iter().find(|known| (&known.x - &x).amax() < 1e-14) {
            self.now = Some(known.clone());
            return;
        }
        self.now = match self.evaluator.trial(&x) {
            Ok(trial) => Some(Arc::new(trial)),
            Err(why) => {
                self.refused = Some((self.evaluator.values(&x), why));
                None
            }
        };
        let Some(now) = &self.now else { return };
        if self.known.len() == REMEMBERED {
            self.known.remove(0);
        }
        self.known.push(now.clone());
        let sum = self.evaluator.residuals(now, self.weights).norm_squared();
        if sum < self.best.1 {
            self.best = (now.clone(), sum);
        }
    }

    fn params(&self) -> DVector<f64> {
        self.z.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        if self.evaluator.counted.interrupted.load(Ordering::Relaxed) {
            return None;
        }
        let bad = || DVector::from_element(self.data, self.bad);
        Some(self.now.as_ref().map_or_else(bad, |now| self.evaluator.residuals(now, self.weights)))
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        let found = match self.evaluator.derivatives(self.now.as_ref()?) {
            Ok(found) => found,
            Err(error) => {
                *self.trouble.borrow_mut() = Some(error);
                return None;
            }
        };
        let all = self.evaluator.jacobian(&found, self.weights);
        let mut free = all.select_columns(self.free.iter());
        for (column, (&k, &z)) in self.free.iter().zip(self.z.iter()).enumerate() {
            free.column_mut(column).scale_mut(self.evaluator.coordinates[k].inner_rate(z - SHIFT));
        }
        Some(free)
    }
}

// -- The least sum of squares with one parameter held: what a standard error says is right only where that is a parabola --

/// Step over the half interval of the standard error.
const STEP: f64 = 0.5;
/// Longest step over the way between the bounds: a parameter that is hardly determined has a standard error beyond all bounds.
const LONGEST: f64 = 0.02;
/// Most steps to a side.
const MOST: usize = 24;
/// A step grows by this where the sum has hardly risen.
const GROWTH: f64 = 1.5;

/// What a profile begins from.
pub(super) struct Least<'a> {
    pub evaluator: &'a Evaluator<'a>,
    pub weights: &'a Weights,
    pub best: &'a Arc<Trial>,
    pub sum: f64,
    /// Along which the others go with the one that is held
    pub covariance: &'a Covariance,
    /// What the loss adds to the variances
    pub factor: f64,
}

impl Least<'_> {
    /// Of the coordinate `index` with a standard error, of which half an interval has so many.
    pub(crate) fn profile(&self, index: usize, error: f64, half: f64) -> Profile {
        // the excess of the sum that ends the interval
        let level = self.factor * half * half;
        let side = |half: f64| self.side(index, half, level);
        let (low, high) = rayon::join(|| side(-half * error), || side(half * error));
        let coordinate = &self.evaluator.coordinates[index];
        let at_least = (self.best.x[index], 0.0);
        let all = low.0.iter().rev().chain([&at_least]).chain(&high.0);
        let value = |x: f64| coordinate.value(x);
        Profile {
            points: all.map(|&(x, excess)| (value(x), excess)).collect(),
            interval: [low.1.map(value), high.1.map(value)],
            level,
        }
    }

    /// (x, excess) to one side, and where the excess reaches the level.
    fn side(&self, index: usize, half: f64, level: f64) -> (Vec<(f64, f64)>, Option<f64>) {
        let (low, high) = self.evaluator.coordinates[index].bounds();
        let others: Vec<usize> = (0..self.evaluator.coordinates.len()).filter(|&other| other != index).collect();
        let mut points: Vec<(f64, f64)> = Vec::new();
        let longest = LONGEST * (high - low);
        let (mut before, mut step) = (self.best.clone(), (STEP * half).clamp(-longest, longest));
        for _ in 0..MOST {
            let from = before.x[index];
            let to = (from + step).clamp(low, high);
            if to == from {
                break;
            }
            let mut x = before.x.clone();
            for other in 0..x.len() {
                let (low, high) = self.evaluator.coordinates[other].bounds();
                x[other] = (x[other] + self.covariance.follows(other, index) * (to - from)).clamp(low, high);
            }
            x[index] = to;
            let Ok(start) = self.evaluator.trial(&x) else { break };
            let found = search(self.evaluator, self.weights, &Arc::new(start), &others);
            let last = points.last().copied().unwrap_or((self.best.x[index], 0.0));
            let excess = (found.sum - self.sum).max(0.0);
            points.push((to, excess));
            if excess >= level {
                return (points, Some(crossing(last, (to, excess), level)));
            }
            if excess - last.1 < 0.1 * level {
                step *= GROWTH;
            }
            before = found.best;
        }
        (points, None)
    }
}

/// Where the root of the excess, which is a straight line if the sum is a parabola, reaches that of the level.
fn crossing(from: (f64, f64), to: (f64, f64), level: f64) -> f64 {
    let root = |excess: f64| excess.max(0.0).sqrt();
    let share = (root(level) - root(from.1)) / (root(to.1) - root(from.1));
    from.0 + share * (to.0 - from.0)
}

#[cfg(test)]
mod profile_tests {
    #[test]
    fn a_parabola_is_crossed_where_it_is() {
        let x = crate::study::parameters::fit::search::crossing((1.0, 1.0), (3.0, 9.0), 4.0);
        assert!((x - 2.0).abs() < 1e-15);
    }
}
