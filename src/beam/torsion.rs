//! Torsion constant of a section, after Saint-Venant.

use std::f64::consts::PI;

/// ζ(5) · 31/32: the sum of n⁻⁵ over odd n.
const ODD_FIFTH_POWERS: f64 = 1.004_523_762_795_139_6;
/// Terms of the rest of the series: the last is below 1e-16 of the first.
const TERMS: usize = 6;

/// J of a rectangle (nm⁴): with the longer side a and the shorter side t,
///
///   J = a t³ [ 1/3 - (64 t/π⁵ a) Σ tanh(nπa/2t)/n⁵ ],  n = 1, 3, 5, ...
///
/// Exact to round-off: tanh x = 1 - 2/(e^2x + 1) leaves a closed sum and one that converges in a few terms. Timoshenko
/// and Goodier, Theory of Elasticity, § 109.
pub fn rectangle_torsion_constant(height: f64, width: f64) -> f64 {
    let (long, short) = (height.max(width), height.min(width));
    let ratio = long / short;
    let term = |k: usize| {
        let n = (2 * k + 1) as f64;
        2.0 / (n.powi(5) * ((n * PI * ratio).exp() + 1.0))
    };
    let sum = ODD_FIFTH_POWERS - (0..TERMS).map(term).sum::<f64>();
    long * short.powi(3) * (1.0 / 3.0 - 64.0 / (PI.powi(5) * ratio) * sum)
}

/// J of an ellipse with these axes (nm⁴): π b³ h³ / (16 (b² + h²)).
pub fn ellipse_torsion_constant(height: f64, width: f64) -> f64 {
    PI * (width * height).powi(3) / (16.0 * (width * width + height * height))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// The series itself, summed with 30 digits (mpmath's nsum over odd n), and for a thin strip its limit.
    #[test]
    fn a_rectangle_has_the_constant_of_the_series() {
        let series = [
            (1.0, 0.140_577_014_955_153_7),
            (2.0, 0.457_363_354_239_141_5),
            (4.0, 1.123_251_833_230_709_5),
            (10.0, 3.123_250_374_572_054),
        ];
        for (width, expected) in series {
            assert_relative_eq!(rectangle_torsion_constant(1.0, width), expected, max_relative = 1e-15);
        }
        assert_eq!(rectangle_torsion_constant(3.0, 7.0), rectangle_torsion_constant(7.0, 3.0));
        let thin = 1e6 / 3.0 - 64.0 / PI.powi(5) * ODD_FIFTH_POWERS;
        assert_relative_eq!(rectangle_torsion_constant(1e6, 1.0), thin, max_relative = 1e-15);
    }

    #[test]
    fn a_disc_has_its_polar_moment() {
        assert_relative_eq!(ellipse_torsion_constant(3.0, 3.0), PI * 81.0 / 32.0, max_relative = 1e-15);
    }
}
