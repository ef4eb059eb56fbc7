//! Standard errors, intervals and correlations of the parameters that were found.

use super::problem::FitOptions;
use super::residuals::{Evaluator, Weights};
use nalgebra::{DMatrix, DVector};
use statrs::distribution::{ContinuousCDF, Normal, StudentsT};

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
        super::measured_curve::median(&mut amounts) / MEDIAN * (residuals.len() as f64 / free).sqrt()
    } else {
        (residuals.iter().map(|residual| residual * residual).sum::<f64>() / free).sqrt()
    };
    found.max(least)
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
