//! What several topics need: the strip of the paper, and the energies of law and section written a second time, for dual
//! numbers, in the form in which they are defined.

#[path = "../shared/strip.rs"]
mod strip;

pub use strip::{paper_strip, whole_peel, with_grip, with_load};

use num_dual::DualNum;
use peelkit::adhesion::{HalfSpace, Law, LineLaw, LineLoad};
use peelkit::beam::Section;
use std::f64::consts::PI;

pub const LOADS: [LineLoad; 3] = [LineLoad::Full, LineLoad::ForceOnly, LineLoad::AxisGap];

/// A_H = 1e-19 J, r0 = 0.4 nm.
pub const PAPER: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };

/// The law of the paper's strip, h = 10 nm.
pub fn paper_law(line_load: LineLoad, far_face: bool) -> LineLaw {
    LineLaw { half_space: PAPER, height: 10.0, law: Law::BodyForce, line_load, far_face }
}

/// T(r), eq. (18), nN/nm².
pub fn traction<D: DualNum<f64> + Copy>(h: &HalfSpace, r: D) -> D {
    let q = r.recip() * h.equilibrium_distance;
    (q.powi(9) / 45.0 - q.powi(3) / 3.0) * (h.hamaker_constant / (2.0 * PI * h.equilibrium_distance.powi(3)))
}

/// W(r), the integral of T from r to infinity, nN/nm.
pub fn potential<D: DualNum<f64> + Copy>(h: &HalfSpace, r: D) -> D {
    let q = r.recip() * h.equilibrium_distance;
    (q.powi(8) / 360.0 - q.powi(2) / 6.0) * (h.hamaker_constant / (2.0 * PI * h.equilibrium_distance.powi(2)))
}

/// Ψ(η, θ) = [W(r1) - W(r2)]/cos θ as it is defined, for cos θ != 0; r1 is the lower edge on either side of 90 degrees.
pub fn line_energy<D: DualNum<f64> + Copy>(law: &LineLaw, gap: D, rotation: D) -> D {
    let (h, half) = (&law.half_space, 0.5 * law.height);
    let tilt = if law.line_load == LineLoad::AxisGap { D::one() } else { rotation.cos() };
    let cos = if tilt.re() < 0.0 { -tilt } else { tilt };
    let lower = potential(h, gap + (-cos + 1.0) * half);
    let upper = if law.far_face { potential(h, gap + (cos + 1.0) * half) } else { D::zero() };
    (lower - upper) / cos
}

/// ½EA Γ1² + ½GA_s Γ2² + ½EI κ², nN.
pub fn stored_energy<D: DualNum<f64> + Copy>(section: &Section, rotation: D, dx: D, dy: D, curvature: D) -> D {
    let (sin, cos) = rotation.sin_cos();
    let (stretch, slide) = (dx * cos + dy * sin - 1.0, dy * cos - dx * sin);
    (stretch.powi(2) * section.axial + slide.powi(2) * section.shear + curvature.powi(2) * section.bending) * 0.5
}
