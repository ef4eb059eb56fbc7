//! Why a design is an optimum, as far as that can be said: first-order conditions, neighbours, and a search without gradients.

use super::evaluation::{Evaluator, OptimisationOptions};
use super::problem::{ConstraintKind, DesignConstraint, DesignFound, DesignProblem, DesignVariable};
use super::refine::ActiveConstraint;
use super::search::{FEASIBLE, SearchResult};
use crate::model::check::error::ModelError;
use crate::study::peel::result::PathEnd;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;
use slsqp::{Func, StopTols, minimize};
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// Why a design is an optimum.
#[derive(Clone, Debug, PartialEq)]
pub struct Certificate {
    /// Largest component of the projected gradient, d ln Q by a coordinate from 0 to 1; none where there is no gradient
    pub projected_gradient: Option<f64>,
    /// What it was without the constraints
    pub gradient: Option<f64>,
    /// Constraints and bounds that are active
    pub active: Vec<ActiveConstraint>,
    /// The random feasible designs beside it
    pub neighbours: Neighbours,
    /// What a search without gradients found from here on; none where it was not asked for
    pub check: Option<DerivativeFreeCheck>,
}

/// Random feasible designs beside an optimum.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Neighbours {
    /// How many were peeled
    pub computed: usize,
    /// How many were asked for and have no such number
    pub bad: usize,
    /// How many are better by more than the error of the search
    pub better: usize,
    /// ln Q of the best of them over that of the optimum, in the direction of the goal: below zero where none is better
    pub largest_gain: f64,
}

/// What COBYLA found from the optimum on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DerivativeFreeCheck {
    /// ln Q of its best over that of the optimum, in the direction of the goal
    pub gain: f64,
    /// Designs that it peeled
    pub evaluations: usize,
}

/// Random feasible designs beside one whose ln Q is known from the search.
pub(super) fn neighbours(
    problem: &DesignProblem,
    options: &OptimisationOptions,
    evaluator: &Evaluator,
    at: &[f64],
    log_value: f64,
) -> Neighbours {
    let sign = problem.goal.sign();
    let gain = |number: usize| -> Option<Option<f64>> {
        let place = neighbour(problem, at, options.seed, number as u64)?;
        let found = (options.known)(&place, false).unwrap_or_else(|| evaluator.evaluate(&place, false));
        Some(found.log_value.map(|value| -sign * (value - log_value)))
    };
    let gains: Vec<Option<Option<f64>>> = (0..options.neighbours)
        .into_par_iter()
        .map(|number| (options.go_on)().then(|| gain(number)).flatten())
        .collect();
    let computed: Vec<f64> = gains.iter().flatten().flatten().copied().collect();
    // both values have the error of the search
    let error = 2.0 * options.search.relative * problem.objective.factors().len() as f64;
    Neighbours {
        computed: computed.len(),
        bad: gains.len() - computed.len(),
        better: computed.iter().filter(|&&gain| gain > error).count(),
        largest_gain: computed.iter().copied().fold(f64::NEG_INFINITY, f64::max),
    }
}

// -- Whether a design problem has a meaning, before anything is computed --

/// How far outside its bounds a variable has a model, in coordinates from 0 to 1: gradients at a bound need that.
const MARGIN: f64 = 1e-3;

