//! A cohesive law: traction against opening of the face that looks down, in place of a half space's.
//!
//! The face at the distance r from the substrate is open by δ = r - r_eq. With the range δ_r the nominal traction, per area of
//! reference, is -σ s(δ/δ_r): it attracts where the face is open, and repels where it is pressed. A shape has a largest s of 1, so
//! that σ is the strength, and the work of adhesion is w = σ δ_r ∫ s over all openings above zero. Per length and width, with
//! W_c(r) = -σ δ_r ∫ s from the opening on,
//!
//!   Ψ(y, θ) = W_c(r),  r = y - (h/2) |cos θ|,   T_c = -∂Ψ/∂y,   M_c = -∂Ψ/∂θ = T_c (h/2) sin θ.
//!
//! Where the section is upright, cos θ = 0, the face that looks down is another one, and M_c changes its sign.

use super::CohesiveShape;
use crate::adhesion::HalfSpace;
use crate::adhesion::section::LineResponse;
use crate::number::Real;
use crate::number::root::Bracket;

/// A cohesive law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cohesive {
    /// How its traction goes with the gap
    pub shape: CohesiveShape,
    /// σ, nN/nm² = GPa
    pub strength: f64,
    /// δ_r, nm
    pub range: f64,
    /// r_eq, the distance at which a face is closed, nm
    pub closed: f64,
}

impl Cohesive {
    /// The law of this strength (nN/nm²) and work of adhesion (nN/nm), closed where the half space has no traction.
    pub fn calibrated(shape: CohesiveShape, strength: f64, work: f64, half_space: &HalfSpace) -> Self {
        Self { shape, strength, range: work / (strength * shape.work()), closed: half_space.equilibrium_gap() }
    }

    /// w, its work of adhesion, nN/nm.
    pub fn work(&self) -> f64 {
        self.strength * self.range * self.shape.work()
    }

    /// The distance beyond which a thousandth of the strength is not reached, nm.
    pub fn cutoff_distance(&self) -> f64 {
        let openings = Bracket { low: 0.5, high: 50.0 };
        let pulls = |opening: f64| self.shape.at(opening)[1] > 1e-3;
        self.closed + self.range * openings.bisected(pulls, |left| left.width() <= 1e-12 * left.high).high
    }

    /// W_c (nN/nm), the traction T = -W_c' (nN/nm²) and b = -T' (nN/nm³) of a face at the distance r, nm.
    #[inline(never)]
    pub fn levels<T: Real>(&self, r: T) -> [T; 3] {
        let per_range = 1.0 / self.range;
        r.each(|r| {
            let [work, s, slope] = self.shape.at((r - self.closed) * per_range);
            [-self.strength * self.range * work, -self.strength * s, self.strength * per_range * slope]
        })
    }

    /// The load on a section whose face is at the distance `gap` where it is not tilted.
    #[inline(never)]
    pub(in crate::adhesion::section) fn on_face<T: Real>(&self, height: T, gap: T, sin: T, cos: T) -> LineResponse<T> {
        LineResponse::of_face(|r| self.levels(r), height, gap, sin, cos)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::adhesion::Rule;
    use approx::{assert_abs_diff_eq, assert_relative_eq};
    use std::num::NonZeroUsize;

    const SHAPES: &[CohesiveShape] = CohesiveShape::ALL;
    const PAPER: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };

    #[test]
    fn each_is_minus_the_slope_of_the_one_before() {
        for &shape in SHAPES {
            for k in -40..400 {
                let (t, d) = (0.003_7 * f64::from(k), 1e-4);
                let slope = |i: usize| {
                    let f = |t| shape.at(t)[i];
                    (8.0 * (f(t + d) - f(t - d)) - (f(t + 2.0 * d) - f(t - 2.0 * d))) / (12.0 * d)
                };
                let [_, s, rise] = shape.at(t);
                assert_abs_diff_eq!(-slope(0), s, epsilon = 1e-9);
                assert_abs_diff_eq!(slope(1), rise, epsilon = 1e-6);
            }
        }
    }

    /// By a rule that is fine enough to see the corners, and at many openings.
    #[test]
    fn work_and_strength_are_those_asked_for() {
        let rule = Rule::new(NonZeroUsize::new(12).unwrap());
        for &shape in SHAPES {
            let (strength, work) = (PAPER.strength(), PAPER.work_of_adhesion());
            let law = Cohesive::calibrated(shape, strength, work, &PAPER);
            let traction = |delta: f64| -law.levels(law.closed + delta)[1];
            let far = 40.0 * law.range;
            let pieces = 8000;
            let by_rule: f64 = (0..pieces)
                .map(|k| [k, k + 1].map(|k| far * f64::from(k) / f64::from(pieces)))
                .flat_map(|[from, to]| {
                    rule.over(from, to).map(|(delta, weight)| weight * traction(delta)).collect::<Vec<_>>()
                })
                .sum();
            assert_relative_eq!(by_rule, work, max_relative = 1e-12);
            assert_relative_eq!(law.levels(law.closed)[0], -work, max_relative = 1e-14);
            let largest = (0..200_000).map(|k| traction(2.0 * law.range * f64::from(k) / 2e5)).fold(0.0, f64::max);
            assert_relative_eq!(largest, strength, max_relative = 1e-8);
            assert_abs_diff_eq!(traction(0.0), 0.0, epsilon = 1e-16);
            assert!(traction(-0.1 * law.range) < 0.0);
        }
    }

    #[test]
    fn reach_is_where_a_thousandth_is_left() {
        for &shape in SHAPES {
            let law = Cohesive::calibrated(shape, 0.2, 0.03, &PAPER);
            assert_relative_eq!(-law.levels(law.cutoff_distance())[1], 2e-4, max_relative = 1e-6);
        }
    }

    #[test]
    fn beyond_its_range_a_rounded_law_is_nothing() {
        for shape in [CohesiveShape::Bilinear, CohesiveShape::Dugdale] {
            for t in [1.31, 2.0, 1e3] {
                assert_eq!(shape.at(t), [0.0; 3], "{shape:?} at {t}");
            }
        }
    }
}
