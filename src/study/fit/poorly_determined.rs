//! Parameters that the measured curve does not tell apart.

use super::coordinate::Coordinate;
use super::result::{Combination, PairDetermined};
use super::statistics::Covariance;

/// Half an interval of a coordinate beyond which a parameter is poorly determined: 10 % of one above zero.
pub(super) const POOR: f64 = 0.1;
/// Two parameters make up for one another from this correlation on.
const TOGETHER: f64 = 0.9;

/// Combinations of the parameters that are searched for by their logarithms.
pub(super) fn combinations(covariance: &Covariance, coordinates: &[Coordinate]) -> Vec<Combination> {
    let among: Vec<usize> =
        covariance.of.iter().copied().filter(|&index| coordinates[index].is_logarithmic()).collect();
    let combination = |(relative_error, direction): (f64, nalgebra::DVector<f64>)| {
        let mut exponents = vec![0.0; coordinates.len()];
        let sign = direction[direction.iamax()].signum();
        among.iter().zip(direction.iter()).for_each(|(&index, &component)| exponents[index] = sign * component);
        Combination { exponents, relative_error }
    };
    covariance.principal(&among).into_iter().map(combination).collect()
}

/// Pairs of which one is `poor` and whose correlation is large, the largest first.
pub(super) fn pairs(covariance: &Covariance, coordinates: &[Coordinate], poor: &[bool]) -> Vec<PairDetermined> {
    let mut found = Vec::new();
    for (k, &one) in covariance.of.iter().enumerate() {
        for &other in &covariance.of[k + 1..] {
            let correlation = covariance.correlation(one, other).unwrap_or(0.0);
            if correlation.abs() < TOGETHER || !(poor[one] || poor[other]) {
                continue;
            }
            let both = coordinates[one].is_logarithmic() && coordinates[other].is_logarithmic();
            let best = if both { best_of_pair(covariance, one, other) } else { None };
            found.push(PairDetermined {
                parameters: [one, other],
                correlation,
                exponent: best.map(|best| best.0),
                relative_error: best.map(|best| best.1),
            });
        }
    }
    found.sort_by(|a, b| b.correlation.abs().total_cmp(&a.correlation.abs()));
    found
}

/// e with which ln p₁ + e ln p₂ has the least variance over 1 + e², and its standard error.
fn best_of_pair(covariance: &Covariance, one: usize, other: usize) -> Option<(f64, f64)> {
    let (error, direction) = covariance.principal(&[one, other]).pop()?;
    let (first, second) = (direction[0], direction[1]);
    (first.abs() > 1e-6).then(|| (second / first, error / first.abs()))
}

#[cfg(test)]
mod tests {
    use super::super::problem::{FitParameter, ParameterOf};
    use super::*;
    use crate::model::Range;
    use nalgebra::DMatrix;

    /// Data that hang on p₁ p₂⁻² alone but for a little.
    #[test]
    fn what_is_well_determined_of_two_is_their_product_of_powers() {
        let of = |key: &str| FitParameter {
            key: key.into(),
            initial: 1.0,
            range: Range::Positive,
            from: None,
            to: None,
            of: ParameterOf::Model,
        };
        let coordinates = [of("a"), of("b")].map(|parameter| Coordinate::new(&parameter, 1.0).unwrap());
        let jacobian = DMatrix::from_row_slice(3, 2, &[100.0, -200.0, 100.0, -200.0, 1.0, 0.5]);
        let covariance = Covariance::new(&jacobian, vec![0, 1], 1.0);
        let found = pairs(&covariance, &coordinates, &[true, true]);
        assert_eq!(found.len(), 1);
        assert!(found[0].correlation > 0.99);
        assert!((found[0].exponent.unwrap() + 2.0).abs() < 1e-3, "{found:?}");
        assert!(found[0].relative_error.unwrap() < 0.01);
        let all = combinations(&covariance, &coordinates);
        assert!(all[0].relative_error > 50.0 * all[1].relative_error);
        assert!(pairs(&covariance, &coordinates, &[false, false]).is_empty());
    }
}
