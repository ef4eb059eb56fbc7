//! The scene of the 200 whose end is the hardest.
//!
//! Reference: verification/bound_scenes.csv, scene 150, collocation without finite elements.
//!
//!     |---------- L = 1772 nm, h = 20.15 nm, EI × 17.25 ----------|  ^ u, rotation held
//!     =============================================================
//!
//! Parameters: A_H = 2.213e-20 J, r0 = 0.2371 nm; `relative` = 1e-6. The other 199 scenes: `peel verify --only bounds`.
//!
//! Expected: every number of the table is reported within its bound, whether the path comes to its end or fails by name at its
//! very end, near u = 1825 nm, where the strip comes off. Why: which of the two it is hangs on round-off; a failure keeps what
//! was reached, and says where it failed.

use crate::common::{paper_strip, whole_peel, with_grip};
use peelkit::model::Hold;
use peelkit::solve::LimitPointKind;
use peelkit::study::PathEnd;

#[test]
fn a_failure_at_the_end_keeps_what_was_reached() {
    let mut model = with_grip(paper_strip(1772.0, 17.25), Hold::Fixed, Hold::Free);
    model.strip.height = 20.15;
    model.adhesion.hamaker_constant = 0.02213;
    model.adhesion.equilibrium_distance = 0.2371;
    let peel = whole_peel(&model, 1e-6);

    if let PathEnd::Failed(failure) = &peel.end {
        let reason = failure.to_string();
        assert!(reason.contains("limit point") && reason.contains("u = 182"), "{reason}");
    }

    let peak = peel.initiation_peak.expect("an initiation peak");
    let mut turns = peel.limit_points.iter().filter(|point| point.kind == LimitPointKind::Displacement);
    let (snap, end) = (turns.next().expect("a snap-off"), turns.next().expect("an end of the snap-back"));
    for (name, value, bound, exact, digit) in [
        ("peak u", peak.displacement, peak.displacement_error, 0.57147872313, 1e-11),
        ("peak P", peak.force, peak.force_error, 0.693230711340, 1e-12),
        ("lp1 u", snap.displacement, snap.displacement_error, 589.058302720, 1e-9),
        ("lp1 P", snap.force, snap.force_error, 0.0366526269826, 1e-13),
        ("lp2 u", end.displacement, end.displacement_error, 105.980017954, 1e-9),
        ("lp2 P", end.force, end.force_error, 0.00240631964109, 1e-14),
    ] {
        let error = (value - exact).abs();
        assert!(error <= bound + digit, "{name}: {value}, error {error:.1e}, bound {bound:.1e}");
        assert!(error <= 1e-6 * exact, "{name}: {value}, error {error:.1e}");
    }
}
