//! Spatulae, and beams of any outline, on ground that is not flat.
//!
//! Reference: the flat spatula; the strip; a cylinder for a sphere, which in the plane is the same circle. (Against the strong form by
//! scipy's solve_bvp: verification/rough_spatula.csv, looked at in tests/checks/ground.rs.)
//!
//! ```text
//!                        ___/  shaft
//!      pad         _____/ neck
//!   ==============/
//!  ~~~\___/~~~\___/~~~\___/~~~  ground
//! ```
//!
//! Parameters: a small spatula, pad 80 nm long and 5 nm thick, and the default one; waves 50 and 100 nm long, circles of 50 nm.
//!
//! Expected: on a wave of no height, and on a circle of no curvature, the force of flat ground and all of it adhering; the same numbers on a
//! sphere as on a cylinder; a table of one section as the strip; no force where the path begins, whatever the grip holds and wherever it
//! pulls. Why: a pad that is bent over to the ground wrongly, or a shaft that is left behind, would still draw a curve.

use approx::assert_relative_eq;
use peelkit::adhesion::{BodyShape, Heights, Round, Sinusoid, Substrate};
use peelkit::model::{
    Body, Discretisation, Form, Ground, Hold, PeelModel, Profile, ProfileColumns, ProfileForm, ProfileTable, Spatula,
    Start, StripModel,
};
use peelkit::solve::InitialState;
use peelkit::study::{Accuracy, PathEnd, Peak, StopCriteria, TestEnd, observed, peel, prepared};
use std::sync::Arc;

const BOUNDS: StopCriteria = StopCriteria::after_points(20_000);

fn small() -> Spatula {
    Spatula {
        pad_length: 80.0,
        neck_length: 60.0,
        shaft_length: 150.0,
        bend_length: 30.0,
        tip_width: 60.0,
        neck_width: 20.0,
        shaft_diameter: 20.0,
        pad_thickness: 5.0,
        ..Spatula::default()
    }
}

fn on(substrate: Substrate, start: Start) -> PeelModel {
    let paper: PeelModel = StripModel::of_the_paper(1.0, 1.0).into();
    PeelModel { body: Body::Spatula(small()), ground: Ground { substrate, start }, ..paper }
}

fn wave(height: f64, wavelength: f64) -> Substrate {
    Substrate::Sinusoid(Sinusoid { height, wavelength, offset: 0.0 })
}

fn round(shape: BodyShape, radius: f64) -> Substrate {
    Substrate::Round(Round { shape, radius, offset: 40.0 })
}

fn first(model: &PeelModel, relative: f64) -> Peak {
    let peel = peel(model, &Accuracy::to(relative), &BOUNDS);
    peel.initiation_peak.unwrap_or_else(|| panic!("{:?}", peel.end))
}

/// In a free grip, which on flat ground begins elsewhere on the same path: free of stress, where the neck is not yet drawn down.
#[test]
fn ground_that_is_nearly_flat_is_flat_ground() {
    let run = |substrate| peel(&on(substrate, Start::Conformed), &Accuracy::to(1e-7), &BOUNDS);
    let flat = run(Substrate::Flat);
    let level = Heights::new(vec![-100.0, 150.0, 400.0], vec![0.0; 3]).unwrap();
    for substrate in [wave(1e-9, 50.0), round(BodyShape::Sphere, 1e13), Substrate::Profile(Arc::new(level))] {
        let found = run(substrate);
        let ((a, b), (c, d)) =
            ((found.peak.unwrap(), flat.peak.unwrap()), (found.snap_off.unwrap(), flat.snap_off.unwrap()));
        assert_relative_eq!(a.force, b.force, max_relative = 2e-7);
        assert_relative_eq!(c.force, d.force, max_relative = 2e-6);
        assert_relative_eq!(c.displacement - a.displacement, d.displacement - b.displacement, max_relative = 1e-5);
        let lies = found.contact(0).unwrap();
        assert_relative_eq!(lies.adhered_fraction, 1.0, epsilon = 1e-3);
        assert_relative_eq!(lies.energy_fraction, 1.0, epsilon = 1e-6);
    }
}

#[test]
fn a_sphere_is_a_cylinder_in_the_plane() {
    let [sphere, cylinder] = [BodyShape::Sphere, BodyShape::Cylinder].map(|shape| {
        let peak = first(&on(round(shape, 50.0), Start::Conformed), 1e-4);
        [peak.force, peak.displacement]
    });
    assert_eq!(sphere, cylinder);
}

