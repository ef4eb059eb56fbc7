//! A cohesive law on the bonded face, averaged over its width.
//!
//! A cohesive law is a nominal traction, per area of reference, and so has no 1/cos θ, as in the plane. At s b d2 from
//! the middle of its width, s from -1/2 to 1/2, the bonded face is at the distance r + s a, r = y - c/2:
//!
//!   Ψ = b ∫ W_c(r + s a) ds.
//!
//! Where the section has turned over, c < 0, that face is attracted and the other one, r = y - |c|/2, may be pressed, as in the plane.

use super::response::SpatialSectionResponse;
use crate::adhesion::section::cohesive::calibrated::{Cohesive, Part};

/// Ψ of a rectangle of this width, nm, with gradient and Hessian.
#[inline(never)]
pub(super) fn response(law: &Cohesive, width: f64, y: f64, a: f64, c: f64) -> SpatialSectionResponse {
    let face = |part, along: f64| of_part(law, part, [width, y, a], [c, along]);
    if c > 0.0 {
        return face(Part::Whole, -0.5);
    }
    let (pulled, pressed) = (face(Part::Pull, -0.5), face(Part::Push, 0.5));
    SpatialSectionResponse {
        energy: pulled.energy + pressed.energy,
        gradient: std::array::from_fn(|k| pulled.gradient[k] + pressed.gradient[k]),
        hessian: std::array::from_fn(|k| pulled.hessian[k] + pressed.hessian[k]),
    }
}

/// Of a part of the law on the face whose middle is at the distance y + `along` c.
fn of_part(law: &Cohesive, part: Part, [width, y, a]: [f64; 3], [c, along]: [f64; 2]) -> SpatialSectionResponse {
    let means = law.over_width(part, y + along * c, a.abs());
    let [energy, by_r, by_a, by_rr, by_ra, by_aa] = means.map(|mean| width * mean);
    let across = if a < 0.0 { -1.0 } else { 1.0 };
    SpatialSectionResponse {
        energy,
        gradient: [by_r, across * by_a, along * by_r],
        hessian: [by_rr, across * by_ra, along * by_rr, by_aa, along * across * by_ra, 0.25 * by_rr],
    }
}
