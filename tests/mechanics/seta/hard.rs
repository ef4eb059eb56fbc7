//! Hard pull-offs of setae: many steps, tips pushed in while others pull, a pull along the ground, the whole loop, beams that buckle, a run that is
//! stopped in the middle of a step.
//!
//! The small seta of `setup.rs`, with other numbers where they stand. Expected values stand with each test.

use super::setup::{along_normal, model, pulled, small};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use peelkit::model::{Seta, Sideways, TipBranch};
use peelkit::study::{
    Bound, EventCause, SetaEnd, SetaLoading, SetaOptions, SetaProgress, SetaPullOff, SetaStart, SetaStep, Stage,
    StepEnd, StopCriteria, StopReason, pull_off, pull_off_from,
};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The error of the length of the worst quaternion of a state.
fn worst_norm(run: &SetaPullOff) -> f64 {
    let norm = |q: [f64; 4]| (q.iter().map(|x| x * x).sum::<f64>().sqrt() - 1.0).abs();
    run.last.as_ref().unwrap().joints.iter().map(|joint| norm(joint.directors)).fold(0.0, f64::max)
}

/// Up and down by 60 nm again and again, ten thousand steps in all, with steps of 0.6 nm and no tip that detaches.
///
/// Reference: the path is elastic, so that every return is to the same equilibrium. Expected: quaternions of length one to 1e-14, force and energy at
/// the end those of the beginning to 1e-9, work zero to the balance of all steps, 1e-8 of the work there and back.
#[test]
fn ten_thousand_steps_do_not_drift() {
    let seta = model(small(), Sideways::Held(0.5));
    let cycles = 50;
    let steps: Vec<SetaStep> =
        (0..2 * cycles).map(|k| along_normal(if k % 2 == 0 { 1.0 } else { -1.0 }, StepEnd::Travel(60.0))).collect();
    let options = SetaOptions { first_step: 0.6, longest_step: 0.6, ..SetaOptions::default() };
    let loading = SetaLoading { start: SetaStart::Adhering, steps };
    let run = pull_off(&seta, &loading, &options, &StopCriteria::default()).unwrap();
    assert_eq!(run.end, SetaEnd::Completed);
    assert!(run.points.len() >= 10_000 && run.events.is_empty(), "{}", run.points.len());
    let (first, last) = (run.points[0], *run.points.last().unwrap());
    assert!(worst_norm(&run) < 1e-14, "{:.2e}", worst_norm(&run));
    (0..3).for_each(|i| assert_abs_diff_eq!(first.force[i], last.force[i], epsilon = 1e-9));
    assert_abs_diff_eq!(first.energy, last.energy, epsilon = 1e-8);
    let there = run.points.iter().map(|point| point.work).fold(0.0, f64::max);
    println!("{} points, norm {:.1e}, work {:.1e} of {there} aJ", run.points.len(), worst_norm(&run), last.work);
    assert!(last.work.abs() < 1e-8 * 2.0 * f64::from(cycles) * there, "{} of {there}", last.work);
}

/// Dragged by lengths that no sum of its steps is to the last digit, and pulled off; pulled up to displacements of that kind.
///
/// Expected: where a step or a bound is met to rounding it has been met. Each run ends, with the iterations of its neighbours: a step to what is left
/// by rounding alone leads nowhere, and was tried again without an end.
#[test]
fn ends_of_steps_are_met_to_rounding() {
    let seta = model(small(), Sideways::Held(0.5));
    let drag = |length| SetaStep { direction: [1.0, 0.0, 0.0], until: StepEnd::Travel(length) };
    for length in (0..36).map(|k| 10.0 + 1.4 * f64::from(k)) {
        let run = pulled(&seta, SetaStart::Adhering, &[drag(length)]);
        let last = run.points.last().unwrap();
        assert_eq!(run.end, SetaEnd::Completed);
        assert_abs_diff_eq!(last.root[0], length, epsilon = 1e-7);
        assert!(run.effort.newton_iterations < 80, "{length} nm: {:?}", run.effort);
        let stop = StopCriteria { displacement: Some(length), ..StopCriteria::default() };
        let run = pull_off(&seta, &SetaLoading::pull([1.0, 0.0, 0.0], 500.0), &SetaOptions::default(), &stop).unwrap();
        assert_eq!(run.end, SetaEnd::Bound(Bound::Displacement(length)));
        assert!(run.effort.newton_iterations < 80, "{length} nm: {:?}", run.effort);
    }
}

