//! Sequential quadratic programming of the crate slsqp, with bounds and constraints as they are.

use super::problem::ConstraintKind;
use super::search::{Search, SearchEnd};
use slsqp::{FailStatus, Func, StopTols, SuccessStatus, minimize};

/// What an equality may miss: it is held between two bounds.
const SLACK: f64 = 1e-9;

/// Searches from coordinates; the best design is among those that the search has seen.
pub(super) fn search(search: &Search, from: &[f64]) -> SearchEnd {
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
    let constraints: Vec<&dyn Func<()>> = sides.iter().map(|side| side as &dyn Func<()>).collect();
    let bounds = vec![(0.0, 1.0); from.len()];
    let tolerance = StopTols { ftol_abs: search.options.tolerance, ..StopTols::default() };
    match minimize(objective, from, &bounds, &constraints, (), search.options.evaluations, Some(tolerance)) {
        Ok((SuccessStatus::MaxEvalReached | SuccessStatus::MaxTimeReached, ..)) => SearchEnd::MostEvaluations,
        Ok(_) => SearchEnd::Converged,
        Err((FailStatus::RoundoffLimited, ..)) => SearchEnd::NoBetterStep("the step is within round-off".into()),
        Err((status, ..)) => SearchEnd::NoBetterStep(format!("{status:?}")),
    }
}
