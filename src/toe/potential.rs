//! A potential of the place of a root, as a polynomial of degree four: E(u) = Σ a_ij (u/s)ⁱ (v/s)ʲ, i + j ≤ 4.
//!
//! The sum over setae at one place is one such polynomial, whatever their heights: that of a seta that stands h higher is E(u, v - h), again of
//! degree four. So the force on a thousand setae costs as much as that on one, and the loss of a seta is a subtraction.

use crate::study::coarsening::seta_law::law::RootResponse;

/// Highest degree.
const DEGREE: usize = 4;
/// Terms up to it.
const TERMS: usize = (DEGREE + 1) * (DEGREE + 2) / 2;

/// a_ij with their scale of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Potential {
    /// s, nm
    scale: f64,
    /// a_ij, aJ, by rising i + j, and by falling i where that is the same
    terms: [f64; TERMS],
}

/// The place of a_ij.
const fn at(i: usize, j: usize) -> usize {
    (i + j) * (i + j + 1) / 2 + j
}

impl Potential {
    /// Zero everywhere; s is 1 nm.
    pub(crate) const ZERO: Self = Self { scale: 1.0, terms: [0.0; TERMS] };

    /// ½ u·K u, with K in nN/nm.
    pub(crate) fn quadratic(stiffness: [[f64; 2]; 2]) -> Self {
        let mut out = Self::ZERO;
        out.terms[at(2, 0)] = 0.5 * stiffness[0][0];
        out.terms[at(1, 1)] = 0.5 * (stiffness[0][1] + stiffness[1][0]);
        out.terms[at(0, 2)] = 0.5 * stiffness[1][1];
        out
    }

    /// c0 + c1 v + c2 v², of the height v of the root alone, in aJ, nN and nN/nm.
    pub(crate) fn of_height(coefficients: [f64; 3]) -> Self {
        let mut out = Self::ZERO;
        (0..3).for_each(|j| out.terms[at(0, j)] = coefficients[j]);
        out
    }

    /// Of a list of a_ij in their order, as a fitted law keeps it. What is missing is zero.
    pub fn of(scale: f64, coefficients: &[f64]) -> Self {
        let mut terms = [0.0; TERMS];
        terms.iter_mut().zip(coefficients).for_each(|(term, own)| *term = *own);
        Self { scale, terms }
    }

    /// Of a root that stands `height` (nm) above the others: E(u, v - height).
    pub(crate) fn raised(&self, height: f64) -> Self {
        if height == 0.0 {
            return *self;
        }
        let shift = -height / self.scale;
        let mut out = Self { scale: self.scale, terms: [0.0; TERMS] };
        for i in 0..=DEGREE {
            for j in 0..=DEGREE - i {
                // (y + shift)^j
                let (mut binomial, mut power) = (1.0, 1.0);
                for low in (0..=j).rev() {
                    out.terms[at(i, low)] += self.terms[at(i, j)] * binomial * power;
                    power *= shift;
                    binomial *= low as f64 / (j - low + 1) as f64;
                }
            }
        }
        out
    }

    /// Adds another one, times a number.
    pub(crate) fn add(&mut self, other: &Self, times: f64) {
        for i in 0..=DEGREE {
            for j in 0..=DEGREE - i {
                let ratio = (self.scale / other.scale).powi((i + j) as i32);
                self.terms[at(i, j)] += times * ratio * other.terms[at(i, j)];
            }
        }
    }

    /// Whether the force is linear in the place.
    pub(crate) fn is_quadratic(&self) -> bool {
        self.terms[at(3, 0)..].iter().all(|&term| term == 0.0)
    }

    /// Energy, force and stiffness with the root at a place, nm.
    pub fn response(&self, root: [f64; 2]) -> RootResponse {
        let power = |x: f64| {
            let mut out = [1.0; DEGREE + 1];
            (1..=DEGREE).for_each(|n| out[n] = out[n - 1] * x);
            out
        };
        let (x, y) = (power(root[0] / self.scale), power(root[1] / self.scale));
        let first = |p: &[f64; DEGREE + 1], n: usize| if n < 1 { 0.0 } else { n as f64 * p[n - 1] };
        let second = |p: &[f64; DEGREE + 1], n: usize| if n < 2 { 0.0 } else { (n * (n - 1)) as f64 * p[n - 2] };
        let mut out = RootResponse::default();
        let (per, per2) = (self.scale.recip(), self.scale.powi(-2));
        for i in 0..=DEGREE {
            for j in 0..=DEGREE - i {
                let a = self.terms[at(i, j)];
                if a == 0.0 {
                    continue;
                }
                let mixed = a * first(&x, i) * first(&y, j) * per2;
                out.energy += a * x[i] * y[j];
                out.force[0] += a * first(&x, i) * y[j] * per;
                out.force[1] += a * x[i] * first(&y, j) * per;
                out.stiffness[0][0] += a * second(&x, i) * y[j] * per2;
                out.stiffness[0][1] += mixed;
                out.stiffness[1][0] += mixed;
                out.stiffness[1][1] += a * x[i] * second(&y, j) * per2;
            }
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Three roots at heights of their own, one by one and as one polynomial; forces are slopes of the energy.
    #[test]
    fn a_sum_is_one_polynomial() {
        let terms: Vec<f64> = (0..TERMS).map(|k| 0.3 + (k as f64 * 1.7).sin()).collect();
        let one = Potential::of(2.5, &terms);
        let (heights, place) = ([-0.7, 0.0, 1.3], [0.4, 1.1]);
        let mut sum = Potential::of(2.5, &[]);
        heights.iter().for_each(|&h| sum.add(&one.raised(h), 1.0));
        let each: Vec<RootResponse> = heights.iter().map(|h| one.response([place[0], place[1] - h])).collect();
        let all = sum.response(place);
        assert_relative_eq!(all.energy, each.iter().map(|r| r.energy).sum::<f64>(), max_relative = 1e-13);
        for i in 0..2 {
            assert_relative_eq!(all.force[i], each.iter().map(|r| r.force[i]).sum::<f64>(), max_relative = 1e-13);
            let step = 1e-6;
            let moved = |by: f64| {
                let mut to = place;
                to[i] += by;
                sum.response(to)
            };
            let slope = (moved(step).energy - moved(-step).energy) / (2.0 * step);
            assert_relative_eq!(all.force[i], slope, max_relative = 1e-8);
            for k in 0..2 {
                let slope = (moved(step).force[k] - moved(-step).force[k]) / (2.0 * step);
                assert_relative_eq!(all.stiffness[k][i], slope, max_relative = 1e-8);
            }
        }
    }
}