impl DesignProblem<'_> {
    /// Whether there is something free, with bounds inside which there are models.
    ///
    /// # Errors
    /// Names the variable, or the constraint, and what is wrong with it.
    pub fn check(&self) -> Result<(), NoOptimum> {
        if self.variables.is_empty() {
            return Err(NoOptimum::NothingFree);
        }
        for DesignVariable { name, lower, upper, .. } in &self.variables {
            let are_bounds = lower.is_finite() && upper.is_finite() && lower < upper;
            if !are_bounds {
                return Err(NoOptimum::Bounds { name: name.clone(), lower: *lower, upper: *upper });
            }
        }
        self.model_at(&self.coordinates(&self.start)).ok_or(NoOptimum::NoModel)?.check()?;
        self.check_bounds()
    }

    /// Whether there is a model at and next to every bound, with the other variables as at the start.
    fn check_bounds(&self) -> Result<(), NoOptimum> {
        let start = self.coordinates(&self.start);
        for (index, variable) in self.variables.iter().enumerate() {
            for end in [-MARGIN, 1.0 + MARGIN] {
                let mut at = start.clone();
                at[index] = end;
                let cause = match self.model_at(&at) {
                    None => Some("it is no such body".to_owned()),
                    Some(model) => model.check().err().map(|error| format!("{} {}", error.key(), error.found())),
                };
                if let Some(cause) = cause {
                    let DesignVariable { name, lower, upper, .. } = variable.clone();
                    return Err(NoOptimum::OutsideRange { name, lower, upper, at: variable.value(end), cause });
                }
            }
        }
        Ok(())
    }

    /// The constraint that is violated most, and by how much.
    pub(super) fn worst_constraint(&self, coordinates: &[f64]) -> Option<(String, f64)> {
        let values = self.values(coordinates);
        let violation = |constraint: &DesignConstraint| {
            let value = (constraint.function)(&values);
            if constraint.kind == ConstraintKind::Equal { value.abs() } else { value }
        };
        let worst = self.constraints.iter().max_by(|a, b| violation(a).total_cmp(&violation(b)))?;
        Some((worst.name.clone(), violation(worst)))
    }
}

// -- Random designs: where searches begin, and neighbours of an optimum. They are reproducible, and projected onto what is feasible --

/// Waves along a profile that a random one is made of.
const WAVES: usize = 3;
/// Evaluations of a projection; it peels nothing.
const PROJECTION: usize = 200;
/// A projection ends where the square of its distance changes by less.
const NEAR: f64 = 1e-16;
/// Least and largest distance of a neighbour, in coordinates from 0 to 1.
const NEAREST: f64 = 1e-3;
const FARTHEST: f64 = 0.1;

/// The feasible design that is nearest to coordinates; none where there is none, or none was found.
pub(super) fn projected(problem: &DesignProblem, wanted: &[f64]) -> Option<Vec<f64>> {
    let inside: Vec<f64> = wanted.iter().map(|c| c.clamp(0.0, 1.0)).collect();
    if problem.violation(&inside) <= 0.0 {
        return Some(inside);
    }
    let distance = |c: &[f64], gradient: Option<&mut [f64]>, _: &mut ()| {
        let away = c.iter().zip(&inside).map(|(a, b)| a - b);
        if let Some(gradient) = gradient {
            gradient.iter_mut().zip(away.clone()).for_each(|(out, away)| *out = 2.0 * away);
        }
        away.map(|away| away * away).sum()
    };
    let side = |index: usize, sign: f64| {
        move |c: &[f64], gradient: Option<&mut [f64]>, _: &mut ()| {
            if let Some(gradient) = gradient {
                let slopes = problem.constraint_gradient(index, c);
                gradient.iter_mut().zip(slopes).for_each(|(out, slope)| *out = sign * slope);
            }
            sign * problem.constraint(index, c)
        }
    };
    let mut sides = Vec::new();
    for (index, constraint) in problem.constraints.iter().enumerate() {
        sides.push(side(index, 1.0));
        if constraint.kind == ConstraintKind::Equal {
            sides.push(side(index, -1.0));
        }
    }
    let constraints: Vec<&dyn Func<()>> = sides.iter().map(|side| side as &dyn Func<()>).collect();
    let bounds = vec![(0.0, 1.0); wanted.len()];
    let tolerance = StopTols { ftol_abs: NEAR, ..StopTols::default() };
    let found = minimize(distance, &inside, &bounds, &constraints, (), PROJECTION, Some(tolerance));
    let (Ok((_, found, _)) | Err((_, found, _))) = found;
    (problem.violation(&found) <= FEASIBLE).then_some(found)
}

/// The random numbers of one design.
fn dice(seed: u64, number: u64) -> ChaCha8Rng {
    let mut dice = ChaCha8Rng::seed_from_u64(seed);
    dice.set_stream(number);
    dice
}

/// A random design: numbers anywhere between their bounds, profiles a few waves long.
pub(super) fn random(problem: &DesignProblem, seed: u64, number: u64) -> Option<Vec<f64>> {
    let mut dice = dice(seed, number);
    let mut columns = BTreeMap::new();
    let mut coordinates = Vec::new();
    for variable in &problem.variables {
        coordinates.push(match variable.along {
            None => dice.random_range(0.1..0.9),
            Some((column, share)) => {
                let waves: &mut Vec<f64> =
                    columns.entry(column).or_insert_with(|| (0..WAVES).map(|_| dice.random_range(-0.4..0.4)).collect());
                let wave = |(k, height): (usize, &f64)| height * (PI * (k + 1) as f64 * share).cos();
                0.5 + waves.iter().enumerate().map(wave).sum::<f64>()
            }
        });
    }
    projected(problem, &coordinates)
}

