//! A seta that is pulled until it is detached and pushed back until it adheres again; preload and drag; interruption.
//!
//! The small seta of `setup.rs`. Expected: a detached seta carries nothing and has no energy; every tip adheres again where its end comes down to
//! the ground, so that the way back is another one than the way there, and what the root has worked over the whole cycle is what events have
//! released but for what the seta has stored; the second run is the first bit for bit, and so is one that was stopped and written down on the
//! way and goes on from there. A preload is met to 1e-8; a drag with tips that are held pulls the seta sideways.

use super::setup::{along_normal, model, pulled, small};
use approx::assert_relative_eq;
use peelkit::model::{Sideways, TipBranch};
use peelkit::study::{
    Bound, SetaEnd, SetaLoading, SetaOptions, SetaProgress, SetaStart, StepEnd, StopCriteria, pull_off_from,
};

#[test]
fn pulled_off_and_pushed_back_it_adheres_again() {
    let steps = [along_normal(1.0, StepEnd::Detached(5000.0)), along_normal(-1.0, StepEnd::Preload(0.5))];
    let cycle = pulled(&model(small(), Sideways::Free), SetaStart::Adhering, &steps);
    assert_eq!(cycle.end, SetaEnd::Completed);
    let detached = cycle.points.iter().rposition(|point| point.attached == 0).unwrap();
    assert!(cycle.points[detached].force_along.abs() < 1e-9);
    assert!(cycle.points[detached].energy.abs() < 1e-9);
    let last = cycle.points.last().unwrap();
    assert_eq!(last.attached, 4);
    assert_relative_eq!(last.force_along, 0.5, max_relative = 1e-8);
    let back: Vec<_> =
        cycle.events.iter().filter(|event| event.before.step == 1).flat_map(|event| &event.tips).collect();
    assert!(back.iter().all(|change| change.to == TipBranch::Attached) && back.len() == 4);
    assert!(cycle.imbalance() < 1e-8, "{:.2e}", cycle.imbalance());
}

#[test]
fn preload_and_drag_as_in_the_experiments() {
    let loading = SetaLoading::pressed_and_dragged(60.0, 1.0, 50.0, 5000.0);
    let pull = |sideways| pulled(&model(small(), sideways), loading.start, &loading.steps);
    let (free, held) = (pull(Sideways::Free), pull(Sideways::Held(0.5)));
    for run in [&free, &held] {
        assert_eq!(run.end, SetaEnd::Completed);
        assert!(run.imbalance() < 1e-8, "{:.2e}", run.imbalance());
    }
    let dragged =
        |run: &peelkit::study::SetaPullOff| run.points.iter().rfind(|point| point.step == 1).unwrap().force[0];
    assert!(dragged(&free).abs() < 1e-6 && dragged(&held) > 0.1, "{} {}", dragged(&free), dragged(&held));
}

#[test]
fn interrupted_and_resumed_it_is_the_same_bit_for_bit() {
    let model = model(small(), Sideways::Free);
    let steps = vec![along_normal(1.0, StepEnd::Detached(5000.0)), along_normal(-1.0, StepEnd::Preload(0.5))];
    let loading = SetaLoading { start: SetaStart::Adhering, steps };
    let options = SetaOptions::default();
    let run = |stop: &StopCriteria, from| pull_off_from(&model, &loading, &options, stop, from).unwrap();
    let whole = run(&StopCriteria::default(), None).0;
    for points in [3, 17, whole.points.len() - 2] {
        let (part, reached) = run(&StopCriteria::after_points(points), None);
        assert_eq!(part.end, SetaEnd::Bound(Bound::Points(points)));
        let written = serde_json::to_string(&reached.unwrap()).unwrap();
        let read: SetaProgress = serde_json::from_str(&written).unwrap();
        assert_eq!(run(&StopCriteria::default(), Some(read)).0, whole);
    }
}
