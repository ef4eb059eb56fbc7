//! Work, what is stored, and what is released; what is refused.
//!
//! Reference: Gauss quadrature of the force along the way between events, exact for a polynomial. Expected: work = stored + released to 1e-9;
//! a closed way before the first loss takes none.

use crate::toe::setup::{PITCH, REACH, STIFFNESS, lamella, spring};
use approx::assert_relative_eq;
use peelkit::study::coarsening::{ExitPlane, LawSheet, SetaLaw, SetaLawErrors};
use peelkit::toe::{ArrayDrive, ArrayEnd, ArrayError, Backing, Lamella, Patch, PatchStep, RootLaw, Scatter};
use std::f64::consts::{FRAC_PI_2, PI};

fn patch(law: RootLaw, scatter: Scatter, steps: Vec<PatchStep>) -> Patch {
    Patch { rows: 6, columns: 7, pitch: PITCH, backing: Backing::Flat, law, scatter, press: 0.0, steps }
}

/// A potential of degree 4 with an exit that is inclined.
fn fitted() -> RootLaw {
    let coefficients = vec![0.0, 0.0, 0.0, 40.0, 10.0, 30.0, -3.0, 2.0, 1.0, -4.0, 0.5, 0.0, -1.0, 0.0, -2.0];
    let exit = ExitPlane { direction: [0.6, 0.8], distance: 100.0 };
    let errors = SetaLawErrors::default();
    let sheets = vec![LawSheet { tips: 1, coefficients, exit }];
    RootLaw::Fitted(SetaLaw { degree: 4, scale: 100.0, sheets, largest_force: 1.0, errors })
}

/// Dragged, then lifted: between two events the force is summed over the setae one by one.
#[test]
fn work_of_a_patch() {
    let scatter = Scatter { height: 20.0, strength: 0.3, seed: 5 };
    let steps = vec![PatchStep { angle: 0.0, distance: Some(30.0) }, PatchStep { angle: FRAC_PI_2, distance: None }];
    let patch = patch(fitted(), scatter, steps);
    let followed = patch.follow().unwrap();
    assert_eq!((followed.events.len(), followed.end), (42, ArrayEnd::Detached));
    // the path by its corners: the start, the end of the drag, the events
    let mut corners = vec![[0.0, 0.0]];
    let drag = followed.places.iter().filter(|place| place[1] == 0.0).count();
    corners.extend(&followed.places[..drag]);
    corners.push([30.0, 0.0]);
    corners.extend(&followed.places[drag..]);
    let (mut work, mut lost) = (0.0, 0);
    for (piece, ends) in corners.windows(2).enumerate() {
        // the event at the end of the piece before has happened; the corner of the drag is none
        lost = if piece <= drag { piece } else { piece - 1 };
        let gone: Vec<u32> = followed.events[..lost].iter().flat_map(|event| event.setae.clone()).collect();
        let delta = [ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]];
        for (share, weight) in
            [(0.5 - 15f64.sqrt() / 10.0, 5.0 / 18.0), (0.5, 8.0 / 18.0), (0.5 + 15f64.sqrt() / 10.0, 5.0 / 18.0)]
        {
            let at = [ends[0][0] + share * delta[0], ends[0][1] + share * delta[1]];
            for seta in (0..42u32).filter(|seta| !gone.contains(seta)) {
                let own = patch.scatter.of(seta as usize);
                let sheet = patch.law.sheet(0, own.strength).unwrap();
                let force = sheet.potential.response([at[0], at[1] - own.height]).force;
                work += weight * (force[0] * delta[0] + force[1] * delta[1]);
            }
        }
    }
    assert_eq!(lost, 41);
    assert_relative_eq!(work, followed.work, max_relative = 1e-9);
    // events are where a seta, alone, meets its plane
    for (event, place) in followed.events.iter().zip(&followed.places) {
        let own = patch.scatter.of(event.setae[0] as usize);
        assert_relative_eq!(0.6 * place[0] + 0.8 * (place[1] - own.height), 100.0 * own.strength, max_relative = 1e-11);
    }
}

/// A seta whose second sheet holds half as much, and whose exits are inclined to one another: lifted it goes from sheet to sheet, and the work is what
/// its sheets take, one behind the other. Put down again before its last exit it stays on its sheet.
#[test]
fn sheets_are_left_one_behind_the_other() {
    let RootLaw::Fitted(mut law) = fitted() else { unreachable!() };
    let half = law.sheets[0].coefficients[..6].iter().map(|own| 0.5 * own).collect();
    let exit = ExitPlane { direction: [0.0, 1.0], distance: 150.0 };
    law.sheets.push(LawSheet { tips: 1, coefficients: half, exit });
    let law = RootLaw::Fitted(law);
    let lift = |distance| PatchStep { angle: FRAC_PI_2, distance };
    let one = |steps| Patch { rows: 1, columns: 1, ..patch(law.clone(), Scatter::default(), steps) }.follow().unwrap();
    let lifted = one(vec![lift(None)]);
    let places: Vec<f64> = lifted.places.iter().map(|place| place[1]).collect();
    assert_relative_eq!(places[..], [125.0, 150.0], max_relative = 1e-12);
    let known = law.lifted().unwrap();
    let energy = |sheet, height| law.sheet(sheet, 1.0).unwrap().potential.response([0.0, height]).energy;
    assert_relative_eq!(known.work, energy(0, 125.0) + energy(1, 150.0) - energy(1, 125.0), max_relative = 1e-12);
    assert_relative_eq!(lifted.work, known.work, max_relative = 1e-12);
    assert_relative_eq!(lifted.released, energy(0, 125.0) - energy(1, 125.0) + energy(1, 150.0), max_relative = 1e-12);
    let largest = lifted.forces.iter().map(|force| force[1]).fold(0.0, f64::max);
    assert_relative_eq!(largest, known.force, max_relative = 1e-12);
    let back = PatchStep { angle: -FRAC_PI_2, distance: Some(100.0) };
    let down = one(vec![lift(Some(130.0)), back, lift(None)]);
    assert_eq!(down.events.iter().map(|event| event.sheets).collect::<Vec<_>>(), [[0, 1], [1, 2]]);
}

