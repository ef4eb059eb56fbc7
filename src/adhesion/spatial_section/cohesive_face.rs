//! A cohesive law on the face that looks down, averaged over its width.
//!
//! A cohesive law is a nominal traction, per area of reference, and so has no 1/cos θ, as in the plane. At s b d2 from
//! the middle of its width, s from -1/2 to 1/2, the face is at the distance r + s a, r = y - |c|/2:
//!
//!   Ψ = b ∫ W_c(r + s a) ds.
//!
//! Ψ_c changes its sign where the face is upright, c = 0, as in the plane.

use super::SpatialSectionResponse;
use crate::adhesion::Cohesive;

/// Ψ of a rectangle of this width, nm, with gradient and Hessian.
#[inline(never)]
pub(super) fn response(law: &Cohesive, width: f64, y: f64, a: f64, c: f64) -> SpatialSectionResponse {
    let means = law.over_width(y - 0.5 * c.abs(), a.abs());
    let [energy, by_r, by_a, by_rr, by_ra, by_aa] = means.map(|mean| width * mean);
    let across = if a < 0.0 { -1.0 } else { 1.0 };
    let along = if c > 0.0 { -0.5 } else { 0.5 };
    SpatialSectionResponse {
        energy,
        gradient: [by_r, across * by_a, along * by_r],
        hessian: [by_rr, across * by_ra, along * by_rr, by_aa, along * across * by_ra, 0.25 * by_rr],
    }
}
