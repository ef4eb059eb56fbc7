//! The three searches, each by a crate that has it.
//!
//! [`quasi_newton`]: L-BFGS of argmin on coordinates that keep to the bounds: c = (1 + sin z)/2, dc/dz = cos z/2.
//!
//! A bound is reached at a finite z, where ln Q is a parabola in z; the gradient by z vanishes there as well where the other side of the
//! bound is the better one, so that no search begins at a bound.

use super::problem::ConstraintKind;
use super::search::{Search, SearchEnd};
use argmin::core::{CostFunction, Error, Executor, Gradient, State, TerminationReason, TerminationStatus};
use argmin::solver::linesearch::MoreThuenteLineSearch;
use argmin::solver::quasinewton::LBFGS;
use nalgebra::DVector;

/// Steps that are remembered.
const MEMORY: usize = 10;
/// A gradient by z below this is none.
const FLAT: f64 = 1e-8;
/// How near to a bound a search begins.
const INSIDE: f64 = 1e-3;

struct Sine<'s, 'p>(&'s Search<'p>);

/// The method has been told to stop.
#[derive(Debug)]
struct Over;

impl std::fmt::Display for Over {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str("no further design is evaluated")
    }
}

impl std::error::Error for Over {}

impl Sine<'_, '_> {
    fn minimised(&self, z: &DVector<f64>) -> Result<(f64, Vec<f64>), Error> {
        if self.0.is_over() {
            return Err(Over.into());
        }
        let coordinates: Vec<f64> = z.iter().map(|z| 0.5 * (1.0 + z.sin())).collect();
        Ok(self.0.minimised(&coordinates, true))
    }
}

impl CostFunction for Sine<'_, '_> {
    type Param = DVector<f64>;
    type Output = f64;

    fn cost(&self, z: &DVector<f64>) -> Result<f64, Error> {
        Ok(self.minimised(z)?.0)
    }
}

impl Gradient for Sine<'_, '_> {
    type Param = DVector<f64>;
    type Gradient = DVector<f64>;

    fn gradient(&self, z: &DVector<f64>) -> Result<DVector<f64>, Error> {
        let (_, gradient) = self.minimised(z)?;
        Ok(DVector::from_iterator(z.len(), gradient.iter().zip(z).map(|(slope, z)| 0.5 * slope * z.cos())))
    }
}

/// Searches from coordinates; the best design is among those that the search has seen. Where a line search finds no better design, the search
/// begins anew from the best one, without what it remembers of the curvature, as long as that brings something.
pub(super) fn quasi_newton(search: &Search, from: &[f64]) -> SearchEnd {
    let mut from = from.to_vec();
    let mut reached = f64::INFINITY;
    loop {
        let end = once(search, &from);
        let SearchEnd::NoBetterStep(_) = end else { return end };
        match search.least() {
            Some((value, at)) if value < reached - search.options.tolerance => (reached, from) = (value, at),
            // a gradient that is round-off has no better step
            Some(_) => return SearchEnd::Converged,
            None => return end,
        }
    }
}

fn once(search: &Search, from: &[f64]) -> SearchEnd {
    let inside = |c: &f64| (2.0 * c.clamp(INSIDE, 1.0 - INSIDE) - 1.0).asin();
    let start = DVector::from_iterator(from.len(), from.iter().map(inside));
    let solver = LBFGS::new(MoreThuenteLineSearch::new(), MEMORY)
        .with_tolerance_grad(FLAT)
        .and_then(|solver| solver.with_tolerance_cost(search.options.tolerance));
    let Ok(solver) = solver else { return SearchEnd::NoBetterStep("its tolerance is below zero".into()) };
    let most = search.options.evaluations as u64;
    let run = Executor::new(Sine(search), solver).configure(|state| state.param(start).max_iters(most)).run();
    match run {
        Ok(result) => match result.state().get_termination_status() {
            TerminationStatus::Terminated(TerminationReason::SolverConverged) => SearchEnd::Converged,
            TerminationStatus::Terminated(TerminationReason::MaxItersReached) => SearchEnd::MostEvaluations,
            other => SearchEnd::NoBetterStep(other.to_string()),
        },
        Err(error) if error.downcast_ref::<Over>().is_some() => SearchEnd::MostEvaluations,
        Err(error) => SearchEnd::NoBetterStep(error.to_string()),
    }
}

// -- Sequential quadratic programming of the crate slsqp, with bounds and constraints as they are --

