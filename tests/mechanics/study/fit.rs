//! Parameters of a strip from curves that were computed with known ones and made noisy.
//!
//!      P |  .o            o  measured: P(U) with normal errors of standard deviation s
//!        | o   `o         U = u + P/k of the machine, recorded from d on
//!        | |      o  o o
//!        |_|__________|___ o o o   the test jumps, and the force is zero
//!          d          d*       U + d
//!
//! Reference: the parameters with which the curves were computed. Of 100 intervals at 95 % about 95 hold them: with the probability 0.997 at least 89.
//! 30 are computed; `PEELKIT_REPETITIONS=100` computes as many as the documents name.
//! A plateau is w, the work of adhesion, 15^(1/3) A_H/(16π r0²): a curve without its first peak determines A_H r0⁻² and neither of the two.
//! Parameters: the paper's strip of 100 nm, errors of 1 % of its first peak, seeds that are fixed.
//! Expected: intervals hold what they say; Huber's loss withstands points that are wrong; a profile is a parabola where the data are good.
//! Why: a number from a fit is of use with an interval that can be believed.

use crate::common::paper_strip;
use peelkit::model::{Body, PeelModel, Range};
use peelkit::study::{
    Accuracy, CurveBy, DisplacementError, Fit, FitCurve, FitDataError, FitEnd, FitOptions, FitParameter, FitProblem,
    FitWarning, Loss, MeasuredCurve, MeasuredPoint, ModelOf, NoFit, ParameterOf, PointPlace, ProfileChoice,
    PulledCurve, StationAt, StationQuantity, StopCriteria, fit, peel,
};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use rayon::prelude::*;

/// Standard error of a force, nN: one hundredth of the first peak.
const NOISE: f64 = 3.4e-3;
const ACCURACY: Accuracy = Accuracy::to(1e-5);

/// What is known: A_H (aJ), r0 (nm), E (GPa), k (nN/nm) and d (nm).
#[derive(Clone, Copy)]
struct Truth {
    hamaker: f64,
    distance: f64,
    modulus: f64,
    stiffness: Option<f64>,
    zero: f64,
    /// h, nm, which is never fitted
    height: f64,
}

const TRUTH: Truth = Truth { hamaker: 0.1, distance: 0.4, modulus: 2.0, stiffness: None, zero: 0.0, height: 10.0 };

fn model(truth: Truth) -> PeelModel {
    let mut model = PeelModel::from(paper_strip(100.0, 1.0));
    let Body::Strip(strip) = &mut model.body else { panic!("a strip") };
    (strip.material.youngs_modulus, strip.height) = (truth.modulus, truth.height);
    (model.adhesion.hamaker_constant, model.adhesion.equilibrium_distance) = (truth.hamaker, truth.distance);
    model.grip.stiffness = truth.stiffness;
    model
}

/// Which of the numbers are fitted, by name, and where the search begins.
fn parameters(names: &[(&'static str, f64)]) -> Vec<FitParameter> {
    let parameter = |&(name, initial): &(&'static str, f64)| {
        let zero = name.contains("zero");
        FitParameter {
            key: name.into(),
            initial,
            range: if zero { Range::OFFSET } else { Range::Positive },
            from: None,
            to: None,
            of: match name {
                "zero" => ParameterOf::DisplacementZero { curve: 0 },
                "force zero" => ParameterOf::ForceZero { curve: 0 },
                _ => ParameterOf::Model,
            },
        }
    };
    names.iter().map(parameter).collect()
}

fn of<'t>(truth: &'t mut Truth, name: &str) -> Option<&'t mut f64> {
    match name {
        "hamaker" => Some(&mut truth.hamaker),
        "distance" => Some(&mut truth.distance),
        "modulus" => Some(&mut truth.modulus),
        "stiffness" => truth.stiffness.as_mut(),
        "zero" => Some(&mut truth.zero),
        _ => None,
    }
}

