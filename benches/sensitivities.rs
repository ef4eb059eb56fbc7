//! Time and error of sensitivities: by the adjoint, and by central differences of whole peels.
//!
//!     cargo bench -p peelkit-benches --bench sensitivities
//!
//! The strip of 100 nm, by its seven numbers. First a table: the largest error of d ln Q/d ln p of peak force and peeling work, against the
//! adjoint at 1e-11, and the time beside that of the peel itself (the least of several). Then Criterion's times.

use criterion::{Criterion, criterion_group, criterion_main};
use peelkit::model::{Body, PeelModel, Strip, StripModel};
use peelkit::study::{Accuracy, Peel, PeelQuantity, StopCriteria, Variation, peel, sensitivities};
use std::hint::black_box;
use std::time::Instant;

const OF: [PeelQuantity; 2] = [PeelQuantity::InitiationPeakForce, PeelQuantity::FirstJumpWork];
/// Steps of the logarithm of a parameter
const STEPS: [f64; 3] = [1e-2, 1e-3, 1e-4];
const REPETITIONS: usize = 9;

fn model() -> PeelModel {
    StripModel::of_the_paper(100.0, 1.0).into()
}

fn peeled(model: &PeelModel, relative: f64) -> Peel {
    peel(model, &Accuracy::to(relative), &StopCriteria::default())
}

fn variations() -> Vec<Variation<'static>> {
    fn of_strip(key: &str, number: fn(&mut Strip) -> &mut f64) -> Variation<'static> {
        Variation::new(key, move |change| {
            let mut model = model();
            if let Body::Strip(strip) = &mut model.body {
                *number(strip) *= change.exp();
            }
            model
        })
    }
    let of_adhesion = |key: &str, number: fn(&mut PeelModel) -> &mut f64| {
        Variation::new(key, move |change| {
            let mut model = model();
            *number(&mut model) *= change.exp();
            model
        })
    };
    vec![
        of_strip("length", |strip| &mut strip.length),
        of_strip("height", |strip| &mut strip.height),
        of_strip("youngs_modulus", |strip| &mut strip.material.youngs_modulus),
        of_strip("poissons_ratio", |strip| &mut strip.material.poissons_ratio),
        of_strip("bending_stiffness_factor", |strip| &mut strip.material.bending_stiffness_factor),
        of_adhesion("hamaker_constant", |model| &mut model.adhesion.hamaker_constant),
        of_adhesion("equilibrium_distance", |model| &mut model.adhesion.equilibrium_distance),
    ]
}

/// d ln Q/d ln p, number by number.
fn by_adjoint(peel: &Peel, variations: &[Variation]) -> Vec<f64> {
    let found = sensitivities(peel, &OF, variations).expect("a strip has them");
    let one = |of: PeelQuantity, k: usize| Some(found.of(of, k)?.value / of.value(peel)?);
    let every = OF.into_iter().flat_map(|of| (0..variations.len()).map(move |k| (of, k)));
    every.map(|(of, k)| one(of, k).expect("the path has it")).collect()
}

fn by_differences(variations: &[Variation], relative: f64, step: f64) -> Vec<f64> {
    let beside: Vec<[Peel; 2]> =
        variations.iter().map(|v| [step, -step].map(|change| peeled(&(v.model)(change), relative))).collect();
    let ln = |of: PeelQuantity, peel: &Peel| of.value(peel).expect("the path has it").ln();
    let every = OF.into_iter().flat_map(|of| beside.iter().map(move |pair| (of, pair)));
    every.map(|(of, [more, less])| (ln(of, more) - ln(of, less)) / (2.0 * step)).collect()
}

/// The result, and the least time that it took, ms.
fn timed<R>(run: impl Fn() -> R) -> (R, f64) {
    let once = || {
        let begin = Instant::now();
        let result = black_box(run());
        (result, 1e3 * begin.elapsed().as_secs_f64())
    };
    (1..REPETITIONS).fold(once(), |best, _| {
        let next = once();
        if next.1 < best.1 { next } else { best }
    })
}

fn table(_: &mut Criterion) {
    let (model, variations) = (model(), variations());
    let reference = by_adjoint(&peeled(&model, 1e-11), &variations);
    let worst = |found: &[f64]| found.iter().zip(&reference).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    println!("| accuracy of the peel | its time, ms | adjoint: ms | error | differences, step | ms | error |");
    println!("|---|---|---|---|---|---|---|");
    for relative in [1e-4, 1e-6, 1e-8] {
        let (own, alone) = timed(|| peeled(&model, relative));
        let (found, adjoint) = timed(|| by_adjoint(&own, &variations));
        for step in STEPS {
            let (differences, time) = timed(|| by_differences(&variations, relative, step));
            let (error, other) = (worst(&found), worst(&differences));
            println!("| {relative:e} | {alone:.1} | {adjoint:.1} | {error:.0e} | {step:e} | {time:.0} | {other:.0e} |");
        }
    }
}

fn times(c: &mut Criterion) {
    let (model, variations) = (model(), variations());
    let own = peeled(&model, 1e-6);
    c.bench_function("sensitivities of a strip by 7 numbers", |b| b.iter(|| by_adjoint(black_box(&own), &variations)));
}

criterion_group! { name = benches; config = Criterion::default().sample_size(20); targets = table, times }
criterion_main!(benches);
