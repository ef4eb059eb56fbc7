//! What one evaluation costs at each level of coarse-graining.
//!
//!     cargo bench -p peelkit-benches --bench levels

use criterion::{Criterion, criterion_group, criterion_main};
use peelkit::adhesion::{
    Faces, HalfSpace, LatticeHalfSpace, Law, LennardJones, Level, LineLaw, LineLoad, Rule, TiltedBlock,
    body_force_by_volume,
};
use std::hint::black_box;
use std::num::NonZeroUsize;

const LAW: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };

fn rule(points: usize) -> Rule {
    Rule::new(NonZeroUsize::new(points).unwrap())
}

/// One point over the half space.
fn points(c: &mut Criterion) {
    let mut group = c.benchmark_group("a point");
    let density = 0.4f64.powi(-3);
    let pair = LennardJones::behind(&LAW, density, density);
    group.bench_function("pair of atoms, eq. (1)", |b| b.iter(|| pair.force_over_distance(black_box(0.25))));
    let lattice = LatticeHalfSpace { pair, spacing: 0.4, cutoff: 4.0 };
    group.bench_function("atom over a lattice, eq. (2)", |b| b.iter(|| lattice.force_on(black_box([0.1, 0.5, 0.0]))));
    let rays = rule(6);
    group.bench_function("half space by volume, eq. (7), 6³ points", |b| {
        b.iter(|| body_force_by_volume(&pair, density * density, black_box(0.5), &rays));
    });
    group.bench_function("body force, eq. (9)", |b| b.iter(|| LAW.body_force(black_box(0.5))));
    group.bench_function("traction, eq. (10)", |b| b.iter(|| LAW.traction(black_box(0.5))));
    let line =
        LineLaw { half_space: LAW, height: 10.0, law: Law::BodyForce, line_load: LineLoad::Full, far_face: true };
    let (sin, cos) = 0.35f64.sin_cos();
    group.bench_function("line load, eqs. (17)-(22)", |b| {
        b.iter(|| {
            let at = line.response(black_box(0.5), black_box(sin), black_box(cos));
            (at.by_gap, at.by_rotation)
        });
    });
    group.finish();
}

/// The piece of strip of figures/cost-against-error, each level with 16 points along an edge.
fn pieces(c: &mut Criterion) {
    let piece = TiltedBlock { half_space: LAW, length: 10.0, height: 10.0, tilt: 20f64.to_radians(), gap: 0.4 };
    let mut group = c.benchmark_group("a piece of strip");
    for (name, level) in [
        ("atoms 0.4 nm apart", Level::Atoms { spacing: 0.4, cutoff: 4.0 }),
        ("volumes", Level::Volumes { rule: rule(16), rays: rule(6) }),
        ("body force", Level::BodyForce { rule: rule(16) }),
        ("surface traction, all faces", Level::SurfaceTraction { rule: rule(16), faces: Faces::All }),
        ("surface traction, near faces", Level::SurfaceTraction { rule: rule(16), faces: Faces::Near }),
        ("line load", Level::LineLoad { rule: rule(16), far_face: true }),
    ] {
        group.bench_function(name, |b| b.iter(|| black_box(&piece).resultant(black_box(&level))));
    }
    group.finish();
}

criterion_group!(benches, points, pieces);
criterion_main!(benches);
