//! COBYLA of the crate cobyla, which asks for no gradient: to check an optimum by, and where there are no sensitivities.

use super::problem::ConstraintKind;
use super::search::{Search, SearchEnd};
use cobyla::{Func, RhoBeg, StopTols, SuccessStatus, minimize};

/// First step of a search, in coordinates from 0 to 1, and of a check around an optimum.
pub(super) const FIRST_STEP: f64 = 0.1;
pub(super) const SMALL_STEP: f64 = 0.01;
/// Steps end there, and what an equality may miss.
const LAST_STEP: f64 = 1e-6;
const SLACK: f64 = 5e-8;

/// Searches from coordinates; the best design is among those that the search has seen.
pub(super) fn search(search: &Search, from: &[f64], step: f64) -> SearchEnd {
    let objective = |c: &[f64], _: &mut ()| search.minimised(c, false).0;
    // at least zero where it holds
    let side = |index: usize, sign: f64, slack: f64| {
        move |c: &[f64], _: &mut ()| slack - sign * search.problem.constraint(index, c)
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
    let tolerance = StopTols { xtol_abs: vec![LAST_STEP; from.len()], ..StopTols::default() };
    let most = search.options.evaluations;
    match minimize(objective, from, &bounds, &constraints, (), most, RhoBeg::All(step), Some(tolerance)) {
        Ok((SuccessStatus::MaxEvalReached | SuccessStatus::MaxTimeReached, ..)) => SearchEnd::MostEvaluations,
        Ok(_) => SearchEnd::Converged,
        Err((status, ..)) => SearchEnd::NoBetterStep(format!("{status:?}")),
    }
}
