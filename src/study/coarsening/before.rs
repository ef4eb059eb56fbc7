//! A branch before its begin: an energy of u, v and θ that goes on from there as a function that is twice differentiable, once where it decays.
//!
//! With U, U_s, U_ss and Ê, Ê_s, Ê_ss at s = 0, all functions of v and θ, and w = u - U,
//!
//!   P0 = Ê_s/U_s,  K0 = (Ê_ss - P0 U_ss)/U_s².
//!
//! Pressed farther than the table goes, the tip is as stiff as where that begins: E = Ê + P0 w + ½ K0 w². Farther away than where the detached
//! branch begins, its attraction falls off to zero: E = Ê (1 + w P0/(3 Ê))³ up to where that is zero.

use super::jet::Jet;

/// The displacement less that at the begin.
fn beyond(begin: Jet, normal: f64) -> Jet {
    Jet::coordinate(normal, 0) - begin
}

/// With the stiffness at the begin: of U and Ê with their derivatives by s.
pub(super) fn straight(u: [Jet; 3], e: [Jet; 3], normal: f64) -> Jet {
    let force = e[1] / u[1];
    let stiffness = (e[2] - force * u[2]) / (u[1] * u[1]);
    let w = beyond(u[0], normal);
    e[0] + (force + stiffness * w * 0.5) * w
}

/// Down to zero.
pub(super) fn decaying(u: [Jet; 3], e: [Jet; 3], normal: f64) -> Jet {
    let share = beyond(u[0], normal) * (e[1] / u[1]) / (e[0] * 3.0);
    let left = Jet { value: 1.0 + share.value, ..share };
    // none is left, and where there is no attraction none was
    if left.value > 0.0 && left.value <= 1.0 { e[0] * left.cube() } else { Jet::default() }
}
