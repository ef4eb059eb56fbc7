//! The run of a fit: search, weights, search again; then errors, correlations and profiles.

use super::coordinate::Coordinate;
use super::curve_trial::{Counted, CurveModel, CurveTrial};
use super::curves::machine_curve::Modelled;
use super::curves::measured_curve::{MeasuredPoint, noise};
use super::problem::{CurveBy, DisplacementError, FitCurve, FitOptions, FitProblem, Loss, ParameterOf, ProfileChoice};
use super::residuals::{Errors, Evaluator, Trial, Weights};
use super::result::{Fit, FitEnd, FittedCurve, FittedJump, FittedParameter, FittedPoint, NoFit, PointPlace, Scale};
use super::search::{Found, Least, search};
use super::statistics::{Covariance, Variances, half_interval, is_estimated, neighbouring_errors, scale};
use super::warnings::{POOR, combinations, pairs};
use crate::study::asked::accuracy::Accuracy;
use crate::study::asked::stop_criteria::StopCriteria;
use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;
use std::sync::Arc;
use std::sync::atomic::Ordering;

/// Most weightings.
const MOST_WEIGHTINGS: usize = 25;
/// After so many the errors go half of the way alone: parameters and errors may swing about where they agree.
const SWINGING: usize = 4;
/// Weights have settled where the coordinates change by less than this share of their standard errors.
const SETTLED: f64 = 0.02;
/// An estimated standard error is no smaller than this share of the largest force: what the path is computed to.
const LEAST_ERROR: f64 = 1e-7;
/// A parameter that changes the curve by less than this share of its largest force has no influence.
const INFLUENCE: f64 = 1e-7;

/// Finds the parameters of a problem with which the first stable branches of the paths are nearest to the measured curves. `stop` gives the criteria of
/// each path; one that is interrupted ends the fit with what was reached.
///
/// # Errors
/// Where there is nothing to fit or too few data, the path of the initial parameters or its derivatives cannot be computed, and where a parameter
/// has no influence.
pub fn fit(
    problem: &FitProblem,
    options: &FitOptions,
    accuracy: &Accuracy,
    stop: &(dyn Fn() -> StopCriteria + Sync),
) -> Result<Fit, NoFit> {
    let count = problem.parameters.len();
    if count == 0 || problem.curves.is_empty() {
        return Err(NoFit::NoParameters);
    }
    let measured = |curve: usize| &problem.curves[curve].measured;
    let half = |curve: usize| {
        let (first, last) = measured(curve).range();
        0.5 * (last - first)
    };
    let span = |of: ParameterOf| match of {
        ParameterOf::Model => half(0),
        ParameterOf::DisplacementZero { curve } => half(curve),
        ParameterOf::ForceZero { curve } => measured(curve).largest_force(),
    };
    let coordinates: Result<Vec<_>, _> =
        problem.parameters.iter().map(|parameter| Coordinate::new(parameter, span(parameter.of))).collect();
    let evaluator =
        Evaluator { problem, coordinates: coordinates?, options, accuracy, stop, counted: Counted::default() };
    let data = evaluator.data();
    if data <= count {
        return Err(NoFit::TooFewData { data, parameters: count });
    }
    let start = Arc::new(evaluator.trial(&DVector::zeros(count))?);
    let sizes = || problem.curves.iter().zip(&start.curves);
    if let Some(why) = sizes().find_map(|(curve, start)| hopeless(curve, start)) {
        return Err(why);
    }
    has_influence(&evaluator, &start, &evaluator.derivatives(&start)?)?;
    let reached = likeliest(&evaluator, &start, count);
    let found = reached.and_then(|reached| finished(&evaluator, &start, reached, data - count));
    let interrupted = evaluator.counted.interrupted.load(Ordering::Relaxed);
    let is_lost = !interrupted && found.as_ref().map_or(true, Fit::is_lost);
    match sizes().find_map(|(curve, start)| other_scale(curve, start)).filter(|_| is_lost) {
        Some(why) => Err(why),
        None => found,
    }
}

