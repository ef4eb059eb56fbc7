//! Gauss's rule, for integrals that have no closed form here.

use gauss_quad::GaussLegendre;
use std::num::NonZeroUsize;

/// Gauss-Legendre points, ascending, and weights on [-1, 1], exact for polynomials of degree below twice their number.
pub fn gauss_legendre(points: NonZeroUsize) -> Vec<(f64, f64)> {
    GaussLegendre::new(points).into_node_weight_pairs().into_vec()
}

/// Gauss-Legendre points and weights on [0, 1].
#[derive(Clone, Debug, PartialEq)]
pub struct Rule {
    pairs: Vec<(f64, f64)>,
}

impl Rule {
    /// A rule of so many points, exact for polynomials of degree below twice that.
    pub fn new(points: NonZeroUsize) -> Self {
        let half = |&(x, w): &(f64, f64)| (0.5 + 0.5 * x, 0.5 * w);
        Self { pairs: gauss_legendre(points).iter().map(half).collect() }
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        self.pairs.len()
    }

    /// Points and weights of the integral from `from` to `to`.
    #[inline]
    pub(crate) fn over(&self, from: f64, to: f64) -> impl Iterator<Item = (f64, f64)> + '_ {
        let width = to - from;
        self.pairs.iter().map(move |&(x, w)| (from + width * x, width * w))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn points_ascend_and_weights_sum_to_two() {
        for points in 1..50 {
            let rule = gauss_legendre(NonZeroUsize::new(points).unwrap());
            assert!(rule.windows(2).all(|pair| pair[0].0 < pair[1].0));
            assert_relative_eq!(rule.iter().map(|pair| pair.1).sum::<f64>(), 2.0, max_relative = 1e-14);
        }
    }

    #[test]
    fn exact_up_to_its_degree() {
        let rule = Rule::new(NonZeroUsize::new(4).unwrap());
        let integral: f64 = rule.over(1.0, 3.0).map(|(x, w)| w * x.powi(7)).sum();
        assert_relative_eq!(integral, (3f64.powi(8) - 1.0) / 8.0, max_relative = 1e-14);
    }
}