/// What is fitted to a curve that is not measured yet.
struct Asked {
    parameters: Vec<FitParameter>,
    model: ModelOf<'static>,
    by: CurveBy<'static>,
}

impl Asked {
    fn of(self, measured: MeasuredCurve) -> FitProblem<'static> {
        let Self { parameters, model, by } = self;
        FitProblem { parameters, curves: vec![FitCurve { by, ..FitCurve::of_peel(measured, model) }] }
    }
}

fn problem(truth: Truth, names: &'static [(&'static str, f64)]) -> Asked {
    let with = move |values: &[f64]| {
        let mut truth = truth;
        for (&(name, _), &value) in names.iter().zip(values) {
            of(&mut truth, name).into_iter().for_each(|place| *place = value);
        }
        model(truth)
    };
    Asked { parameters: parameters(names), model: Box::new(with), by: CurveBy::Peel }
}

/// Displacements of the grip at which the curve is measured, nm: close around the peak, and wider up to 45 nm.
fn places() -> impl Iterator<Item = f64> {
    (1..=15).map(|k| 0.1 * f64::from(k)).chain((1..=29).map(|k| 1.5 * f64::from(k) + 0.5))
}

/// The curve without errors: (U + d, P).
fn exact(truth: Truth, from: f64) -> Vec<(f64, f64)> {
    let peel = peel(&model(truth), &Accuracy::to(1e-7), &StopCriteria::default());
    let compliance = truth.stiffness.map_or(0.0, f64::recip);
    let at = |u: f64| {
        let force = peel.stations(StationAt { quantity: StationQuantity::Displacement, value: u }).found[0].force;
        (u + compliance * force + truth.zero, force)
    };
    places().filter(|&u| u > from).map(at).collect()
}

/// A normal number from two uniform ones (Box and Muller).
fn normal(random: &mut ChaCha8Rng) -> f64 {
    let mut uniform = || ((random.next_u64() >> 11) as f64 + 0.5) / (1u64 << 53) as f64;
    (-2.0 * uniform().ln()).sqrt() * (std::f64::consts::TAU * uniform()).cos()
}

fn noisy(exact: &[(f64, f64)], seed: u64) -> Vec<MeasuredPoint> {
    with_noise(exact, NOISE, seed)
}

fn with_noise(exact: &[(f64, f64)], noise: f64, seed: u64) -> Vec<MeasuredPoint> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let point = |&(displacement, force): &(f64, f64)| MeasuredPoint {
        displacement,
        force: force + noise * normal(&mut random),
        force_error: None,
    };
    exact.iter().map(point).collect()
}

fn fitted(asked: Asked, points: Vec<MeasuredPoint>, options: &FitOptions) -> Result<Fit, NoFit> {
    let curve = MeasuredCurve::new(points, None, Some(0.0)).unwrap();
    fit(&asked.of(curve), options, &ACCURACY, &StopCriteria::default)
}

/// Whether the interval of a parameter holds its true value.
fn holds(fit: &Fit, index: usize, truth: f64) -> bool {
    let [low, high] = fit.parameters[index].interval.unwrap();
    low <= truth && truth <= high
}

/// How many curves are made noisy and fitted: 12, or as many as `PEELKIT_REPETITIONS` says.
fn repetitions() -> u64 {
    std::env::var("PEELKIT_REPETITIONS").map_or(12, |number| number.parse().unwrap())
}

/// How many of so many repetitions have each true value in its interval.
fn counted(truth: Truth, names: &'static [(&'static str, f64)], exact: &[(f64, f64)], repetitions: u64) -> Vec<usize> {
    let options = FitOptions { profile: ProfileChoice::None, ..FitOptions::default() };
    let one = |seed: u64| -> Vec<bool> {
        let fit = fitted(problem(truth, names), noisy(exact, seed), &options).unwrap();
        assert!(fit.converged(), "repetition {seed}: {:?}", fit.end);
        let true_value = |name: &str| *of(&mut truth.clone(), name).unwrap();
        names.iter().enumerate().map(|(k, &(name, _))| holds(&fit, k, true_value(name))).collect()
    };
    let all: Vec<Vec<bool>> = (1..=repetitions).into_par_iter().map(one).collect();
    (0..names.len()).map(|k| all.iter().filter(|held| held[k]).count()).collect()
}

