//! Standard errors, intervals and correlations of the parameters that were found.

use super::measured_curve::{MeasuredPoint, second_difference};
use super::problem::{DisplacementError, FitOptions};
use super::residuals::{Errors, Evaluator, Trial, Weights};
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

/// Most rounds of the estimate of both standard errors.
const ROUNDS: usize = 50;
/// It has settled where no variance changes by more than this share.
const SAME: f64 = 1e-6;
/// A residual whose point determines the parameters by itself is no smaller than so much of its variance says.
const LEAST_FREE: f64 = 0.05;

/// The standard errors of a force and of a displacement that the residuals of a trial show.
///
/// Point i has the variance vᵢ = s² + (P'ᵢ sᵤ)², its residual (1 - hᵢ) vᵢ with its leverage h. Both are those of the largest likelihood of normal
/// errors, by Fisher's scoring: squares of the residuals over 1 - h are fitted by 1 and P'², weighted by v⁻², until v has settled (Searle, Casella and
/// McCulloch, Variance Components, 1992, section 6.6). `jacobian` is that of the weighted residuals; `before` is where the rounds begin. Where the
/// standard error of a force is known, that of a displacement alone is estimated.
pub(super) fn error_components(
    evaluator: &Evaluator,
    trial: &Trial,
    jacobian: &DMatrix<f64>,
    before: Errors,
    least: f64,
) -> Errors {
    let leverages = leverages(jacobian);
    let measured = &evaluator.measured.points;
    let square = |row: usize| {
        let residual = trial.modelled[row].force - measured[row].force;
        residual * residual / (1.0 - leverages[row]).max(LEAST_FREE)
    };
    let known = |row: usize| measured[row].force_error.or(evaluator.options.force_error);
    let rows: Vec<Row> = (0..measured.len())
        .map(|row| Row {
            square: square(row),
            slope: trial.modelled[row].slope.powi(2),
            known: known(row).map(|error| error * error),
        })
        .collect();
    let given = match evaluator.options.displacement_error {
        DisplacementError::Estimated => None,
        DisplacementError::None => Some(0.0),
        DisplacementError::Known(error) => Some(error * error),
    };
    let [force, displacement] = variances(&rows, given, least * least);
    let force = if rows.iter().all(|row| row.known.is_some()) { before.force } else { force.sqrt() };
    Errors { force, displacement: displacement.sqrt() }
}

/// The standard errors of a force and of a displacement by how neighbouring points differ: what lies between two others is off the line through these
/// by the more, the steeper they rise. A search that begins without an error of the displacements may end where steep points alone are met.
pub(super) fn neighbouring_errors(evaluator: &Evaluator, least: f64) -> Errors {
    let measured = &evaluator.measured;
    let known = evaluator.options.force_error;
    let row = |three: &[MeasuredPoint]| {
        let (off, slope) = second_difference(three);
        let known = three[1].force_error.or(known).map(|error| error * error);
        Row { square: off * off, slope: slope * slope, known }
    };
    let rows: Vec<Row> = measured.points.windows(3).map(row).collect();
    let [_, displacement] = variances(&rows, None, least * least);
    Errors { force: measured.noise().max(least), displacement: displacement.sqrt() }
}

/// A squared residual over what is left of its variance, nN².
struct Row {
    square: f64,
    /// P'², (nN/nm)²
    slope: f64,
    /// Variance of its force where that is known, nN²
    known: Option<f64>,
}

