//! Standard errors, intervals and correlations of the parameters that were found.

use super::problem::FitOptions;
use super::residuals::{Evaluator, Trial, Weights};
use super::result::Profile;
use super::search::search;
use nalgebra::{DMatrix, DVector};
use statrs::distribution::{ContinuousCDF, Normal, StudentsT};
use std::sync::Arc;

/// Of the intervals.
const CONFIDENCE: f64 = 0.95;
/// A direction is taken to be determined by the data if its singular value is this share of the largest.
const RANK: f64 = 1e-9;

/// Covariance of coordinates.
#[derive(Clone, Debug)]
pub(super) struct Covariance {
    /// Which coordinates: those that are at no bound
    pub of: Vec<usize>,
    pub matrix: DMatrix<f64>,
    /// Largest over least singular value of the derivatives
    pub condition: f64,
}

impl Covariance {
    /// From the derivatives of the residuals, over their standard errors, by the coordinates `of`: (JᵀJ)⁻¹ times what the loss adds.
    pub fn new(jacobian: &DMatrix<f64>, of: Vec<usize>, factor: f64) -> Self {
        if of.is_empty() {
            return Self { of, matrix: DMatrix::zeros(0, 0), condition: f64::INFINITY };
        }
        let own = jacobian.select_columns(of.iter());
        let svd = own.svd(false, true);
        let largest = svd.singular_values.max();
        let condition = largest / svd.singular_values.min();
        let count = of.len();
        let matrix = match svd.v_t {
            Some(directions) => {
                let variances = svd.singular_values.map(|value| factor / value.max(RANK * largest).powi(2));
                directions.transpose() * DMatrix::from_diagonal(&variances) * directions
            }
            None => DMatrix::zeros(count, count),
        };
        Self { of, matrix, condition }
    }

    /// Standard error of a coordinate; none at a bound.
    pub fn standard_error(&self, index: usize) -> Option<f64> {
        let place = self.of.iter().position(|&own| own == index)?;
        Some(self.matrix[(place, place)].max(0.0).sqrt())
    }

    /// How far one coordinate goes with another that is moved by 1, where the sum of squares is least: their covariance over the variance of the
    /// other; 0 at a bound.
    pub fn follows(&self, one: usize, other: usize) -> f64 {
        let place = |index: usize| self.of.iter().position(|&own| own == index);
        let (Some(a), Some(b)) = (place(one), place(other)) else { return 0.0 };
        self.matrix[(a, b)] / self.matrix[(b, b)]
    }

    /// Correlation of two coordinates; none at a bound.
    pub fn correlation(&self, one: usize, other: usize) -> Option<f64> {
        let place = |index: usize| self.of.iter().position(|&own| own == index);
        let (a, b) = (place(one)?, place(other)?);
        Some((self.matrix[(a, b)] / (self.matrix[(a, a)] * self.matrix[(b, b)]).sqrt()).clamp(-1.0, 1.0))
    }

    /// Directions in some of its coordinates along which errors are independent, with their standard errors: the largest first.
    pub fn principal(&self, among: &[usize]) -> Vec<(f64, DVector<f64>)> {
        let place = |index: &usize| self.of.iter().position(|own| own == index);
        let places: Vec<usize> = among.iter().filter_map(place).collect();
        if places.len() != among.len() || places.is_empty() {
            return Vec::new();
        }
        let block = DMatrix::from_fn(places.len(), places.len(), |a, b| self.matrix[(places[a], places[b])]);
        let eigen = block.symmetric_eigen();
        let mut all: Vec<(f64, DVector<f64>)> = (0..places.len())
            .map(|k| (eigen.eigenvalues[k].max(0.0).sqrt(), eigen.eigenvectors.column(k).into_owned()))
            .collect();
        all.sort_by(|a, b| b.0.total_cmp(&a.0));
        all
    }
}

/// How many standard errors half an interval has: of the normal distribution where the errors of the forces are known, of Student's where
/// they were estimated with so many degrees of freedom.
pub(super) fn half_interval(estimated: bool, freedom: usize) -> f64 {
    let share = 0.5 + 0.5 * CONFIDENCE;
    match StudentsT::new(0.0, 1.0, freedom.max(1) as f64) {
        Ok(student) if estimated => student.inverse_cdf(share),
        _ => Normal::standard().inverse_cdf(share),
    }
}