#[test]
fn intervals_hold_what_is_known_in_95_of_100_repetitions() {
    let repetitions = repetitions();
    let held = counted(TRUTH, &[("hamaker", 0.13), ("modulus", 1.5)], &exact(TRUTH, 0.0), repetitions);
    println!("{held:?} of {repetitions}");
    assert!(held.iter().all(|&count| 100 * count as u64 >= 89 * repetitions), "{held:?} of {repetitions}");
}

/// E = 3 GPa and A_H = 0.12 aJ, measured with errors of 0.02 nm and 0.004 nN that nobody has given: both are estimated. That of the displacements rests
/// on the few points where the curve is steep and comes out 18 % too small, so that intervals of 95 % hold what is known in 85 and 86 of 100
/// repetitions, which `docs/how-to/runs/fit.md` says; of the first 12 in 10 and 10. No fewer may.
#[test]
fn intervals_where_both_errors_are_estimated_are_somewhat_too_narrow() {
    let truth = Truth { hamaker: 0.12, modulus: 3.0, ..TRUTH };
    let (curve, problem) = (exact(truth, 0.0), || problem(truth, &[("hamaker", 0.1), ("modulus", 2.0)]));
    let one = |seed: u64| {
        let mut random = ChaCha8Rng::seed_from_u64(1000 + seed);
        let mut points = with_noise(&curve, 0.004, seed);
        points.iter_mut().for_each(|point| point.displacement += 0.02 * normal(&mut random));
        let options = FitOptions { profile: ProfileChoice::None, ..FitOptions::default() };
        let fit = fitted(problem(), points, &options).unwrap();
        let errors = [fit.estimated_error.unwrap(), fit.estimated_displacement_error.unwrap()];
        ([holds(&fit, 0, 0.12), holds(&fit, 1, 3.0)], errors)
    };
    let repetitions = repetitions();
    let all: Vec<_> = (1..=repetitions).into_par_iter().map(one).collect();
    let held = [0, 1].map(|k| all.iter().filter(|one| one.0[k]).count());
    let mean = [0, 1].map(|k| all.iter().map(|one| one.1[k]).sum::<f64>() / repetitions as f64);
    println!("{held:?} of {repetitions}, errors {mean:?}");
    let least = if repetitions < 100 { 80 } else { 83 };
    assert!(held.iter().all(|&count| 100 * count as u64 >= least * repetitions), "{held:?} of {repetitions}");
    assert!((mean[0] / 0.004 - 1.0).abs() < 0.15 && (mean[1] / 0.02 - 1.0).abs() < 0.25, "{mean:?}");
}

/// A load cell that shows 0.05 nN where nothing pulls, in a record that goes on behind the jump.
#[test]
fn the_zero_of_the_force_is_found_with_the_strip() {
    let mut curve = exact(TRUTH, 0.0);
    let jump = peel(&model(TRUTH), &Accuracy::to(1e-7), &StopCriteria::default()).snap_off.unwrap().displacement;
    curve.extend((0..6).map(|k| (jump + 0.3 + f64::from(k), 0.0)));
    let points: Vec<MeasuredPoint> =
        noisy(&curve, 5).into_iter().map(|point| MeasuredPoint { force: point.force + 0.05, ..point }).collect();
    let problem = problem(TRUTH, &[("hamaker", 0.12), ("modulus", 1.7), ("force zero", 0.0)]);
    let measured = MeasuredCurve::new(points, None, None).unwrap();
    assert_eq!(measured.behind_jump.len(), 6);
    let fit = fit(&problem.of(measured), &FitOptions::default(), &ACCURACY, &StopCriteria::default).unwrap();
    assert!(fit.converged() && holds(&fit, 0, 0.1) && holds(&fit, 1, 2.0) && holds(&fit, 2, 0.05), "{fit:?}");
    let half = |k: usize| fit.parameters[k].standard_error.unwrap();
    // six points without a force and 44 with one
    assert!(half(2) < 1.1 * NOISE / 6f64.sqrt() && fit.curves[0].force_zero == fit.parameters[2].value, "{}", half(2));
}

