//! By how much the force rises where the pull of a seta begins, against a cantilever on springs.
//!
//! ```text
//!                     ● root, moved along d, never turned
//!                   /
//!                 /   shaft, L = 70 µm, φ from the normal
//!               /
//!              ●  two tips on a brush of 20 nm, springs k along the normal and c along the ground
//!          ============
//! ```
//!
//! Reference: the compliance of a shaft that is clamped at its root, L³/(3EI) + L/(κGA) across it and L/(EA) along it, and that of the springs in
//! series: C = t t' L/(EA) + n n' (L³/(3EI) + L/(κGA)) + (n a' + a n') L²/(2EI) + a a' L/(EI) + diag(1/(2c), 1/(2k)), where a = (H, 0) is how far
//! the tips go as the end of the shaft turns. Free tips leave 1/C_yy along the normal; held ones d' C⁻¹ d.
//! Parameters: φ = 0, 30 and 60 degrees; k = 0.1 N/m; c = 0.05 N/m; d along the normal and inclined to both sides. Expected: to 1e-5, as the brush
//! is short and not rigid.

use super::setup::model;
use approx::assert_relative_eq;
use nalgebra::{Matrix2, Vector2};
use peelkit::model::{CurvePoint, NormalPull, PullCurve, Seta, SetaModel, Sideways};
use peelkit::study::{SetaLoading, SetaOptions, SetaPullOff, StopCriteria, pull_off};
use std::f64::consts::PI;
use std::sync::Arc;

const NORMAL: f64 = 0.1;
const ALONG: f64 = 0.05;

/// A tip whose force is NORMAL u as far as 50 nm.
fn linear() -> PullCurve {
    let known = [(-50.0, -5.0, NORMAL), (0.0, 0.0, NORMAL), (50.0, 5.0, NORMAL), (60.0, 5.5, 0.0), (64.0, 5.3, -0.2)];
    let point = |(displacement, force, slope): (f64, f64, f64)| CurvePoint { displacement, force, slope };
    PullCurve::new(known.map(point).to_vec(), -900.0).unwrap()
}

fn seta(angle: f64) -> Seta {
    Seta {
        forks: 1,
        tip_pitch: 20.0,
        brush_height: 20.0,
        brush_angle: 0.0,
        shaft_angle: angle.to_radians(),
        diameter_ratio: 0.9,
        height_scatter: 0.0,
        ..Seta::default()
    }
}

fn pulled(angle: f64, sideways: Sideways, direction: [f64; 3]) -> SetaPullOff {
    let model = model(seta(angle), sideways);
    let law = NormalPull { curve: linear(), sideways, contact_height: 0.0 };
    let model = SetaModel { law: Arc::new(law), ..model };
    let loading = SetaLoading::pull(direction, 20_000.0);
    pull_off(&model, &loading, &SetaOptions::default(), &StopCriteria::after_points(2)).unwrap()
}

/// C, nm/nN
fn compliance(angle: f64, along: f64) -> Matrix2<f64> {
    let Seta { shaft_length: l, shaft_diameter: d, brush_height, material, .. } = seta(angle);
    let (e, nu) = (material.youngs_modulus, material.poissons_ratio);
    let (area, inertia) = (PI * d * d / 4.0, PI * d.powi(4) / 64.0);
    let shear = material.shear_correction * e / (2.0 * (1.0 + nu)) * area;
    let (sin, cos) = angle.to_radians().sin_cos();
    let (t, n, a) = (Vector2::new(sin, cos), Vector2::new(cos, -sin), Vector2::new(brush_height, 0.0));
    let springs = Matrix2::from_diagonal(&Vector2::new(0.5 / along, 0.5 / NORMAL));
    let turned = (n * a.transpose() + a * n.transpose()) * (l * l / (2.0 * e * inertia))
        + a * a.transpose() * (l / (e * inertia));
    t * t.transpose() * (l / (e * area))
        + n * n.transpose() * (l.powi(3) / (3.0 * e * inertia) + l / shear)
        + turned
        + springs
}

#[test]
fn free_tips_leave_that_of_a_cantilever() {
    for angle in [0.0, 30.0, 60.0] {
        let found = pulled(angle, Sideways::Free, [0.0, 1.0, 0.0]).initial_stiffness.unwrap();
        assert_relative_eq!(found, 1.0 / compliance(angle, ALONG)[(1, 1)], max_relative = 1e-5);
    }
}

#[test]
fn held_tips_stiffen_a_pull_at_an_angle() {
    for degrees in [45f64, 90.0, 135.0] {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let found = pulled(60.0, Sideways::Held(ALONG), [cos, sin, 0.0]).initial_stiffness.unwrap();
        let d = Vector2::new(cos, sin);
        let known = (d.transpose() * compliance(60.0, ALONG).try_inverse().unwrap() * d)[0];
        assert_relative_eq!(found, known, max_relative = 1e-5);
    }
}
