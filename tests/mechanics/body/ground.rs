//! Strips on ground that is not flat.
//!
//! Reference: differences of the energy and of the gradient; verification/rough.csv, the strong form by scipy's solve_bvp; the flat
//! strip; a finer run.
//!
//! Parameters: the paper's strip (h = 10 nm, E = 2 GPa) and thicker ones, waves 8 nm high and 100 nm long.
//!
//! Expected: tangents as differences; a wave of 1e-9 nm as flat ground; the equilibrium without a force where the path starts, u = P = 0
//! there; two such equilibria of a strip of 20 nm, one of 10 nm; errors below their bounds. Why: a strip that slides off its
//! start, or a force without a potential, would still draw a curve.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use peelkit::adhesion::{BodyShape, GroundLaw, Heights, Ridge, Round, Sinusoid, Substrate};
use peelkit::beam::{BeamOnGround, EnergyDensity, Profile};
use peelkit::model::{Discretisation, Form, Ground, Hold, PeelModel, Start, StripModel};
use peelkit::solve::InitialState;
use peelkit::study::{Accuracy, PathEnd, Peel, StopCriteria, TestEnd, observed, peel, prepared};
use std::sync::Arc;

const BOUNDS: StopCriteria = StopCriteria::after_points(20_000);
const NEAR: StopCriteria = StopCriteria::up_to(2.0);

fn wave(height: f64, wavelength: f64, offset: f64) -> Substrate {
    Substrate::Sinusoid(Sinusoid { height, wavelength, offset })
}

fn strip(length: f64, thickness: f64, substrate: Substrate, start: Start) -> PeelModel {
    let mut strip = StripModel::of_the_paper(length, 1.0);
    strip.strip.height = thickness;
    PeelModel { ground: Ground { substrate, start }, ..strip.into() }
}

/// Gradient and tangent of the density by values, at tilts and gaps of every size.
#[test]
fn tangents_are_differences() {
    let strip = StripModel::of_the_paper(100.0, 1.0);
    let heights = Heights::new(vec![0.0, 15.0, 30.0, 40.0, 60.0], vec![0.0, 3.0, -2.0, 1.0, 0.0]).unwrap();
    let round = Round { shape: BodyShape::Sphere, radius: 30.0, offset: 20.0 };
    for substrate in
        [wave(8.0, 100.0, 3.0), wave(5.0, 30.0, 1.0), Substrate::Round(round), Substrate::Profile(Arc::new(heights))]
    {
        let ground = GroundLaw { law: strip.line_law(), substrate: substrate.clone() };
        let beam = BeamOnGround { profile: Profile::uniform(strip.section(), 1.0, 10.0), ground, friction: None };
        let slopes = [-0.03, 0.2, 0.01];
        for (x, gap, rotation) in [(17.3, 0.26, 0.1), (22.0, 0.3, -0.2), (33.3, 0.5, 0.7), (28.1, 2.0, -1.2)] {
            let value = [x, substrate.above(x, 5.0 + gap) - 5.0, rotation];
            let at = |value: [f64; 3]| beam.response(0.0, value, slopes, 0.0);
            let here = at(value);
            for g in 0..3 {
                let step = 2e-4;
                let moved = |k: f64| at(std::array::from_fn(|f| value[f] + if f == g { k * step } else { 0.0 }));
                let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(moved);
                let slope = |pick: &dyn Fn(&peelkit::beam::PointResponse<f64, 3>) -> f64| {
                    (8.0 * (pick(&c) - pick(&b)) - (pick(&d) - pick(&a))) / (12.0 * step)
                };
                assert_abs_diff_eq!(slope(&|r| r.energy), here.by_value[g], epsilon = 1e-8);
                assert_abs_diff_eq!(slope(&|r| r.adhesion), here.coverage_by_value[g], epsilon = 1e-8);
                for f in 0..3 {
                    let size = here.value_value[f][g].abs().max(1.0);
                    assert_abs_diff_eq!(slope(&|r| r.by_value[f]), here.value_value[f][g], epsilon = 1e-6 * size);
                    assert_abs_diff_eq!(slope(&|r| r.by_slope[f]), here.slope_value[f][g], epsilon = 1e-7 * size);
                    assert_abs_diff_eq!(here.value_value[f][g], here.value_value[g][f], epsilon = 1e-12 * size);
                }
            }
        }
    }
}

#[test]
fn a_wave_of_no_height_is_flat_ground() {
    let first = |model: &PeelModel| peel(model, &Accuracy::to(1e-7), &NEAR).initiation_peak.unwrap();
    let flat = first(&StripModel::of_the_paper(100.0, 1.0).into());
    for substrate in [
        wave(1e-9, 100.0, 0.0),
        Substrate::Round(Round { shape: BodyShape::Sphere, radius: 1e13, offset: 0.0 }),
        Substrate::Ridge(Ridge { radius: 1e13, offset: 0.0 }),
        Substrate::Profile(Arc::new(Heights::new(vec![0.0, 50.0, 120.0], vec![0.0; 3]).unwrap())),
    ] {
        let found = first(&strip(100.0, 10.0, substrate, Start::Conformed));
        assert_relative_eq!(found.force, flat.force, max_relative = 2e-7);
        assert_relative_eq!(found.displacement, flat.displacement, max_relative = 2e-6);
    }
}

