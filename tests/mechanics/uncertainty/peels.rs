//! Uncertain peels against laws that hold exactly.
//!
//! References: the force is proportional to the width of a strip, and to Young's modulus and Hamaker's constant together; the steady force of a long
//! strip solves P + P²/(2EA) = -bΨ(y_eq, 0) (the first integral, `analytic::steady_force`), Kendall's at 90 degrees, with -Ψ ∝ A_H/r₀² at a gap far
//! below the height.
//!
//!     P |  /\____      the plateau P ≈ w b, w ∝ A_H r₀⁻²
//!       | /      \
//!       +---------- u
//!
//! Parameters: the paper's strip of 100 nm; a flexible one of 200 nm for the plateau; relative accuracy 1e-5 and 1e-4; some hundred samples.
//! Expected: a force that is proportional to powers of lognormal inputs is lognormal, its log deviation that of the powers, within the sampling error; a
//! sample is what a peel of its inputs gives, on any number of threads; derivatives are those of differences. Why: between the closed forms of
//! `closed_forms` and these laws nothing of the analysis is left unchecked.

use super::{input, plan};
use crate::common::paper_strip;
use peelkit::analytic::steady_force;
use peelkit::model::{PeelModel, StripModel};
use peelkit::study::uncertainty::{
    Analysis, DerivativesBy, Design, Distribution, Indices, Outcome, Plan, SampledPeel, Statistics, one_at_a_time,
    peel_numbers, sample, sobol_indices, taylor_by_differences, taylor_polynomials,
};
use peelkit::study::{Accuracy, PeelQuantity, StopCriteria, peel};

const BOUNDS: StopCriteria = StopCriteria::after_points(5000);

fn lognormal(median: f64, log_deviation: f64) -> Distribution {
    Distribution::Lognormal { median, log_deviation }
}

/// A strip with some of its numbers replaced.
fn strip(length: f64, set: impl Fn(&mut StripModel)) -> PeelModel {
    let mut strip = paper_strip(length, 1.0);
    set(&mut strip);
    PeelModel::from(strip)
}

fn values(outcomes: &[Option<Outcome>], number: usize) -> Vec<Option<f64>> {
    outcomes.iter().map(|outcome| outcome.as_ref().and_then(|outcome| outcome.values[number])).collect()
}

/// Width b, and E and A_H by the same factor c: P ∝ b c.
#[test]
fn a_force_that_is_a_product_is_lognormal() {
    let inputs = vec![input("b", lognormal(3.0, 0.2)), input("c", lognormal(1.0, 0.1))];
    let design = Design::new(plan(inputs, 640, 0)).unwrap();
    let model = |x: &[f64]| {
        Ok(strip(100.0, |strip| {
            strip.strip.width = x[0];
            strip.strip.material.youngs_modulus *= x[1];
            strip.adhesion.hamaker_constant *= x[1];
        }))
    };
    let (of, accuracy) = ([PeelQuantity::InitiationPeakForce], Accuracy::to(1e-5));
    let sampled = SampledPeel { model: &model, of: &of, accuracy: &accuracy, stop: &|| BOUNDS };
    let outcomes = sample(&design, &|| true, &|at| sampled.outcome(&design.inputs(at)));
    let taylors = taylor_polynomials(design.plan(), &sampled);
    assert_eq!(taylors.1, DerivativesBy::Sensitivities);
    let alone = one_at_a_time(design.plan(), 0.05, &sampled);
    let analysis = Analysis::new(design, &of, outcomes, taylors, alone);
    let number = &analysis.numbers[0];
    let one = peel(&strip(100.0, |_| {}), &accuracy, &BOUNDS).initiation_peak.unwrap().force;
    let exact = lognormal(3.0 * one, 0.05f64.sqrt());
    let found = number.statistics.as_ref().unwrap();
    let is_in = |value: f64, of: peelkit::study::uncertainty::Estimate| (of.value - value).abs() <= of.error;
    assert!(is_in(exact.mean(), found.mean) && is_in(exact.deviation(), found.deviation), "{found:?} {exact:?}");
    for quantile in &found.quantiles {
        let expected = exact.quantile(quantile.probability);
        let width = quantile.to - quantile.from;
        assert!((quantile.value - expected).abs() <= width, "{quantile:?} {expected}");
    }
    let share = |s: f64| (s * s).exp_m1() / 0.05f64.exp_m1();
    for (of, s) in number.indices.iter().zip([0.2, 0.1]) {
        assert!((of.first.value - share(s)).abs() <= 1.5 * of.first.error, "{of:?} {}", share(s));
    }
    // P = p b c: dP/db = P/b, d²P/(db dc) = P/(b c), no others
    let taylor = number.taylor.as_ref().unwrap();
    let (b, c) = (taylor.center[0], taylor.center[1]);
    let hessian = taylor.hessian.as_ref().unwrap();
    assert!((taylor.value / (one * b * c) - 1.0).abs() < 1e-5);
    assert!((taylor.gradient[0] * b / taylor.value - 1.0).abs() < 1e-5);
    assert!((taylor.gradient[1] * c / taylor.value - 1.0).abs() < 1e-5);
    assert!((hessian[(0, 1)] * b * c / taylor.value - 1.0).abs() < 1e-3, "{hessian}");
    assert!((hessian[(0, 0)] * b * b / taylor.value).abs() < 1e-3, "{hessian}");
    // of a product the quadratic is the product
    let second = &number.propagations[1];
    assert!(!second.fails() && second.mean_difference.value.abs() < 1e-4 * found.mean.value, "{second:?}");
    let [low, high] = number.alone[0];
    let ends = [0.05, 0.95].map(|p| lognormal(3.0, 0.2).quantile(p) * c * one);
    assert!((low.unwrap() / ends[0] - 1.0).abs() < 1e-5 && (high.unwrap() / ends[1] - 1.0).abs() < 1e-5);
}

