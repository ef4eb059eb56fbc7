//! What a user waits for, and the kernels that it is made of.
//!
//!     cargo bench -p peelkit-benches --bench peel

mod common;

use common::Setting;
use criterion::{Criterion, criterion_group, criterion_main};
use peelkit::model::{Form, StripModel};
use peelkit::solve::{MOST_POINTS, Pace, Path, PathOptions};
use peelkit::study::{Accuracy, PeelResult, PointKind, Spacing, StopCriteria, follow_point, peel, sweep};
use std::hint::black_box;

const DEFAULT: Accuracy = Accuracy::to(1e-6);
const BOUNDS: StopCriteria = StopCriteria::after_points(5000);

/// The paper's strip.
fn strip(length: f64, factor: f64) -> StripModel {
    StripModel::of_the_paper(length, factor)
}

/// The full path with special points and error bounds.
fn paths(c: &mut Criterion) {
    let mut group = c.benchmark_group("peel");
    for (name, length, factor) in [("100 nm", 100.0, 1.0), ("100 nm, EI x 1e-4", 100.0, 1e-4), ("10000 nm", 1e4, 1.0)] {
        let model = strip(length, factor);
        group.bench_function(name, |b| b.iter(|| peel(black_box(&model), &DEFAULT, &BOUNDS)));
    }
    group.finish();
}

/// The path alone, points only, without limit points and bounds, at what is chosen for 1e-8.
fn path_alone(c: &mut Criterion) {
    let problem = strip(100.0, 1.0).problem(Form::TwoField, 7).unwrap();
    let options = PathOptions {
        elements: 20,
        step_tolerance: 3.8e-3,
        stride: 1.0,
        longest: None,
        tolerance: 1e-10,
        prediction: MOST_POINTS,
        first_displacement: 0.008,
        pace: Pace::Quick,
    };
    c.bench_function("path alone, 100 nm at 1e-8", |b| {
        b.iter(|| {
            let mut path = Path::new(black_box(&problem), options);
            while path.advance().is_ok_and(|point| path.points().len() < 3 || point.observables.force > 0.0) {}
            (path.points().len(), path.iterations())
        });
    });
}

/// EI/EI0 from 1e-4 to 1e4 in 33 points, each the full path, on all cores.
fn stiffness_sweep(c: &mut Criterion) {
    let cases: Vec<_> = (0..33).map(|k| strip(100.0, 10f64.powf(-4.0 + 0.25 * f64::from(k)))).collect();
    let run = |model: &StripModel| PeelResult::from(&peel(model, &DEFAULT, &BOUNDS));
    c.bench_function("sweep of 33 stiffnesses", |b| b.iter(|| sweep(black_box(&cases), &|| true, &run)));
}

/// The initiation peak followed over EI/EI0 from 1e-4 to 1e4 in 1000 values at 1e-8, on one core: time a thousand values.
fn peak_only(c: &mut Criterion) {
    let values: Vec<f64> = (0..1000).map(|k| 10f64.powf(-4.0 + 8.0 * f64::from(k) / 999.0)).collect();
    let model = |factor| strip(100.0, factor);
    let accuracy = Accuracy::to(1e-8);
    c.bench_function("peak followed over 1000 stiffnesses", |b| {
        b.iter(|| {
            let values = black_box(&values);
            follow_point(
                PointKind::InitiationPeak,
                values,
                Spacing::Logarithmic,
                &model,
                &accuracy,
                &|| BOUNDS,
                &|_| (),
            )
        });
    });
}

/// The law at four points side by side, an element of each order, and a Newton iteration beside the bare law at its points.
fn kernels(c: &mut Criterion) {
    let mut setting = Setting::new(12, 7);
    for points in [4, 84] {
        c.bench_function(&format!("line law, all derivatives, at {points} points"), |b| b.iter(|| setting.law(points)));
    }
    c.bench_function("Newton iteration, 12 elements of order 7: 84 points", |b| b.iter(|| setting.iterate()));
    c.bench_function("energy alone, 12 elements of order 7", |b| b.iter(|| setting.energy()));
    let mut group = c.benchmark_group("4 elements, integrated and eliminated");
    for order in 1..=8 {
        let mut setting = Setting::new(4, order);
        group.bench_function(format!("order {order}"), |b| b.iter(|| setting.eliminate()));
    }
    group.finish();
}

criterion_group!(benches, paths, path_alone, stiffness_sweep, peak_only, kernels);
criterion_main!(benches);
