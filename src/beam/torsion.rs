//! Saint-Venant's torsion constant J of a section, nm⁴: the torque is G J times the twist per length.
//!
//! Source: S. P. Timoshenko, J. N. Goodier, Theory of Elasticity, 3rd ed. (1970), arts. 106 (ellipse) and 109
//! (rectangle).

use super::section::{Material, rectangle_second_moment};
use crate::adhesion::spatial_section::section::SectionShape;
use std::f64::consts::PI;

/// ζ(5)
const ZETA_5: f64 = 1.036_927_755_143_37;

/// Sides of a rectangle whose exp(-π a/b) is 2e-18.
const THIN: f64 = 13.0;

/// J of a section of this width and height (of an ellipse, its axes), nm⁴, to 1e-15 of its size.
pub fn torsion_constant(shape: SectionShape, width: f64, height: f64) -> f64 {
    match shape {
        SectionShape::Rectangle => of_rectangle(width.max(height), width.min(height)),
        SectionShape::Ellipse => of_ellipse(width, height),
    }
}

/// The largest shear strain of torsion over the twist per length, nm: in the middle of a longer side of a rectangle, at the ends of the shorter
/// axis of an ellipse.
pub(crate) fn torsion_strain(shape: SectionShape, width: f64, height: f64) -> f64 {
    let (a, b) = (width.max(height), width.min(height));
    match shape {
        // b [1 - (8/π²) Σ 1/(n² cosh(n π a/2b))] over odd n; the term behind these is below 1e-16
        SectionShape::Rectangle => {
            let term = |k: u32| f64::from(2 * k + 1).powi(-2) / (f64::from(2 * k + 1) * 0.5 * PI * a / b).cosh();
            b * (1.0 - 8.0 / (PI * PI) * (0..12).map(term).sum::<f64>())
        }
        SectionShape::Ellipse => a * a * b / (a * a + b * b),
    }
}

/// J = a b³ [1/3 - (64/π⁵)(b/a) Σ tanh(n π a/2b)/n⁵] over odd n, with sides a ≥ b.
///
/// With tanh x = 1 - 2/(e²ˣ + 1) the ones add up to 31/32 ζ(5), and what is left of a term falls with eⁿ, e = exp(-π a/b):
/// it is 2 eⁿ/(n⁵ (1 + eⁿ)). At n = 9 that is below 2e-17.
fn of_rectangle(a: f64, b: f64) -> f64 {
    let less = |left: f64| a * b.powi(3) * (1.0 / 3.0 - 64.0 / PI.powi(5) * (b / a) * (31.0 / 32.0 * ZETA_5 - left));
    // of thinner ones it is below what ζ(5) is rounded by
    if a > THIN * b {
        return less(0.0);
    }
    let e = (-PI * a / b).exp();
    let square = e * e;
    let (e3, e5) = (square * e, square * square * e);
    let e7 = square * e5;
    let term = |power: f64, over: f64| 2.0 / over * power / (1.0 + power);
    let left = term(e7, 16807.0) + term(e5, 3125.0) + term(e3, 243.0) + term(e, 1.0);
    less(left)
}

/// J = π a³ b³/(16 (a² + b²)), of a circle π a⁴/32.
fn of_ellipse(a: f64, b: f64) -> f64 {
    PI * (a * b).powi(3) / (16.0 * (a * a + b * b))
}

// -- The stiffness of a section that a planar beam does not have --

/// Of torsion, and of bending along the width.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LateralStiffness {
    /// GJ, nN nm²
    pub torsion: f64,
    /// EI3, of bending along the width, nN nm²
    pub bending: f64,
}