/// Stiffness and zero of the machine as well, and a jump: all at once.
#[test]
fn a_machine_is_found_with_the_strip() {
    let truth = Truth { stiffness: Some(0.5), zero: 1.3, ..TRUTH };
    let mut curve = exact(truth, 0.0);
    let peel = peel(&model(truth), &Accuracy::to(1e-7), &StopCriteria::default());
    // it jumps next to its rigid machine's jump: the force is so flat there
    let jump = peel.snap_off.unwrap().displacement + 2.0 * peel.snap_off.unwrap().force + truth.zero;
    curve.extend((0..6).map(|k| (jump + 0.3 + f64::from(k), 0.0)));
    let names: &[_] = &[("hamaker", 0.12), ("modulus", 1.7), ("stiffness", 0.8), ("zero", 1.0)];
    let problem = problem(truth, &[("hamaker", 0.12), ("modulus", 1.7), ("stiffness", 0.8), ("zero", 1.0)]);
    let fit = fitted(problem, noisy(&curve, 5), &FitOptions::default()).unwrap();
    assert!(fit.converged(), "{:?}", fit.end);
    for (k, &(name, _)) in names.iter().enumerate() {
        assert!(holds(&fit, k, *of(&mut truth.clone(), name).unwrap()), "{name}: {:?}", fit.parameters[k]);
    }
    let found = fit.curves[0].jump.unwrap();
    assert!(found.used && (found.modelled.unwrap() - found.displacement).abs() < 3.0 * found.error, "{found:?}");
    assert!((fit.estimated_error.unwrap() / NOISE - 1.0).abs() < 0.4);
}

/// Without the peak the curve knows the work of adhesion alone.
#[test]
fn what_a_plateau_does_not_tell_apart_is_poorly_determined_together() {
    let curve = exact(TRUTH, 3.0);
    let names: &'static [_] = &[("hamaker", 0.12), ("distance", 0.42)];
    let fit = fitted(problem(TRUTH, names), noisy(&curve, 1), &FitOptions::default()).unwrap();
    assert!(fit.parameters.iter().all(|parameter| parameter.poorly_determined), "{:?}", fit.parameters);
    let pair = &fit.pairs[0];
    assert!(pair.correlation > 0.95, "{pair:?}");
    assert!((pair.exponent.unwrap() + 2.0).abs() < 0.2, "{pair:?}");
    assert!(pair.relative_error.unwrap() < 0.02, "{pair:?}");
    assert!(fit.warnings().iter().any(|warning| matches!(warning, FitWarning::Together { .. })));
    let profile = fit.parameters[0].profile.as_ref().unwrap();
    assert!(profile.points.len() > 3, "{fit:?}");
    let known = |k: usize| fit.parameters[k].value;
    let work = known(0) / known(1).powi(2);
    assert!((work / (0.1 / 0.16) - 1.0).abs() < 0.04, "{work}");
}

