//! A Newton iteration in the plane and in space, on the same 12 elements of order 7, and whole peels in space at 1e-6: of the strip of
//! scenes/strip-sideways.toml, pulled sideways at 60 degrees, and of the spatula of scenes/spatula.toml, sideways at 60 degrees and straight
//! up.
//!
//!     cargo bench -p peelkit-benches --bench space

#[path = "common/iteration.rs"]
mod iteration;

use criterion::{Criterion, criterion_group, criterion_main};
use iteration::Iteration;
use peelkit::model::{Body, Form, PeelModel, Space, Spatula, StripModel};
use peelkit::study::{Accuracy, StopCriteria, peel};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

fn iterations(c: &mut Criterion) {
    let mut group = c.benchmark_group("Newton iteration, 12 elements of order 7");
    for (name, mut of) in [
        ("in the plane, two fields", Iteration::planar(Form::TwoField)),
        ("in the plane, three fields", Iteration::planar(Form::ThreeField)),
        ("in space", Iteration::spatial()),
    ] {
        group.bench_function(name, |b| b.iter(|| of.iterate()));
        group.bench_function(format!("{name}: factorised"), |b| b.iter(|| of.factorise()));
        group.bench_function(format!("{name}: the way back"), |b| b.iter(|| of.recover()));
        group.bench_function(format!("{name}: energy alone"), |b| b.iter(|| of.evaluate()));
    }
    group.finish();
}

fn whole_peels(c: &mut Criterion) {
    let mut strip = PeelModel::from(StripModel::of_the_paper(100.0, 1.0));
    if let Body::Strip(strip) = &mut strip.body {
        strip.width = 40.0;
    }
    strip.pull.angle = FRAC_PI_3;
    strip.space = Some(Space { azimuth: FRAC_PI_2, ..Space::default() });
    let mut group = c.benchmark_group("Whole peel in space at 1e-6");
    group.sample_size(20);
    group.bench_function("strip pulled sideways", |b| {
        b.iter(|| peel(&strip, &Accuracy::to(1e-6), &StopCriteria::default()))
    });
    let mut spatula = Spatula::default().model();
    spatula.space = Some(Space { azimuth: FRAC_PI_2, ..Space::default() });
    group.bench_function("spatula pulled straight up", |b| {
        b.iter(|| peel(&spatula, &Accuracy::to(1e-6), &StopCriteria::default()))
    });
    spatula.pull.angle = FRAC_PI_3;
    group.bench_function("spatula pulled sideways", |b| {
        b.iter(|| peel(&spatula, &Accuracy::to(1e-6), &StopCriteria::default()))
    });
    group.finish();
}

criterion_group!(benches, iterations, whole_peels);
criterion_main!(benches);
