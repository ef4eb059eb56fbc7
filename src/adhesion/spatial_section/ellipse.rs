//! The body force of eq. (9) summed over an ellipse that is tilted both ways, in closed form.
//!
//! The heights of an ellipse's points depend on the tilts through ρ² = (a² + c²)/4 alone, ρ the rise from the axis to
//! its highest point. With w² = y² - ρ² and z = ρ²/w² the energy per length is the integral of T over the ellipse,
//!
//!   Ψ = (π b h/4) A_H/(2π r0³) [ (r0/w)⁹/45 (1 + 27/4 z + 99/8 z² + 429/64 z³) - (r0/w)³/3 ].
//!
//! In a disc, b = h, it depends on the direction of the axis and not on a roll about it.

use super::even_power::EvenPower;
use super::response::SpatialSectionResponse;
use crate::adhesion::levels::half_space::HalfSpace;
use crate::number::Real;

/// The means of r⁻⁹ and r⁻³.
const REPEL: EvenPower<4> = EvenPower::new(4.5, [1.0, 27.0 / 4.0, 99.0 / 8.0, 429.0 / 64.0]);
const ATTRACT: EvenPower<1> = EvenPower::new(1.5, [1.0]);

/// ρ², v = 1/w², v^(9/2), v^(3/2) and what they are multiplied by.
#[inline(always)]
fn powers<T: Real>(half_space: &HalfSpace, area: T, y: T, a: T, c: T) -> ([T; 4], [T; 2]) {
    let e = (a * a + c * c) * 0.25;
    let v = (y * y - e).recip();
    let [root] = v.each(|v| [v.sqrt()]);
    let v2 = v * v;
    let r0_squared = half_space.equilibrium_distance * half_space.equilibrium_distance;
    let scale = area * half_space.hamaker_constant * 0.125;
    let repel = scale * r0_squared * r0_squared * r0_squared / T::splat(45.0);
    ([e, v, v2 * v2 * root, v * root], [repel, scale / T::splat(3.0)])
}

/// Ψ of an ellipse in a rectangle of this `area` b h, nm²; its lowest point, y - ρ, is above zero.
#[inline(always)]
pub(super) fn energy<T: Real>(half_space: &HalfSpace, area: T, y: T, a: T, c: T) -> T {
    let ([e, v, nine, three], [repel, attract]) = powers(half_space, area, y, a, c);
    REPEL.value(e, v, nine) * repel - ATTRACT.value(e, v, three) * attract
}

/// Ψ with gradient and Hessian.
#[inline(always)]
pub(super) fn response<T: Real>(half_space: &HalfSpace, area: T, y: T, a: T, c: T) -> SpatialSectionResponse<T> {
    let ([e, v, nine, three], [repel, attract]) = powers(half_space, area, y, a, c);
    let (r, t) = (REPEL.derivatives(y, e, v, nine), ATTRACT.derivatives(y, e, v, three));
    let [energy, by_y, by_e, by_yy, by_ye, by_ee] = std::array::from_fn(|k| r[k] * repel - t[k] * attract);
    let (a, c) = (a * 0.5, c * 0.5);
    SpatialSectionResponse {
        energy,
        gradient: [by_y, by_e * a, by_e * c],
        hessian: [by_yy, by_ye * a, by_ye * c, by_ee * a * a + by_e * 0.5, by_ee * a * c, by_ee * c * c + by_e * 0.5],
    }
}
