//! Ways of the grip of a plane solid: at an angle, and turning as it goes.
//!
//! Reference: the strip as a beam, whose sections stay plane.
//!
//! ```text
//!                      P  /  α
//!                        / ______
//!   ====================o           x of the left end is held, the rest slides along the ground
//!   ---------------------------
//! ```
//!
//! Parameters: the strip of 100 nm, elements H1(2) of 1 nm, at 60 and 120 degrees, and at 90 degrees with 0.02 rad/nm.
//!
//! Expected: forces at u = 10 and 20 nm are those of the beam within 0.5 %, those of a solid that is pulled straight up too. Why: the front then stands far
//! from the grip, and a section in the process zone deforms alike whichever way the grip goes.

use super::{element, model};
use approx::assert_relative_eq;
use peelkit::model::{Hold, PeelModel, SolidSettings};
use peelkit::study::{Accuracy, SolidOptions, StationAt, StationQuantity, StopCriteria, peel, peel_solid};

/// Forces at the displacements that a solid and a beam have been looked at, and the rotation of the end of the solid at the last.
fn beside_a_beam(change: fn(&mut PeelModel)) -> (Vec<[f64; 2]>, f64) {
    let mut model = model(100.0, 10.0);
    change(&mut model);
    let at = [10.0, 20.0].map(|value| StationAt { quantity: StationQuantity::Displacement, value });
    let stop = StopCriteria { events: at.map(Into::into).to_vec(), ..StopCriteria::up_to(20.5) };
    let settings = SolidSettings { element: element("H1(2)"), along: 1.0, through: 2, ..SolidSettings::default() };
    let options = SolidOptions { stop: stop.clone(), bounded: 0, ..SolidOptions::default() };
    let solid = peel_solid(&model, &settings, &options).unwrap();
    let beam = peel(&model, &Accuracy::to(1e-6), &stop);
    let of = |(found, at): (_, StationAt)| {
        let found: &peelkit::study::SolidStation = found;
        [found.point.force, beam.stations(at).found[0].force]
    };
    let turned = solid.stations.last().unwrap().point.end_rotation;
    (solid.stations.iter().zip(at).map(of).collect(), turned)
}

#[test]
fn at_an_angle_the_force_is_that_of_a_beam() {
    let changes: [fn(&mut PeelModel); 2] =
        [|model| model.pull.angle = 60_f64.to_radians(), |model| model.pull.angle = 120_f64.to_radians()];
    for change in changes {
        let (forces, _) = beside_a_beam(change);
        assert_eq!(forces.len(), 2);
        for [solid, beam] in forces {
            assert_relative_eq!(solid, beam, max_relative = 5e-3);
        }
    }
}

#[test]
fn a_grip_that_turns_is_that_of_a_beam() {
    let (forces, turned) = beside_a_beam(|model| {
        model.grip.rotation = Hold::Fixed;
        model.pull.turn = 0.02;
    });
    assert_relative_eq!(turned, 0.02 * 20.0, max_relative = 1e-9);
    for [solid, beam] in forces {
        assert_relative_eq!(solid, beam, max_relative = 5e-3);
    }
}
