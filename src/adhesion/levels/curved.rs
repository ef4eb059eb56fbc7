//! Attraction of a convex sphere or cylinder, which the half space of eq. (9) approximates.

use super::half_space::HalfSpace;
use crate::number::gauss::Rule;
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, PI};
use std::num::NonZeroUsize;

/// The shape of a curved body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum BodyShape {
    /// A ball
    Sphere,
    /// Endless
    Cylinder,
}

/// A convex body in front of which the half space is an approximation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvedBody {
    /// Which of the two
    pub shape: BodyShape,
    /// nm
    pub radius: f64,
}

/// ∫ r^-n over a body, and its slope with the gap, for n = 12 and n = 6.
struct Powers {
    repulsion: [f64; 2],
    attraction: [f64; 2],
}

/// Points on half of a cylinder's section as seen from outside: 1e-11 of the result at a gap of a hundredth of the radius.
const CHORDS: NonZeroUsize = NonZeroUsize::new(48).expect("it is not zero");

impl CurvedBody {
    /// Body force density at `gap` d (nm) from the surface, nN/nm³, positive away from it: eq. (7) over this body.
    /// `material` gives A_H and r0 of the pair.
    pub fn body_force(&self, material: &HalfSpace, gap: f64) -> f64 {
        -self.combined(material, gap)[1]
    }

    /// The body force summed over a column that begins at `gap` and points away, nN/nm²: eq. (10) in front of this body.
    pub fn traction(&self, material: &HalfSpace, gap: f64) -> f64 {
        self.combined(material, gap)[0]
    }

    /// β1β2ε (r0¹² ∫r^-12 - 2 r0⁶ ∫r^-6) and its slope with the gap, β1β2ε = A_H/(2π² r0⁶).
    fn combined(&self, material: &HalfSpace, gap: f64) -> [f64; 2] {
        let r0_6 = material.equilibrium_distance.powi(6);
        let scale = material.hamaker_constant / (2.0 * PI * PI);
        let powers = match self.shape {
            BodyShape::Sphere => self.sphere(gap),
            BodyShape::Cylinder => self.cylinder(gap),
        };
        [0, 1].map(|k| scale * (r0_6 * powers.repulsion[k] - 2.0 * powers.attraction[k]))
    }

    /// Closed forms. With c = 1 + d/R and k = c² - 1,
    ///
    ///   ∫r^-6 = 4π/(3R³) k^-3,   ∫r^-12 = 4π/(3R⁹) (c⁶ + 21c⁴/5 + 3c² + 1/3) k^-9.
    fn sphere(&self, gap: f64) -> Powers {
        let (r, x) = (self.radius, gap / self.radius);
        let (c, k) = (1.0 + x, x * (2.0 + x));
        let c2 = c * c;
        let p = ((c2 + 4.2) * c2 + 3.0) * c2 + 1.0 / 3.0;
        let p_slope = c * ((6.0 * c2 + 16.8) * c2 + 6.0);
        let (sixth, twelfth) = (4.0 * PI / (3.0 * r.powi(3)), 4.0 * PI / (3.0 * r.powi(9)));
        Powers {
            repulsion: [twelfth * p / k.powi(9), twelfth / r * (p_slope - 18.0 * c * p / k) / k.powi(9)],
            attraction: [sixth / k.powi(3), -6.0 * sixth / r * c / k.powi(4)],
        }
    }

    /// Along the axis r^-n sums to c_n ρ^(1-n), c_12 = 63π/256 and c_6 = 3π/8. A chord of the section at the angle ψ from the
    /// normal runs from ρ1 to ρ2, ρ1 ρ2 = D² - R² with D = R + d; with sin ψ = (R/D) sin τ
    ///
    ///   ∫ρ^-m = ∫ (ρ1^(2-m) - ρ2^(2-m))/(m-2) dψ,   slope: -m ∫ cos ψ (ρ1^(1-m) - ρ2^(1-m))/(m-1) dψ.
    fn cylinder(&self, gap: f64) -> Powers {
        let (r, d) = (self.radius, self.radius + gap);
        let k = gap * (gap + 2.0 * r);
        let mut powers = Powers { repulsion: [0.0; 2], attraction: [0.0; 2] };
        for (tau, weight) in Rule::new(CHORDS).over(0.0, FRAC_PI_2) {
            let (sin, cos) = tau.sin_cos();
            let cos_psi = (cos * cos + k / (d * d) * sin * sin).sqrt();
            let far = d * cos_psi + r * cos;
            let near = k / far;
            // both sides of the normal
            let angle = 2.0 * weight * r / d * cos / cos_psi;
            let difference = |power: i32| near.powi(-power) - far.powi(-power);
            for (sums, m, along_axis) in
                [(&mut powers.repulsion, 11, 63.0 * PI / 256.0), (&mut powers.attraction, 5, 3.0 * PI / 8.0)]
            {
                let factor = angle * along_axis;
                sums[0] += factor * difference(m - 2) / f64::from(m - 2);
                sums[1] -= factor * cos_psi * f64::from(m) * difference(m - 1) / f64::from(m - 1);
            }
        }
        powers
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const LAW: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };
    const SHAPES: [BodyShape; 2] = [BodyShape::Sphere, BodyShape::Cylinder];

    #[test]
    fn body_force_is_minus_the_slope_of_the_traction() {
        for shape in SHAPES {
            let body = CurvedBody { shape, radius: 3.0 };
            for gap in [0.25, 0.4, 2.0] {
                let (d, t) = (1e-3 * gap, |g| body.traction(&LAW, g));
                let slope = (8.0 * (t(gap + d) - t(gap - d)) - (t(gap + 2.0 * d) - t(gap - 2.0 * d))) / (12.0 * d);
                assert_relative_eq!(body.body_force(&LAW, gap), -slope, max_relative = 1e-7);
            }
        }
    }

    /// To first order in d/R a sphere loses the fraction d/R of the attraction r^-4 and a cylinder half of that.
    #[test]
    fn a_wide_body_is_a_half_space_less_its_curvature() {
        let gap = 20.0; // attraction alone: the repulsion is (0.4/20)⁶ of it
        for (shape, share) in SHAPES.into_iter().zip([1.0, 0.5]) {
            for radius in [1e4, 1e5] {
                let off = CurvedBody { shape, radius }.body_force(&LAW, gap) / LAW.body_force(gap) - 1.0;
                assert_relative_eq!(off, -share * gap / radius, max_relative = 3.0 * gap / radius);
            }
        }
    }

    /// Far from a small sphere its volume attracts as one atom: -φ' with r^-7.
    #[test]
    fn a_far_sphere_attracts_with_its_volume() {
        let body = CurvedBody { shape: BodyShape::Sphere, radius: 0.1 };
        let (distance, volume) = (50.0, 4.0 / 3.0 * PI * 1e-3);
        let expected = -12.0 * 0.1 / (2.0 * PI * PI) * volume / f64::powi(distance, 7);
        assert_relative_eq!(body.body_force(&LAW, distance - 0.1), expected, max_relative = 1e-4);
    }
}