/// Of a seta of strength s: s² E(u/s), as of a spring that softens.
#[test]
fn strengths_scale_a_law() {
    for law in [fitted(), RootLaw::Softening { stiffness: STIFFNESS, first: 60.0, last: 150.0 }] {
        let last = law.sheets() - 1;
        let [one, weak] = [1.0, 0.7].map(|strength| law.sheet(last, strength).unwrap());
        let [own, scaled] = [one.potential.response([30.0, 90.0]), weak.potential.response([21.0, 63.0])];
        assert_relative_eq!(scaled.energy, 0.49 * own.energy, max_relative = 1e-12);
        (0..2).for_each(|i| assert_relative_eq!(scaled.force[i], 0.7 * own.force[i], max_relative = 1e-12));
        assert_relative_eq!(weak.exit.distance, 0.7 * one.exit.distance, max_relative = 1e-14);
    }
}

#[test]
fn a_closed_way_before_the_first_loss_takes_no_work() {
    let way = [0.0, FRAC_PI_2, PI, -FRAC_PI_2].map(|angle| PatchStep { angle, distance: Some(30.0) });
    let followed = patch(fitted(), Scatter { height: 5.0, ..Scatter::default() }, way.to_vec()).follow().unwrap();
    assert!(followed.events.is_empty());
    assert!(followed.work.abs() < 1e-9 * 42.0 * 40.0, "{:e}", followed.work);
}

/// All energies, with heights, strengths and shear that stays.
#[test]
fn work_of_a_lamella() {
    let law = RootLaw::Held {
        stiffness: [[3.0 * STIFFNESS, 0.3 * STIFFNESS], [0.3 * STIFFNESS, STIFFNESS]],
        exit: ExitPlane { direction: [0.6, 0.8], distance: REACH },
    };
    let scatter = Scatter { height: 0.1 * REACH, strength: 0.2, seed: 1 };
    let band = Lamella { columns: 5, law, scatter, section: lamella(2).section, ..lamella(30) };
    let soft =
        Lamella { section: peelkit::toe::BandSection { bending: 1e-3 * band.section.bending, ..band.section }, ..band };
    let followed = soft.follow(ArrayDrive::Force { angle: 1.2 }, [200.0, 0.0, 0.0], usize::MAX).unwrap();
    assert!(followed.events.len() > 140 && followed.end == ArrayEnd::Mechanism, "{:?}", followed.end);
    assert!(followed.imbalance < 1e-6, "{:.1e}", followed.imbalance);
    assert!(followed.events.iter().all(|event| event.released > 0.0));
    let sum: f64 = followed.events.iter().map(|event| event.released).sum();
    assert!(sum > 0.0);
}

#[test]
fn what_is_refused() {
    let high = Scatter { height: 6000.0, ..Scatter::default() };
    let mut lift = patch(spring(), high, vec![PatchStep { angle: FRAC_PI_2, distance: None }]);
    let Err(ArrayError::Unattached { unattached, press, .. }) = lift.follow() else { panic!() };
    let deep = (0..42).filter(|&i| -high.of(i).height > REACH).count();
    assert_eq!(unattached, deep);
    lift.press = press * (1.0 + 1e-9);
    assert!(lift.follow().is_ok());
    assert!(matches!(lamella(1).follow(ArrayDrive::Moment, [0.0; 3], 1), Err(ArrayError::TooFew { .. })));
    assert_eq!(lamella(5).follow(ArrayDrive::Force { angle: 0.5 }, [0.0; 3], 1), Err(ArrayError::NoShear));
    assert_eq!(
        Lamella { law: fitted(), ..lamella(5) }.follow(ArrayDrive::Moment, [0.0; 3], 1),
        Err(ArrayError::NotLinear)
    );
    let stays = lamella(60).follow(ArrayDrive::Force { angle: FRAC_PI_2 }, [0.0, 1e9, 0.0], 1);
    assert!(stays.unwrap_err().to_string().contains("by itself"));
    let nan = Lamella { pitch: f64::NAN, ..lamella(5) };
    assert!(matches!(nan.check(), Err(ArrayError::NotPositive { name: "pitch", .. })));
}
