//! The curve of a tip from the peel of its spatula, and the law made of it.
//!
//! Reference: the default spatula, `verification/spatula_curve.csv` and the values of its peel (u, P): forces on the way, the peak 6.67038424 nN at
//! 361.24302 nm, the first displacement limit point at 364.418953 nm. Expected: forces to 1e-4, between the points of the path a cubic; derivatives
//! of the energy are those of differences to their error; work to the peak is that of the curve. A tip detaches where the spatula snaps off and
//! adheres again where it touches the ground.

use super::setup::curve;
use approx::{assert_abs_diff_eq, assert_relative_eq};
use peelkit::model::{NormalPull, Sideways, Spatula, TipBranch, TipLaw};
use peelkit::study::{Accuracy, tip_curve};

const NO_TURN: [f64; 4] = [1.0, 0.0, 0.0, 0.0];

#[test]
fn the_curve_is_that_of_the_spatula() {
    let curve = tip_curve(&Spatula::default().model(), &Accuracy::to(1e-6), 50.0).unwrap();
    let known = [
        (25.0, 0.44211814),
        (50.0, 0.86200850),
        (100.0, 2.15096220),
        (150.0, 4.22128380),
        (200.0, 4.75625911),
        (250.0, 5.18794422),
        (300.0, 5.79432248),
        (350.0, 6.528724),
        (361.24302, 6.67038424),
    ];
    for (u, force) in known {
        assert_relative_eq!(curve.force(u).0, force, max_relative = 1e-4);
    }
    assert_relative_eq!(curve.force(361.24302).0, 6.67038424, max_relative = 2e-5);
    assert_abs_diff_eq!(curve.snap_off(), 364.418953, epsilon = 1e-2);
    assert!(curve.force(-30.0).0 < 0.0, "pressed, the ground pushes");
    assert!(curve.energy_at_rest() < -900.0 && curve.energy(curve.snap_off()) > 0.0);
}

#[test]
fn derivatives_are_those_of_differences() {
    let law = NormalPull { curve: curve(), sideways: Sideways::Held(0.3), contact_height: 0.0 };
    let at = |y: f64| law.response(TipBranch::Attached, [3.0, y, -2.0], NO_TURN);
    let small = 1e-3;
    for y in [-70.0, -20.0, 5.0, 99.9, 150.0, 340.0, 362.5, 363.9, 364.5] {
        let (own, up, down) = (at(y), at(y + small), at(y - small));
        assert_abs_diff_eq!(own.gradient[1], (up.energy - down.energy) / (2.0 * small), epsilon = 1e-6);
        assert_abs_diff_eq!(own.hessian[1][1], (up.gradient[1] - down.gradient[1]) / (2.0 * small), epsilon = 1e-6);
    }
    let own = at(50.0);
    assert_relative_eq!(own.gradient[0], 0.9, max_relative = 1e-12);
    assert_relative_eq!(own.gradient[2], -0.6, max_relative = 1e-12);
}

#[test]
fn a_tip_remembers_whether_it_adheres() {
    let law = NormalPull { curve: curve(), sideways: Sideways::Free, contact_height: 0.0 };
    let on = |before, y| law.branch(before, [0.0, y, 0.0], NO_TURN);
    assert_eq!(on(TipBranch::Attached, 200.0), TipBranch::Attached);
    assert_eq!(on(TipBranch::Attached, 363.0), TipBranch::Detaching);
    assert_eq!(on(TipBranch::Detaching, 364.1), TipBranch::Detached);
    assert_eq!(on(TipBranch::Detached, 200.0), TipBranch::Detached);
    assert_eq!(on(TipBranch::Detached, -1e-9), TipBranch::Attached);
}