/// What an equality may miss: it is held between two bounds.
const SLACK: f64 = 1e-9;

/// Searches from coordinates; the best design is among those that the search has seen.
pub(super) fn sequential_quadratic(search: &Search, from: &[f64]) -> SearchEnd {
    let objective = |c: &[f64], gradient: Option<&mut [f64]>, _: &mut ()| {
        let (value, slopes) = search.minimised(c, true);
        if let Some(gradient) = gradient {
            gradient.copy_from_slice(&slopes);
        }
        value
    };
    // g ≤ 0; of an equality e ≤ slack and -e ≤ slack
    let side = |index: usize, sign: f64, slack: f64| {
        move |c: &[f64], gradient: Option<&mut [f64]>, _: &mut ()| {
            if let Some(gradient) = gradient {
                let slopes = search.problem.constraint_gradient(index, c);
                gradient.iter_mut().zip(slopes).for_each(|(out, slope)| *out = sign * slope);
            }
            sign * search.problem.constraint(index, c) - slack
        }
    };
    let mut sides = Vec::new();
    for (index, constraint) in search.problem.constraints.iter().enumerate() {
        match constraint.kind {
            ConstraintKind::AtMost => sides.push(side(index, 1.0, 0.0)),
            ConstraintKind::Equal => sides.extend([1.0, -1.0].map(|sign| side(index, sign, SLACK))),
        }
    }
    let constraints: Vec<&dyn slsqp::Func<()>> = sides.iter().map(|side| side as &dyn slsqp::Func<()>).collect();
    let bounds = vec![(0.0, 1.0); from.len()];
    let tolerance = slsqp::StopTols { ftol_abs: search.options.tolerance, ..slsqp::StopTols::default() };
    match slsqp::minimize(objective, from, &bounds, &constraints, (), search.options.evaluations, Some(tolerance)) {
        Ok((slsqp::SuccessStatus::MaxEvalReached | slsqp::SuccessStatus::MaxTimeReached, ..)) => {
            SearchEnd::MostEvaluations
        }
        Ok(_) => SearchEnd::Converged,
        Err((slsqp::FailStatus::RoundoffLimited, ..)) => SearchEnd::NoBetterStep("the step is within round-off".into()),
        Err((status, ..)) => SearchEnd::NoBetterStep(format!("{status:?}")),
    }
}

// -- COBYLA of the crate cobyla, which asks for no gradient: to check an optimum by, and where there are no sensitivities --

/// First step of a search, in coordinates from 0 to 1, and of a check around an optimum.
pub(super) const FIRST_STEP: f64 = 0.1;
pub(super) const SMALL_STEP: f64 = 0.01;
/// Steps end there, and what an equality may miss of a search without gradients.
const LAST_STEP: f64 = 1e-6;
const ROUGH_SLACK: f64 = 5e-8;

/// Searches from coordinates; the best design is among those that the search has seen.
pub(super) fn derivative_free(search: &Search, from: &[f64], step: f64) -> SearchEnd {
    let objective = |c: &[f64], _: &mut ()| search.minimised(c, false).0;
    // at least zero where it holds
    let side = |index: usize, sign: f64, slack: f64| {
        move |c: &[f64], _: &mut ()| slack - sign * search.problem.constraint(index, c)
    };
    let mut sides = Vec::new();
    for (index, constraint) in search.problem.constraints.iter().enumerate() {
        match constraint.kind {
            ConstraintKind::AtMost => sides.push(side(index, 1.0, 0.0)),
            ConstraintKind::Equal => sides.extend([1.0, -1.0].map(|sign| side(index, sign, ROUGH_SLACK))),
        }
    }
    let constraints: Vec<&dyn cobyla::Func<()>> = sides.iter().map(|side| side as &dyn cobyla::Func<()>).collect();
    let bounds = vec![(0.0, 1.0); from.len()];
    let tolerance = cobyla::StopTols { xtol_abs: vec![LAST_STEP; from.len()], ..cobyla::StopTols::default() };
    let most = search.options.evaluations;
    match cobyla::minimize(objective, from, &bounds, &constraints, (), most, cobyla::RhoBeg::All(step), Some(tolerance))
    {
        Ok((cobyla::SuccessStatus::MaxEvalReached | cobyla::SuccessStatus::MaxTimeReached, ..)) => {
            SearchEnd::MostEvaluations
        }
        Ok(_) => SearchEnd::Converged,
        Err((status, ..)) => SearchEnd::NoBetterStep(format!("{status:?}")),
    }
}
