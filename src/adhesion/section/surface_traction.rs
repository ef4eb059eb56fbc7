//! The surface traction of eq. (10) on the faces of a section, eqs. (11) and (12), with its moment.
//!
//! A face element of the reference length dS whose normal is tilted by θ faces the substrate with cos θ dS (β dv = β0 dV: what it is
//! stretched by, its density has lost). With r1 = y - (h/2) cos θ and r2 = y + (h/2) cos θ, per length and width
//!
//!   T_c = cos θ [T(r1) - T(r2)],   M_c = (h/2) sin θ cos θ [T(r1) + T(r2)].
//!
//! It has no potential: ∂T_c/∂θ - ∂M_c/∂y = -sin θ [T(r1) - T(r2)]. Over the four faces of a piece the traction is the body force
//! ([`crate::adhesion::TiltedBlock`]); the faces at the ends of a beam, which would make up for that, are left out, as in a mesh of which the
//! bottom face alone is a contact surface. As its energy stands cos θ [W(r1) - W(r2)], whose slope along y is -T_c.

use super::response::{LineResponse, one_minus};
use crate::adhesion::levels::half_space::HalfSpace;
use crate::number::Real;

/// The bottom face and, turned the other way, the top face.
#[inline(never)]
pub(super) fn both_faces<T: Real>(half_space: &HalfSpace, height: T, gap: T, sin: T, cos: T) -> LineResponse<T> {
    let near = gap + one_minus(sin, cos) * (height * 0.5);
    let [bottom, top] = [near, near + cos * height].map(|r| half_space.levels(r));
    let lever = height * sin * 0.5;
    response([0, 1, 2].map(|k| bottom[k] - top[k]), [0, 1, 2].map(|k| bottom[k] + top[k]), lever, height, sin, cos)
}

/// The face that looks down alone.
#[inline(never)]
pub(super) fn near_face<T: Real>(half_space: &HalfSpace, height: T, gap: T, sin: T, cos: T) -> LineResponse<T> {
    let (s, c) = (cos.select(sin, -sin), cos.select(cos, -cos));
    let face = half_space.levels(gap + one_minus(s, c) * (height * 0.5));
    response(face, face, height * s * 0.5, height, s, c)
}

/// Of differences and sums of potential, traction and body force of the two faces. `lever` is (h/2) sin θ.
#[inline(always)]
fn response<T: Real>(less: [T; 3], both: [T; 3], lever: T, height: T, sin: T, cos: T) -> LineResponse<T> {
    let ([w, t, b], [_, t_both, b_both]) = (less, both);
    LineResponse {
        energy: cos * w,
        by_gap: -cos * t,
        by_rotation: -lever * cos * t_both,
        energy_by_rotation: -sin * w - cos * lever * t_both,
        gap_gap: cos * b,
        gap_rotation: sin * t + cos * lever * b_both,
        rotation_gap: lever * cos * b_both,
        rotation_rotation: cos * lever * lever * b - height * (cos - sin) * (cos + sin) * t_both * 0.5,
    }
}
