//! How a path ends, and what is true all along it.
//!
//! Reference: the definitions of the ends, of stability and of work in the design; ∫ P du by Simpson's rule.
//!
//!     pivoting               turned back              bound
//!          |  P = 0                    u = 0           P |  /|
//!          |                 ____________/               | / |  the path goes on, the scene
//!     _____|                 ===========                 |/  |  wanted no more
//!     on its left edge       as it lay before            +---+--- u
//!
//! Parameters: the paper's strip, L = 100 nm, EI × 1 (pivoting) and × 1e-4 (turned back); L = 1000 nm for the plateau.
//!
//! Expected: the named end, at the place that defines it; the number of negative eigenvalues 0 up to the snap-off and 1 behind
//! it; work equal to the area under the curve. Why: a user who reads `end` decides by it whether the peak is one.

use crate::common::{paper_strip, whole_peel, with_grip, with_load};
use peelkit::adhesion::LineLoad;
use peelkit::model::{Hold, StripModel};
use peelkit::solve::LimitPointKind;
use peelkit::study::{Accuracy, PathEnd, Peel, Stage, StopCriteria, StopReason, peel};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

const FREE: StopCriteria = StopCriteria::after_points(5000);

fn bounded(bounds: StopCriteria) -> Peel {
    peel(&paper_strip(100.0, 1.0), &Accuracy::to(1e-6), &bounds)
}

/// The reason of an end that a bound made.
#[track_caller]
fn bound_of(peel: &Peel) -> String {
    match &peel.end {
        PathEnd::Bound(bound) => bound.to_string(),
        other => panic!("expected a bound, ended {other:?}"),
    }
}

#[test]
fn strip_of_100_nm_pivots_on_its_edge() {
    let peel = whole_peel(&paper_strip(100.0, 1.0), 1e-6);
    assert_eq!(peel.end, PathEnd::Pivoting);
    let last = peel.points[peel.points.len() - 1];
    assert!(last.force.abs() < 1e-9, "P = {:e} nN at the last point", last.force);
    assert!(peel.points[1..peel.points.len() - 1].iter().all(|p| p.force > 0.0), "the force vanishes at the end only");
    let kinds: Vec<LimitPointKind> = peel.limit_points.iter().map(|l| l.kind).collect();
    assert_eq!(kinds[..2], [LimitPointKind::Load, LimitPointKind::Displacement][..], "peak, then snap-off: {kinds:?}");
    assert_eq!(kinds.iter().filter(|k| **k == LimitPointKind::Displacement).count(), 2, "{kinds:?}");
    // effort: 75 points, 253 iterations, 14 elements when written
    let effort = peel.effort;
    assert!(effort.points <= 94 && effort.newton_iterations <= 316 && effort.elements <= 17, "{effort:?}");
}

#[test]
fn soft_strip_closes_again() {
    let peel = whole_peel(&paper_strip(100.0, 1e-4), 1e-6);
    assert_eq!(peel.end, PathEnd::TurnedBack);
    let last = peel.points[peel.points.len() - 1];
    assert!(last.displacement.abs() < 1e-9, "u = {:e} nm at the last point", last.displacement);
    assert!(peel.snap_off.is_some());
    // effort: 136 points, 785 iterations, 24 elements when written
    let effort = peel.effort;
    assert!(effort.points <= 170 && effort.newton_iterations <= 980 && effort.elements <= 30, "{effort:?}");
}

#[test]
fn bound_on_points() {
    let peel = bounded(StopCriteria { points: 12, ..FREE });
    assert_eq!(peel.points.len(), 12);
    assert_eq!(bound_of(&peel), "bounds.points = 12");
}

#[test]
fn bound_on_displacement() {
    let peel = bounded(StopCriteria { displacement: Some(10.0), ..FREE });
    assert_eq!(bound_of(&peel), "bounds.displacement = 10 nm");
    let (last, before) = (peel.points.len() - 1, peel.points.len() - 2);
    assert!(peel.points[last].displacement > 10.0 && peel.points[before].displacement <= 10.0);
    assert!(peel.snap_off.is_none(), "the snap-off lies beyond 10 nm");
    assert!(peel.initiation_peak.is_some(), "the peak lies before 10 nm");
}

#[test]
fn bound_on_time() {
    // no time at all: whatever the machine, it is over at once
    let peel = bounded(FREE.or_when(|stage| (stage == Stage::Path).then_some(StopReason::Time { seconds: 0.0 })));
    assert_eq!(bound_of(&peel), "bounds.time = 0 s");
}