/// A random feasible neighbour.
pub(super) fn neighbour(problem: &DesignProblem, of: &[f64], seed: u64, number: u64) -> Option<Vec<f64>> {
    // others than those of the starts
    let mut dice = dice(seed, u64::MAX - number);
    let direction: Vec<f64> = of.iter().map(|_| dice.random_range(-1.0..1.0)).collect();
    let length = direction.iter().map(|d: &f64| d * d).sum::<f64>().sqrt();
    let distance = NEAREST * (FARTHEST / NEAREST).powf(dice.random_range(0.0..1.0));
    let moved: Vec<f64> = of.iter().zip(&direction).map(|(c, d)| c + distance * d / length).collect();
    projected(problem, &moved)
}

// -- Why a design problem is refused, or no optimum was found --

/// Why there is no optimum.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum NoOptimum {
    #[error("nothing is free: no variable is given; name at least one parameter or a profile")]
    NothingFree,
    #[error(
        "`{name}` has the bounds {lower} and {upper}; the lower one has to be below the upper one, and both finite"
    )]
    Bounds { name: String, lower: f64, upper: f64 },
    #[error(
        "`{name}` may go from {lower} to {upper}, and next to {at} there is no such model: {cause}; leave a margin of a thousandth inside its range"
    )]
    OutsideRange { name: String, lower: f64, upper: f64, at: f64, cause: String },
    #[error("the design at the start cannot be computed: {0}")]
    Start(#[from] ModelError),
    #[error("the design at the start has no model")]
    NoModel,
    #[error(
        "the peel of the design at the start has no {name}: it ended {end}; choose another objective, or another start"
    )]
    NoObjective { name: &'static str, end: String },
    #[error("the design at the start has no {name}: {why}; choose another objective, or another start")]
    NoNumber { name: &'static str, why: String },
    #[error("{name} is {value:e} at the start, and an objective has to be above zero")]
    NotPositive { name: &'static str, value: f64 },
    #[error(
        "no design meets all constraints: {name} is violated by {violation:.3e} at the design that comes nearest; widen the bounds or drop it"
    )]
    Contradictory { name: String, violation: f64 },
    #[error("the objective cannot be differentiated here: {why}; use the search without gradients")]
    NoGradient { why: String },
    #[error("none of {evaluations} designs could be computed")]
    AllBad { evaluations: usize },
}

/// How a path ended, in a word or with its reason.
pub(super) fn end_text(end: &PathEnd) -> String {
    match end {
        PathEnd::Failed(failure) => format!("failed, {failure}"),
        other => format!("{other:?}").to_lowercase(),
    }
}

// -- What an optimisation finds --

/// One design with its peels, to the accuracy that was asked for.
#[derive(Debug)]
pub struct Design {
    /// Of the variables, in the unit of the library
    pub values: Vec<f64>,
    /// From 0 to 1 between the bounds
    pub coordinates: Vec<f64>,
    /// Q, in its unit
    pub objective: f64,
    /// Bound on the error of Q; none where the number of the peel has none
    pub error: Option<f64>,
    /// What the objective is made of
    pub of: DesignFound,
}

/// The best design that was found.
#[derive(Debug)]
pub struct Optimum {
    /// The design at the start
    pub before: Design,
    /// The best one
    pub after: Design,
    /// Bounds on the errors of its values, in their units: how far it is to where the gradient vanishes. Of variables at a bound zero; none
    /// where the curvature is not known, as of many variables and under constraints
    pub value_errors: Option<Vec<f64>>,
    /// Q after over Q before
    pub gain: f64,
    /// Bound on the error of that
    pub gain_error: Option<f64>,
    /// The searches, in the order of their starts
    pub searches: Vec<SearchResult>,
    /// Which search found the best
    pub best_search: usize,
    /// Why it is an optimum; none after an interruption
    pub certificate: Option<Certificate>,
    /// Whether it was interrupted
    pub unfinished: bool,
}
