//! What several test files need: the strip of the paper, and the energies of law and section written a second time, for
//! dual numbers, in the form in which they are defined.

// every test file is a program of its own and uses a part of this
#![allow(dead_code)]

use num_dual::DualNum;
use peelkit::adhesion::{HalfSpace, Law, LineLaw, LineLoad};
use peelkit::beam::Section;
use peelkit::model::{Grip, Hold, StripModel};
use peelkit::study::{Accuracy, Bounds, Peel, peel};
use std::f64::consts::PI;

pub const LOADS: [LineLoad; 3] = [LineLoad::Full, LineLoad::ForceOnly, LineLoad::AxisGap];

/// A_H = 1e-19 J, r0 = 0.4 nm.
pub const PAPER: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };

/// The law of the paper's strip, h = 10 nm.
pub fn paper_law(line_load: LineLoad, far_face: bool) -> LineLaw {
    LineLaw { half_space: PAPER, height: 10.0, law: Law::BodyForce, line_load, far_face }
}

/// The paper's strip: h = 10 nm, width 1 nm, E = 2 GPa, nu = 0.2, both of the grip's other motions free.
///
/// `length` in nm; `factor` multiplies EI alone.
pub fn paper_strip(length: f64, factor: f64) -> StripModel {
    StripModel::of_the_paper(length, factor)
}

/// The same strip under another line load.
pub fn with_load(mut model: StripModel, line_load: LineLoad) -> StripModel {
    model.adhesion.line_load = line_load;
    model
}

/// The same strip in another grip.
pub fn with_grip(mut model: StripModel, rotation: Hold, horizontal: Hold) -> StripModel {
    model.grip = Grip { rotation, horizontal, ..model.grip };
    model
}

/// A whole peel without bounds that matter.
pub fn whole_peel(model: &StripModel, relative: f64) -> Peel {
    peel(model, &Accuracy::to(relative), &Bounds { points: 5000, time_s: None, displacement: None })
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