#[test]
fn a_profile_is_a_parabola_where_the_data_are_good() {
    let noise = 0.1 * NOISE;
    let options = FitOptions { profile: ProfileChoice::All, force_error: Some(noise), ..FitOptions::default() };
    let names: &'static [_] = &[("hamaker", 0.13), ("modulus", 1.5)];
    let fit = fitted(problem(TRUTH, names), with_noise(&exact(TRUTH, 0.0), noise, 3), &options).unwrap();
    for parameter in &fit.parameters {
        let [low, high] = parameter.interval.unwrap();
        let [from, to] = parameter.profile.as_ref().unwrap().interval.map(Option::unwrap);
        let width = high - low;
        assert!((low - from).abs() < 0.03 * width && (high - to).abs() < 0.03 * width, "{parameter:?}");
        assert!(!parameter.poorly_determined && parameter.at_bound.is_none());
    }
    assert_eq!(fit.estimated_error, None);
    let reduced = fit.sum_of_squares / fit.degrees_of_freedom as f64;
    assert!((0.5..1.6).contains(&reduced), "{reduced}");
}

/// Three points that are wrong by thirty standard errors.
#[test]
fn a_robust_loss_withstands_wrong_points() {
    let mut points = noisy(&exact(TRUTH, 0.0), 7);
    for k in [12, 20, 33] {
        points[k].force += 30.0 * NOISE;
    }
    let names: &'static [_] = &[("hamaker", 0.13), ("modulus", 1.5)];
    let with = |loss| {
        let options = FitOptions { loss, profile: ProfileChoice::None, ..FitOptions::default() };
        fitted(problem(TRUTH, names), points.clone(), &options).unwrap()
    };
    let off = |fit: &Fit| (fit.parameters[0].value / 0.1 - 1.0).abs();
    let squares = with(Loss::Squares);
    for loss in [Loss::Huber, Loss::SoftL1] {
        let fit = with(loss);
        assert!(
            fit.converged() && off(&fit) < 0.5 * off(&squares),
            "{loss:?}: {} against {}",
            off(&fit),
            off(&squares)
        );
        assert!(holds(&fit, 0, 0.1) && holds(&fit, 1, 2.0), "{loss:?}: {:?}", fit.parameters);
        assert!([12, 20, 33].iter().all(|&k| fit.curves[0].points[k].weight < 0.2));
    }
}

/// A search may begin where the model jumps before the measured curve does, and points may lie before its start.
#[test]
fn points_beyond_the_ends_of_the_branch_do_not_stop_the_search() {
    let names: &'static [_] = &[("hamaker", 0.07), ("modulus", 4.0)];
    let mut curve = exact(TRUTH, 0.0);
    curve.insert(0, (-0.01, -0.02));
    let fit = fitted(problem(TRUTH, names), noisy(&curve, 11), &FitOptions::default()).unwrap();
    assert!(fit.converged() && holds(&fit, 0, 0.1) && holds(&fit, 1, 2.0), "{:?}", fit.parameters);
    assert_eq!(fit.curves[0].points[0].place, PointPlace::BeforeStart);
    assert!(fit.warnings().iter().any(|warning| matches!(warning, FitWarning::BeforeStart { points: 1, .. })));
}

#[test]
fn what_cannot_be_fitted_is_refused() {
    let points = noisy(&exact(TRUTH, 0.0), 2);
    let options = FitOptions::default();
    assert_eq!(fitted(problem(TRUTH, &[]), points.clone(), &options), Err(NoFit::NoParameters));
    let none = fitted(problem(TRUTH, &[("hamaker", 0.1), ("nothing", 1.0)]), points.clone(), &options);
    assert!(matches!(&none, Err(NoFit::NoInfluence { key, .. }) if key == "nothing"), "{none:?}");
    let few = fitted(
        problem(TRUTH, &[("hamaker", 0.1), ("distance", 0.4), ("modulus", 2.0), ("zero", 0.0)]),
        points[..4].to_vec(),
        &options,
    );
    assert_eq!(few, Err(NoFit::TooFewData { data: 4, parameters: 4 }));
    let negative = fitted(problem(TRUTH, &[("hamaker", -1.0)]), points.clone(), &options);
    assert!(matches!(negative, Err(NoFit::OutsideBounds { .. })), "{negative:?}");
    let back: Vec<_> = points.iter().chain(points.iter().rev()).copied().collect();
    assert!(matches!(MeasuredCurve::new(back, None, Some(0.0)), Err(FitDataError::ThereAndBack { .. })));
}

