//! The whole optimisation: searches from several starts at once, the best of them refined and certified.

use super::evaluation::{Evaluator, OptimisationOptions, SearchMethod, derivatives};
use super::methods;
use super::optimum::{
    Certificate, DerivativeFreeCheck, Design, NoOptimum, Optimum, end_text, neighbours, projected, random,
};
use super::problem::{DesignFound, DesignNumber, DesignProblem, Factor, NumberBy, NumberOf};
use super::refine::{projected_gradient, refined};
use super::search::{FEASIBLE, Search, SearchEnd, SearchResult};
use crate::study::peel::result::Peel;
use crate::study::terms::term_selection::peel;
use rayon::prelude::*;

/// Finds the best design.
///
/// # Errors
/// Where the problem has no meaning, where its start has no objective, and where no design could be computed.
pub fn optimise(problem: &DesignProblem, options: &OptimisationOptions) -> Result<Optimum, NoOptimum> {
    problem.check()?;
    let given = problem.coordinates(&problem.start);
    let first = feasible(problem, &given)?;
    let before = design(problem, options, &given)?;
    let method = options.method.unwrap_or(match (&before.of, problem.constraints.is_empty()) {
        (DesignFound::Curves(_), _) => SearchMethod::DerivativeFree,
        (DesignFound::Peels(_), true) => SearchMethod::QuasiNewton,
        (DesignFound::Peels(_), false) => SearchMethod::SequentialQuadratic,
    });
    if method != SearchMethod::DerivativeFree {
        differentiable(problem, &before)?;
    }
    let evaluator = Evaluator::new(problem, options, &before.of);
    let starts: Vec<Vec<f64>> = std::iter::once(first)
        .chain((1..options.starts).filter_map(|number| random(problem, options.seed, number as u64)))
        .collect();
    let search =
        |(number, from): (usize, &Vec<f64>)| Search::new(problem, options, &evaluator, number).run(method, from);
    let mut searches: Vec<SearchResult> = starts.par_iter().enumerate().map(search).collect();
    let (mut best_search, found) = best(problem, &searches)?;
    let unfinished = searches.iter().any(|search| search.end == SearchEnd::Interrupted);
    if unfinished {
        let after = design(problem, options, &found)?;
        return Ok(assembled(before, after, None, searches, best_search, None, true));
    }
    let mut found = found;
    let mut check = None;
    if options.check && method != SearchMethod::DerivativeFree {
        let number = searches.len();
        let checked = Search::new(problem, options, &evaluator, number).run_check(&found);
        let value = |result: &SearchResult| result.best.and_then(|best| result.evaluations[best].log_value);
        let gain = value(&checked).zip(value(&searches[best_search])).map(|(a, b)| -problem.goal.sign() * (a - b));
        check = gain.map(|gain| DerivativeFreeCheck { gain, evaluations: checked.evaluations.len() });
        searches.push(checked);
        if let Ok((better, coordinates)) = best(problem, &searches) {
            (best_search, found) = (better, coordinates);
        }
    }
    let refined = refined(problem, &evaluator, &found);
    let after = design(problem, options, &refined.coordinates)?;
    let sign = problem.goal.sign();
    let minimised =
        refined.precise.map(|precise| precise.gradient.iter().map(|slope| sign * slope).collect::<Vec<_>>());
    let projection = minimised.as_ref().map(|slopes| projected_gradient(problem, &refined.coordinates, slopes));
    let here = evaluator.evaluate(&refined.coordinates, false).log_value;
    let certificate = Certificate {
        projected_gradient: projection.as_ref().map(|projection| projection.largest()),
        gradient: minimised.map(|slopes| slopes.iter().map(|slope| slope.abs()).fold(0.0, f64::max)),
        active: projection.map_or_else(Vec::new, |projection| projection.held),
        neighbours: here
            .map(|value| neighbours(problem, options, &evaluator, &refined.coordinates, value))
            .unwrap_or_default(),
        check,
    };
    let errors = refined.errors.map(|errors| {
        let width = |(k, error): (usize, &f64)| {
            let (variable, c) = (&problem.variables[k], refined.coordinates[k]);
            0.5 * (variable.value(c + error) - variable.value(c - error)).abs()
        };
        errors.iter().enumerate().map(width).collect()
    });
    Ok(assembled(before, after, errors, searches, best_search, Some(certificate), false))
}

/// The first design that a search begins with.
fn feasible(problem: &DesignProblem, given: &[f64]) -> Result<Vec<f64>, NoOptimum> {
    projected(problem, given).ok_or_else(|| {
        // the constraint that holds least of all
        let inside: Vec<f64> = given.iter().map(|c| c.clamp(0.0, 1.0)).collect();
        problem
            .worst_constraint(&inside)
            .map_or(NoOptimum::NoModel, |(name, violation)| NoOptimum::Contradictory { name, violation })
    })
}