/// The plateau is the steady force, sample by sample, and lognormal with the powers 1 of A_H and -2 of r₀; E does nothing to it.
#[test]
fn the_plateau_is_kendalls() {
    let inputs =
        vec![input("A_H", lognormal(0.1, 0.1)), input("r0", lognormal(0.4, 0.03)), input("E", lognormal(2.0, 0.2))];
    let design = Design::new(plan(inputs, 400, 0)).unwrap();
    let of_inputs = |x: &[f64]| {
        strip(200.0, |strip| {
            strip.adhesion.hamaker_constant = x[0];
            strip.adhesion.equilibrium_distance = x[1];
            strip.strip.material.youngs_modulus = x[2];
            strip.strip.material.bending_stiffness_factor = 0.01;
        })
    };
    let (of, accuracy) = ([PeelQuantity::PlateauForce], Accuracy::to(1e-4));
    let model = |x: &[f64]| Ok(of_inputs(x));
    let sampled = SampledPeel { model: &model, of: &of, accuracy: &accuracy, stop: &|| BOUNDS };
    let outcomes = sample(&design, &|| true, &|at| sampled.outcome(&design.inputs(at)));
    let values = values(&outcomes, 0);
    for (sample, value) in values.iter().enumerate().step_by(37) {
        let inputs = design.inputs(design.place(sample));
        let model = of_inputs(&inputs);
        let steady = steady_force(model.line_law().rest_energy(), inputs[2] * 10.0);
        assert!((value.unwrap() / steady - 1.0).abs() < 3e-3, "{value:?} {steady} {inputs:?}");
    }
    let logarithms: Vec<Option<f64>> = values.iter().map(|value| value.map(f64::ln)).collect();
    let found = Statistics::of(&design, &logarithms, &[]).unwrap();
    let expected = (0.1f64.powi(2) + (2.0 * 0.03f64).powi(2)).sqrt();
    assert!(
        (found.deviation.value - expected).abs() <= found.deviation.error + 0.01 * expected,
        "{found:?} {expected}"
    );
    let indices = sobol_indices(&design, &logarithms);
    let shares = [0.01, 0.0036, 0.0].map(|share| share / 0.0136);
    for (of, share) in indices.iter().zip(shares) {
        assert!((of.total.value - share).abs() <= of.total.error + 0.01, "{of:?} {share}");
    }
}

