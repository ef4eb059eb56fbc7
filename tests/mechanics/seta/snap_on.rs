//! Tips that are drawn to the ground one after the other, while a seta is pressed on by the table of its tips.
//!
//! Reference: the same seta pulled off without a preload, whose tips all adhere at the start. Expected: all tips come down, at events that begin with
//! a tip and release energy, no beam buckles; where all adhere the way there plays no part, so that the peak is the same to 1e-8; work and energy
//! agree within the tolerance of the steps.

use peelkit::model::{Adhesion, Body, Grip, PeelModel, Seta, SetaModel, Sideways, Spatula, TipBranch};
use peelkit::study::coarsening::{CoarseningOptions, PadEnd, TableLaw, TipRange, coarsen};
use peelkit::study::{EventCause, SetaEnd, SetaLoading, SetaOptions, StopCriteria, pull_off};
use std::sync::Arc;

const TIPS: usize = 16;

#[test]
fn tips_that_the_ground_draws_on_snap_on_one_after_the_other() {
    let spatula = PeelModel::of(Body::Spatula(Spatula::default()), Adhesion::default(), Grip::FREE);
    let range = TipRange { press: 5.0, rotation: [-0.1, 0.1], ..TipRange::SLIDING };
    let options = CoarseningOptions { range, tolerance: 1e-2, ..CoarseningOptions::of(PadEnd::Sliding) };
    let law = TableLaw::new(Arc::new(coarsen(&spatula, &options).unwrap()), Sideways::Free);
    let seta = Seta { forks: TIPS.ilog2() as usize, ..Seta::default() };
    let model = SetaModel::new(seta, Arc::new(law));
    let options = SetaOptions { balance: 1e-6, ..SetaOptions::default() };
    let run = |loading| pull_off(&model, &loading, &options, &StopCriteria::default()).unwrap();
    let pressed = run(SetaLoading::pressed_and_dragged(201.0, 12.0, 0.0, 60_000.0));
    println!("{:?}, {} events, {:.1e}", pressed.end, pressed.events.len(), pressed.imbalance());
    assert!(pressed.end == SetaEnd::Completed && pressed.imbalance() < 1e-6, "{:.1e}", pressed.imbalance());
    let drawn: Vec<_> = pressed.events.iter().filter(|event| event.before.step == 0).collect();
    assert!(drawn.iter().all(|event| event.released > 0.0 && event.cause == EventCause::Tips), "{drawn:?}");
    let adhered = drawn.iter().flat_map(|event| &event.tips).filter(|change| change.to == TipBranch::Attached);
    assert!(drawn.len() > 3 && adhered.count() == TIPS);
    let alone = run(SetaLoading::pull([0.0, 1.0, 0.0], 60_000.0));
    let [one, other] = [&pressed, &alone].map(|run| run.peak.as_ref().unwrap().point);
    println!("{one:?} {other:?}");
    assert!(one.attached == TIPS && (one.force_along - other.force_along).abs() < 1e-8 * other.force_along);
}
