//! The other laws of adhesion: surface traction and cohesive laws on a tilted section.
//!
//! Reference: R. A. Sauer, Advances in the computational modeling of the gecko adhesion mechanism, eqs. (10)-(12); for the
//! cohesive laws their own definitions (`src/adhesion/section/cohesive/`).
//!
//!         ___/                θ: rotation of the section's middle line, h = 10 nm
//!     ___/  /                 surface traction: T(r1) cos θ on the bottom face, -T(r2) cos θ on the top face,
//!    /  y  /                  each at its own point of the section
//!   /_____/                   cohesive: the nominal traction -σ s(δ/δ_r) on the bottom face, δ = r1 - r_eq
//!  r1 ---------
//!
//! Parameters: A_H = 1e-19 J, r0 = 0.4 nm, so σ = 0.1236 GPa and w = 0.0307 J/m²; gaps from 0.2 to 1.5 nm, tilts from -160 to 170
//! degrees.
//!
//! Expected: every derivative is that of the number it belongs to, to the error of a difference of fourth order; a law that says it
//! has a potential has one, and the surface traction has none; force and moment are those of the tractions on the faces.

mod common;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use common::PAPER;
use peelkit::adhesion::{Cohesive, CohesiveShape, Law, LineLaw, LineLoad, LineResponse};
use peelkit::model::StripModel;
use peelkit::scene::Scene;

const SHAPES: &[CohesiveShape] = CohesiveShape::ALL;
const LOADS: [LineLoad; 3] = [LineLoad::Full, LineLoad::ForceOnly, LineLoad::AxisGap];
const GAPS: [f64; 6] = [0.2, 0.2547, 0.29, 0.41, 0.7, 1.5];
const DEGREES: [f64; 10] = [0.0, 0.4, 3.0, 11.0, 40.0, 83.0, -7.0, -30.0, 104.0, 170.0];

fn laws() -> Vec<LineLaw> {
    let cohesive = SHAPES
        .iter()
        .map(|&shape| Law::Cohesive(Cohesive::calibrated(shape, PAPER.strength(), PAPER.work_of_adhesion(), &PAPER)));
    let mut laws = Vec::new();
    for law in [Law::SurfaceTraction].into_iter().chain(cohesive) {
        for line_load in LOADS {
            for far_face in [true, false] {
                laws.push(LineLaw { half_space: PAPER, height: 10.0, law, line_load, far_face });
            }
        }
    }
    laws
}

fn at(law: &LineLaw, gap: f64, rotation: f64) -> LineResponse<f64> {
    let (sin, cos) = rotation.sin_cos();
    law.response(gap, sin, cos)
}

/// Slope by a central difference of fourth order.
fn slope(f: impl Fn(f64) -> f64, d: f64) -> f64 {
    (8.0 * (f(d) - f(-d)) - (f(2.0 * d) - f(-2.0 * d))) / (12.0 * d)
}

#[test]
fn derivatives_are_slopes() {
    for law in laws() {
        for (gap, degrees) in GAPS.into_iter().flat_map(|gap| DEGREES.map(|degrees| (gap, degrees))) {
            let rotation = degrees.to_radians();
            let here = at(&law, gap, rotation);
            // an axis-gap law that is blind to tilt has the largest slopes of all: 1e-3 of r0 is small beside its corners
            let by_gap = |of: &dyn Fn(LineResponse<f64>) -> f64| slope(|d| of(at(&law, gap + d, rotation)), 2e-5);
            let by_turn = |of: &dyn Fn(LineResponse<f64>) -> f64| slope(|d| of(at(&law, gap, rotation + d)), 4e-6);
            let close = |what: &str, computed: f64, difference: f64, size: f64| {
                let off = (computed - difference).abs();
                assert!(
                    off <= 1e-7 * size,
                    "{what} of {law:?} at {gap} nm, {degrees} degrees: {computed:e}, {difference:e}"
                );
            };
            close("by_gap", here.by_gap, by_gap(&|r| r.energy), 1.0);
            close("energy_by_rotation", here.energy_by_rotation, by_turn(&|r| r.energy), 5.0);
            close("gap_gap", here.gap_gap, by_gap(&|r| r.by_gap), 1e2);
            close("gap_rotation", here.gap_rotation, by_turn(&|r| r.by_gap), 5e2);
            close("rotation_gap", here.rotation_gap, by_gap(&|r| r.by_rotation), 5e2);
            close("rotation_rotation", here.rotation_rotation, by_turn(&|r| r.by_rotation), 2.5e3);
        }
    }
}