#[test]
fn a_bound_beyond_the_path_changes_nothing() {
    let free = bounded(FREE);
    let wide = bounded(StopCriteria { displacement: Some(1e6), ..FREE }.or_when(|_| None));
    assert_eq!((wide.points, wide.limit_points, wide.end), (free.points, free.limit_points, free.end));
}

/// 0 up to the snap-off, 1 on the way back, 0 where u grows again; under a weight 1 more where P falls.
#[test]
fn negative_eigenvalues_tell_the_snap_off() {
    for model in [paper_strip(100.0, 1.0), with_grip(paper_strip(100.0, 1.0), Hold::Fixed, Hold::Free)] {
        let peel = whole_peel(&model, 1e-6);
        let turns: Vec<usize> =
            peel.limit_points.iter().filter(|l| l.kind == LimitPointKind::Displacement).map(|l| l.after).collect();
        assert!(turns.len() >= 2, "{:?}", peel.limit_points);
        for (i, p) in peel.points[..peel.points.len() - 1].iter().enumerate() {
            let passed = turns.iter().filter(|&&after| i > after).count();
            assert_eq!(p.negative_eigenvalues, passed % 2, "point {i} of {}", peel.points.len());
        }
        let peak = peel.initiation_peak.expect("there is a peak");
        for p in peel.points.iter().take(turns[0]) {
            let falling = p.displacement > peak.displacement && p.force < peak.force;
            assert_eq!(p.negative_eigenvalues_load, usize::from(falling), "u = {} nm", p.displacement);
        }
    }
}

/// ∫ P du by Simpson's rule in the parameter of the curve: P and u parabolas through three points.
fn area_of(three: [(f64, f64, usize); 3]) -> f64 {
    let [u0, u1, u2] = three.map(|p| p.0);
    let [p0, p1, p2] = three.map(|p| p.1);
    (p0 * (4.0 * u1 - 3.0 * u0 - u2) + 4.0 * p1 * (u2 - u0) + p2 * (u0 - 4.0 * u1 + 3.0 * u2)) / 6.0
}

/// Work at every point of the path and at the snap-off is the area under the dense curve.
#[track_caller]
fn assert_work_is_area(model: &StripModel) {
    const PER_STEP: usize = 40;
    let peel = whole_peel(model, 1e-8);
    let curve = peel.dense_curve(PER_STEP);
    assert_eq!(curve.len(), (peel.points.len() - 1) * PER_STEP + 1);
    let largest = peel.points.iter().map(|p| p.work.abs()).fold(0.0, f64::max);
    let areas = |from: usize, to: usize| -> f64 {
        curve[from..=to].windows(3).step_by(2).map(|three| area_of([three[0], three[1], three[2]])).sum()
    };
    let mut area = 0.0;
    for (i, p) in peel.points.iter().enumerate() {
        let off = (p.work - area).abs() / largest;
        assert!(off < 2e-5, "point {i}, u = {} nm: work {} aJ, area {area} aJ, {off:.1e}", p.displacement, p.work);
        if i + 1 < peel.points.len() {
            area += areas(i * PER_STEP, (i + 1) * PER_STEP);
        }
    }
    // between the snap-off and the point before it the force is nearly linear in the displacement
    let snap = peel.snap_off.expect("snaps off");
    let before = peel.points[snap.after];
    let step = 0.5 * (before.force + snap.force) * (snap.displacement - before.displacement);
    let rest = (snap.work - before.work - step).abs();
    assert!(
        rest < 0.1 * step.abs() + 1e-6 * largest,
        "work at the snap-off {} aJ, before it {} aJ",
        snap.work,
        before.work
    );
}

#[test]
fn work_is_the_area_under_the_curve() {
    assert_work_is_area(&paper_strip(100.0, 1.0));
}

#[test]
fn work_is_the_area_under_the_curve_of_a_softer_strip() {
    assert_work_is_area(&paper_strip(100.0, 0.01));
}

#[test]
fn work_is_the_area_under_the_curve_of_a_held_strip() {
    assert_work_is_area(&with_grip(paper_strip(100.0, 1.0), Hold::Free, Hold::Fixed));
}

#[test]
fn work_is_the_area_under_the_curve_of_a_clamped_strip() {
    assert_work_is_area(&with_grip(paper_strip(100.0, 1.0), Hold::Fixed, Hold::Fixed));
}

