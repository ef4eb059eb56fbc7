//! The line load of a tilted section above a half space.
//!
//! Reference: R. A. Sauer, Advances in the computational modeling of the gecko adhesion mechanism, eqs. (17)-(22).
//!
//!            r2 = y + (h/2) cos θ
//!         ___/
//!     ___/  /          θ: rotation of the section's middle line, h = 10 nm
//!    /  y  /
//!   /_____/            the substrate is the half space below
//!  r1 = y - (h/2) cos θ
//!  ------------------
//!
//! Parameters: A_H = 1e-19 J, r0 = 0.4 nm, h = 10 nm; gaps of the axis from 0.15 to 8 nm, tilts from -170 to 180 degrees.
//!
//! Expected: the paper's T_c and M_c; all first and second derivatives of Ψ; at 90 degrees, where the paper's form is 0/0,
//! the limit, taken from a form of Ψ without the quotient,
//!
//!   Ψ = (1/cos θ) ∫_{r1}^{r2} T(r) dr = ∫_{-h/2}^{h/2} T(y + s cos θ) ds.
//!
//! Why: all that follows is computed from these eight numbers, and Newton's method is only as good as the second ones.

use crate::common::{LOADS, PAPER, line_energy, paper_law, traction};
use gauss_quad::GaussLegendre;
use nalgebra::{SVector, vector};
use num_dual::{Dual2SVec64, DualNum, hessian};
use peelkit::adhesion::{LineLaw, LineLoad, LineResponse};
use std::f64::consts::PI;
use std::num::NonZeroUsize;

const GAPS: [f64; 8] = [0.15, 0.22, 0.2547, 0.3, 0.45, 1.0, 3.0, 8.0];

fn at_degrees(law: &LineLaw, gap: f64, degrees: f64) -> LineResponse<f64> {
    let (sin, cos) = degrees.to_radians().sin_cos();
    law.response(gap, sin, cos)
}

/// What round-off is measured against: the repulsive and the attractive part, added and not subtracted, and by how much
/// a derivative along the gap and along the rotation multiplies them.
struct Size {
    energy: f64,
    gap: f64,
    rotation: f64,
}

impl Size {
    fn of(law: &LineLaw, gap: f64, degrees: f64) -> Self {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let tilt = if law.line_load == LineLoad::AxisGap { 1.0 } else { cos.abs() };
        let r1 = gap + 0.5 * law.height * (1.0 - tilt);
        let q = law.half_space.equilibrium_distance / r1;
        let length = law.height.min(r1 / tilt.max(1e-300));
        let energy = law.half_space.potential_scale() * (q.powi(8) / 45.0 + q.powi(2) / 3.0) * length / r1;
        Self { energy, gap: 10.0 / r1, rotation: 1.0 + 5.0 * law.height / r1 + (sin / tilt.max(0.1)).abs() }
    }
}

#[track_caller]
fn assert_close(what: &str, computed: f64, expected: f64, allowed: f64) {
    assert!((computed - expected).abs() <= allowed, "{what}: {computed:e}, expected {expected:e} within {allowed:.1e}");
}

/// Compares a response with the value, gradient and Hessian of a potential in (gap, rotation).
#[track_caller]
fn assert_derivatives(
    law: &LineLaw,
    gap: f64,
    degrees: f64,
    (energy, gradient, hessian): (f64, SVector<f64, 2>, nalgebra::SMatrix<f64, 2, 2>),
    relative: f64,
) {
    let at = at_degrees(law, gap, degrees);
    let size = Size::of(law, gap, degrees);
    let moment = if law.line_load == LineLoad::ForceOnly { 0.0 } else { 1.0 };
    let close = |what: &str, computed: f64, expected: f64, factor: f64| {
        let allowed = relative * (size.energy * factor + expected.abs());
        assert_close(&format!("{what} of {law:?} at {gap} nm, {degrees} degrees"), computed, expected, allowed);
    };
    let (g, r) = (size.gap, size.rotation);
    close("energy", at.energy, energy, 1.0);
    close("by_gap", at.by_gap, gradient[0], g);
    close("energy_by_rotation", at.energy_by_rotation, gradient[1], r);
    close("by_rotation", at.by_rotation, moment * gradient[1], r);
    close("gap_gap", at.gap_gap, hessian[(0, 0)], g * g);
    close("gap_rotation", at.gap_rotation, hessian[(0, 1)], g * r);
    close("rotation_gap", at.rotation_gap, moment * hessian[(1, 0)], g * r);
    close("rotation_rotation", at.rotation_rotation, moment * hessian[(1, 1)], r * r);
}

