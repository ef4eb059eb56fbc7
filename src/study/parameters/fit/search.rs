//! The least squares of some coordinates, the others held, by Levenberg and Marquardt's method.

use super::residuals::{Derivatives, Evaluator, Trial, Weights};
use super::result::NoFit;
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
            None
        }
        Reason::LostPatience => Some(format!("it has not converged in {} evaluations", report.number_of_evaluations)),
        _ if evaluator.interrupted.load(Ordering::Relaxed) => Some("it was interrupted".to_owned()),
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
        self.now = self.evaluator.trial(&x).ok().map(Arc::new);
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
        if self.evaluator.interrupted.load(Ordering::Relaxed) {
            return None;
        }
        let bad = || DVector::from_element(self.data, self.bad);
        Some(self.now.as_ref().map_or_else(bad, |now| self.evaluator.residuals(now, self.weights)))
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        let found: Derivatives = match self.evaluator.derivatives(self.now.as_ref()?) {
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
