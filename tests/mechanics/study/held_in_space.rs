//! Bodies in space that their adhesive holds along the ground: `adhesion.shear_strength`.
//!
//! ```text
//!                  / P, sideways or oblique
//!   ______________/        a point of the face that has slipped by t, in any direction, is pulled back to where it was bonded
//!  ===============
//! ```
//!
//! A strip of 100 nm by 10 nm by 20 nm, 2 GPa, under a cohesive law of 0.03 J/m² and 10 MPa, and the default spatula. Expected from energy alone: w b L
//! of work to take all of a strip off, whatever the direction. A pull at a vanishing azimuth is that in the plane, which another element computes. A
//! spatula that is held has a larger peak the smaller the angle. What is not computed is refused. The effort is pinned.

use peelkit::adhesion::{Attraction, CohesiveShape};
use peelkit::beam::Material;
use peelkit::model::{Adhesion, Body, Grip, Hold, PeelModel, Pull, Space, Spatula, Strip};
use peelkit::study::{Accuracy, PathEnd, Peel, StopCriteria, peel};

const WORK: f64 = 0.03;
const WIDTH: f64 = 20.0;
const LENGTH: f64 = 100.0;

fn strip(shape: CohesiveShape, elevation: f64, azimuth: f64) -> PeelModel {
    let strip = Strip {
        length: LENGTH,
        height: 10.0,
        width: WIDTH,
        material: Material::of(2.0, 0.2),
        crack: None,
        layers: None,
    };
    let adhesion = Adhesion {
        attraction: Attraction::Cohesive(shape),
        work: Some(WORK),
        strength: Some(0.01),
        shear_strength: Some(0.01),
        ..Adhesion::default()
    };
    let model = PeelModel::of(Body::Strip(strip), adhesion, Grip::FREE);
    let pull = Pull { angle: elevation.to_radians(), ..model.pull };
    let space = Space { azimuth: azimuth.to_radians(), ..Space::default() };
    PeelModel { pull, space: Some(space), ..model }
}

fn peeled(model: &PeelModel, relative: f64) -> Peel {
    peel(model, &Accuracy::to(relative), &StopCriteria::default())
}

#[test]
fn all_work_goes_into_the_interface() {
    for (shape, elevation, azimuth) in [(CohesiveShape::Exponential, 60.0, 60.0), (CohesiveShape::Bilinear, 20.0, 30.0)]
    {
        let found = peeled(&strip(shape, elevation, azimuth), 1e-6);
        assert_eq!(found.end, PathEnd::Detached, "{shape:?}");
        let (work, expected) = (found.points.last().unwrap().work, WORK * WIDTH * LENGTH);
        // a face is off where a thousandth of its shear strength is left: with exp(-8.8) of its work
        assert!((0.0..1.5e-4).contains(&(1.0 - work / expected)), "{shape:?}: {work}, {expected}");
    }
}

#[test]
fn hardly_aside_it_is_the_strip_in_the_plane() {
    let [aside, plane] = [1e-4, 0.0].map(|azimuth| peeled(&strip(CohesiveShape::Exponential, 60.0, azimuth), 1e-6));
    let [one, other] = [&aside, &plane].map(|found| found.initiation_peak.unwrap());
    assert!((one.force - other.force).abs() < one.force_error + other.force_error, "{one:?} {other:?}");
    assert!((one.force / other.force - 1.0).abs() < 1e-9, "{one:?} {other:?}");
}

#[test]
fn a_spatula_holds_more_the_smaller_the_angle() {
    let model = |degrees: f64| {
        let free = Spatula::default().model();
        let adhesion = Adhesion {
            attraction: Attraction::Cohesive(CohesiveShape::Exponential),
            shear_strength: Some(0.02),
            ..free.adhesion
        };
        let pull = Pull { angle: degrees.to_radians(), ..free.pull };
        let grip = Grip { rotation: Hold::Fixed, ..free.grip };
        PeelModel { adhesion, pull, grip, space: Some(Space::default()), ..free }
    };
    let peaks = [90.0, 45.0, 20.0].map(|degrees| peeled(&model(degrees), 1e-4).peak.unwrap().force);
    // of one that slides, straight up: 6.686 nN
    assert!((6.4..6.7).contains(&peaks[0]), "{peaks:?}");
    assert!(peaks[1] > 3.0 * peaks[0] && peaks[2] > 3.0 * peaks[1], "{peaks:?}");
    let flat = PeelModel { space: None, ..model(90.0) };
    assert_eq!(flat.check().unwrap_err().key(), "adhesion.shear_strength");
}

/// A work of slip that is that of opening changes nothing, and at a vanishing azimuth two works are those of the strip in the plane.
#[test]
fn a_work_of_slip_of_its_own() {
    let peak = |azimuth: f64, work: Option<f64>| {
        let mut model = strip(CohesiveShape::Exponential, 60.0, azimuth);
        model.adhesion.shear_work = work;
        let found = peel(&model, &Accuracy::to(1e-6), &StopCriteria::after_points(40));
        found.limit_points.first().map(|point| point.force).unwrap()
    };
    assert_eq!(peak(60.0, Some(WORK)), peak(60.0, None));
    let [aside, plane] = [1e-4, 0.0].map(|azimuth| peak(azimuth, Some(3.0 * WORK)));
    assert!((aside / plane - 1.0).abs() < 1e-9, "{aside} {plane}");
}

/// With two works the work of the grip is summed up along the path. Of what opens and slips in every direction it lies between both works of the
/// whole strip.
#[test]
fn two_works_take_what_lies_between_them() {
    let mut model = strip(CohesiveShape::Exponential, 30.0, 60.0);
    model.adhesion.shear_work = Some(3.0 * WORK);
    let found = peeled(&model, 1e-4);
    assert_eq!(found.end, PathEnd::Detached);
    let share = found.points.last().unwrap().work / (WORK * WIDTH * LENGTH);
    assert!((1.0..3.0).contains(&share), "{share}");
}

#[test]
fn effort() {
    let found = peeled(&strip(CohesiveShape::Exponential, 60.0, 60.0), 1e-6);
    let effort = (found.effort.points, found.effort.newton_iterations, found.effort.elements);
    assert_eq!(effort, (113, 484, 48));
}