#[test]
fn a_law_with_a_potential_has_one() {
    for law in laws() {
        let has = matches!(law.law, Law::Cohesive(_)) && law.line_load == LineLoad::Full
            || law.line_load == LineLoad::AxisGap;
        assert_eq!(law.has_potential(), has, "{law:?}");
        let mut largest = 0.0f64;
        for (gap, degrees) in GAPS.into_iter().flat_map(|gap| DEGREES.map(|degrees| (gap, degrees))) {
            let here = at(&law, gap, degrees.to_radians());
            largest = largest.max((here.by_rotation - here.energy_by_rotation).abs());
            largest = largest.max((here.rotation_gap - here.gap_rotation).abs());
        }
        assert_eq!(largest < 1e-15, has, "{law:?}: {largest:e}");
    }
}

/// Force and moment of a section from the traction at the points of its faces.
#[test]
fn surface_traction_is_that_of_the_faces() {
    for far_face in [true, false] {
        let law =
            LineLaw { half_space: PAPER, height: 10.0, law: Law::SurfaceTraction, line_load: LineLoad::Full, far_face };
        for (gap, degrees) in GAPS.into_iter().flat_map(|gap| DEGREES.map(|degrees| (gap, degrees))) {
            let rotation = f64::to_radians(degrees);
            let here = at(&law, gap, rotation);
            let axis = gap + 5.0;
            // the face that looks down, then the other: how far it is along the section's normal, and which way it faces
            let looks_down = -rotation.cos().signum();
            let faces = [(looks_down, 1.0), (-looks_down, if far_face { -1.0 } else { 0.0 })];
            let (mut force, mut moment) = (0.0, 0.0);
            for (side, sign) in faces {
                let (x, y) = (-side * 5.0 * rotation.sin(), axis + side * 5.0 * rotation.cos());
                let one = sign * PAPER.traction(y) * rotation.cos().abs();
                force += one;
                moment += x * one;
            }
            assert_abs_diff_eq!(-here.by_gap, force, epsilon = 1e-12 * (1.0 + force.abs()));
            assert_abs_diff_eq!(-here.by_rotation, moment, epsilon = 1e-11 * (1.0 + moment.abs()));
        }
    }
}

/// A section that lies flat feels the same traction by every law that knows the half space; a cohesive one is as strong.
#[test]
fn flat_sections() {
    let flat = |law: Law, gap: f64| {
        let law = LineLaw { half_space: PAPER, height: 10.0, law, line_load: LineLoad::Full, far_face: true };
        -at(&law, gap, 0.0).by_gap
    };
    for gap in GAPS {
        let scale = PAPER.strength() * (0.3 / gap).powi(3).max((0.3 / gap).powi(9));
        assert_abs_diff_eq!(
            flat(Law::SurfaceTraction, gap),
            flat(Law::BodyForce, gap),
            epsilon = 1e-13 * scale.max(1.0)
        );
    }
    for &shape in SHAPES {
        let law = Cohesive::calibrated(shape, 0.05, 0.02, &PAPER);
        let largest =
            (1..4000).map(|k| -flat(Law::Cohesive(law), law.closed + 1e-3 * f64::from(k))).fold(0.0, f64::max);
        assert_relative_eq!(largest, 0.05, max_relative = 1e-4);
    }
}

#[test]
fn a_scene_says_which_law() {
    let text = "[strip]\nlength = \"100 nm\"\nheight = \"10 nm\"\nyoungs_modulus = \"2 GPa\"\n\
                [adhesion]\nhamaker_constant = \"1e-19 J\"\nequilibrium_distance = \"0.4 nm\"\n";
    let with = |more: &str| Scene::parse("law.toml", &format!("{text}{more}"), &[]);
    let law = |more: &str| with(more).unwrap().model.line_law().law;
    assert_eq!(law(""), Law::BodyForce);
    assert_eq!(law("law = \"surface-traction\""), Law::SurfaceTraction);
    let Law::Cohesive(bilinear) = law("law = \"bilinear\"\nwork = \"20 mJ/m2\"\nstrength = \"50 MPa\"") else {
        panic!("a bilinear law is a cohesive one")
    };
    assert_eq!((bilinear.shape, bilinear.strength), (CohesiveShape::Bilinear, 0.05));
    assert_relative_eq!(-bilinear.levels(bilinear.closed)[0], 0.02, max_relative = 1e-14);
    let error = with("work = \"0.02 J/m2\"").unwrap_err().to_string();
    assert!(error.contains("adhesion.work") && error.contains("cohesive"), "{error}");
    let error = with("law = \"bilinar\"").unwrap_err();
    assert!(format!("{error:?}").contains("bilinear"), "{error:?}");
}

/// The work of adhesion of a strip is that of its law: of a cohesive one all of it, of a body force what the height leaves.
#[test]
fn work_of_adhesion_of_a_strip() {
    let mut model = StripModel::of_the_paper(100.0, 1.0);
    for &shape in SHAPES {
        model.adhesion.attraction = peelkit::model::Attraction::Cohesive(shape);
        assert_relative_eq!(-model.line_law().rest_energy(), PAPER.work_of_adhesion(), max_relative = 1e-13);
    }
}
