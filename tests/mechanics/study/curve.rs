//! The curve between the points of a path.
//!
//! Reference: solved points of the same path on a finer mesh with steps of their own, so that they lie anywhere between
//! the points that are judged. Strip of the paper, 100 and 200 nm, and a soft one.
//!
//! Expected: the interpolated curve, sampled 200 times a step, passes the reference points within 0.1 times the square root of the
//! accuracy asked for (1e-4 at 1e-6, 1e-5 at 1e-8). Distances are relative to displacement and force; forces below a
//! hundredth of the largest one and displacements below r0/100 count as they are. Where a soft strip closes again, steps are long for
//! what the curve does and slopes are good to few digits: three times as much is allowed there.

use peelkit::model::StripModel;
use peelkit::study::{Accuracy, Choice, Peel, StopCriteria, peel};

const BOUNDS: StopCriteria = StopCriteria::after_points(5000);

/// The largest distance of reference points from a curve.
fn distance(reference: &Peel, curve: &[(f64, f64, usize)]) -> f64 {
    let largest = reference.points.iter().map(|p| p.force).fold(0.0, f64::max);
    let mut near = 0;
    let mut worst = 0.0f64;
    for point in &reference.points[1..reference.points.len() - 1] {
        let scale = (1.0 / (point.displacement + 0.004), 1.0 / (point.force + 0.01 * largest));
        let away = |at: (f64, f64, usize)| ((at.0 - point.displacement) * scale.0, (at.1 - point.force) * scale.1);
        let from = |i: usize| {
            let (a, b) = (away(curve[i]), away(curve[i + 1]));
            let (dx, dy) = (b.0 - a.0, b.1 - a.1);
            let along = (-(a.0 * dx + a.1 * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
            (a.0 + along * dx).hypot(a.1 + along * dy)
        };
        // both go the same way
        let window = near..(near + curve.len() / 4).min(curve.len() - 1);
        near = window.min_by(|&a, &b| from(a).total_cmp(&from(b))).unwrap();
        worst = worst.max(from(near));
    }
    worst
}

fn curve_is_good(length: f64, factor: f64, relative: f64, wanted: f64) {
    let model = StripModel::of_the_paper(length, factor);
    let fine = Accuracy::to(1e-10);
    let reference = peel(&model, &fine.with(Choice { step: Some(2e-3), ..fine.choice }), &BOUNDS);
    let peel = peel(&model, &Accuracy::to(relative), &BOUNDS);
    let found = distance(&reference, &peel.dense_curve(200));
    println!(
        "L = {length} nm, EI x {factor:e}, relative {relative:e}: {found:.2e}, {} points, {} iterations",
        peel.effort.points, peel.effort.newton_iterations
    );
    assert!(found < wanted, "{found:e}");
}

#[test]
fn the_curve_keeps_up_with_the_points() {
    for (length, factor) in [(100.0, 1.0), (200.0, 10.0)] {
        for (relative, wanted) in [(1e-4, 1e-3), (1e-6, 1e-4), (1e-8, 1e-5)] {
            curve_is_good(length, factor, relative, wanted);
        }
    }
}

#[test]
fn the_curve_of_a_soft_strip_that_closes_again() {
    curve_is_good(100.0, 1e-3, 1e-6, 3e-4);
}