#[test]
fn a_sample_is_the_peel_of_its_inputs_on_any_number_of_threads() {
    let inputs = vec![input("h", Distribution::Normal { mean: 10.0, deviation: 0.5 }), input("E", lognormal(2.0, 0.2))];
    let plan = Plan { indices: Indices::Omitted, ..plan(inputs, 40, 2) };
    let design = Design::new(plan).unwrap();
    let of_inputs = |x: &[f64]| {
        strip(50.0, |strip| {
            strip.strip.height = x[0];
            strip.strip.material.youngs_modulus = x[1];
        })
    };
    let (of, accuracy) = (PeelQuantity::OF_A_PEEL, Accuracy::to(1e-4));
    let model = |x: &[f64]| if x[0] > 10.5 { Err("too high".to_owned()) } else { Ok(of_inputs(x)) };
    let sampled = SampledPeel { model: &model, of: &of, accuracy: &accuracy, stop: &|| BOUNDS };
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| sample(&design, &|| true, &|at| sampled.outcome(&design.inputs(at))))
    };
    let outcomes = on(1);
    assert_eq!(outcomes, on(3));
    let mut refused = 0;
    for (sample, outcome) in outcomes.iter().enumerate() {
        let (inputs, outcome) = (design.inputs(design.place(sample)), outcome.as_ref().unwrap());
        if inputs[0] > 10.5 {
            refused += 1;
            assert_eq!((outcome.cut_short.as_deref(), outcome.values[0]), (Some("too high"), None));
            continue;
        }
        let peel = peel(&of_inputs(&inputs), &accuracy, &BOUNDS);
        assert_eq!(outcome.values, of.map(|quantity| quantity.value(&peel)), "sample {sample}");
        assert_eq!(outcome.cut_short, None);
    }
    assert!(refused > 0);
    let taylors = (vec![None; of.len()], DerivativesBy::Differences);
    let analysis = Analysis::new(design, &of, outcomes, taylors, Vec::new());
    let [cut] = &analysis.cut_short()[..] else { panic!("one reason") };
    assert_eq!((cut.count, cut.reason.as_str()), (refused, "too high"));
    assert_eq!(analysis.numbers[0].statistics.as_ref().unwrap().missing, refused);
}

/// Whole paths and the path to the initiation peak alone give the same, and a sample that is stopped says so.
#[test]
fn the_initiation_peak_alone_is_that_of_the_whole_path() {
    let (model, accuracy) = (strip(100.0, |_| {}), Accuracy::to(1e-6));
    let peaks = [PeelQuantity::InitiationPeakForce, PeelQuantity::InitiationPeakDisplacement];
    let alone = peel_numbers(&model, &peaks, &accuracy, &|| BOUNDS);
    let whole = peel_numbers(&model, &PeelQuantity::OF_A_PEEL, &accuracy, &|| BOUNDS);
    for number in 0..2 {
        let (one, other) = (alone.values[number].unwrap(), whole.values[number].unwrap());
        assert!((one / other - 1.0).abs() < 2e-6, "{one} {other}");
    }
    let cut = peel_numbers(&model, &PeelQuantity::OF_A_PEEL, &accuracy, &|| StopCriteria::after_points(30));
    assert_eq!(cut.cut_short.as_deref(), Some("bounds.points = 30"));
}

/// Gradient and second derivatives by sensitivities against those by differences of whole peels, of a force, a place and a work.
#[test]
fn derivatives_are_those_of_differences() {
    let deviation = |mean: f64| Distribution::Normal { mean, deviation: 0.01 * mean };
    let inputs = vec![input("h", deviation(10.0)), input("E", deviation(2.0)), input("r0", deviation(0.4))];
    let plan = plan(inputs, 1000, 0);
    let model = |x: &[f64]| {
        Ok(strip(100.0, |strip| {
            strip.strip.height = x[0];
            strip.strip.material.youngs_modulus = x[1];
            strip.adhesion.equilibrium_distance = x[2];
        }))
    };
    let of = [PeelQuantity::InitiationPeakForce, PeelQuantity::FirstJumpDisplacement, PeelQuantity::FirstJumpWork];
    let accuracy = Accuracy::to(1e-9);
    let sampled = SampledPeel { model: &model, of: &of, accuracy: &accuracy, stop: &|| BOUNDS };
    let (exact, by) = taylor_polynomials(&plan, &sampled);
    assert_eq!(by, DerivativesBy::Sensitivities);
    for (exact, differences) in exact.iter().zip(taylor_by_differences(&plan, &sampled)) {
        let (exact, differences) = (exact.as_ref().unwrap(), differences.unwrap());
        // as powers: d ln Q/d ln p and p q/Q d²Q/(dp dq)
        let scale = |i: usize| exact.center[i] / exact.value;
        for i in 0..3 {
            assert!(scale(i) * (exact.gradient[i] - differences.gradient[i]).abs() < 1e-3, "{exact:?} {differences:?}");
            for j in 0..3 {
                let (one, other) = (exact.hessian.as_ref().unwrap(), differences.hessian.as_ref().unwrap());
                let apart = scale(i) * exact.center[j] * (one[(i, j)] - other[(i, j)]).abs();
                assert!(apart < 2e-2, "{apart} {exact:?} {differences:?}");
            }
        }
    }
}