/// T_c and M_c as the paper prints them, eqs. (17)-(22), per width. Beyond 90 degrees the face that stays when the far one
/// is left out is the one that then looks down.
fn paper_form(law: &LineLaw, gap: f64, degrees: f64) -> (f64, f64) {
    let turned = !law.far_face && degrees.to_radians().cos() < 0.0;
    let angle = degrees.to_radians() - if turned { PI } else { 0.0 };
    let (a_h, r0, half) = (law.half_space.hamaker_constant, law.half_space.equilibrium_distance, 0.5 * law.height);
    let factor = a_h / (2.0 * PI * r0.powi(3));
    let t = |r: f64| factor * ((r0 / r).powi(9) / 45.0 - (r0 / r).powi(3) / 3.0);
    let t_star = |r: f64| factor * ((r0 / r).powi(8) / 40.0 - (r0 / r).powi(2) / 2.0);
    let r_m = gap + half;
    let (r1, r2) = (r_m - half * angle.cos(), r_m + half * angle.cos());
    let far = if law.far_face { 1.0 } else { 0.0 };
    let t_c = (t(r1) - far * t(r2)) / angle.cos();
    let t_c_star = (t_star(r1) - far * t_star(r2)) / angle.cos();
    (t_c, (r_m * t_c - r0 * t_c_star) * angle.tan())
}

fn away_from_90() -> impl Iterator<Item = f64> {
    let steep = [0.0, 0.5, 5.0, 20.0, 45.0, 60.0, 75.0, 80.0, 100.0, 105.0, 130.0, 155.0, 170.0];
    steep.into_iter().chain(steep.map(|d| -d))
}

#[test]
fn load_is_the_papers() {
    for far_face in [true, false] {
        for degrees in away_from_90() {
            for gap in GAPS {
                let full = paper_law(LineLoad::Full, far_face);
                let (t_c, m_c) = paper_form(&full, gap, degrees);
                let size = Size::of(&full, gap, degrees);
                let (force, moment) = (1e-12 * size.energy * size.gap, 1e-12 * size.energy * size.rotation * 10.0);
                let at = at_degrees(&full, gap, degrees);
                let here = format!("far face {far_face}, {gap} nm, {degrees} degrees");
                assert_close(&format!("T_c, {here}"), -at.by_gap, t_c, force);
                assert_close(&format!("M_c, {here}"), -at.by_rotation, m_c, moment);

                let force_only = at_degrees(&paper_law(LineLoad::ForceOnly, far_face), gap, degrees);
                assert_close(&format!("T_c alone, {here}"), -force_only.by_gap, t_c, force);
                assert_eq!(force_only.by_rotation, 0.0, "force-only has no moment");

                // blind to tilt: the paper's traction of the flat section
                let (flat, _) = paper_form(&full, gap, 0.0);
                let axis_gap = at_degrees(&paper_law(LineLoad::AxisGap, far_face), gap, degrees);
                let flat_size = Size::of(&paper_law(LineLoad::AxisGap, far_face), gap, degrees);
                assert_close(
                    &format!("axis-gap, {here}"),
                    -axis_gap.by_gap,
                    flat,
                    1e-12 * flat_size.energy * flat_size.gap,
                );
                assert_eq!(axis_gap.by_rotation, 0.0, "axis-gap has no moment");
            }
        }
    }
}

#[test]
fn derivatives_are_those_of_the_defined_potential() {
    for (line_load, far_face) in LOADS.into_iter().flat_map(|load| [(load, true), (load, false)]) {
        let law = paper_law(line_load, far_face);
        for degrees in away_from_90() {
            for gap in GAPS {
                let oracle = hessian(
                    |v: SVector<Dual2SVec64<2>, 2>| line_energy(&law, v[0], v[1]),
                    &vector![gap, degrees.to_radians()],
                );
                assert_derivatives(&law, gap, degrees, oracle, 1e-11);
            }
        }
    }
}

/// ∫ T(y + s cos θ) ds over the section, by Gauss's rule on panels of equal ratio of their distances: for any tilt. The
/// points s stay while gap and rotation vary, so that dual numbers differentiate under the integral.
fn integrated<D: DualNum<f64> + Copy>(law: &LineLaw, gap: D, rotation: D) -> D {
    const PANELS: usize = 28;
    let rule = GaussLegendre::new(NonZeroUsize::new(14).expect("not zero"));
    let (h, cos) = (law.height, rotation.cos());
    let y = gap + 0.5 * h;
    let r1 = y.re() - 0.5 * h * cos.re();
    let end = |k: usize| {
        let part = k as f64 / PANELS as f64;
        let ratio = (h * cos.re() / r1).ln_1p();
        if ratio.abs() < 1e-12 { h * part } else { r1 * (ratio * part).exp_m1() / cos.re() }
    };
    let mut sum = D::zero();
    for k in 0..PANELS {
        let (from, to) = (end(k), end(k + 1));
        for &(node, weight) in rule.as_node_weight_pairs() {
            let s = 0.5 * (from + to) + 0.5 * (to - from) * node - 0.5 * h;
            sum += traction(&law.half_space, y + cos * s) * (0.5 * (to - from) * weight);
        }
    }
    sum
}

