//! What a user waits for, and the two kernels that it is made of.
//!
//!     cargo bench --bench peel

use criterion::{Criterion, criterion_group, criterion_main};
use peelkit::model::{Form, StripModel};
use peelkit::solve::{PathRow, Workspace};
use peelkit::study::{Accuracy, Bounds, PointKind, Spacing, SweepCase, follow_point, peel, sweep};
use std::hint::black_box;

const DEFAULT: Accuracy = Accuracy::to(1e-6);
const BOUNDS: Bounds = Bounds { points: 5000, time_s: None, displacement: None };

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

/// EI/EI0 from 1e-4 to 1e4 in 33 points, each the full path, on all cores.
fn stiffness_sweep(c: &mut Criterion) {
    let case = |value| SweepCase { value, model: strip(100.0, value), accuracy: DEFAULT, bounds: BOUNDS };
    let cases: Vec<_> = (0..33).map(|k| case(10f64.powf(-4.0 + 0.25 * f64::from(k)))).collect();
    c.bench_function("sweep of 33 stiffnesses", |b| b.iter(|| sweep(black_box(&cases), &|| true, &|_| ())));
}

/// The initiation peak followed over EI/EI0 from 1e-4 to 1e4 in 1000 values at 1e-8, on one core: time a thousand values.
fn peak_only(c: &mut Criterion) {
    let values: Vec<f64> = (0..1000).map(|k| 10f64.powf(-4.0 + 8.0 * f64::from(k) / 999.0)).collect();
    let model = |factor| strip(100.0, factor);
    let accuracy = Accuracy::to(1e-8);
    c.bench_function("peak followed over 1000 stiffnesses", |b| {
        b.iter(|| {
            let values = black_box(&values);
            follow_point(PointKind::InitiationPeak, values, Spacing::Logarithmic, &model, &accuracy, &BOUNDS, &|| ())
        });
    });
}

fn kernels(c: &mut Criterion) {
    let model = strip(100.0, 1.0);
    let law = model.line_law();
    let (sin, cos) = 0.3f64.sin_cos();
    c.bench_function("line law, all derivatives", |b| {
        b.iter(|| law.response(black_box(0.3), black_box(sin), black_box(cos)));
    });

    let problem = model.problem(Form::TwoField, 7);
    let at = problem.at_rest(12);
    let (row, mut work) = (PathRow::default(), Workspace::default());
    c.bench_function("elimination, 12 elements of order 7", |b| {
        b.iter(|| problem.chain.eliminate(black_box(at.configuration()), &row, &mut work));
    });
}

criterion_group!(benches, paths, stiffness_sweep, peak_only, kernels);
criterion_main!(benches);