/// s² (nN²), no less than `least`, and sᵤ² (nm²), where it is not `given`.
fn variances(rows: &[Row], given: Option<f64>, least: f64) -> [f64; 2] {
    let count = rows.len().max(1) as f64;
    let unknown = |row: &Row| f64::from(u8::from(row.known.is_none()));
    let mut found = [(rows.iter().map(|row| row.square).sum::<f64>() / count).max(least), given.unwrap_or(0.0)];
    for _ in 0..ROUNDS {
        let (mut matrix, mut right) = ([[0.0; 2]; 2], [0.0; 2]);
        for row in rows {
            let base = row.known.unwrap_or(found[0]).max(least);
            let weight = (base + row.slope * found[1]).powi(-2);
            let by = [unknown(row), row.slope];
            let square = row.square - row.known.unwrap_or(0.0) - row.slope * given.unwrap_or(0.0);
            for i in 0..2 {
                right[i] += weight * by[i] * square;
                (0..2).for_each(|j| matrix[i][j] += weight * by[i] * by[j]);
            }
        }
        let alone = |k: usize| if matrix[k][k] > 0.0 { (right[k] / matrix[k][k]).max(0.0) } else { 0.0 };
        let determinant = matrix[0][0] * matrix[1][1] - matrix[0][1] * matrix[1][0];
        let both = [
            (right[0] * matrix[1][1] - right[1] * matrix[0][1]) / determinant,
            (right[1] * matrix[0][0] - right[0] * matrix[1][0]) / determinant,
        ];
        let next = if let Some(given) = given {
            [alone(0).max(least), given]
        } else if rows.iter().all(|row| row.known.is_some()) {
            [found[0], alone(1)]
        } else if determinant <= RANK * matrix[0][0] * matrix[1][1] || both[1] <= 0.0 {
            [alone(0).max(least), 0.0]
        } else if both[0] <= least {
            [least, alone(1)]
        } else {
            both
        };
        let settled = (0..2).all(|k| (next[k] - found[k]).abs() <= SAME * next[k]);
        found = next;
        if settled {
            break;
        }
    }
    found
}

/// hᵢ, the diagonal of J (JᵀJ)⁻¹ Jᵀ.
fn leverages(jacobian: &DMatrix<f64>) -> Vec<f64> {
    let svd = jacobian.clone().svd(true, false);
    let largest = svd.singular_values.max();
    let Some(left) = svd.u else { return vec![0.0; jacobian.nrows()] };
    let determined = |k: &usize| svd.singular_values[*k] > RANK * largest;
    let of = |row: usize| (0..left.ncols()).filter(determined).map(|k| left[(row, k)].powi(2)).sum();
    (0..jacobian.nrows()).map(of).collect()
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

    /// 4000 residuals of normal errors, by their quantiles in a shuffled order: of s = 0.3 and s_u = 0.2 over slopes up to 5; of s alone; of s_u
    /// beside an s that is known.
    #[test]
    fn errors_of_forces_and_displacements_are_told_apart_by_the_slope() {
        let normal = |k: usize| Normal::standard().inverse_cdf(((k * 1597) % 4000) as f64 / 4000.0 + 1.25e-4);
        let row = |k: usize, displacement: f64, known: Option<f64>| {
            let slope = 5.0 * (k as f64 / 4000.0).powi(3);
            Row { square: (0.09 + (slope * displacement).powi(2)) * normal(k).powi(2), slope: slope * slope, known }
        };
        let of = |displacement: f64, known: Option<f64>, given: Option<f64>| {
            let rows: Vec<Row> = (0..4000).map(|k| row(k, displacement, known)).collect();
            variances(&rows, given, 1e-12).map(f64::sqrt)
        };
        let [force, displacement] = of(0.2, None, None);
        assert!((force / 0.3 - 1.0).abs() < 0.05 && (displacement / 0.2 - 1.0).abs() < 0.05, "{force} {displacement}");
        let [force, displacement] = of(0.0, None, None);
        assert!((force / 0.3 - 1.0).abs() < 0.03 && displacement < 0.02, "{force} {displacement}");
        let [_, displacement] = of(0.2, Some(0.09), None);
        assert!((displacement / 0.2 - 1.0).abs() < 0.05, "{displacement}");
        let [force, displacement] = of(0.2, None, Some(0.04));
        assert!((force / 0.3 - 1.0).abs() < 0.05 && displacement == 0.2, "{force} {displacement}");
    }

    /// Of a line the leverage of its ends is 1/n + t²/Σt².
    #[test]
    fn leverages_are_those_of_a_line() {
        let jacobian = DMatrix::from_fn(5, 2, |row, column| if column == 0 { 1.0 } else { row as f64 - 2.0 });
        let found = leverages(&jacobian);
        assert!((found[0] - 0.6).abs() < 1e-12 && (found[2] - 0.2).abs() < 1e-12, "{found:?}");
    }

    #[test]
    fn half_intervals_are_those_of_tables() {
        assert!((half_interval(false, 5) - 1.959964).abs() < 1e-5);
        assert!((half_interval(true, 5) - 2.570582).abs() < 1e-5);
    }
}
