//! The section force along the axis, by how far the axis is stretched.
//!
//! With λ = 1 + Γ1 and EA of small strains,
//!
//! ```text
//! linear                  N = EA Γ1                   w = EA Γ1²/2
//! neo-Hookean             N = EA (λ - λ⁻²)/3          w = EA (λ² + 2/λ - 3)/6
//! neo-Hookean, wide       N = EA (λ - λ⁻³)/4          w = EA (λ² + λ⁻² - 2)/8
//! ```
//!
//! of the undeformed section. The neo-Hookean ones are incompressible: the first is under tension alone, the width of the second stays what it is
//! (plane strain). Bending and shear stay linear. Source: L. R. G. Treloar, The Physics of Rubber Elasticity, 3rd ed. (1975), chapter 4.

use crate::number::Real;
use serde::{Deserialize, Serialize};

/// How the force along the axis follows its stretch.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum StretchLaw {
    /// N = EA Γ1
    #[default]
    Linear,
    /// Incompressible and neo-Hookean, under tension along its axis alone: N = EA (λ - λ⁻²)/3
    NeoHookean,
    /// The same of a section whose width cannot change: N = EA (λ - λ⁻³)/4
    NeoHookeanWide,
}

/// What an axial strain makes of a section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StretchResponse<T> {
    /// N, nN
    pub force: T,
    /// dN/dΓ1, nN
    pub stiffness: T,
    /// w, nN
    pub energy: T,
}

/// Strains closer than this to one another are the same, over the stretch.
const SAME: f64 = 1e-15;
/// Steps of Newton's method after which it has converged from anywhere that a number can be.
const MOST: usize = 200;

impl StretchLaw {
    /// All of them, by their names.
    pub const NAMED: [(&str, Self); 3] =
        [("linear", Self::Linear), ("neo-hookean", Self::NeoHookean), ("neo-hookean-wide", Self::NeoHookeanWide)];

    /// Whether N is EA Γ1.
    pub(crate) fn is_linear(self) -> bool {
        self == Self::Linear
    }

    /// N, its slope and the energy at Γ1 of a section of EA (nN): with factors in place of differences of powers of λ, which would cancel.
    #[inline(always)]
    pub fn at<T: Real>(self, axial: T, strain: T) -> StretchResponse<T> {
        let inverse = match self {
            Self::Linear => {
                let force = strain * axial;
                return StretchResponse { force, stiffness: axial, energy: force * strain * 0.5 };
            }
            Self::NeoHookean | Self::NeoHookeanWide => (strain + 1.0).recip(),
        };
        let square = inverse * inverse;
        let (force, stiffness, energy) = if self == Self::NeoHookean {
            (
                (strain * (strain * (1.0 / 3.0) + 1.0) + 1.0) * square,
                (square * inverse * 2.0 + 1.0) * (1.0 / 3.0),
                (strain * (1.0 / 3.0) + 1.0) * inverse,
            )
        } else {
            let middle = strain * 0.5 + 1.0;
            (
                (strain * (strain * (strain * 0.25 + 1.0) + 1.5) + 1.0) * square * inverse,
                (square * square * 3.0 + 1.0) * 0.25,
                middle * middle * square,
            )
        };
        StretchResponse {
            force: axial * strain * force,
            stiffness: axial * stiffness,
            energy: axial * strain * strain * energy * 0.5,
        }
    }

    /// Γ1 under the force N over EA.
    pub(crate) fn strain(self, force_over_axial: f64) -> f64 {
        let power = match self {
            Self::Linear => return force_over_axial,
            Self::NeoHookean => 2.0,
            Self::NeoHookeanWide => 3.0,
        };
        // N is concave in λ: from below Newton's method comes up to the root and does not pass it
        let pressed = (1.0 - (power + 1.0) * force_over_axial.min(0.0)).powf(-1.0 / power);
        let mut strain = pressed - 1.0;
        for _ in 0..MOST {
            let at = self.at(1.0, strain);
            let step = (force_over_axial - at.force) / at.stiffness;
            strain += step;
            if step.abs() <= SAME * (1.0 + strain) {
                break;
            }
        }
        strain
    }

    /// w under the force N, nN.
    pub fn energy(self, axial: f64, force: f64) -> f64 {
        match self {
            Self::Linear => 0.5 * (force * (force / axial)),
            _ => self.at(axial, self.strain(force / axial)).energy,
        }
    }

    /// N/Γ1 under the force N, nN.
    pub(crate) fn secant(self, axial: f64, force: f64) -> f64 {
        match self {
            Self::Linear => axial,
            _ if force == 0.0 => axial,
            _ => force / self.strain(force / axial),
        }
    }

    /// N Γ1 - w, the complementary energy under the force N, nN.
    pub(crate) fn complementary_energy(self, axial: f64, force: f64) -> f64 {
        match self {
            Self::Linear => self.energy(axial, force),
            _ => force * self.strain(force / axial) - self.energy(axial, force),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const BOTH: [(StretchLaw, i32); 2] = [(StretchLaw::NeoHookean, 2), (StretchLaw::NeoHookeanWide, 3)];

    /// The formulas at the head, and N = w', dN/dΓ1 = w'' by differences.
    #[test]
    fn force_and_stiffness_are_those_of_the_formulas() {
        for (law, power) in BOTH {
            for strain in [-0.6, -0.1, 0.2, 1.5, 6.0f64] {
                let stretch = 1.0 + strain;
                let at = law.at(7.0, strain);
                assert_relative_eq!(
                    at.force,
                    7.0 / f64::from(power + 1) * (stretch - stretch.powi(-power)),
                    max_relative = 1e-13
                );
                let energy = match law {
                    StretchLaw::NeoHookean => (stretch * stretch + 2.0 / stretch - 3.0) / 6.0,
                    _ => (stretch * stretch + stretch.powi(-2) - 2.0) / 8.0,
                };
                assert_relative_eq!(at.energy, 7.0 * energy, max_relative = 1e-13);
                let [ahead, behind] = [1e-5, -1e-5].map(|step| law.at(7.0, strain + step));
                assert_relative_eq!(at.force, (ahead.energy - behind.energy) / 2e-5, max_relative = 1e-8);
                assert_relative_eq!(at.stiffness, (ahead.force - behind.force) / 2e-5, max_relative = 1e-8);
            }
        }
    }

    /// Small strains are those of the linear law to their own size, with all digits.
    #[test]
    fn small_strains_are_linear() {
        for (law, power) in BOTH {
            let at = law.at(3.0, 1e-9);
            assert_relative_eq!(at.force, 3e-9 * (1.0 - 0.5 * f64::from(power) * 1e-9), max_relative = 1e-15);
            assert_relative_eq!(at.energy, 1.5e-18, max_relative = 2e-9);
            assert_relative_eq!(law.energy(3.0, 3e-9), 1.5e-18, max_relative = 1e-8);
        }
    }

    #[test]
    fn strains_are_those_of_their_forces() {
        for law in [StretchLaw::Linear, StretchLaw::NeoHookean, StretchLaw::NeoHookeanWide] {
            for force in [-1e6, -3.0, -1e-3, 0.0, 1e-9, 0.4, 2.0, 1e5] {
                if law.is_linear() && force < -0.5 {
                    continue;
                }
                let found = law.at(1.0, law.strain(force)).force;
                assert!((found - force).abs() <= 1e-13 * force.abs(), "{law:?} {force} {found}");
            }
            assert_relative_eq!(
                law.energy(2.0, 0.8) + law.complementary_energy(2.0, 0.8),
                0.8 * law.strain(0.4),
                max_relative = 1e-14
            );
        }
    }
}
