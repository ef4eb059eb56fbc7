//! A strip that its adhesive holds along the substrate: `adhesion.shear_strength`.
//!
//! ```text
//!            / P
//!   ________/ α         what has slipped by t carries the shear traction 2 w t/δ_t² exp(-t²/δ_t²)
//!  =========            over the shear lag length (EA/(b k))^(1/2)
//! ```
//!
//! The tape is 20 mm by 50 µm by 20 mm, 2 GPa, under an exponential law of 100 J/m² and 1 MPa. Expected, whatever the shear strength, from energy alone:
//! Kendall's force P (1 - cos α) + P²/(2EA) = w b where it peels steadily, (2 EA w b)^(1/2) where it is pulled along itself, and w b L of work to take
//! all of it off. A strip that slides peels at another force. With a work of slip of its own, w_t, it peels between Kendall's forces of both works, and
//! fails at (2 EA w_t b)^(1/2) where it is pulled along itself; all that works is summed up, and lies between the works of both. The effort is pinned.

use super::steady_force::at;
use peelkit::adhesion::{Attraction, CohesiveShape};
use peelkit::beam::Material;
use peelkit::model::{Adhesion, Body, Grip, PeelModel, Strip};
use peelkit::study::{Accuracy, FollowedUntil, NotOutOfPlane, PathEnd, Peel, StopCriteria, peel};

const WORK: f64 = 100.0;
const WIDTH: f64 = 2e7;
const LENGTH: f64 = 2e7;

fn tape(shear_strength: f64) -> PeelModel {
    let strip = Strip {
        length: LENGTH,
        height: 5e4,
        width: WIDTH,
        material: Material::of(2.0, 0.35),
        crack: None,
        layers: None,
    };
    let law = Adhesion {
        attraction: Attraction::Cohesive(CohesiveShape::Exponential),
        work: Some(WORK),
        strength: Some(1e-3),
        shear_strength: Some(shear_strength),
        ..Adhesion::default()
    };
    let equilibrium_distance = law.distance_of_work_and_strength().unwrap();
    PeelModel::of(Body::Strip(strip), Adhesion { equilibrium_distance, ..law }, Grip::FREE)
}

fn with_shear_work(model: PeelModel, shear_work: f64) -> PeelModel {
    let adhesion = Adhesion { shear_work: Some(shear_work), ..model.adhesion };
    PeelModel { adhesion, ..model }
}

fn peeled(model: &PeelModel) -> Peel {
    peel(model, &Accuracy::to(1e-6), &StopCriteria::default())
}

#[test]
fn the_steady_force_is_kendalls_whatever_the_shear_strength() {
    for (degrees, strength) in [(45.0, 1e-3), (45.0, 1e-2), (60.0, 5e-4), (90.0, 1e-3), (120.0, 1e-3)] {
        let model = at(tape(strength), degrees);
        let derived = model.derived().section.unwrap();
        assert_eq!(derived.sliding_force, None);
        let plateau = peeled(&model).plateau.unwrap();
        let off = (plateau.force / derived.kendall_force - 1.0).abs();
        assert!(off < 1e-6, "{degrees} degrees, {strength} GPa: {plateau:?}, {}", derived.kendall_force);
    }
}

/// A long lap joint fails by what its stretch releases.
#[test]
fn a_lap_joint_fails_at_the_force_of_its_energy() {
    let mut model = at(tape(1e-3), 0.0);
    let Body::Strip(strip) = &mut model.body else { unreachable!() };
    strip.length *= 2.0;
    let axial = model.section().axial;
    // behind its peak it lets go at once
    let stop = StopCriteria { until: FollowedUntil::FirstJump, ..StopCriteria::default() };
    let peak_of = |model: &PeelModel| peel(model, &Accuracy::to(1e-6), &stop).initiation_peak.unwrap();
    let peak = peak_of(&model);
    let expected = (2.0 * axial * WORK * WIDTH).sqrt();
    assert!((peak.force / expected - 1.0).abs() < 1e-9, "{peak:?}, {expected}");
    // of the work in shear, where it has one
    for shear_work in [50.0, 300.0] {
        let tough = with_shear_work(model.clone(), shear_work);
        let peak = peak_of(&tough);
        let expected = (2.0 * axial * shear_work * WIDTH).sqrt();
        // the load is off the face, so that the end opens by a millionth: towards the force of the other work
        let off = (peak.force / expected - 1.0) * (WORK - shear_work).signum();
        assert!((0.0..2e-6).contains(&off), "{shear_work}: {peak:?}, {expected}");
    }
    model.adhesion.shear_strength = None;
    assert_eq!(model.check().unwrap_err().key(), "drive.angle");
}

#[test]
fn all_work_goes_into_the_interface() {
    for degrees in [30.0, 45.0] {
        let found = peeled(&at(tape(1e-3), degrees));
        assert_eq!(found.end, PathEnd::Detached);
        let work = found.points.last().unwrap().work;
        let expected = WORK * WIDTH * LENGTH;
        assert!((work / expected - 1.0).abs() < 1e-5, "{degrees}: {work:e}, {expected:e}");
    }
}

#[test]
fn a_tape_that_takes_more_work_in_shear_peels_between_two_forces() {
    for (degrees, shear_work) in [(45.0, 300.0), (45.0, 50.0), (90.0, 300.0)] {
        let model = with_shear_work(at(tape(1e-3), degrees), shear_work);
        assert!(!model.has_potential());
        let derived = model.derived().section.unwrap();
        let [one, other] = [derived.kendall_force, derived.kendall_force_in_shear.unwrap()];
        let found = peeled(&model);
        assert_eq!(found.end, PathEnd::Detached);
        let plateau = found.plateau.unwrap().force;
        let share = (plateau - one) / (other - one);
        assert!((1e-3..0.2).contains(&share), "{degrees} degrees, {shear_work}: {plateau} between {one} and {other}");
        // what the plateau takes is what all of the tape takes, but for its ends
        let angle = degrees.to_radians();
        let steady = plateau * (1.0 - angle.cos()) + plateau * plateau / (2.0 * model.section().axial);
        let work = found.points.last().unwrap().work;
        assert!((work / (steady * LENGTH) - 1.0).abs() < 0.05, "{degrees}, {shear_work}: {work:e}, {steady:e}");
    }
    let model = tape(1e-3);
    assert!(model.has_potential() && with_shear_work(model, WORK).has_potential());
}

#[test]
fn effort() {
    let found = peeled(&at(tape(1e-3), 45.0));
    let effort = (found.effort.points, found.effort.newton_iterations, found.effort.elements);
    assert_eq!(effort, (88, 394, 48));
}

#[test]
fn its_stability_out_of_the_plane_is_refused() {
    assert_eq!(NotOutOfPlane::of(&tape(1e-3)), Some(NotOutOfPlane::Shear));
}