/// E = 3 GPa and A_H = 0.12 aJ, measured with errors of 0.2 nm and 0.004 nN.
#[test]
fn residuals_that_errors_of_displacements_make_are_said_to_be_so() {
    let truth = Truth { hamaker: 0.12, modulus: 3.0, ..TRUTH };
    let mut random = ChaCha8Rng::seed_from_u64(4);
    let mut points = with_noise(&exact(truth, 0.0), 0.004, 5);
    points.iter_mut().for_each(|point| point.displacement += 0.2 * normal(&mut random));
    let problem = || problem(truth, &[("hamaker", 0.1), ("modulus", 2.0)]);
    let options = FitOptions {
        profile: ProfileChoice::None,
        displacement_error: DisplacementError::None,
        ..FitOptions::default()
    };
    let proposed = |fit: &Fit| {
        fit.warnings().into_iter().find_map(|warning| match warning {
            FitWarning::ExactDisplacements { displacement_error, .. } => Some(displacement_error),
            _ => None,
        })
    };
    let fit = fitted(problem(), points.clone(), &options).unwrap();
    let error = proposed(&fit).unwrap_or_else(|| panic!("{:?} {:?}", fit.estimated_error, fit.scatter));
    assert!((0.04..1.0).contains(&error), "{error}");
    let fit = fitted(problem(), points, &FitOptions { displacement_error: DisplacementError::Known(0.2), ..options })
        .unwrap();
    assert_eq!(proposed(&fit), None);
    let good = fitted(problem(), noisy(&exact(truth, 0.0), 6), &options).unwrap();
    assert_eq!(proposed(&good), None);
}

/// A curve in nm and nN under the heading of µm and µN, and forces the other way round: of displacements that are too small the model is followed no
/// farther.
#[test]
fn a_curve_in_another_unit_is_refused_with_the_likely_one() {
    for (factor, given, meant, units) in [(1e3, "u", "n", &["N", "m"][..]), (1e-3, "n", "u", &["N"])] {
        let mut points = noisy(&exact(TRUTH, 0.0), 2);
        for point in &mut points {
            (point.displacement, point.force) = (factor * point.displacement, factor * point.force);
        }
        let problem = problem(TRUTH, &[("hamaker", 0.13), ("modulus", 1.5)]);
        let refused = fitted(problem, points, &FitOptions::default()).unwrap_err();
        assert!(matches!(refused, NoFit::OtherScale { .. }), "{refused}");
        for unit in units {
            let said = format!("{given}{unit} is written there and {meant}{unit} is meant");
            assert!(refused.remedy().contains(&said), "{}", refused.remedy());
        }
    }
}

/// One parameter alone that ends at its bound leaves no direction in which the curve changes.
#[test]
fn a_fit_whose_only_parameter_ends_at_its_bound_has_no_interval() {
    let mut problem = problem(TRUTH, &[("hamaker", 0.13)]);
    problem.parameters[0].from = Some(0.12);
    let fit = fitted(problem, noisy(&exact(TRUTH, 0.0), 2), &FitOptions::default()).unwrap();
    assert!(fit.parameters[0].at_bound.is_some() && fit.parameters[0].interval.is_none(), "{:?}", fit.parameters);
    assert!(fit.warnings().iter().any(|warning| matches!(warning, FitWarning::AtBound { .. })));
}

