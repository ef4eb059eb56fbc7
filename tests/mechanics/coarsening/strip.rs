//! The table of a strip, whose limit points an independent method gives.
//!
//!   _______________|u      L = 100 nm, h = 10 nm, E = 2 GPa; the end is pulled straight up without rotation
//!   ///////////////
//!
//! Reference: `peel` of the strip with a fixed rotation, to 1e-8, which agrees with Gauss collocation of the strong form.
//! Expected: the limit of the table at θ = 0 is its first displacement limit point, the largest force its peak.

use super::at;
use crate::common::paper_strip;
use peelkit::model::{Grip, Hold, PeelModel};
use peelkit::prelude::{Accuracy, StopCriteria, peel};
use peelkit::study::coarsening::{CoarseningOptions, PadEnd, TipRange, TipSheet, coarsen};

#[test]
fn its_limit_is_that_of_the_pull() {
    let range = TipRange { press: 0.0, rotation: [-0.004, 0.004], ..TipRange::SLIDING };
    let options = CoarseningOptions { range, ..CoarseningOptions::of(PadEnd::Sliding) };
    let model = PeelModel::from(paper_strip(100.0, 1.0));
    let table = coarsen(&model, &options).unwrap();
    assert!(table.is_met(), "{:?}", table.attached_errors);

    let grip = Grip { rotation: Hold::Fixed, ..Grip::FREE };
    let pulled = peel(&PeelModel { grip, ..model }, &Accuracy::to(1e-8), &StopCriteria::after_points(3000));
    let snap_off = pulled.snap_off.expect("the path turns back");
    let [_, limit] = table.attached.ends(at(0.0, 0.0, 0.0));
    assert!((limit - snap_off.displacement).abs() < 1e-5 + table.attached_errors.limit, "{limit}");
    let peak = pulled.peak.expect("the path has a peak");
    let found = table.response(TipSheet::Attached, at(peak.displacement, 0.0, 0.0)).force[0];
    assert!((found - peak.force).abs() < table.attached_errors.force[0], "{found} {}", peak.force);
}
