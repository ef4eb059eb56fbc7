//! What a test of a strip in space records: the stable branches, the jumps and the energies, by the code of the plane.
//!
//! References: verification/space_peels.csv, Gauss collocation of the strong form; the whole path of the same strip, without a spring.
//!
//! ```text
//!          machine: U = u + P/k along (cos α cos β, sin α, cos α sin β), elevation α, azimuth β
//!        ≷ k      b = 10 and 40 nm, L = 100 nm, h = 10 nm, E = 2 GPa, ν = 0.2, A_H = 1e-19 J, r0 = 0.4 nm
//!     _/ u, P     the grip free, rolled to nothing, or held in all but the pull
//!     ///////
//! ```
//!
//! Expected: the first jump is the fold of the path within the bounds of both; work, energy and energy released balance to 1e-6. Why: the
//! gradient flow and the branch behind it are in as many directions as the strip can turn, of which the plane knows one.

use peelkit::model::{Body, Hold, PeelModel, Space, Step, StripModel};
use peelkit::study::{
    Accuracy, JumpKind, LoadingDirection, NoTest, Observed, PullOff, StopCriteria, TestEnd, observed, observed_retreat,
    peel,
};
use std::f64::consts::FRAC_PI_2;

fn strip(width: f64, [elevation, azimuth]: [f64; 2], space: Space) -> PeelModel {
    let mut model = PeelModel::from(StripModel::of_the_paper(100.0, 1.0));
    if let Body::Strip(strip) = &mut model.body {
        strip.width = width;
    }
    model.pull.angle = elevation.to_radians();
    model.space = Some(Space { azimuth: azimuth.to_radians(), ..space });
    model
}

fn tested(model: &PeelModel) -> Observed {
    observed(model, &Accuracy::to(1e-4), &StopCriteria::after_points(2000)).unwrap()
}

#[track_caller]
fn assert_balanced(test: &Observed) {
    for balance in [test.retreat.unwrap(), test.cycle.unwrap()] {
        assert!(balance.error() <= 1e-6, "{balance:?} is off by {:.1e}", balance.error());
    }
    assert!(test.jumps.iter().all(|jump| jump.released > jump.released_error && jump.released_error > 0.0));
}

/// The first jump and the pull-off force of a sideways pull are fold and peak of the collocation's path.
#[test]
fn the_first_jump_of_a_sideways_pull_is_the_fold_of_its_path() {
    let model = strip(40.0, [60.0, 90.0], Space::default());
    let stop = StopCriteria { displacement: Some(12.9), ..StopCriteria::after_points(2000) };
    let test = observed(&model, &Accuracy::to(1e-4), &stop).unwrap();
    assert!(matches!(test.end, TestEnd::Bound(_)), "{:?}", test.end);
    let jump = &test.jumps[0];
    let off = (jump.machine - 12.77812798843).abs();
    assert!(off <= jump.machine_error + 1e-10, "U = {} ± {:.1e}", jump.machine, jump.machine_error);
    let pull_off = test.pull_off.unwrap();
    let off = (pull_off.force - 15.28007876413).abs();
    assert!(off <= pull_off.force_error + 1e-10, "P = {} ± {:.1e}", pull_off.force, pull_off.force_error);
    assert!(jump.kind == JumpKind::SnapOff && jump.released > 0.0, "{jump:?}");
}

/// Held in all but the pull, behind a spring: it comes off at once, and back, and lies as it lay. The spring decides where: U = u + P/k of
/// the path has its maximum there.
#[test]
fn a_cycle_of_a_held_grip_closes() {
    let held = Space { lateral: Hold::Fixed, roll: Hold::Fixed, yaw: Hold::Fixed, ..Space::default() };
    let mut model = strip(10.0, [60.0, 30.0], held);
    (model.grip.rotation, model.grip.horizontal) = (Hold::Fixed, Hold::Fixed);
    let path = peel(
        &model,
        &Accuracy::to(1e-4),
        &StopCriteria { displacement: Some(19.0), ..StopCriteria::after_points(400) },
    );
    let stiffness = 5.0;
    let largest = path.dense_curve(64).iter().map(|(u, force, _)| u + force / stiffness).fold(0.0, f64::max);
    model.grip.stiffness = Some(stiffness);
    let test = tested(&model);
    assert_eq!(test.end, TestEnd::Closed);
    assert_balanced(&test);
    let released: f64 = test.jumps.iter().map(|jump| jump.released).sum();
    assert!((test.hysteresis.unwrap() / released - 1.0).abs() < 1e-5, "{:?} and {released}", test.hysteresis);
    let first = test.jumps[0].machine;
    assert!((first / largest - 1.0).abs() < 2e-6, "U = {first}, and {largest} on the path");
    assert!(test.jumps[0].detached);
}

/// Free to turn, it comes back to stand on the face of its end: another equilibrium.
#[test]
fn a_strip_that_is_free_to_turn_comes_back_upright() {
    let test = tested(&strip(10.0, [60.0, 30.0], Space { roll: Hold::Fixed, ..Space::default() }));
    assert!(matches!(test.end, TestEnd::Returned(_)), "{:?}", test.end);
    assert_balanced(&test);
}

/// The retreat alone ends on the face of the end, on which the strip stands then. What holds it there, 40 nN, is no pull-off force of the pad.
#[test]
fn a_retreat_ends_where_the_strip_stands_on_its_end() {
    let model = strip(40.0, [60.0, 90.0], Space::default());
    let test = retreat(&model);
    assert_eq!(test.end, TestEnd::Off);
    assert!(test.points.iter().all(|point| point.way == LoadingDirection::Retreat));
    assert!(test.retreat.unwrap().error() <= 1e-6 && test.cycle.is_none());
    assert_force(&test, 15.28007876413, 1e-10);
}

/// Rolled by five degrees before: the collocation's peak. The test there and back has to begin at rest.
#[test]
fn a_rolled_strip_is_pulled_off() {
    let held = Space { roll: Hold::Fixed, yaw: Hold::Fixed, azimuth: FRAC_PI_2, ..Space::default() };
    let mut model = strip(10.0, [90.0, 90.0], held);
    model.steps = vec![Step::Lift(0.5), Step::Roll(5f64.to_radians()), Step::Release];
    assert_force(&retreat(&model), 2.61014616, 5e-9);
    let there_and_back = observed(&model, &Accuracy::to(1e-4), &StopCriteria::after_points(2000));
    assert_eq!(there_and_back.err(), Some(NoTest::Steps));
}

/// Straight up a wide strip leaves its plane before its planar peak: the pull-off force is the peak of that branch, by collocation.
#[test]
fn a_wide_strip_is_pulled_off_on_the_branch_that_leaves_its_plane() {
    let test = retreat(&strip(40.0, [90.0, 90.0], Space::default()));
    assert_eq!(test.end, TestEnd::Off);
    assert_force(&test, 13.17406487898, 1e-9);
}

fn retreat(model: &PeelModel) -> Observed {
    observed_retreat(model, &Accuracy::to(1e-6), &StopCriteria::after_points(2000)).unwrap()
}

/// Within its bound, and the digits of the reference.
#[track_caller]
fn assert_force(test: &Observed, expected: f64, digits: f64) {
    let PullOff { force, force_error, .. } = test.peeling_force().unwrap();
    assert!((force - expected).abs() <= force_error + digits, "{force} ± {force_error:.1e}, not {expected}");
}
