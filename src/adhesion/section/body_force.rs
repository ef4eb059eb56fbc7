//! The body force of eq. (9) summed over a section, eqs. (17)-(22), in closed form, with its potential.
//!
//! A section of height h at the angle θ has its axis at y, its bottom edge at r1 = y - (h/2) cos θ and its top edge at
//! r2 = y + (h/2) cos θ. Per length and width
//!
//!   Ψ(y, θ) = [W(r1) - W(r2)] / cos θ,   T_c = -∂Ψ/∂y,   M_c = -∂Ψ/∂θ.
//!
//! The paper gives T_c and M_c and does not say that they have this potential. At cos θ = 0 the quotient is 0/0; with
//! D = r1 r2 and α = r1² + r2² the differences of powers divide out,
//!
//!   Ψ = (A_H h/π) y [ r0⁶ α (α² - 2D²) / (360 D⁸) - 1 / (6 D²) ],
//!
//! which has no cancellation at any angle and is even in cos θ.

use super::response::{LineResponse, one_minus};
use crate::adhesion::levels::half_space::HalfSpace;
use crate::number::Real;

/// Both faces, exact and free of cancellation at any rotation. In (y, A) with A = (h/2)² cos²θ,
/// D = y² - A and α = 2(y² + A); g = α(α² - 2D²).
#[inline(always)]
pub(super) fn both_faces<T: Real>(half_space: &HalfSpace, h: T, gap: T, sin: T, cos: T) -> LineResponse<T> {
    let r0_squared = half_space.equilibrium_distance * half_space.equilibrium_distance;
    let r1 = gap + one_minus(sin, cos) * (h * 0.5);
    let r2 = r1 + cos * h;
    let y = gap + h * 0.5;
    let (d, a) = (r1 * r2, r1 * r1 + r2 * r2);
    let v = d.recip();
    let (dd, aa, ad, yy) = (d * d, a * a, a * d, y * y);
    let yv = y * v;

    let g = a * (aa - dd * 2.0);
    let g_y = y * (aa * 12.0 - dd * 8.0 - ad * 8.0);
    let g_a = aa * 6.0 - dd * 4.0 + ad * 4.0;
    let g_yy = aa * 12.0 - dd * 8.0 - ad * 8.0 + yy * (a * 80.0 - d * 64.0);
    let g_ya = a * y * 56.0;
    let g_aa = a * 20.0 + d * 16.0;
    // e = g / D⁸; every derivative is v⁸ times what is in brackets
    let vg = v * g;
    let first_y = g_y - y * vg * 16.0;
    let first_a = g_a + vg * 8.0;
    let second_yy = g_yy - vg * 16.0 - yv * g_y * 16.0 + yy * v * vg * 32.0 - yv * first_y * 16.0;
    let second_ya = g_ya - yv * (g_a + vg) * 16.0 + v * first_y * 8.0;
    let second_aa = g_aa + v * (g_a + vg) * 8.0 + v * first_a * 8.0;

    let v2 = v * v;
    let v3 = v2 * v;
    let v4 = v2 * v2;
    let attract = h * (half_space.hamaker_constant / (6.0 * std::f64::consts::PI));
    let repel = v4 * v4 * (attract * (r0_squared * r0_squared * r0_squared / 60.0));

    let energy = repel * y * g - y * v2 * attract;
    let by_y = repel * (g + y * first_y) - (v2 - yy * v3 * 4.0) * attract;
    let by_a = repel * y * first_a - y * v3 * (attract * 2.0);
    let yy2 = repel * (first_y * 2.0 + y * second_yy) - y * (yy * v4 * 24.0 - v3 * 12.0) * attract;
    let ya = repel * (first_a + y * second_ya) - (v3 * 2.0 - yy * v4 * 12.0) * attract;
    let aa2 = repel * y * second_aa - y * v4 * (attract * 6.0);

    let a_t = sin * cos * (h * h * -0.5);
    let a_tt = (cos - sin) * (cos + sin) * (h * h * -0.5);
    LineResponse {
        energy,
        by_gap: by_y,
        by_rotation: by_a * a_t,
        energy_by_rotation: by_a * a_t,
        gap_gap: yy2,
        gap_rotation: ya * a_t,
        rotation_gap: ya * a_t,
        rotation_rotation: aa2 * a_t * a_t + by_a * a_tt,
    }
}

/// The bottom face alone, Ψ = W(r1)/|cos θ|; singular where the section stands on edge.
#[inline(always)]
pub(super) fn near_face<T: Real>(half_space: &HalfSpace, height: T, gap: T, sin: T, cos: T) -> LineResponse<T> {
    let (s, c) = (cos.select(sin, -sin), cos.select(cos, -cos));
    let half = height * 0.5;
    let r1 = gap + one_minus(s, c) * half;
    let w = half_space.potential(r1);
    let t = half_space.traction(r1);
    let b = half_space.body_force(r1);
    let ic = c.recip();
    let tan = s * ic;
    let by_rotation = w * tan * ic - t * tan * half;
    let mixed = b * tan * half - t * s * ic * ic;
    LineResponse {
        energy: w * ic,
        by_gap: -t * ic,
        by_rotation,
        energy_by_rotation: by_rotation,
        gap_gap: b * ic,
        gap_rotation: mixed,
        rotation_gap: mixed,
        rotation_rotation: b * s * tan * (half * half) - t * (ic * ic + tan * tan) * half
            + w * (ic + tan * tan * ic * 2.0),
    }
}