/// A table of one section is a strip, on waves as well.
#[test]
fn a_table_of_one_section_is_the_strip() {
    let strip: PeelModel = StripModel::of_the_paper(100.0, 1.0).into();
    let columns = ProfileColumns {
        places: vec![0.0, 40.0, 100.0],
        widths: vec![1.0; 3],
        heights: vec![10.0; 3],
        ..Default::default()
    };
    let table = ProfileTable::new(columns).unwrap();
    let body = Body::Profile(Profile { form: ProfileForm::Table(table), material: strip.material() });
    for start in [Start::Conformed, Start::Crests] {
        let ground = Ground { substrate: wave(8.0, 100.0), start };
        let [a, b] = [&strip.body, &body].map(|body| {
            let model = PeelModel { body: body.clone(), ground: ground.clone(), ..strip.clone() };
            let bounds = StopCriteria { displacement: Some(2.0), ..BOUNDS };
            let peel = peel(&model, &Accuracy::to(1e-7), &bounds);
            (peel.initiation_peak.unwrap(), peel.contact(0).unwrap())
        });
        assert_relative_eq!(a.0.force, b.0.force, max_relative = 2e-7);
        assert_relative_eq!(a.0.displacement, b.0.displacement, max_relative = 2e-6);
        assert_relative_eq!(a.1.adhered_fraction, b.1.adhered_fraction, epsilon = 1e-3);
        assert_relative_eq!(a.1.energy_fraction, b.1.energy_fraction, epsilon = 1e-6);
    }
}

/// Where it starts nothing pulls, whatever the grip holds and however it is then pulled; pressed on and laid on as well.
#[test]
fn a_path_starts_without_a_force() {
    for (change, start) in [
        ((|_| ()) as fn(&mut PeelModel), Start::Crests),
        (|model| model.grip.rotation = Hold::Fixed, Start::Conformed),
        (|model| model.grip.horizontal = Hold::Fixed, Start::Conformed),
        (|model| model.pull.angle = 0.5, Start::Conformed),
        (|model| model.pull.angle = 2.5, Start::Crests),
    ] {
        let mut model = on(wave(2.0, 50.0), start);
        change(&mut model);
        let peel = peel(&model, &Accuracy::to(1e-5), &StopCriteria { displacement: Some(1.0), ..BOUNDS });
        assert!(matches!(peel.end, PathEnd::Bound(_)), "{:?}", peel.end);
        let point = peel.points[0];
        assert!(
            point.force.abs() < 1e-6 && point.displacement.abs() < 1e-12 && point.negative_eigenvalues == 0,
            "{point:?}"
        );
    }
}

/// Pressed on, no less of it adheres than laid on; on a wave too short for it to follow, less than on flat ground.
#[test]
fn how_it_lies_depends_on_how_it_came_there() {
    let lies = |substrate: Substrate, start| {
        let model = on(substrate, start);
        let peel = peel(&model, &Accuracy::to(1e-4), &StopCriteria { displacement: Some(0.05), ..BOUNDS });
        peel.contact(0).unwrap_or_else(|| panic!("{:?}", peel.end))
    };
    let (pressed, laid) = (lies(wave(4.0, 50.0), Start::Conformed), lies(wave(4.0, 50.0), Start::Crests));
    assert!(pressed.energy_fraction > laid.energy_fraction - 1e-9, "{pressed:?} {laid:?}");
    let sharp = lies(wave(4.0, 20.0), Start::Crests);
    assert!(sharp.adhered_fraction < 0.6, "{sharp:?}");
}

/// The gap below the pad is kept along the ground, and no part of the beam is within it.
#[test]
fn it_rests_off_the_ground() {
    for (substrate, start) in
        [(round(BodyShape::Cylinder, 60.0), Start::Conformed), (wave(3.0, 50.0), Start::Conformed)]
    {
        let how = Discretisation::moving(Form::TwoField, 7);
        let problem = prepared(&on(substrate, start), how, None).unwrap().problem;
        let InitialState::Known { at, .. } = &problem.start else { panic!("{:?}", problem.start) };
        assert!(
            problem.beam.nearest(at) > 0.5 * problem.beam.planar().unwrap().rest_gap,
            "{}",
            problem.beam.nearest(at)
        );
        assert!(problem.beam.grip_forces(at).vertical.abs() < 1e-7, "{:?}", problem.beam.grip_forces(at));
    }
}

#[test]
fn a_test_on_waves_balances() {
    let test = observed(&on(wave(2.0, 50.0), Start::Conformed), &Accuracy::to(1e-4), &BOUNDS).unwrap();
    assert!(!matches!(test.end, TestEnd::Failed(_)), "{:?}", test.end);
    assert!(!test.jumps.is_empty() && test.retreat.unwrap().error() < 1e-4, "{:?}", test.jumps);
}