/// A seta whose tips stand far apart in height: where the lowest are pushed in, the highest are pulled.
///
/// Reference: equilibrium of the whole, the forces of the tips together are that on the root. Expected: at rest tips of both signs that add up to the
/// force on the root to 1e-7, the pull-off to its end, every tip detached once, balance to 1e-8.
#[test]
fn some_tips_are_pushed_in_while_others_pull() {
    let scattered = Seta { height_scatter: 60.0, ..small() };
    let run = pulled(
        &model(scattered.clone(), Sideways::Free),
        SetaStart::Adhering,
        &[along_normal(-1.0, StepEnd::Travel(20.0)), along_normal(1.0, StepEnd::Detached(5000.0))],
    );
    let pushed =
        pulled(&model(scattered, Sideways::Free), SetaStart::Adhering, &[along_normal(-1.0, StepEnd::Travel(20.0))]);
    let last = pushed.last.unwrap();
    let loads: Vec<f64> = last.tips.iter().map(|tip| tip.load[1]).collect();
    assert!(loads.iter().any(|load| *load > 0.1) && loads.iter().any(|load| *load < -0.1), "{loads:?}");
    assert_abs_diff_eq!(loads.iter().sum::<f64>(), -last.point.force[1], epsilon = 1e-7);
    assert_eq!(run.end, SetaEnd::Completed);
    assert_eq!(run.events.iter().flat_map(|event| &event.tips).count(), 4);
    assert!(run.imbalance() < 1e-8, "{:.2e}", run.imbalance());
}

/// Pulled off, pushed back to where it began, and pulled off again: a closed loop of the root.
///
/// Reference: a cycle that ends where it began has no change of energy. Expected: both pull-offs have the same force at their peak to 1e-9, and
/// between them, from detached to detached, the root has worked what events have released to 1e-8: hysteresis, more than zero.
#[test]
fn the_work_of_a_loop_is_what_its_events_release() {
    let pull = along_normal(1.0, StepEnd::Detached(5000.0));
    let steps =
        [pull, along_normal(-1.0, StepEnd::Preload(2.0)), pull, along_normal(-1.0, StepEnd::Preload(2.0)), pull];
    for sideways in [Sideways::Free, Sideways::Held(0.5)] {
        let run = pulled(&model(small(), sideways), SetaStart::Adhering, &steps);
        assert_eq!(run.end, SetaEnd::Completed);
        let peak = |step: usize| {
            let own = run.points.iter().filter(|point| point.step == step);
            own.map(|point| point.force_along).fold(0.0, f64::max)
        };
        assert_relative_eq!(peak(2), peak(4), max_relative = 1e-6);
        let end = |step: usize| run.points.iter().rfind(|point| point.step == step).unwrap();
        let (from, to) = (end(2), end(4));
        assert_abs_diff_eq!(from.energy, to.energy, epsilon = 1e-8);
        let (work, released) = (to.work - from.work, to.released - from.released);
        println!("{sideways:?}: a loop works {work} aJ and releases {released} aJ");
        assert!(work > 100.0);
        assert_relative_eq!(work, released, max_relative = 1e-8);
    }
}

/// Held tips while the root is pulled along the ground.
///
/// Where a tip lets go the displacement turns, and the tip that lets go is not the softest one. Expected: every tip that detaches while others hold
/// does so in an event that releases energy, and the seta, which nothing lifts, slides on by its tips sticking and slipping: its end is a
/// bound on the displacement, met to 1e-9, and the balance is 1e-8.
#[test]
fn held_tips_pulled_along_the_ground_stick_and_slip() {
    let loading = SetaLoading::pull([1.0, 0.0, 0.0], 60_000.0);
    let stop = StopCriteria { displacement: Some(4000.0), ..StopCriteria::default() };
    let seta = model(small(), Sideways::Held(0.5));
    let run = pull_off(&seta, &loading, &SetaOptions::default(), &stop).unwrap();
    println!("{:?}, {} points, {} events", run.end, run.points.len(), run.events.len());
    assert_eq!(run.end, SetaEnd::Bound(Bound::Displacement(4000.0)));
    assert_relative_eq!(run.points.last().unwrap().displacement, 4000.0, max_relative = 1e-9);
    assert!(!run.events.is_empty() && run.events.iter().all(|event| event.released > 0.0));
    assert!(run.imbalance() < 1e-8, "{:.2e}", run.imbalance());
}