/// Every parameter has to change the curve.
fn has_influence(evaluator: &Evaluator, start: &Trial, found: &DMatrix<f64>) -> Result<(), NoFit> {
    let force = start.modelled().fold(evaluator.largest_force(), |most, at| at.force.abs().max(most));
    let jump = start.curves.iter().map(|curve| curve.found.end().abs()).fold(0.0, f64::max);
    let (points, jumps) = (evaluator.points().count(), evaluator.jumps().count());
    for (index, parameter) in evaluator.problem.parameters.iter().enumerate() {
        let largest = found.view((0, index), (points, 1)).amax();
        let moved = found.view((points, index), (jumps, 1)).iter().fold(0.0, |most: f64, of| most.max(of.abs()));
        if largest < INFLUENCE * force && moved < INFLUENCE * jump {
            return Err(NoFit::NoInfluence { key: parameter.key.clone(), largest });
        }
    }
    Ok(())
}

/// What the searches came to.
struct Reached {
    found: Found,
    weights: Weights,
    /// Standard error of a force that was estimated
    estimated: Option<f64>,
    /// That of a displacement likewise
    estimated_displacement: Option<f64>,
    weightings: usize,
}

impl Reached {
    /// -ln of the likelihood of the residuals with the errors that were found, but for a constant.
    fn unlikelihood(&self) -> f64 {
        0.5 * self.found.sum + self.weights.errors.iter().map(|error| error.ln()).sum::<f64>()
    }
}

/// The search. Where the error of the displacements is estimated there may be two ends: one that meets the steep points and one that ascribes what it
/// misses there to the displacements. So the search begins once with no error of theirs, and once with that which neighbours show; the likelier end counts.
fn likeliest(evaluator: &Evaluator, start: &Arc<Trial>, count: usize) -> Result<Reached, NoFit> {
    let options = evaluator.options;
    let least = LEAST_ERROR * evaluator.largest_force();
    let exact = Errors { force: noise(evaluator.measured()).max(least), displacement: evaluator.displacement_error() };
    let one = weighted_search(evaluator, start, count, exact)?;
    let is_estimated = options.displacement_error == DisplacementError::Estimated && options.loss == Loss::Squares;
    // a curve of whole pull-offs costs as much again
    let is_cheap = evaluator.problem.curves.iter().all(|curve| matches!(curve.by, CurveBy::Peel));
    if !is_estimated || !is_cheap || evaluator.counted.interrupted.load(Ordering::Relaxed) {
        return Ok(one);
    }
    let other = weighted_search(evaluator, start, count, neighbouring_errors(evaluator, least));
    let place = |reached: &Reached| (reached.found.trouble.is_some(), reached.unlikelihood());
    match other {
        Ok(other) if place(&other) < place(&one) => Ok(other),
        _ => Ok(one),
    }
}

/// Searches from these errors, and again with weights from what was found, until they have settled.
fn weighted_search(
    evaluator: &Evaluator,
    start: &Arc<Trial>,
    count: usize,
    mut errors: Errors,
) -> Result<Reached, NoFit> {
    let options = evaluator.options;
    let least = LEAST_ERROR * evaluator.largest_force();
    let estimates = is_estimated(options, evaluator);
    let robust = options.loss != Loss::Squares;
    let unknown = options.displacement_error == DisplacementError::Estimated && !robust;
    let components = unknown || (estimates && !robust && options.displacement_error != DisplacementError::None);
    let changes = estimates || robust || options.displacement_error != DisplacementError::None;
    // what is far off where a search begins is no outlier
    let mut weights = if robust { evaluator.weights(errors) } else { evaluator.reweighted(start, errors) };
    let free: Vec<usize> = (0..count).collect();
    let mut best = start.clone();
    let mut weightings = 0;
    loop {
        weightings += 1;
        let found = search(evaluator, &weights, &best, &free);
        let moved = &found.best.x - &best.x;
        best = found.best.clone();
        let derivatives = evaluator.derivatives(&best)?;
        if components {
            let jacobian = evaluator.jacobian(&derivatives, &weights);
            let found = Variances::of_trial(evaluator, &best, &jacobian, &weights, least).errors(errors);
            errors = if weightings > SWINGING { found.between(errors) } else { found };
        } else if estimates {
            let residuals: Vec<f64> = best.modelled().zip(evaluator.points()).map(|(m, p)| m.force - p.force).collect();
            errors.force = scale(&residuals, &weights, count, robust, least);
        }
        let next = evaluator.reweighted(&best, errors);
        let covariance = Covariance::new(&evaluator.jacobian(&derivatives, &next), free.clone(), 1.0);
        let settled =
            free.iter().all(|&k| moved[k].abs() <= SETTLED * covariance.standard_error(k).unwrap_or(f64::INFINITY));
        let over = found.trouble.is_some() || !changes || weightings == MOST_WEIGHTINGS;
        if over || (settled && weightings > 1) {
            let sum = evaluator.residuals(&best, &next).norm_squared();
            let trouble = found.trouble.or_else(|| {
                (weightings == MOST_WEIGHTINGS).then(|| format!("its weights have not settled in {weightings} rounds"))
            });
            let found = Found { best, sum, trouble };
            return Ok(Reached {
                found,
                weights: next,
                estimated: estimates.then_some(errors.force),
                estimated_displacement: unknown.then_some(errors.displacement),
                weightings,
            });
        }
        weights = next;
    }
}