/// Without a potential the work is an integral itself, over the same interpolants; tests/mechanics/beam/first_integral.rs has another.
#[test]
fn work_is_the_area_under_the_curve_without_a_potential() {
    assert_work_is_area(&with_load(paper_strip(100.0, 1.0), LineLoad::ForceOnly));
}

/// Between two points with no turn between them, the dense curve goes neither back nor beyond.
#[track_caller]
fn assert_dense_curve_stays_between(model: &StripModel, relative: f64) {
    const PER_STEP: usize = 40;
    let peel = whole_peel(model, relative);
    let curve = peel.dense_curve(PER_STEP);
    for i in 0..peel.points.len() - 1 {
        if peel.limit_points.iter().any(|l| l.after == i && l.kind == LimitPointKind::Displacement) {
            continue;
        }
        let (from, to) = (peel.points[i].displacement, peel.points[i + 1].displacement);
        let slack = 1e-3 * (to - from).abs();
        for &(u, _, _) in &curve[i * PER_STEP..=(i + 1) * PER_STEP] {
            let inside = u > from.min(to) - slack && u < from.max(to) + slack;
            assert!(inside, "u = {u} nm behind point {i}, which goes from {from} to {to}");
        }
    }
}

#[test]
fn dense_curve_stays_between_its_points() {
    assert_dense_curve_stays_between(&paper_strip(100.0, 1.0), 1e-6);
    assert_dense_curve_stays_between(&paper_strip(1000.0, 1.0), 1e-6);
}

#[test]
fn dense_curve_of_a_soft_strip_stays_between_its_points() {
    assert_dense_curve_stays_between(&paper_strip(100.0, 0.01), 1e-8);
    assert_dense_curve_stays_between(&paper_strip(100.0, 1e-4), 1e-10);
}

#[test]
fn dense_curve_in_a_guided_grip_stays_between_its_points() {
    assert_dense_curve_stays_between(&with_grip(paper_strip(100.0, 1.0), Hold::Fixed, Hold::Free), 1e-6);
}

#[test]
fn plateau_only_where_the_strip_is_long() {
    assert_eq!(whole_peel(&paper_strip(100.0, 1.0), 1e-6).plateau, None);
    let long = whole_peel(&paper_strip(1000.0, 1.0), 1e-6);
    let plateau = long.plateau.expect("1000 nm has a plateau");
    let snap = long.snap_off.expect("1000 nm snaps off");
    let peak = long.initiation_peak.expect("1000 nm has a peak");
    assert!(plateau.displacement > peak.displacement && plateau.displacement < snap.displacement);
    assert!(plateau.force < 0.2 * peak.force);
}

/// A long, thick strip, whose accuracy asks for several meshes: a caller who has no more time behind the first is told that this ended the search for
/// a better one, where its error bounds are too large.
#[test]
fn a_caller_who_stops_the_search_for_a_better_mesh_reads_so() {
    let mut model = paper_strip(8475.0, 0.0698);
    model.strip.height = 94.18;
    model.strip.material.poissons_ratio = 0.032;
    model.adhesion.line_load = LineLoad::ForceOnly;
    model.adhesion.hamaker_constant = 0.01782;
    model.adhesion.equilibrium_distance = 0.2142;
    model.grip.rotation = Hold::Fixed;
    let asked = Arc::new(AtomicUsize::new(0));
    let after = |most: usize| {
        let asked = asked.clone();
        asked.store(0, Ordering::Relaxed);
        FREE.or_when(move |stage| {
            let over = stage == Stage::Path && asked.fetch_add(1, Ordering::Relaxed) > most;
            over.then_some(StopReason::Time { seconds: 1.0 })
        })
    };
    let whole = peel(&model, &Accuracy::to(1e-6), &after(usize::MAX));
    assert!(!matches!(whole.end, PathEnd::Failed(_)), "{:?}", whole.end);
    let times = asked.load(Ordering::Relaxed);
    let ends: Vec<String> = [0.5, 0.6, 0.7, 0.8, 0.9]
        .map(|part| match peel(&model, &Accuracy::to(1e-6), &after((part * times as f64) as usize)).end {
            PathEnd::Failed(failure) => failure.to_string(),
            other => format!("{other:?}"),
        })
        .into();
    let told = ends.iter().filter(|end| {
        end.starts_with("the error bounds are") && end.ends_with("bounds.time = 1 s ended the search for a better mesh")
    });
    assert!(told.count() > 0, "{ends:#?}");
    assert!(ends.iter().all(|end| !end.ends_with("to stop before")), "{ends:#?}");
}
