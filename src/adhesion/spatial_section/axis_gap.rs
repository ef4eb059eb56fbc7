//! The traction at the gap below the axis, independent of both tilts: Ψ = b [W(η) - W(η + h)] with η = y - h/2, as in
//! the plane.

use super::response::SpatialSectionResponse;
use crate::adhesion::section::line_load::LineLaw;
use crate::number::Real;

/// Ψ of a section of this width and height, nm, taken as level: cos θ = 1.
#[inline(never)]
pub(super) fn response<T: Real>(law: &LineLaw, [width, height]: [T; 2], y: T) -> SpatialSectionResponse<T> {
    let zero = T::splat(0.0);
    let at = law.response_of(height, y - height * 0.5, zero, T::splat(1.0));
    SpatialSectionResponse {
        energy: at.energy * width,
        gradient: [at.by_gap * width, zero, zero],
        hessian: [at.gap_gap * width, zero, zero, zero, zero, zero],
    }
}
