//! A Newton iteration in the plane and in space, on the same 12 elements of order 7.
//!
//!     cargo bench -p peelkit-benches --bench space

#[path = "common/iteration.rs"]
mod iteration;

use criterion::{Criterion, criterion_group, criterion_main};
use iteration::Iteration;
use peelkit::model::Form;

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

criterion_group!(benches, iterations);
criterion_main!(benches);
