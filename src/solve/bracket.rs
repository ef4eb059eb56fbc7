//! Which steps of a path hold turning points.

use super::limit::{Turn, solve_on};
use super::stretch::{Hermite, Stretch};
use super::{Problem, Solution, SolveError, Workspace};
use std::sync::Arc;

/// Labels between which the slope of a quantity changes sign on one step: where it differs at the two ends, or, for a pair
/// of turns within the step, where the cubic through both ends turns and a solution in between confirms it.
pub fn brackets(
    problem: &Problem,
    points: &[Arc<Solution>],
    index: usize,
    stretch: &Stretch,
    turn: Turn,
    relative: f64,
    work: &mut Workspace,
) -> Result<Vec<(f64, f64)>, SolveError> {
    let (from, to) = (&points[index], &points[index + 1]);
    let (pick, end) = (turn.pick(), stretch.end());
    let (first, last) = (pick(&from.slope), pick(&to.slope));
    if (first < 0.0) != (last < 0.0) {
        return Ok(vec![(0.0, end)]);
    }
    let along = |p: &Solution| pick(&p.slope) / stretch.weights.dot(&p.slope);
    let cubic = Hermite::new(&[(0.0, pick(&from.observables), along(from)), (end, pick(&to.observables), along(to))]);
    // the slope of a cubic is extreme where its second derivative, linear in the label, vanishes
    let (bend_from, bend_to) = (cubic.at(0.0).2, cubic.at(end).2);
    let extreme = end * bend_from / (bend_from - bend_to);
    if !(extreme > 0.0 && extreme < end) || (cubic.at(extreme).1 < 0.0) == (first < 0.0) {
        return Ok(Vec::new());
    }
    let (values, beyond) = ((pick(&from.observables), pick(&to.observables)), cubic.at(extreme).0);
    if turn == Turn::Load && (values.0 - values.1).abs().max((beyond - values.0).abs()) < relative * beyond.abs() {
        return Ok(Vec::new());
    }
    let between = solve_on(problem, stretch, extreme, false, work)?;
    if (pick(&between.slope) < 0.0) == (first < 0.0) {
        return Ok(Vec::new());
    }
    Ok(vec![(0.0, extreme), (extreme, end)])
}
