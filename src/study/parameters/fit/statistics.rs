//! Standard errors, intervals and correlations of the parameters that were found.

use super::curves::measured_curve::{median, noise, second_difference};
use super::problem::{DisplacementError, FitOptions};
use super::residuals::{Errors, Evaluator, Trial, Weights};
use nalgebra::{DMatrix, DVector};
use statrs::distribution::{ContinuousCDF, Normal, StudentsT};

/// Of the intervals.
const CONFIDENCE: f64 = 0.95;
/// To which the half of one is computed, in standard errors.
const HALF_TO: f64 = 1e-9;
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
    pub(crate) fn new(jacobian: &DMatrix<f64>, of: Vec<usize>, factor: f64) -> Self {
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
    pub(crate) fn standard_error(&self, index: usize) -> Option<f64> {
        let place = self.of.iter().position(|&own| own == index)?;
        Some(self.matrix[(place, place)].max(0.0).sqrt())
    }

    /// How far one coordinate goes with another that is moved by 1, where the sum of squares is least: their covariance over the variance of the
    /// other; 0 at a bound.
    pub(crate) fn follows(&self, one: usize, other: usize) -> f64 {
        let place = |index: usize| self.of.iter().position(|&own| own == index);
        let (Some(a), Some(b)) = (place(one), place(other)) else { return 0.0 };
        self.matrix[(a, b)] / self.matrix[(b, b)]
    }

    /// Correlation of two coordinates; none at a bound.
    pub(crate) fn correlation(&self, one: usize, other: usize) -> Option<f64> {
        let place = |index: usize| self.of.iter().position(|&own| own == index);
        let (a, b) = (place(one)?, place(other)?);
        Some((self.matrix[(a, b)] / (self.matrix[(a, a)] * self.matrix[(b, b)]).sqrt()).clamp(-1.0, 1.0))
    }

    /// Directions in some of its coordinates along which errors are independent, with their standard errors: the largest first.
    pub(crate) fn principal(&self, among: &[usize]) -> Vec<(f64, DVector<f64>)> {
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

/// How many standard errors half an interval has: of the normal distribution where errors are known, of Student's where they were estimated with
/// so many degrees of freedom.
pub(super) fn half_interval(freedom: Option<f64>) -> f64 {
    let share = 0.5 + 0.5 * CONFIDENCE;
    let normal = Normal::standard().inverse_cdf(share);
    let Some(Ok(student)) = freedom.map(|freedom| StudentsT::new(0.0, 1.0, freedom.max(1.0))) else { return normal };
    // the inverse of statrs 0.19 does not end for some degrees of freedom that are no whole number; with one there are 12.7
    let (mut low, mut high) = (normal, 13.0);
    while high - low > HALF_TO {
        let middle = 0.5 * (low + high);
        if student.cdf(middle) < share { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Whether the standard errors of the forces are estimated from the residuals.
pub(super) fn is_estimated(options: &FitOptions, evaluator: &Evaluator) -> bool {
    options.force_error.is_none() && evaluator.points().any(|point| point.force_error.is_none())
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
        median(&mut amounts) / MEDIAN * (residuals.len() as f64 / free).sqrt()
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

/// Residuals rᵢ of a fit with derivatives J, and what their variances vᵢ = kᵢ + aᵢ s² + bᵢ sᵤ² are made of.
///
/// A residual has the variance (1 - hᵢ) vᵢ with its leverage h, the diagonal of J C Jᵀ V⁻¹, C = (Jᵀ V⁻¹ J)⁻¹. s² and sᵤ² are those of the largest
/// likelihood of normal errors, by Fisher's scoring: rᵢ²/(1 - hᵢ) - kᵢ is fitted by aᵢ and bᵢ, weighted by v⁻², until v has settled (Searle, Casella and
/// McCulloch, Variance Components, 1992, section 6.6).
pub(super) struct Variances {
    /// J, one row a datum, without weights
    jacobian: DMatrix<f64>,
    /// rᵢ²/(1 - hᵢ), nN²
    squares: Vec<f64>,
    /// kᵢ, nN²
    known: Vec<f64>,
    /// aᵢ, and bᵢ: 1 and P'² where s and sᵤ are not known, else 0
    of: [Vec<f64>; 2],
    /// No variance is smaller, nN²
    least: f64,
}

impl Variances {
    /// Of a trial, whose derivatives `jacobian` are over the standard errors of `weights`.
    pub(crate) fn of_trial(
        evaluator: &Evaluator,
        trial: &Trial,
        jacobian: &DMatrix<f64>,
        weights: &Weights,
        least: f64,
    ) -> Self {
        let leverages = leverages(jacobian);
        let mut jacobian = jacobian.clone();
        weights.errors.iter().enumerate().for_each(|(row, &error)| jacobian.row_mut(row).scale_mut(error));
        let mut all = Self::new(jacobian, least);
        let given = match evaluator.options.displacement_error {
            DisplacementError::Estimated => None,
            DisplacementError::None => Some(0.0),
            DisplacementError::Known(error) => Some(error * error),
        };
        for ((own, modelled), leverage) in evaluator.points().zip(trial.modelled()).zip(leverages) {
            let force = own.force_error.or(evaluator.options.force_error);
            let square = (modelled.force - own.force).powi(2) / (1.0 - leverage).max(LEAST_FREE);
            all.push(square, modelled.slope.powi(2), force, given);
        }
        // the jumps and the forces behind them: their derivatives are over their errors
        for _ in all.squares.len()..all.jacobian.nrows() {
            all.push(0.0, 0.0, Some(1.0), Some(0.0));
        }
        all
    }

    /// By how neighbouring points differ: what lies between two others is off the line through these by the more, the steeper they rise.
    fn of_neighbours(evaluator: &Evaluator, least: f64) -> Self {
        let neighbours = || evaluator.measured().flat_map(|measured| measured.points.windows(3));
        let mut all = Self::new(DMatrix::zeros(neighbours().count(), 0), least);
        for three in neighbours() {
            let (off, slope) = second_difference(three);
            let force = three[1].force_error.or(evaluator.options.force_error);
            all.push(off * off, slope * slope, force, None);
        }
        all
    }

    fn new(jacobian: DMatrix<f64>, least: f64) -> Self {
        Self { jacobian, squares: Vec::new(), known: Vec::new(), of: [Vec::new(), Vec::new()], least: least * least }
    }

    /// A squared residual (nN²), a squared slope ((nN/nm)²), and what is known: a standard error of its force, a variance of its displacement.
    fn push(&mut self, square: f64, slope: f64, force: Option<f64>, displacement: Option<f64>) {
        self.squares.push(square);
        self.known.push(force.map_or(0.0, |error| error * error) + displacement.map_or(0.0, |known| known * slope));
        self.of[0].push(f64::from(u8::from(force.is_none())));
        self.of[1].push(if displacement.is_none() { slope } else { 0.0 });
    }

    fn is_unknown(&self, k: usize) -> bool {
        self.of[k].iter().any(|&share| share > 0.0)
    }

    /// vᵢ
    fn at(&self, found: [f64; 2]) -> Vec<f64> {
        let of = |row: usize| self.known[row] + self.of[0][row] * found[0] + self.of[1][row] * found[1];
        (0..self.squares.len()).map(|row| of(row).max(self.least)).collect()
    }

    /// J over the square roots of vᵢ.
    fn weighted(&self, variances: &[f64]) -> DMatrix<f64> {
        let mut weighted = self.jacobian.clone();
        variances.iter().enumerate().for_each(|(row, v)| weighted.row_mut(row).scale_mut(v.sqrt().recip()));
        weighted
    }

    /// tr(P Aₘ P Aₙ) of two diagonals with P = V⁻¹ - V⁻¹ J C Jᵀ V⁻¹, by the rows of J over the square roots of v, and C.
    fn information(&self, variances: &[f64], weighted: &DMatrix<f64>, covariance: &DMatrix<f64>) -> [[f64; 2]; 2] {
        let sides = weighted * covariance;
        // Σᵢ aᵢ/vᵢ jᵢ jᵢᵀ C
        let through = [0, 1].map(|k: usize| {
            let mut scaled = weighted.clone();
            (0..scaled.nrows()).for_each(|row| scaled.row_mut(row).scale_mut(self.of[k][row] / variances[row]));
            scaled.transpose() * &sides
        });
        let leverage = |row: usize| weighted.row(row).dot(&sides.row(row));
        let left: Vec<f64> =
            (0..variances.len()).map(|row| (1.0 - 2.0 * leverage(row)) / variances[row].powi(2)).collect();
        let pair = |m: usize, n: usize| {
            let own: f64 = (0..left.len()).map(|row| left[row] * self.of[m][row] * self.of[n][row]).sum();
            own + (&through[m] * &through[n]).trace()
        };
        [0, 1].map(|m| [0, 1].map(|n| pair(m, n)))
    }

    /// s² (nN²) and sᵤ² (nm²); 0 of what is known.
    fn found(&self) -> [f64; 2] {
        let unknown = [0, 1].map(|k| self.is_unknown(k));
        let mean = self.squares.iter().sum::<f64>() / self.squares.len().max(1) as f64;
        let mut found = [if unknown[0] { mean.max(self.least) } else { 0.0 }, 0.0];
        for _ in 0..ROUNDS {
            let variances = self.at(found);
            let weighted = |m: usize, times: &dyn Fn(usize) -> f64| -> f64 {
                (0..variances.len()).map(|row| self.of[m][row] * times(row) / variances[row].powi(2)).sum()
            };
            let matrix = [0, 1].map(|m| [0, 1].map(|n| weighted(m, &|row| self.of[n][row])));
            let right = [0, 1].map(|m| weighted(m, &|row| self.squares[row] - self.known[row]));
            let alone = |k: usize| if matrix[k][k] > 0.0 { (right[k] / matrix[k][k]).max(0.0) } else { 0.0 };
            let determinant = matrix[0][0] * matrix[1][1] - matrix[0][1] * matrix[1][0];
            let both = [
                (right[0] * matrix[1][1] - right[1] * matrix[0][1]) / determinant,
                (right[1] * matrix[0][0] - right[0] * matrix[1][0]) / determinant,
            ];
            let next = match unknown {
                [false, _] => [0.0, alone(1)],
                [true, false] => [alone(0).max(self.least), 0.0],
                _ if determinant <= RANK * matrix[0][0] * matrix[1][1] || both[1] <= 0.0 => {
                    [alone(0).max(self.least), 0.0]
                }
                _ if both[0] <= self.least => [self.least, alone(1)],
                _ => both,
            };
            let settled = (0..2).all(|k| (next[k] - found[k]).abs() <= SAME * next[k]);
            found = next;
            if settled {
                break;
            }
        }
        found
    }

    /// Standard errors of a force and of a displacement that these residuals show, or that were known before.
    pub(crate) fn errors(&self, before: Errors) -> Errors {
        let found = self.found();
        let error = |k: usize, before: f64| if self.is_unknown(k) { found[k].sqrt() } else { before };
        Errors { force: error(0, before.force), displacement: error(1, before.displacement) }
    }

    /// With how many degrees of freedom the errors give the variance Cₖₖ of each coordinate of a covariance: νₖ = 2 Cₖₖ²/(gᵀ W g), with
    /// gₘ = ∂Cₖₖ/∂θₘ and the covariance W = 2 [tr(P Aₘ P Aₙ)]⁻¹ of s² and sᵤ² (Satterthwaite 1946; Giesbrecht and Burns 1985). Infinite where no error
    /// is estimated; n - p where that of all forces is, and nothing else.
    pub(crate) fn freedoms(&self, errors: Errors, covariance: &Covariance) -> Vec<f64> {
        let variances = self.at([errors.force.powi(2), errors.displacement.powi(2)]);
        let weighted = self.weighted(&variances).select_columns(covariance.of.iter());
        let matrix = &covariance.matrix;
        let information = self.information(&variances, &weighted, matrix);
        let unknown: Vec<usize> = (0..2).filter(|&k| self.is_unknown(k)).collect();
        let of = |m: usize, n: usize| information[unknown[m]][unknown[n]];
        // over the roots of the diagonal: the units differ
        let root = |m: usize| of(m, m).sqrt();
        let scaled = DMatrix::from_fn(unknown.len(), unknown.len(), |m, n| of(m, n) / (root(m) * root(n)));
        let spread = scaled.pseudo_inverse(RANK).unwrap_or_else(|_| DMatrix::zeros(unknown.len(), unknown.len()));
        let sides = &weighted * matrix;
        let freedom = |k: usize| {
            let slope = |m: usize| {
                let diagonal = &self.of[unknown[m]];
                (0..variances.len()).map(|row| sides[(row, k)].powi(2) * diagonal[row] / variances[row]).sum::<f64>()
            };
            let slopes = DVector::from_fn(unknown.len(), |m, _| slope(m) / root(m));
            matrix[(k, k)].powi(2) / (slopes.transpose() * &spread * &slopes)[(0, 0)]
        };
        (0..covariance.of.len()).map(freedom).collect()
    }
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

/// Where a search begins that takes the errors for those which neighbours show: one that begins without an error of the displacements may end where
/// steep points alone are met.
pub(super) fn neighbouring_errors(evaluator: &Evaluator, least: f64) -> Errors {
    let force = noise(evaluator.measured()).max(least);
    let [_, displacement] = Variances::of_neighbours(evaluator, least).found();
    Errors { force, displacement: displacement.sqrt() }
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
        let of = |displacement: f64, known: Option<f64>, given: Option<f64>| {
            let mut all = Variances::new(DMatrix::zeros(4000, 0), 1e-6);
            for k in 0..4000 {
                let slope = 5.0 * (k as f64 / 4000.0).powi(3);
                all.push((0.09 + (slope * displacement).powi(2)) * normal(k).powi(2), slope * slope, known, given);
            }
            all.found().map(f64::sqrt)
        };
        let [force, displacement] = of(0.2, None, None);
        assert!((force / 0.3 - 1.0).abs() < 0.05 && (displacement / 0.2 - 1.0).abs() < 0.05, "{force} {displacement}");
        let [force, displacement] = of(0.0, None, None);
        assert!((force / 0.3 - 1.0).abs() < 0.03 && displacement < 0.02, "{force} {displacement}");
        let [_, displacement] = of(0.2, Some(0.3), None);
        assert!((displacement / 0.2 - 1.0).abs() < 0.05, "{displacement}");
        let [force, displacement] = of(0.2, None, Some(0.04));
        assert!((force / 0.3 - 1.0).abs() < 0.05 && displacement == 0.0, "{force} {displacement}");
    }

    /// A line through twelve points with one error has n - p degrees of freedom. Of two errors in two groups of points the mean of each group has its
    /// own n - 1.
    #[test]
    fn freedoms_are_those_of_a_line_and_of_two_means() {
        let line = DMatrix::from_fn(12, 2, |row, column| if column == 0 { 1.0 } else { row as f64 - 5.5 });
        let mut all = Variances::new(line, 1e-9);
        (0..12).for_each(|row| all.push(1.0 + row as f64, 0.3, None, Some(0.0)));
        let errors = all.errors(Errors::default());
        assert!((errors.force.powi(2) - 78.0 / 12.0).abs() < 1e-9, "{errors:?}");
        let of = |all: &Variances, errors: Errors| {
            let weighted = all.weighted(&all.at([errors.force.powi(2), errors.displacement.powi(2)]));
            all.freedoms(errors, &Covariance::new(&weighted, (0..weighted.ncols()).collect(), 1.0))
        };
        assert!(of(&all, errors).iter().all(|freedom| (freedom - 10.0).abs() < 1e-9), "{:?}", of(&all, errors));
        let means = DMatrix::from_fn(12, 2, |row, column| f64::from(u8::from((row < 4) == (column == 0))));
        let mut all = Variances::new(means, 1e-9);
        // the errors of the first four are those of their forces, those of the others of their displacements
        (0..4).for_each(|row| all.push(1.0 + row as f64, 0.0, None, None));
        (0..8).for_each(|row| all.push(2.0 + row as f64, 0.25, Some(0.0), None));
        let errors = all.errors(Errors::default());
        assert!((errors.force.powi(2) - 10.0 / 4.0).abs() < 1e-6, "{errors:?}");
        assert!((errors.displacement.powi(2) - 44.0 / 8.0 / 0.25).abs() < 1e-4, "{errors:?}");
        let freedoms = of(&all, errors);
        assert!((freedoms[0] - 3.0).abs() < 1e-6 && (freedoms[1] - 7.0).abs() < 1e-6, "{freedoms:?}");
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
        assert!((half_interval(None) - 1.959964).abs() < 1e-5);
        assert!((half_interval(Some(5.0)) - 2.570582).abs() < 1e-5);
    }
}
