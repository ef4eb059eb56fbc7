//! A cohesive law, or one of the user's own, averaged over the width of the face that looks down.
//!
//! At s b d2 from the middle of its width, s from -1/2 to 1/2, a section is as high as if its axis were at y + s a, and what it has there per
//! width is the law in the plane, Ψ_p(y, c) with c = h cos θ:
//!
//!   Ψ = b ∫ Ψ_p(y + s a, c) ds.
//!
//! A cohesive law is a nominal traction, per area of reference, so it has no 1/cos θ: Ψ_p = W_c(r), r = y - |c|/2. Ψ_c changes its sign where the
//! face is upright, c = 0, as in the plane.

use super::SpatialSectionResponse;
use super::width_average::mean;
use crate::adhesion::{Cohesive, OwnLaw, TiltedSection};

/// Below this sine the second derivative by c of a law of the user's own is taken there: it is a quotient 0/0 in the angle.
const LEAST_SINE: f64 = 1e-3;

/// Ψ of a rectangle of this width, nm, by a cohesive law, with gradient and Hessian.
#[inline(never)]
pub(super) fn cohesive(law: &Cohesive, width: f64, y: f64, a: f64, c: f64) -> SpatialSectionResponse {
    let (r, rise) = (y - 0.5 * c.abs(), a.abs());
    let breaks = law.shape.breaks().iter().map(|opening| (law.closed + law.range * opening - r) / rise);
    let [w, by_r, by_a, by_rr, by_ra, by_aa] = mean(breaks, |s| {
        let [w, t, b] = law.levels(r + s * rise);
        [w, -t, -s * t, b, s * b, s * s * b]
    })
    .map(|mean| width * mean);
    let across = if a < 0.0 { -1.0 } else { 1.0 };
    let along = if c > 0.0 { -0.5 } else { 0.5 };
    SpatialSectionResponse {
        energy: w,
        gradient: [by_r, across * by_a, along * by_r],
        hessian: [by_rr, across * by_ra, along * by_rr, by_aa, along * across * by_ra, 0.25 * by_rr],
    }
}

/// A law of the user's own in space: the law in the plane, and between which heights of the face it is smooth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct OwnFace {
    law: OwnLaw,
    height: f64,
    rest_gap: f64,
}

impl OwnFace {
    pub fn new(law: OwnLaw, height: f64) -> Self {
        Self { law, height, rest_gap: law.law().rest_gap(height) }
    }

    /// Ψ of a rectangle of this width, nm, with gradient and Hessian.
    #[inline(never)]
    pub fn response(&self, width: f64, y: f64, a: f64, c: f64) -> SpatialSectionResponse {
        let rise = a.abs();
        let face = y - 0.5 * c.abs();
        // the law is smooth between distances of the face each twice the one before, from half of the distance at rest
        let breaks = (-1..24).map(|k| (self.rest_gap * 2f64.powi(k) - face) / rise);
        let [energy, by_y, by_a, by_c, yy, ya, yc, aa, ac, cc] = mean(breaks, |s| {
            let [energy, by_y, by_c, yy, yc, cc] = self.in_the_plane(y + s * rise, c);
            [energy, by_y, s * by_y, by_c, yy, s * yy, yc, s * s * yy, s * yc, cc]
        })
        .map(|mean| width * mean);
        let across = if a < 0.0 { -1.0 } else { 1.0 };
        SpatialSectionResponse {
            energy,
            gradient: [by_y, across * by_a, by_c],
            hessian: [yy, across * ya, yc, aa, across * ac, cc],
        }
    }

    /// Ψ, Ψ_y, Ψ_c, Ψ_yy, Ψ_yc and Ψ_cc in the plane, per width.
    ///
    /// With c = h cos θ it is Ψ_θ = -h sin θ Ψ_c and Ψ_θθ = h² sin² θ Ψ_cc - c Ψ_c, which where the section is not tilted says nothing of Ψ_cc, nor
    /// of Ψ_yc. A little tilt stands for none there: no force depends on these two, and what a tangent has of them is multiplied by sin θ.
    fn in_the_plane(&self, y: f64, c: f64) -> [f64; 6] {
        let h = self.height;
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
