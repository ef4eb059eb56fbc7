//! The table of a spatula whose pad is held at its free end: a function of height, place along the substrate and rotation of the other end.
//!
//!         ⟲ /|P
//!          / |--> H       at v = 0 and θ = 0 it is the pull in a grip that is held along the substrate
//!   |_____/
//!   ////////////
//!
//! Reference: `peel` of the same spatula with rotation and place of the grip held, to 1e-6.
//! Parameters: the default spatula; pressed by 2 nm, v within ±4 nm, θ within ±0.02 rad, to 1e-3.
//! Expected: peak and first displacement limit point within the bounds that the table states; three forces that are the gradient of one energy.

use super::{at, differences, spatula};
use peelkit::model::{Grip, Hold, PeelModel};
use peelkit::prelude::{Accuracy, StopCriteria, peel};
use peelkit::study::coarsening::{CoarseningOptions, PadEnd, TipRange, TipSheet, coarsen};

#[test]
fn a_pull_along_a_straight_line_is_one_line_of_the_table() {
    let range = TipRange { press: 2.0, lateral: [-4.0, 4.0], rotation: [-0.02, 0.02] };
    let options = CoarseningOptions { range, ..CoarseningOptions::of(PadEnd::Held) };
    let table = coarsen(&spatula(), &options).unwrap();
    assert!(table.is_met(), "{:?}", table.attached_errors);

    let grip = Grip { rotation: Hold::Fixed, horizontal: Hold::Fixed, ..Grip::FREE };
    let pulled = peel(&PeelModel { grip, ..spatula() }, &Accuracy::to(1e-6), &StopCriteria::after_points(400));
    let peak = pulled.peak.expect("the path has a peak");
    let snap_off = pulled.snap_off.expect("the path turns back");
    let found = table.response(TipSheet::Attached, at(peak.displacement, 0.0, 0.0));
    let bound = table.attached_errors.force;
    assert!((found.force[0] - peak.force).abs() < bound[0], "{} {}", found.force[0], peak.force);
    let [_, limit] = table.attached.ends(at(0.0, 0.0, 0.0));
    assert!((limit - snap_off.displacement).abs() < 1e-5 + table.attached_errors.limit, "{limit}");

    for k in 1..40 {
        let share = |ratio: f64| (ratio * f64::from(k)).fract();
        let (lateral, rotation) = (8.0 * share(0.8191725) - 4.0, 0.04 * share(0.6710436) - 0.02);
        let [begin, end] = table.attached.ends(at(0.0, lateral, rotation));
        let place = at(begin + 0.98 * share(0.5497005) * (end - begin), lateral, rotation);
        let [force, stiffness] = differences(&table.attached, place);
        assert!(force < 1e-4 && stiffness < 1e-3, "{place}: {force:.1e} {stiffness:.1e}");
    }
}
