//! An adhesive whose traction grows with the rate at which it opens.
//!
//! Where the face is open by δ and is attracted by the traction a(δ) at rest, it is attracted by
//!
//!   a(δ) g(dδ/dt),   g(x) = (1 + x/v)ⁿ where it opens,   g = 1 where it closes,
//!
//! while it opens at the rate dδ/dt. So it resists like a linear dashpot at rates far below v, and with the power n of the rate far above. What is
//! pressed has the traction at rest.
//!
//! A step in time replaces dδ/dt by c (δ - δ_k), with a rate c and a known opening δ_k from the steps before. Then the additional traction
//! a (g - 1) is a function of the opening alone, and the tangent of the step is symmetric. Its power a (g - 1) dδ/dt is dissipated.

use serde::{Deserialize, Serialize};

/// How the traction grows with the rate of opening.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct OpeningRate {
    /// v, nm/ns = m/s
    pub reference: f64,
    /// n
    pub exponent: f64,
}

impl OpeningRate {
    /// The least exponent and the largest.
    pub const EXPONENTS: [f64; 2] = [0.01, 2.0];

    /// g - 1 and its derivative by the rate (nm/ns), ns/nm.
    pub(crate) fn excess(&self, rate: f64) -> [f64; 2] {
        if rate <= 0.0 {
            return [0.0; 2];
        }
        let excess = (self.exponent * (rate / self.reference).ln_1p()).exp_m1();
        [excess, self.exponent * (1.0 + excess) / (self.reference + rate)]
    }

    /// From W, T and b of a face at rest, what they have besides in a step in which it has opened by so much (nm) since the known opening; in place of W
    /// stands the power over c.
    pub(in crate::adhesion::section) fn levels(
        &self,
        [_, traction, slope]: [f64; 3],
        opened: f64,
        per_time: f64,
    ) -> [f64; 3] {
        let attraction = -traction;
        if attraction <= 0.0 {
            return [0.0; 3];
        }
        let [excess, by_rate] = self.excess(per_time * opened);
        [attraction * excess * opened, -attraction * excess, slope * excess + attraction * by_rate * per_time]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const RATE: OpeningRate = OpeningRate { reference: 2e-3, exponent: 0.4 };

    /// Linear in slow opening, a power in fast opening, nothing where it closes; the derivative is that of differences.
    #[test]
    fn slow_fast_and_backwards() {
        assert_relative_eq!(RATE.excess(2e-9)[0], 0.4e-6, max_relative = 1e-6);
        assert_relative_eq!(RATE.excess(2e3)[0], 1e6_f64.powf(0.4), max_relative = 1e-2);
        assert_eq!(RATE.excess(-1.0), [0.0; 2]);
        for rate in [1e-5, 1e-3, 0.1] {
            let step = 1e-4 * rate;
            let slope = (RATE.excess(rate + step)[0] - RATE.excess(rate - step)[0]) / (2.0 * step);
            assert_relative_eq!(RATE.excess(rate)[1], slope, max_relative = 1e-7);
        }
    }

    /// Traction and tangent of a step against differences, and the power over c, which is traction times what has opened.
    #[test]
    fn levels_are_those_of_a_step() {
        let rest = |opening: f64| [0.0, -opening * (-opening).exp(), (1.0 - opening) * (-opening).exp()];
        let (known, per_time) = (0.4, 0.05);
        let at = |opening: f64| RATE.levels(rest(opening), opening - known, per_time);
        for opening in [0.41, 0.7, 1.5] {
            let [power, traction, slope] = at(opening);
            let step = 1e-6;
            assert_relative_eq!(
                slope,
                -(at(opening + step)[1] - at(opening - step)[1]) / (2.0 * step),
                max_relative = 1e-7
            );
            assert_relative_eq!(power, -traction * (opening - known));
        }
        assert_eq!(at(0.3), [0.0; 3]);
    }
}
