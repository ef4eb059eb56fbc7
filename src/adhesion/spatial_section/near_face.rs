//! The body force of eq. (9) with the lower face alone, Ψ = W(r1)/|cos θ| in the plane, averaged over the width, in
//! closed form.
//!
//! With 1/|cos θ| = h/|c| and the face at r + s a, r = y - |c|/2, s from -1/2 to 1/2,
//!
//!   Ψ = (b h/|c|) ∫ W(r + s a) ds = b h [V(r - a/2) - V(r + a/2)] / (a |c|):
//!
//! of the four corners of the rectangle the two of the face that looks down. With e = a²/4, v = 1/(r² - e) and z = e v
//! the means over the width are v⁴ (1 + 8 z + 16 z² + 64/7 z³) of r⁻⁸ and v of r⁻². There is a pole at c = 0, as in the
//! plane.

use super::even_power::EvenPower;
use super::response::SpatialSectionResponse;
use crate::adhesion::levels::half_space::HalfSpace;
use crate::number::Real;

const REPEL: EvenPower<4> = EvenPower::new(4.0, [1.0, 8.0, 16.0, 64.0 / 7.0]);
const ATTRACT: EvenPower<1> = EvenPower::new(1.0, [1.0]);

/// Ψ of a rectangle of this `area`, nm², with gradient and Hessian; the lowest corner, y - (|a| + |c|)/2, is above
/// zero.
#[inline(always)]
pub(super) fn response<T: Real>(half_space: &HalfSpace, area: T, y: T, a: T, c: T) -> SpatialSectionResponse<T> {
    let side = c.select(T::splat(1.0), T::splat(-1.0));
    let k = c * side;
    let (r, e) = (y - k * 0.5, a * a * 0.25);
    let v = (r * r - e).recip();
    let v2 = v * v;
    let r0_squared = half_space.equilibrium_distance * half_space.equilibrium_distance;
    let attract = area * (half_space.potential_scale() * r0_squared) / T::splat(6.0);
    let repel = attract * r0_squared * r0_squared * r0_squared / T::splat(60.0);
    let (p, q) = (REPEL.derivatives(r, e, v, v2 * v2), ATTRACT.derivatives(r, e, v, v));
    let inverse = k.recip();
    let [m, m_r, m_e, m_rr, m_re, m_ee] = std::array::from_fn(|i| (p[i] * repel - q[i] * attract) * inverse);
    let half = a * 0.5;
    SpatialSectionResponse {
        energy: m,
        gradient: [m_r, m_e * half, -(m * inverse + m_r * 0.5) * side],
        hessian: [
            m_rr,
            m_re * half,
            -(m_r * inverse + m_rr * 0.5) * side,
            m_ee * half * half + m_e * 0.5,
            -(m_e * inverse + m_re * 0.5) * half * side,
            (m * inverse * 2.0 + m_r) * inverse + m_rr * 0.25,
        ],
    }
}
