//! A law of the user's own, averaged over the width of a section.
//!
//! At s b d2 from the middle of its width, s from -1/2 to 1/2, a section is as high as if its axis were at y + s a, and
//! what it has there per width is the law in the plane, Ψ_p(y, c) with c = h cos θ:
//!
//!   Ψ = b ∫ Ψ_p(y + s a, c) ds.

use super::adaptive_mean::mean;
use super::response::SpatialSectionResponse;
use crate::adhesion::section::own::{OwnLaw, TiltedSection};

/// Below this sine of the tilt the second derivative by c of a law of the user's own is that at this sine: it is a
/// quotient 0/0 in the angle, with a round-off of 1e-16 over the square of the sine. A tangent has it times that
/// square.
const LEAST_SINE: f64 = 1e-4;

/// Up to this rise over the gap at rest Gauss's two points, ±1/√12, do: what they leave out of a r⁻¹⁰ is 4e-16 of it.
const NARROW: f64 = 1e-4;
const GAUSS: f64 = 0.288_675_134_594_812_9;

/// A law of the user's own in space: the law in the plane, and the gap at rest, by which a width is divided.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct OwnFace {
    law: OwnLaw,
    rest_gap: f64,
}

impl OwnFace {
    pub(crate) fn new(law: OwnLaw, height: f64) -> Self {
        Self { law, rest_gap: law.law().rest_gap(height) }
    }

    /// Ψ of a rectangle of this width and height, nm, with gradient and Hessian.
    #[inline(never)]
    pub(crate) fn response(&self, [width, height]: [f64; 2], y: f64, a: f64, c: f64) -> SpatialSectionResponse {
        let rise = a.abs();
        let face = y - 0.5 * c.abs();
        let at = |s: f64| {
            let [energy, by_y, by_c, yy, yc, cc] = self.in_the_plane(height, y + s * rise, c);
            [energy, by_y, s * by_y, by_c, yy, s * yy, yc, s * s * yy, s * yc, cc]
        };
        let means = if rise <= NARROW * self.rest_gap {
            let [low, high] = [-GAUSS, GAUSS].map(at);
            std::array::from_fn(|k| 0.5 * (low[k] + high[k]))
        } else {
            // in parts of which the face is twice as far where they end as where they begin, from half of the distance
            // at rest
            mean((-1..24).map(|k| (self.rest_gap * 2f64.powi(k) - face) / rise), at)
        };
        let [energy, by_y, by_a, by_c, yy, ya, yc, aa, ac, cc] = means.map(|mean| width * mean);
        let across = if a < 0.0 { -1.0 } else { 1.0 };
        SpatialSectionResponse {
            energy,
            gradient: [by_y, across * by_a, by_c],
            hessian: [yy, across * ya, yc, aa, across * ac, cc],
        }
    }

    /// Ψ, Ψ_y, Ψ_c, Ψ_yy, Ψ_yc and Ψ_cc in the plane, per width.
    ///
    /// With c = h cos θ it is Ψ_θ = -h sin θ Ψ_c and Ψ_θθ = h² sin² θ Ψ_cc - c Ψ_c, which where the section is not
    /// tilted says nothing of Ψ_cc, nor of Ψ_yc. A little tilt stands for none there: no force depends on these two,
    /// and what a tangent has of them is multiplied by sin θ.
    fn in_the_plane(&self, h: f64, y: f64, c: f64) -> [f64; 6] {
        let cos = (c / h).clamp(-1.0, 1.0);
        let at = |sin: f64, cos: f64| {
            let at = self.law.law().response(&TiltedSection { height: h, gap: y - 0.5 * h, sin, cos });
            (at, h * sin, h * cos)
        };
        let sin = ((1.0 - cos) * (1.0 + cos)).sqrt();
        let (here, arm, rise) = at(sin, cos);
        let little = || at(LEAST_SINE, ((1.0 - LEAST_SINE) * (1.0 + LEAST_SINE)).sqrt().copysign(cos));
        let (tilted, tilted_arm, tilted_rise) = if sin < LEAST_SINE { little() } else { (here, arm, rise) };
        let (by_c, yc) = if sin > 0.0 {
            (-here.by_rotation / arm, -here.gap_rotation / arm)
        } else {
            (-here.rotation_rotation / rise, -tilted.gap_rotation / tilted_arm)
        };
        let slope = -tilted.by_rotation / tilted_arm;
        let cc = (tilted.rotation_rotation + tilted_rise * slope) / (tilted_arm * tilted_arm);
        [here.energy, here.by_gap, by_c, here.gap_gap, yc, cc]
    }
}
