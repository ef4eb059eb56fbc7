//! The first peak, against values of an independent program on which two families of its meshes agree to the digits given.
//!
//! It is made within a few nanometres of the grip: the strip need not be 100 nm long. A traction does not reach far, and one of 40 nm has the
//! same peak to a millionth; the body force of the rest strains the strip in its plane, and takes 60 nm.

use super::{element, model, strip};
use peelkit::model::{PeelModel, SolidSettings};
use peelkit::solid::{Grading, Plane, SolidContact, SolidGrip};
use peelkit::solve::{Located, Path, PathEvent, PathOptions, PathTracer, TraceOptions};

struct Found {
    force: f64,
    displacement: f64,
}

/// At most 20 points and 80 iterations.
fn first_peak(settings: &SolidSettings, model: &PeelModel) -> Found {
    let problem = strip(settings, model).problem();
    let options = PathOptions { step_tolerance: 0.1, ..PathOptions::default() };
    let mut tracer = PathTracer::new(&problem, Path::new(&problem, options), TraceOptions::default());
    for _ in 0..20 {
        match tracer.advance().unwrap() {
            PathEvent::Point(_) => {}
            PathEvent::LimitPoint { located: Located { observables, .. }, .. } => {
                assert!(tracer.iterations() <= 80, "{} iterations", tracer.iterations());
                return Found { force: observables.force, displacement: observables.displacement };
            }
            event => panic!("{event:?}"),
        }
    }
    panic!("20 points do not reach the peak")
}

/// A mesh that is graded to the grip.
struct Graded {
    element: &'static str,
    along: f64,
    through: usize,
    levels: usize,
    ratio: f64,
}

/// Looks at a first peak on a mesh: `tolerance` is that of the force, 1e-5 for five digits; the displacement, where the force is level, has 3e-4 nm.
fn holds(graded: &Graded, settings: SolidSettings, length: f64, expected: (f64, f64), tolerance: f64) {
    let Graded { along, through, levels, ratio, .. } = *graded;
    let settings = SolidSettings {
        element: element(graded.element),
        along,
        through,
        grading: Grading::Grip { levels, ratio },
        ..settings
    };
    let found = first_peak(&settings, &model(length, 10.0));
    let (force, displacement) = expected;
    let apart = (found.force / force - 1.0).abs();
    assert!(apart < tolerance, "{settings:?}: {} nN, {apart:.2e} off", found.force);
    assert!((found.displacement - displacement).abs() < 3e-4, "{settings:?}: u = {}", found.displacement);
}

const RIGID: Graded = Graded { element: "Q(5,5)", along: 2.5, through: 4, levels: 3, ratio: 0.25 };
const FACE: Graded = Graded { element: "Q(5,5)", along: 3.0, through: 2, levels: 3, ratio: 0.3 };
const DEPTH: Graded = Graded { element: "Q(5,5)", along: 3.0, through: 2, levels: 4, ratio: 0.3 };

fn settings(grip: SolidGrip, plane: Plane, contact: SolidContact) -> SolidSettings {
    SolidSettings { grip, plane, contact, ..SolidSettings::default() }
}

#[test]
fn rigid_grip_and_traction() {
    let of = |contact| settings(SolidGrip::Rigid, Plane::Stress, contact);
    holds(&RIGID, of(SolidContact::ReferenceTraction), 40.0, (0.325137, 0.36457), 5e-6);
    holds(&RIGID, of(SolidContact::CurrentTraction), 40.0, (0.328422, 0.3785), 5e-6);
}

#[test]
fn rigid_grip_and_body_force() {
    let of = settings(SolidGrip::Rigid, Plane::Stress, SolidContact::BodyForce);
    holds(&RIGID, of, 60.0, (0.324103, 0.35968), 1e-5);
}

#[test]
fn parabolic_traction_and_traction_of_the_ground() {
    for (plane, reference, current) in [
        (Plane::Stress, (0.3996794, 0.355789), (0.399356, 0.357039)),
        (Plane::Strain, (0.4023970, 0.346867), (0.401347, 0.347827)),
    ] {
        let of = |contact| settings(SolidGrip::Parabolic, plane, contact);
        holds(&FACE, of(SolidContact::ReferenceTraction), 40.0, reference, 5e-6);
        holds(&FACE, of(SolidContact::CurrentTraction), 40.0, current, 1e-5);
    }
}

#[test]
fn parabolic_traction_and_body_force() {
    for (plane, expected) in [(Plane::Stress, (0.3870142, 0.339155)), (Plane::Strain, (0.3885477, 0.331119))] {
        holds(&DEPTH, settings(SolidGrip::Parabolic, plane, SolidContact::BodyForce), 60.0, expected, 1e-5);
    }
}

/// A second family of meshes: another order, and columns and rows elsewhere.
#[test]
fn another_family_of_meshes_agrees() {
    let of = |grip| settings(grip, Plane::Stress, SolidContact::ReferenceTraction);
    let other = Graded { element: "Q(4,4)", along: 2.0, through: 3, levels: 3, ratio: 0.35 };
    holds(&other, of(SolidGrip::Parabolic), 40.0, (0.3996794, 0.355789), 1e-5);
    let even = Graded { element: "Q(5,5)", along: 1.67, through: 6, levels: 2, ratio: 0.25 };
    holds(&even, of(SolidGrip::Rigid), 40.0, (0.325137, 0.36457), 5e-6);
}