#[test]
fn derivatives_are_those_of_the_integral_at_every_tilt() {
    let near_90 = [-1e-1, -1e-3, -1e-5, -1e-8, -1e-12, 0.0, 1e-12, 1e-8, 1e-5, 1e-3, 1e-1].map(|d| 90.0 + d);
    let coarse = (0..=36).map(|k| 5.0 * f64::from(k));
    for line_load in [LineLoad::Full, LineLoad::ForceOnly] {
        let law = paper_law(line_load, true);
        for degrees in coarse.clone().chain(near_90).chain(near_90.map(|d| -d)) {
            for gap in GAPS {
                let oracle = hessian(
                    |v: SVector<Dual2SVec64<2>, 2>| integrated(&law, v[0], v[1]),
                    &vector![gap, degrees.to_radians()],
                );
                assert_derivatives(&law, gap, degrees, oracle, 1e-11);
            }
        }
    }
}

/// Upright the whole height is at one distance y: Ψ = h T(y), T_c = h b(y), and the moment vanishes by symmetry.
#[test]
fn upright_section_feels_its_height_times_the_body_force() {
    let law = paper_law(LineLoad::Full, true);
    for gap in GAPS {
        let at = law.response(gap, 1.0, 0.0);
        let y = gap + 5.0;
        assert_close("Ψ", at.energy, 10.0 * PAPER.traction(y), 1e-14 * at.energy.abs());
        assert_close("T_c", -at.by_gap, 10.0 * PAPER.body_force(y), 1e-14 * at.by_gap.abs());
        assert_eq!(at.by_rotation, 0.0);
    }
}

/// A section and the same section turned over are one: even about 90 degrees and about 0.
#[test]
fn even_in_the_cosine_and_in_the_tilt() {
    for (line_load, far_face) in LOADS.into_iter().flat_map(|load| [(load, true), (load, false)]) {
        let law = paper_law(line_load, far_face);
        for degrees in [0.0f64, 10.0, 50.0, 85.0, 89.999] {
            let (sin, cos) = degrees.to_radians().sin_cos();
            for gap in GAPS {
                let at = law.response(gap, sin, cos);
                let size = Size::of(&law, gap, degrees);
                for (mirrored, sign) in [
                    (law.response(gap, sin, -cos), -1.0),
                    (law.response(gap, -sin, cos), -1.0),
                    (law.response(gap, -sin, -cos), 1.0),
                ] {
                    // the near face alone grows like 1/cos³ towards 90 degrees
                    let steep = if far_face { 1.0 } else { cos.powi(-3) };
                    let close = |a: f64, b: f64, factor: f64| {
                        let allowed = 1e-12 * size.energy * factor * steep;
                        assert!((a - b).abs() <= allowed, "{law:?} at {gap} nm, {degrees} degrees: {a:e} and {b:e}");
                    };
                    close(mirrored.energy, at.energy, 1.0);
                    close(mirrored.by_gap, at.by_gap, size.gap);
                    close(mirrored.by_rotation, sign * at.by_rotation, size.rotation);
                    close(mirrored.energy_by_rotation, sign * at.energy_by_rotation, size.rotation);
                    close(mirrored.gap_gap, at.gap_gap, size.gap.powi(2));
                    close(mirrored.gap_rotation, sign * at.gap_rotation, size.gap * size.rotation);
                    close(mirrored.rotation_gap, sign * at.rotation_gap, size.gap * size.rotation);
                    close(mirrored.rotation_rotation, at.rotation_rotation, size.rotation.powi(2));
                }
            }
        }
    }
}

#[test]
fn rest_is_where_the_force_vanishes_and_costs_the_work_of_adhesion() {
    for line_load in LOADS {
        for height in [0.5, 2.0, 10.0, 40.0] {
            let near = LineLaw { height, ..paper_law(line_load, false) };
            assert_close("r_eq", near.rest_gap(), 0.4 * 15f64.powf(-1.0 / 6.0), 1e-15);
            assert_close("w_adh", -near.rest_energy(), PAPER.work_of_adhesion(), 1e-16);
            assert_eq!((-near.rest_energy() * 1e4).round() / 1e4, 0.0307, "the paper's footnote 5, J/m²");

            let far = LineLaw { height, ..paper_law(line_load, true) };
            let (gap, at) = (far.rest_gap(), far.response(far.rest_gap(), 0.0, 1.0));
            assert_close("T_c at rest", at.by_gap, 0.0, 4.0 * f64::EPSILON * gap * at.gap_gap);
            // the top face's attraction is missing below: the section lies higher, by the shift to first order
            let top = PAPER.traction(gap + height);
            assert!(gap > near.rest_gap() && gap < PAPER.strongest_gap());
            let shift = -top / near.response(near.rest_gap(), 0.0, 1.0).gap_gap;
            let second_order = 12.0 * (shift / near.rest_gap()).powi(2);
            assert_close("shift of the rest gap", gap - near.rest_gap(), shift, second_order * gap + 1e-15);
            assert!(-far.rest_energy() < PAPER.work_of_adhesion(), "less to peel than a half space");
        }
    }
}