/// P = a U with a = 2 behind a = 1.5, from which on no curve can be computed: the search ends beside that, far from the points, and says so.
/// Where the curve cannot be computed from a = 2.5 on, which a search from a = 1 meets on its way at most, it finds a = 2.
#[test]
fn a_fit_that_ends_beside_curves_that_cannot_be_computed_says_so() {
    let ended = |last: f64| {
        let of = move |values: &[f64], _: &StopCriteria| match values[0] {
            a if a > last => Err("the plateau is lost".to_owned()),
            a => Ok(PulledCurve::of((0..=9).map(|k| (f64::from(k), a * f64::from(k))))),
        };
        let (range, of_model) = (Range::Positive, ParameterOf::Model);
        let a = FitParameter { key: "a".into(), initial: 1.0, range, from: None, to: None, of: of_model };
        let problem =
            Asked { parameters: vec![a], model: Box::new(|_| model(TRUTH)), by: CurveBy::Values(Box::new(of)) };
        let point = |u: f64| MeasuredPoint { displacement: u, force: 2.0 * u, force_error: Some(0.1 + 0.01 * u) };
        fitted(problem, (1..9).map(|k| point(f64::from(k))).collect(), &FitOptions::default()).unwrap()
    };
    let stalled = ended(1.5);
    let FitEnd::Stopped(why) = &stalled.end else { panic!("{:?}", stalled.end) };
    assert!(why.contains("with a = 1.5") && why.ends_with("the plateau is lost"), "{why}");
    assert!(stalled.parameters[0].value > 1.45 && stalled.parameters[0].value <= 1.5, "{:?}", stalled.parameters[0]);
    let found = ended(2.5);
    assert!(found.converged() && (found.parameters[0].value / 2.0 - 1.0).abs() < 1e-6, "{:?}", found.end);
}

/// Something else than a peel: P = a (1 - exp(-U/b)) up to U = 3 b, where an event takes a tenth of it, and nothing adheres from U = 5 b on. From its points with
/// a = 2, b = 7 both are found again, with the place of the jump, although no derivative is given and the event passes over points.
#[test]
fn a_curve_without_derivatives_is_fitted() {
    let of = |a: f64, b: f64| {
        let force = move |u: f64| a * (1.0 - (-u / b).exp()) * if u > 3.0 * b { 0.9 } else { 1.0 };
        let up = (0..=60).map(move |k| 3.0 * b * f64::from(k) / 60.0).map(move |u| (u, force(u)));
        let behind = (0..=40).map(move |k| 3.0 * b + 2.0 * b * f64::from(k) / 40.0);
        let behind = behind.map(move |u| (u, force(u.max(3.0 * b + 1e-12))));
        let mut curve = PulledCurve::of(up.chain(behind));
        curve.detached = Some(5.0 * b);
        curve
    };
    let (range, parameter) = (Range::Positive, ParameterOf::Model);
    let parameter =
        |key: &str, initial: f64| FitParameter { key: key.into(), initial, range, from: None, to: None, of: parameter };
    let with = |by: CurveBy<'static>| Asked {
        parameters: vec![parameter("a", 1.5), parameter("b", 8.0)],
        model: Box::new(|_| model(TRUTH)),
        by,
    };
    let problem = with(CurveBy::Values(Box::new(move |values, _| Ok(of(values[0], values[1])))));
    let exact = |u: f64| 2.0 * (1.0 - (-u / 7.0).exp()) * if u > 21.0 { 0.9 } else { 1.0 };
    let point = |u: f64, force: f64| MeasuredPoint { displacement: u, force, force_error: Some(1e-3) };
    let branch = (0..=34).map(|k| f64::from(k) + 0.3).map(|u| point(u, exact(u)));
    let points: Vec<_> = branch.chain((0..4).map(|k| point(36.0 + f64::from(k), 0.0))).collect();
    let fit = fitted(problem, points, &FitOptions { profile: ProfileChoice::None, ..FitOptions::default() }).unwrap();
    let [a, b] = [0, 1].map(|k| fit.parameters[k].value);
    assert!(fit.converged() && (a / 2.0 - 1.0).abs() < 1e-3 && (b / 7.0 - 1.0).abs() < 1e-3, "{a} {b} {:?}", fit.end);
    assert!((fit.curves[0].jump.unwrap().modelled.unwrap() - 35.0).abs() < 0.05, "{:?}", fit.curves[0].jump);
    let short = with(CurveBy::Values(Box::new(|_, _| Err("no pull".to_owned()))));
    let refused =
        fitted(short, (1..9).map(|k| point(f64::from(k), 1.0 + f64::from(k))).collect(), &FitOptions::default());
    assert!(matches!(refused, Err(NoFit::NoStart(why)) if why == "no pull"));
}