/// Within a contact much shorter than its radius a parabola is its circle.
#[test]
fn a_wide_ridge_is_a_cylinder() {
    let round = Round { shape: BodyShape::Cylinder, radius: 1e5, offset: 20.0 };
    let ridge = Ridge { radius: round.radius, offset: round.offset };
    let [cylinder, ridge] = [Substrate::Round(round), Substrate::Ridge(ridge)].map(|substrate| {
        peel(&strip(60.0, 10.0, substrate, Start::Conformed), &Accuracy::to(1e-6), &NEAR).initiation_peak.unwrap()
    });
    assert_relative_eq!(ridge.force, cylinder.force, max_relative = 1e-5);
    assert_relative_eq!(ridge.displacement, cylinder.displacement, max_relative = 1e-5);
}

fn energy_at_start(model: &PeelModel) -> f64 {
    let problem = prepared(model, Discretisation::moving(Form::TwoField, 7), None).unwrap().problem;
    let InitialState::Known { at, .. } = &problem.start else { panic!("{:?}", problem.start) };
    assert_eq!((at.force, problem.displacement(at)), (0.0, 0.0));
    problem.beam.planar().unwrap().chain.energy(problem.beam.planar().unwrap().configuration(at), &at.values).0.total
}

/// A thin strip follows the ground, however it came there; a thick one stays on the crests, or in the valley once it is pressed
/// there.
#[test]
fn a_thick_strip_has_two_equilibria() {
    let start = |thickness, start| energy_at_start(&strip(200.0, thickness, wave(8.0, 100.0, 0.0), start));
    assert_relative_eq!(start(10.0, Start::Conformed), start(10.0, Start::Crests), max_relative = 1e-9);
    let (pressed, laid) = (start(20.0, Start::Conformed), start(20.0, Start::Crests));
    assert!(pressed > laid + 1.0 && laid < 0.0, "{pressed} {laid}");

    let lies = |thickness, start| {
        let model = strip(200.0, thickness, wave(8.0, 100.0, 0.0), start);
        peel(&model, &Accuracy::to(1e-4), &StopCriteria { displacement: Some(0.05), ..BOUNDS }).contact(0).unwrap()
    };
    let (thin, thick) = (lies(10.0, Start::Crests), lies(20.0, Start::Crests));
    assert!(thin.adhered_fraction > 0.99 && thin.penetration.unwrap() > 0.98, "{thin:?}");
    assert!(thick.adhered_fraction < 0.5 && thick.penetration.unwrap() < 0.2 && thick.largest_gap > 6.0, "{thick:?}");
    assert_eq!(thin.sharp(), None);
}

/// Where it starts nothing pulls, whatever the grip holds and however it is then pulled.
#[test]
fn a_path_starts_without_a_force() {
    let first = |change: fn(&mut PeelModel)| {
        let mut model = strip(60.0, 10.0, wave(8.0, 100.0, 20.0), Start::Conformed);
        change(&mut model);
        let peel = peel(&model, &Accuracy::to(1e-5), &StopCriteria { displacement: Some(0.3), ..BOUNDS });
        assert!(matches!(peel.end, PathEnd::Bound(_)), "{:?}", peel.end);
        peel.points[0]
    };
    for change in [
        |_: &mut PeelModel| (),
        |model: &mut PeelModel| model.grip.rotation = Hold::Fixed,
        |model: &mut PeelModel| model.grip.horizontal = Hold::Fixed,
        |model: &mut PeelModel| model.pull.angle = 1.0,
    ] {
        let point = first(change);
        assert!(
            point.force.abs() < 1e-7 && point.displacement.abs() < 1e-12 && point.negative_eigenvalues == 0,
            "{point:?}"
        );
    }
}

/// What is reported of a whole path on more elements and with a finer tolerance: nowhere farther off than its bound.
#[test]
fn errors_are_below_their_bounds() {
    let model = strip(100.0, 10.0, wave(8.0, 100.0, 0.0), Start::Conformed);
    let run = |relative: f64| -> Peel { peel(&model, &Accuracy::to(relative), &BOUNDS) };
    let (coarse, fine) = (run(1e-5), run(1e-8));
    assert_eq!((&coarse.end, coarse.limit_points.len()), (&PathEnd::Pivoting, fine.limit_points.len()));
    for (a, b) in coarse.limit_points.iter().zip(&fine.limit_points) {
        assert!((a.force - b.force).abs() <= a.force_error + b.force_error, "{a:?} {b:?}");
        assert!((a.displacement - b.displacement).abs() <= a.displacement_error + b.displacement_error, "{a:?} {b:?}");
    }
}

/// A test jumps from valley to valley, and its work is the change of energy and what the jumps release.
#[test]
fn a_test_on_waves_balances() {
    let mut model = strip(100.0, 10.0, wave(8.0, 100.0, 0.0), Start::Conformed);
    model.grip.rotation = Hold::Fixed;
    let test = observed(&model, &Accuracy::to(1e-5), &BOUNDS).unwrap();
    assert!(!matches!(test.end, TestEnd::Failed(_)), "{:?}", test.end);
    assert!(test.jumps.len() > 1 && test.retreat.unwrap().error() < 1e-5, "{:?}", test.jumps);
}

/// Ground sharper than the half space can stand for is told.
#[test]
fn sharp_ground_is_warned_of() {
    let round = Round { shape: BodyShape::Sphere, radius: 6.0, offset: 0.0 };
    let model = strip(20.0, 10.0, Substrate::Round(round), Start::Crests);
    let contact =
        peel(&model, &Accuracy::to(1e-4), &StopCriteria { displacement: Some(0.05), ..BOUNDS }).contact(0).unwrap();
    assert_relative_eq!(contact.sharp().unwrap(), 6.0, max_relative = 1e-12);
    // to first order 1.5 d/R of a sphere's attraction is lost, d = 5^(-1/6) r0 = 0.306 nm; the repulsion changes less
    assert!((-0.15..-0.05).contains(&contact.crest_error.unwrap()), "{contact:?}");
}