impl LateralStiffness {
    /// Of a section between a rectangle (`roundness` 0) and an ellipse (1) of this width and height, nm, as [`Material::section`] has it:
    /// J is between those of the two, I3 = (h b³/12)(1 + (12π/64 - 1) q). The factor of the planar bending stiffness has no part in it.
    pub(crate) fn of(material: &Material, width: f64, height: f64, roundness: f64) -> Self {
        let torsion_constant = match roundness {
            1.0 => torsion_constant(SectionShape::Ellipse, width, height),
            0.0 => torsion_constant(SectionShape::Rectangle, width, height),
            between => {
                let rectangle = torsion_constant(SectionShape::Rectangle, width, height);
                rectangle + between * (torsion_constant(SectionShape::Ellipse, width, height) - rectangle)
            }
        };
        let second_moment = rectangle_second_moment(width, height) * (1.0 + (12.0 * PI / 64.0 - 1.0) * roundness);
        let shear_modulus = material.youngs_modulus / (2.0 * (1.0 + material.poissons_ratio));
        Self { torsion: shear_modulus * torsion_constant, bending: material.youngs_modulus * second_moment }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn of_a_square() {
        // by mpmath, 25 digits
        let unit = torsion_constant(SectionShape::Rectangle, 1.0, 1.0);
        assert_relative_eq!(unit, 0.140_577_014_955_153_7, max_relative = 2e-15);
        assert_relative_eq!(torsion_constant(SectionShape::Rectangle, 3.0, 3.0), 81.0 * unit, max_relative = 1e-15);
    }

    /// The series with the sides exchanged is another series with the same sum; summed as it stands, up to n = 4e4.
    #[test]
    fn of_rectangles_by_the_series_of_the_other_side() {
        for side in [1.0, 1.2, 2.0, 5.0, 13.0, 40.0] {
            let sum: f64 =
                (0..20_000).rev().map(|k| f64::from(2 * k + 1)).map(|n| (0.5 * n * PI / side).tanh() / n.powi(5)).sum();
            let other = side.powi(3) * (1.0 / 3.0 - 64.0 / PI.powi(5) * side * sum);
            // the terms of this one are side² times as large as what is left of them
            let allowed = 2e-15 * (1.0 + side * side);
            for (width, height) in [(side, 1.0), (1.0, side)] {
                assert_relative_eq!(
                    torsion_constant(SectionShape::Rectangle, width, height),
                    other,
                    max_relative = allowed
                );
            }
        }
    }

    /// Timoshenko and Goodier's table of J/(a b³).
    #[test]
    fn of_rectangles_as_published() {
        for (side, published) in [(1.2, 0.166), (1.5, 0.196), (2.0, 0.229), (3.0, 0.263), (5.0, 0.291), (10.0, 0.312)] {
            let computed = torsion_constant(SectionShape::Rectangle, side, 1.0) / side;
            assert!((computed - published).abs() <= 6e-4, "{side}: {computed}");
        }
    }

    #[test]
    fn of_a_circle_and_an_ellipse() {
        assert_relative_eq!(
            torsion_constant(SectionShape::Ellipse, 10.0, 10.0),
            0.5 * PI * 625.0,
            max_relative = 1e-15
        );
        // semi-axes p and q: π p³ q³/(p² + q²)
        assert_relative_eq!(torsion_constant(SectionShape::Ellipse, 6.0, 2.0), PI * 27.0 / 10.0, max_relative = 1e-15);
    }

    /// Timoshenko and Goodier's table of the largest strain over b times the twist; of a circle it is the radius.
    #[test]
    fn largest_strains_as_published() {
        for (side, published) in [(1.0, 0.675), (1.2, 0.759), (1.5, 0.848), (2.0, 0.930), (3.0, 0.985), (5.0, 0.999)] {
            let computed = torsion_strain(SectionShape::Rectangle, 3.0, 3.0 * side) / 3.0;
            assert!((computed - published).abs() <= 6e-4, "{side}: {computed}");
        }
        assert_relative_eq!(torsion_strain(SectionShape::Ellipse, 10.0, 10.0), 5.0, max_relative = 1e-15);
    }
}
