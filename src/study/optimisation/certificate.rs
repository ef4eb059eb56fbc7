//! Why a design is an optimum, as far as that can be said: first-order conditions, neighbours, and a search without gradients.

use super::evaluation::Evaluator;
use super::options::OptimisationOptions;
use super::problem::DesignProblem;
use super::projected_gradient::ActiveConstraint;
use super::starts::neighbour;
use rayon::prelude::*;

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
        let found = (options.known)(&place).unwrap_or_else(|| evaluator.evaluate(&place, false));
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