/// An upright seta without scatter whose shaft is slender, pressed on: it buckles.
///
/// Reference: Euler's load of the shaft, π² EI/L² times a factor of its ends: 4 held at both, 1/4 free to sway at the lower one. Expected: a first loss of
/// stability within these bounds with an event or a turn of the branch, not a jump over it: the force on the root stays below the upper one,
/// energy is released in every event, and the balance is 1e-8.
#[test]
fn a_shaft_that_is_pressed_on_buckles() {
    let (length, diameter) = (6000.0, 150.0);
    let slender = Seta {
        shaft_angle: 0.0,
        brush_angle: 0.0,
        height_scatter: 0.0,
        shaft_length: length,
        shaft_diameter: diameter,
        ..small()
    };
    let second = std::f64::consts::PI * f64::powi(diameter, 4) / 64.0;
    let euler = std::f64::consts::PI.powi(2) * slender.material.youngs_modulus * second / (length * length);
    let run = pulled(
        &model(slender, Sideways::Held(5.0)),
        SetaStart::Adhering,
        &[along_normal(-1.0, StepEnd::Travel(600.0))],
    );
    let most = run.points.iter().map(|point| point.force_along).fold(0.0, f64::max);
    println!("Euler {euler} nN, most {most} nN, {:?}, {} events", run.end, run.events.len());
    for event in &run.events {
        println!(
            "  {:.4} nm {:.6} nN {} tips {:.3e} aJ",
            event.before.displacement,
            event.before.force_along,
            event.tips.len(),
            event.released
        );
    }
    assert_eq!(run.end, SetaEnd::Completed);
    let buckled = run.events.iter().find(|event| event.cause == EventCause::Buckling).unwrap();
    assert!(buckled.before.force_along > 0.25 * euler && buckled.before.force_along < 4.0 * euler);
    assert!(run.imbalance() < 1e-8, "{:.2e}", run.imbalance());
}

/// Stopped at any of its solves, also in the middle of a step, and resumed.
///
/// Reference: the run that nothing stops. Expected: the same result, bit for bit.
#[test]
fn stopped_in_the_middle_of_a_step_it_goes_on_bit_for_bit() {
    let seta = model(small(), Sideways::Held(0.5));
    let steps = vec![along_normal(1.0, StepEnd::Detached(5000.0)), along_normal(-1.0, StepEnd::Preload(0.5))];
    let loading = SetaLoading { start: SetaStart::Adhering, steps };
    let options = SetaOptions::default();
    let run = |stop: &StopCriteria, from| pull_off_from(&seta, &loading, &options, stop, from).unwrap();
    let whole = run(&StopCriteria::default(), None).0;
    assert!(whole.events.iter().flat_map(|event| &event.tips).any(|change| change.to == TipBranch::Attached));
    let mut reached: Option<SetaProgress> = None;
    for _ in 0..10_000 {
        let left = Arc::new(AtomicUsize::new(97));
        let stop = StopCriteria::default().or_when(move |stage| {
            let is_last = stage == Stage::Results && left.fetch_sub(1, Ordering::Relaxed) <= 1;
            is_last.then(|| left.store(1, Ordering::Relaxed)).map(|()| StopReason::Interrupted)
        });
        let (part, progress) = run(&stop, reached);
        if part.end == SetaEnd::Completed {
            assert_eq!(part, whole);
            return;
        }
        assert_eq!(part.end, SetaEnd::Bound(Bound::Interrupted));
        let written = serde_json::to_string(&progress.unwrap()).unwrap();
        reached = Some(serde_json::from_str(&written).unwrap());
    }
    panic!("it does not go on");
}