/// Whether the standard errors of the forces are estimated from the residuals.
pub(super) fn is_estimated(options: &FitOptions, evaluator: &Evaluator) -> bool {
    options.force_error.is_none() && evaluator.measured.points.iter().any(|point| point.force_error.is_none())
}

/// The standard error of a force that residuals (nN) of so many parameters show: their root mean square, or, where a loss is to keep outliers out,
/// their median.
pub(super) fn scale(residuals: &[f64], weights: &Weights, parameters: usize, robust: bool, least: f64) -> f64 {
    // of normal errors the median of the amounts is 0.6745 standard deviations
    const MEDIAN: f64 = 0.6745;
    debug_assert_eq!(residuals.len(), weights.errors.len());
    let free = residuals.len().saturating_sub(parameters).max(1) as f64;
    let found = if robust {
        let mut amounts: Vec<f64> = residuals.iter().map(|residual| residual.abs()).collect();
        crate::study::parameters::fit::measured_curve::median(&mut amounts) / MEDIAN
            * (residuals.len() as f64 / free).sqrt()
    } else {
        (residuals.iter().map(|residual| residual * residual).sum::<f64>() / free).sqrt()
    };
    found.max(least)
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
    /// Excess of the sum that ends the interval: the square of the half interval in standard errors
    pub level: f64,
}

impl Least<'_> {
    /// Of the coordinate `index` whose half interval by its standard error is `half`.
    pub fn profile(&self, index: usize, half: f64) -> Profile {
        let (low, high) = rayon::join(|| self.side(index, -half), || self.side(index, half));
        let coordinate = &self.evaluator.coordinates[index];
        let at_least = (self.best.x[index], 0.0);
        let all = low.0.iter().rev().chain([&at_least]).chain(&high.0);
        let value = |x: f64| coordinate.value(x);
        Profile {
            points: all.map(|&(x, excess)| (value(x), excess)).collect(),
            interval: [low.1.map(value), high.1.map(value)],
            level: self.level,
        }
    }

    /// (x, excess) to one side, and where the excess reaches the level.
    fn side(&self, index: usize, half: f64) -> (Vec<(f64, f64)>, Option<f64>) {
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
            if excess >= self.level {
                return (points, Some(crossing(last, (to, excess), self.level)));
            }
            if excess - last.1 < 0.1 * self.level {
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
        let x = crate::study::parameters::fit::statistics::crossing((1.0, 1.0), (3.0, 9.0), 4.0);
        assert!((x - 2.0).abs() < 1e-15);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A line a + b t by its normal equations: variances s²/n and s²/Σ(t - mean)², independent where the mean of t is 0.
    #[test]
    fn covariances_are_those_of_a_line() {
        let times = [-2.0, -1.0, 0.0, 1.0, 2.0];
        let jacobian = DMatrix::from_fn(5, 2, |row, column| if column == 0 { 10.0 } else { 10.0 * times[row] });
        let covariance = Covariance::new(&jacobian, vec![0, 1], 1.0);
        assert!((covariance.standard_error(0).unwrap() - 0.1 / 5f64.sqrt()).abs() < 1e-12);
        assert!((covariance.standard_error(1).unwrap() - 0.1 / 10f64.sqrt()).abs() < 1e-12);
        assert!(covariance.correlation(0, 1).unwrap().abs() < 1e-12);
        assert!((covariance.condition - 2f64.sqrt()).abs() < 1e-12);
        assert!(Covariance::new(&jacobian, vec![1], 1.0).standard_error(0).is_none());
        let none = Covariance::new(&jacobian, Vec::new(), 1.0);
        assert!(none.standard_error(0).is_none() && none.correlation(0, 1).is_none() && !none.condition.is_finite());
    }

    #[test]
    fn half_intervals_are_those_of_tables() {
        assert!((half_interval(false, 5) - 1.959964).abs() < 1e-5);
        assert!((half_interval(true, 5) - 2.570582).abs() < 1e-5);
    }
}