/// How many standard errors half an interval of each parameter has.
fn halves(
    evaluator: &Evaluator,
    best: &Trial,
    jacobian: &DMatrix<f64>,
    weights: &Weights,
    covariance: &Covariance,
    estimated: [Option<f64>; 2],
    freedom: usize,
) -> Vec<f64> {
    let count = evaluator.coordinates.len();
    let [force, displacement] = estimated;
    if force.is_none() && displacement.is_none() {
        return vec![half_interval(None); count];
    }
    let mut halves = vec![half_interval(Some(freedom as f64)); count];
    if evaluator.options.loss == Loss::Squares {
        let errors = Errors { force: force.unwrap_or(0.0), displacement: displacement.unwrap_or(0.0) };
        let least = LEAST_ERROR * evaluator.largest_force();
        let freedoms = Variances::of_trial(evaluator, best, jacobian, weights, least).freedoms(errors, covariance);
        for (&k, freedom) in covariance.of.iter().zip(freedoms) {
            halves[k] = half_interval(Some(freedom));
        }
    }
    halves
}

/// The result with its statistics.
fn finished(evaluator: &Evaluator, start: &Trial, reached: Reached, freedom: usize) -> Result<Fit, NoFit> {
    let Reached { found, weights, estimated, estimated_displacement, weightings } = reached;
    let (best, options, count) = (found.best, evaluator.options, evaluator.coordinates.len());
    let interrupted = evaluator.counted.interrupted.load(Ordering::Relaxed);
    let end = match found.trouble {
        _ if interrupted => FitEnd::Interrupted,
        Some(why) => FitEnd::Stopped(why),
        None => FitEnd::Converged,
    };
    let plain = Weights { robust: vec![1.0; weights.errors.len()], ..weights.clone() };
    let jacobian = evaluator.jacobian(&evaluator.derivatives(&best)?, &plain);
    let standardised = evaluator.standardised(&best, &plain);
    let inside: Vec<usize> = (0..count).filter(|&k| evaluator.coordinates[k].at_bound(best.x[k]).is_none()).collect();
    let factor = options.loss.covariance_factor(&standardised, count);
    let covariance = Covariance::new(&jacobian, inside, factor);
    let halves = halves(evaluator, &best, &jacobian, &plain, &covariance, [estimated, estimated_displacement], freedom);
    let values = evaluator.values(&best.x);
    let parameter = |k: usize| {
        let (own, coordinate) = (&evaluator.problem.parameters[k], &evaluator.coordinates[k]);
        let (x, (low, high), half) = (best.x[k], coordinate.bounds(), halves[k]);
        let error = covariance.standard_error(k);
        let interval =
            error.map(|error| [-half, half].map(|half| coordinate.value((x + half * error).clamp(low, high))));
        let bound = coordinate.at_bound(x).map(|side| coordinate.value(if side < 0 { low } else { high }));
        FittedParameter {
            key: own.key.clone(),
            initial: own.initial,
            value: values[k],
            logarithmic: coordinate.is_logarithmic(),
            standard_error: error.map(|error| error * coordinate.rate(x)),
            interval,
            bounds: [coordinate.value(low), coordinate.value(high)],
            at_bound: bound,
            poorly_determined: coordinate.is_logarithmic() && error.is_some_and(|error| half * error > POOR),
            profile: None,
        }
    };
    let mut parameters: Vec<FittedParameter> = (0..count).map(parameter).collect();
    let poor: Vec<bool> = parameters.iter().map(|parameter| parameter.poorly_determined).collect();
    // at a bound the sum of squares has no minimum: intervals of the others would be those beside a value that is most likely wrong
    let is_minimum = parameters.iter().all(|parameter| parameter.at_bound.is_none());
    if end == FitEnd::Converged {
        let least =
            Least { evaluator, weights: &weights, best: &best, sum: found.sum, covariance: &covariance, factor };
        let wanted = |k: &usize| match options.profile {
            ProfileChoice::All => true,
            ProfileChoice::Poor => is_minimum && poor[*k],
            ProfileChoice::None => false,
        };
        let asked: Vec<(usize, f64)> =
            (0..count).filter(wanted).filter_map(|k| Some((k, covariance.standard_error(k)?))).collect();
        let profiles: Vec<_> = asked.par_iter().map(|&(k, error)| (k, least.profile(k, error, halves[k]))).collect();
        profiles.into_iter().for_each(|(k, profile)| parameters[k].profile = Some(profile));
    }
    let row = |one: usize| (0..count).map(|other| covariance.correlation(one, other)).collect();
    Ok(Fit {
        curves: fitted_curves(evaluator, start, &best, &weights),
        correlations: (0..count).map(row).collect(),
        combinations: combinations(&covariance, &evaluator.coordinates),
        pairs: pairs(&covariance, &evaluator.coordinates, &poor),
        condition: Some(covariance.condition).filter(|condition| condition.is_finite()),
        sum_of_squares: found.sum,
        degrees_of_freedom: freedom,
        estimated_error: estimated,
        estimated_displacement_error: estimated_displacement,
        scatter: noise(evaluator.measured()),
        exact_displacements: estimated_displacement.is_none() && evaluator.displacement_error() == 0.0,
        paths: evaluator.counted.paths.load(Ordering::Relaxed),
        weightings,
        end,
        parameters,
    })
}