/// Strips of 10 and of 5 nm, recorded from 0.3 and from -0.2 nm on: one A_H, one E, and each its own d. All are within their intervals.
#[test]
fn curves_of_several_strips_are_fitted_together() {
    let truths = [Truth { zero: 0.3, ..TRUTH }, Truth { zero: -0.2, height: 5.0, ..TRUTH }];
    let names: &'static [_] = &[("hamaker", 0.12), ("modulus", 1.7), ("zero", 0.0)];
    let mut parameters = parameters(names);
    parameters.push(FitParameter { of: ParameterOf::DisplacementZero { curve: 1 }, ..parameters[2].clone() });
    let curve = |(seed, truth): (u64, Truth)| {
        let measured = MeasuredCurve::new(noisy(&exact(truth, 0.0), seed), None, Some(0.0)).unwrap();
        problem(Truth { zero: 0.0, ..truth }, names).of(measured).curves.remove(0)
    };
    let both = FitProblem { parameters, curves: (3..).zip(truths).map(curve).collect() };
    let fit = fit(&both, &FitOptions::default(), &ACCURACY, &StopCriteria::default).unwrap();
    assert!(fit.converged() && holds(&fit, 0, 0.1) && holds(&fit, 1, 2.0), "{:?}", fit.parameters);
    assert!(holds(&fit, 2, 0.3) && holds(&fit, 3, -0.2), "{:?}", fit.parameters);
    let zeros: Vec<f64> = fit.curves.iter().map(|curve| curve.displacement_zero).collect();
    assert_eq!(zeros, [fit.parameters[2].value, fit.parameters[3].value]);
    assert_eq!((fit.points().count(), fit.degrees_of_freedom), (88, 84));
    // of each alone the modulus is known less well
    for (number, truth) in (3..).zip(truths) {
        let alone = fitted(
            problem(Truth { zero: 0.0, ..truth }, names),
            noisy(&exact(truth, 0.0), number),
            &FitOptions::default(),
        )
        .unwrap();
        let [own, together] = [&alone, &fit].map(|fit| fit.parameters[1].standard_error.unwrap());
        assert!(together < 0.9 * own, "{together} {own}");
    }
}

/// A curve twice has the parameters of it once, with errors that are smaller by √2.
#[test]
fn a_curve_that_is_given_twice_counts_twice() {
    let names: &'static [_] = &[("hamaker", 0.13), ("modulus", 1.5)];
    let options = FitOptions {
        force_error: Some(NOISE),
        displacement_error: DisplacementError::None,
        profile: ProfileChoice::None,
        ..FitOptions::default()
    };
    let points = noisy(&exact(TRUTH, 0.0), 4);
    let once = fitted(problem(TRUTH, names), points.clone(), &options).unwrap();
    let measured = || MeasuredCurve::new(points.clone(), None, Some(0.0)).unwrap();
    let curves = (0..2).map(|_| problem(TRUTH, names).of(measured()).curves.remove(0)).collect();
    let twice = FitProblem { parameters: parameters(names), curves };
    let twice = fit(&twice, &options, &ACCURACY, &StopCriteria::default).unwrap();
    for (one, both) in once.parameters.iter().zip(&twice.parameters) {
        assert!((one.value / both.value - 1.0).abs() < 1e-6, "{one:?} {both:?}");
        let ratio = one.standard_error.unwrap() / both.standard_error.unwrap();
        assert!((ratio / 2f64.sqrt() - 1.0).abs() < 1e-5, "{ratio}");
    }
    assert!((twice.sum_of_squares / once.sum_of_squares - 2.0).abs() < 1e-9);
}