/// A design to the accuracy asked for.
fn design(problem: &DesignProblem, options: &OptimisationOptions, coordinates: &[f64]) -> Result<Design, NoOptimum> {
    let factors = problem.objective.factors();
    let (numbers, of) = match &problem.number {
        NumberBy::Peel => peeled(problem, options, coordinates, &factors)?,
        NumberBy::Values(number) => computed(&problem.values(coordinates), options, number, &factors)?,
    };
    let (mut objective, mut error) = (1.0, Some(0.0));
    for (factor, (value, own)) in factors.iter().zip(numbers) {
        if value <= 0.0 {
            return Err(NoOptimum::NotPositive { name: factor.of.name(), value });
        }
        objective *= value.powf(factor.power);
        error = error.zip(own).map(|(sum, error)| sum + error / value);
    }
    let values = problem.values(coordinates);
    let coordinates = coordinates.to_vec();
    Ok(Design { values, coordinates, objective, error: error.map(|error| error * objective), of })
}

/// The number of each factor of an objective with the bound on its error, and what has these numbers.
type Numbers = (Vec<(f64, Option<f64>)>, DesignFound);

fn peeled(
    problem: &DesignProblem,
    options: &OptimisationOptions,
    coordinates: &[f64],
    factors: &[Factor],
) -> Result<Numbers, NoOptimum> {
    let model = problem.model_at(coordinates).ok_or(NoOptimum::NoModel)?;
    model.check()?;
    let one = |factor: &Factor| peel(&factor.model(model.clone()), &options.accuracy, &(options.stop)());
    let peels: Vec<Peel> = factors.par_iter().map(one).collect();
    let number = |(factor, peel): (&Factor, &Peel)| match factor.of.value(peel) {
        Some(value) => Ok((value, factor.of.error(peel))),
        None => Err(NoOptimum::NoObjective { name: factor.of.name(), end: end_text(&peel.end) }),
    };
    let numbers: Result<Vec<_>, _> = factors.iter().zip(&peels).map(number).collect();
    Ok((numbers?, DesignFound::Peels(peels)))
}

fn computed(
    values: &[f64],
    options: &OptimisationOptions,
    number: &NumberOf,
    factors: &[Factor],
) -> Result<Numbers, NoOptimum> {
    let one = |factor: &Factor| {
        number(values, factor.angle, &(options.stop)())
            .map_err(|why| NoOptimum::NoNumber { name: factor.of.name(), why })
    };
    let found: Vec<DesignNumber> = factors.par_iter().map(one).collect::<Result<_, _>>()?;
    let numbers = found.iter().map(|found| (found.value, found.error)).collect();
    Ok((numbers, DesignFound::Curves(found.into_iter().map(|found| found.curve).collect())))
}

/// Whether the objective has a gradient at the start: else it has none anywhere.
fn differentiable(problem: &DesignProblem, before: &Design) -> Result<(), NoOptimum> {
    let DesignFound::Peels(peels) = &before.of else {
        let why = "it is not the number of a peel of a single beam in equilibrium".to_owned();
        return Err(NoOptimum::NoGradient { why });
    };
    problem.objective.factors().iter().zip(peels).try_for_each(|(factor, peel)| {
        derivatives(problem, factor, peel, &before.coordinates).map(drop).map_err(|why| NoOptimum::NoGradient { why })
    })
}

/// The search with the best feasible design, and that.
fn best(problem: &DesignProblem, searches: &[SearchResult]) -> Result<(usize, Vec<f64>), NoOptimum> {
    let sign = problem.goal.sign();
    let value =
        |search: &SearchResult| sign * search.best.and_then(|k| search.evaluations[k].log_value).unwrap_or(f64::NAN);
    let with_best = searches.iter().enumerate().filter(|(_, search)| search.best.is_some());
    let found = with_best.min_by(|a, b| value(a.1).total_cmp(&value(b.1)));
    let evaluations = searches.iter().map(|search| search.evaluations.len()).sum();
    let (number, search) = found.ok_or(NoOptimum::AllBad { evaluations })?;
    let best = search.best.and_then(|k| search.evaluations.get(k)).ok_or(NoOptimum::AllBad { evaluations })?;
    debug_assert!(problem.violation(&best.coordinates) <= FEASIBLE);
    Ok((number, best.coordinates.clone()))
}

fn assembled(
    before: Design,
    after: Design,
    value_errors: Option<Vec<f64>>,
    searches: Vec<SearchResult>,
    best_search: usize,
    certificate: Option<Certificate>,
    unfinished: bool,
) -> Optimum {
    let gain = after.objective / before.objective;
    let relative = |design: &Design| design.error.map(|error| error / design.objective);
    let gain_error = relative(&before).zip(relative(&after)).map(|(a, b)| gain * (a + b));
    Optimum { before, after, value_errors, gain, gain_error, searches, best_search, certificate, unfinished }
}

/// How a search chooses its designs.
impl Search<'_> {
    /// Searches from these coordinates.
    pub(crate) fn run(self, method: SearchMethod, from: &[f64]) -> SearchResult {
        self.gives_up.set(method != SearchMethod::DerivativeFree);
        let end = match method {
            SearchMethod::QuasiNewton => methods::quasi_newton(&self, from),
            SearchMethod::SequentialQuadratic => methods::sequential_quadratic(&self, from),
            SearchMethod::DerivativeFree => methods::derivative_free(&self, from, methods::FIRST_STEP),
        };
        self.into_result(end)
    }

    /// Searches without gradients in the neighbourhood of these coordinates.
    pub(crate) fn run_check(self, from: &[f64]) -> SearchResult {
        let end = methods::derivative_free(&self, from, methods::SMALL_STEP);
        self.into_result(end)
    }
}