/// Each curve with what was found of it.
fn fitted_curves(evaluator: &Evaluator, start: &Trial, best: &Trial, weights: &Weights) -> Vec<FittedCurve> {
    let mut rows = weights.errors.iter().zip(&weights.robust);
    let mut jump_errors = weights.jump_errors.iter();
    let values = evaluator.values(&best.x);
    let one = |((own, best), start): ((CurveModel, &CurveTrial), &CurveTrial)| {
        let measured = &own.curve.measured;
        let rows = measured.points.iter().zip(&best.modelled).zip(rows.by_ref());
        let point =
            |((measured, modelled), (&error, &weight)): ((&MeasuredPoint, &Modelled), (&f64, &f64))| FittedPoint {
                displacement: measured.displacement,
                force: measured.force,
                modelled: modelled.force,
                slope: modelled.slope,
                error,
                weight,
                place: modelled.place,
            };
        let used = own.jump().is_some();
        let error = if used { jump_errors.next().copied() } else { None };
        FittedCurve {
            points: rows.map(point).collect(),
            jump: measured.jump.map(|jump| FittedJump {
                displacement: jump.displacement,
                error: error.unwrap_or(1.0),
                modelled: best.found.jump().map(|jump| jump + best.displacement_zero),
                used,
            }),
            displacement_zero: best.displacement_zero,
            force_zero: best.force_zero,
            curve: best.recorded(),
            initial_curve: start.recorded(),
            model: (own.curve.model)(&values),
        }
    };
    evaluator.curves().zip(&best.curves).zip(&start.curves).map(one).collect()
}

/// That a measured curve is not of the size of that at which the search begins: a column has another unit than its name says, most likely.
fn other_scale(FitCurve { measured, .. }: &FitCurve, start: &CurveTrial) -> Option<NoFit> {
    let curve = start.found.points();
    let largest = |of: fn(&(f64, f64)) -> f64| curve.iter().map(|at| of(at).abs()).fold(0.0, f64::max);
    let (from, to) = measured.range();
    let force = measured.points.iter().map(|point| (point.force - start.force_zero).abs()).fold(0.0, f64::max);
    let forces = Scale { measured: force, modelled: largest(|at| at.1) };
    let displacements = Scale { measured: from.abs().max(to.abs()), modelled: largest(|at| at.0) };
    let is_other = forces.thousands() != 0 || displacements.thousands() != 0;
    is_other.then_some(NoFit::OtherScale { forces, displacements })
}

/// The same of a curve of which both columns are so and no point lies on the path at which the search begins: no search comes from there to it.
fn hopeless(curve: &FitCurve, start: &CurveTrial) -> Option<NoFit> {
    let why = other_scale(curve, start)?;
    let NoFit::OtherScale { forces, displacements } = &why else { return None };
    let both = forces.thousands() != 0 && displacements.thousands() != 0;
    let none = start.modelled.iter().all(|at| at.place != PointPlace::OnBranch);
    (both && none).then_some(why)
}
