//! Rods that stay in a plane: whatever the plane, the beam in space is the one of the plane.
//!
//! Reference: the planar element's rod; closed forms of rods under an end moment.
//!
//!     ///o============== ^ P     in the plane of x and y (EI2), of x and z (EI3), and any between where EI2 = EI3
//!     ///o============== ) M
//!
//! Expected: the tip of a cantilever as far as it bends to 1e-10 of L, and the force that holds it; a moment rolls it
//! up into one and two circles, and with a part about its axis into helices, to 1e-10. Why: two texts of one element.

use super::setup::{Rod, assert_close, tabulated_tip, tip};
use peelkit::beam::rotation::{Quaternion, apply, exponential, matrix, product};
use peelkit::beam::{ReferenceCurve, Section, SpatialRestCurve, SpatialStiffness};
use peelkit::model::{Drive, RodModel, Support};
use peelkit::solve::{Observables, controlled};
use std::f64::consts::PI;

const AXIAL: f64 = 400.0;
const SHEAR: f64 = 150.0;
const LOADS: [f64; 3] = [0.5, 3.0, 10.0];

/// x, y and the rotation of the tip in the plane, under each load.
fn planar(bending: f64) -> Vec<[f64; 3]> {
    let model = RodModel {
        length: 1.0,
        section: Section { axial: AXIAL, shear: SHEAR, bending },
        rest: ReferenceCurve::straight(0.0, 0.0, 0.0),
        left: Support::CLAMPED,
        right: Support::FREE,
        drive: Drive::Y,
    };
    let problem = model.problem(8).unwrap();
    let found = controlled(&problem, problem.initial(12), Observables::FORCE, &LOADS, 1e-13).unwrap();
    let tip = |values: &[f64]| [1.0 + values[values.len() - 3], values[values.len() - 2], values[values.len() - 1]];
    found.iter().map(|solution| tip(problem.beam.planar().unwrap().nodes(&solution.at.values))).collect()
}

/// The rod along x, turned about it by an angle.
fn rolled(angle: f64) -> SpatialRestCurve {
    let rest = SpatialRestCurve::along_x(0.0);
    SpatialRestCurve { directors: product(exponential([angle, 0.0, 0.0]), rest.directors), ..rest }
}

/// Its tip under forces in the plane that makes an angle with that of x and y: along x, in that plane, out of it.
fn spatial(rest: SpatialRestCurve, bending: [f64; 2], shear: [f64; 2], angle: f64) -> Vec<([f64; 3], usize)> {
    let stiffness = SpatialStiffness::diagonal(AXIAL, shear, 0.7, bending);
    let rod = Rod { order: 8, ..Rod::clamped(stiffness, rest, 1.0) };
    let load = |force: f64| [[0.0, force * angle.cos(), force * angle.sin()], [0.0; 3]];
    let found = rod.under(12, load, 0.5, &LOADS);
    let seen = |place: [f64; 3]| {
        let (sin, cos) = angle.sin_cos();
        [place[0], cos * place[1] + sin * place[2], cos * place[2] - sin * place[1]]
    };
    found.into_iter().map(|(at, iterations)| (seen(tip(&at)), iterations)).collect()
}

#[test]
fn a_cantilever_in_every_plane() {
    let bending = 1.3;
    let wanted = planar(bending);
    let stiff = (40.0, 900.0);
    // about the width in x and y, about the height in x and z, and with the section turned between the two
    let cases = [
        ("x and y", rolled(0.0), [bending, stiff.0], [stiff.1, SHEAR], 0.0),
        ("x and z", rolled(0.0), [stiff.0, bending], [SHEAR, stiff.1], 0.5 * PI),
        ("at 0.7", rolled(0.7), [bending, stiff.0], [stiff.1, SHEAR], 0.7),
        ("at 2.5", rolled(2.5 - 0.5 * PI), [stiff.0, bending], [SHEAR, stiff.1], 2.5),
        ("of a round section", rolled(0.4), [bending; 2], [SHEAR; 2], 1.1),
    ];
    for (name, rest, bending, shear, angle) in cases {
        for (k, (found, iterations)) in spatial(rest, bending, shear, angle).into_iter().enumerate() {
            let [x, y, _] = wanted[k];
            assert_close(&found, &[x, y, 0.0], 1e-10, &format!("{name}, P = {}", LOADS[k]));
            assert!(iterations <= 60, "{name}: {iterations} iterations");
        }
    }
}

/// Closed forms of the table for rods that are rigid in stretching and shear, which a moment alone does not stretch or
/// shear.
#[test]
fn moments_roll_it_up_into_circles_and_helices() {
    let stiffness = SpatialStiffness::diagonal(1e3, [1e3; 2], 1.0, [1.0; 2]);
    let turns = [0.25, 0.5, 1.0, 2.0];
    for (case, about) in [("end_moment", [0.0, 0.6, 0.8]), ("end_screw", [0.6, 0.0, 0.8])] {
        for angle in [0.0, 0.9] {
            let rod = Rod::clamped(stiffness, rolled(angle), 1.0);
            let load = |turns: f64| [[0.0; 3], about.map(|part| 2.0 * PI * turns * part)];
            for ((at, iterations), turns) in rod.under(16, load, 0.05, &turns).into_iter().zip(turns) {
                assert_close(&tip(&at), &tabulated_tip(case, turns), 1e-10, &format!("{case}, {turns} turns"));
                assert!(iterations <= 200, "{case}, {turns} turns: {iterations} iterations");
            }
        }
    }
}

/// The same with the whole picture turned: directors at rest that are not those of a strip along x.
#[test]
fn in_any_direction() {
    let turn: Quaternion = exponential([0.3, -1.1, 0.7]);
    let rest = SpatialRestCurve::along_x(0.0);
    let turned = SpatialRestCurve { directors: product(turn, rest.directors), ..rest };
    let stiffness = SpatialStiffness::diagonal(1e3, [1e3; 2], 1.0, [1.0; 2]);
    let about = apply(&matrix(turn), &[0.0, 2.0 * PI * 0.6, 2.0 * PI * 0.8]);
    let rod = Rod::clamped(stiffness, turned, 1.0);
    let (at, _) = rod.under(16, |turns| [[0.0; 3], about.map(|part| turns * part)], 0.05, &[0.25]).remove(0);
    let wanted = apply(&matrix(turn), &tabulated_tip("end_moment", 0.25));
    assert_close(&tip(&at), &wanted, 1e-10, "a quarter of a circle");
}
