//! Which steps of a path hold limit points.

use super::locate::{ROUGH, slope_at, solve_on, step_to};
use super::search::LimitPointKind;
use crate::solve::error::SolveError;
use crate::solve::newton::Solution;
use crate::solve::path::hermite::Hermite;
use crate::solve::path::segment::PathSegment;
use crate::solve::problem::Problem;
use crate::solve::workspace::Workspace;
use std::sync::Arc;

/// Places inside a step at which the interpolated slope is looked at.
const PLACES: usize = 16;
/// A displacement whose slope falls below this share of that at the ends of a step may turn twice within it.
const NEARLY: f64 = 0.5;
/// Solutions inside a step that are spent on finding out.
const MOST_LOOKS: usize = 4;

/// Labels between which the slope of a quantity changes sign on one step: where it differs at the two ends, or, for a pair
/// of turns within the step, where an interpolant comes near to turning and a solution in between does.
pub fn brackets(
    problem: &Problem,
    points: &[Arc<Solution>],
    index: usize,
    segment: &PathSegment,
    turn: LimitPointKind,
    relative: f64,
    ws: &mut Workspace,
) -> Result<Vec<(f64, f64)>, SolveError> {
    let (from, to) = (&points[index], &points[index + 1]);
    let pick = turn.pick();
    if (pick(&from.slope) < 0.0) != (pick(&to.slope) < 0.0) {
        return Ok(vec![(0.0, segment.end())]);
    }
    let between = match turn {
        LimitPointKind::Load => turned_load(problem, (from, to), segment, relative, ws)?,
        LimitPointKind::Displacement => turned_displacement(problem, segment, ws)?,
    };
    Ok(between.map_or_else(Vec::new, |label| vec![(0.0, label), (label, segment.end())]))
}

/// A label at which the force goes the other way than at both ends of the step, if the cubic through them turns.
fn turned_load(
    problem: &Problem,
    (from, to): (&Solution, &Solution),
    segment: &PathSegment,
    relative: f64,
    ws: &mut Workspace,
) -> Result<Option<f64>, SolveError> {
    let (pick, end) = (LimitPointKind::Load.pick(), segment.end());
    let first = pick(&from.slope);
    let along = |p: &Solution| pick(&p.slope) / segment.weights.dot(&p.slope);
    let cubic = Hermite::new(&[(0.0, pick(&from.observables), along(from)), (end, pick(&to.observables), along(to))]);
    // the slope of a cubic is extreme where its second derivative, linear in the label, vanishes
    let (bend_from, bend_to) = (cubic.at(0.0).2, cubic.at(end).2);
    let extreme = end * bend_from / (bend_from - bend_to);
    if !(extreme > 0.0 && extreme < end) || (cubic.at(extreme).1 < 0.0) == (first < 0.0) {
        return Ok(None);
    }
    let (values, beyond) = ((pick(&from.observables), pick(&to.observables)), cubic.at(extreme).0);
    if (values.0 - values.1).abs().max((beyond - values.0).abs()) < relative * beyond.abs() {
        return Ok(None);
    }
    let between = solve_on(problem, segment, extreme, ROUGH, ws)?;
    let slope = slope_at(problem, segment, &between, LimitPointKind::Load, ws)?;
    Ok(((slope < 0.0) != (first < 0.0)).then_some(extreme))
}

/// A label at which the displacement goes the other way than at both ends of the step. Two limit points that have just been
/// born lie close together: where the slope is small between them, solutions there say whether it changes its sign.
fn turned_displacement(
    problem: &Problem,
    segment: &PathSegment,
    ws: &mut Workspace,
) -> Result<Option<f64>, SolveError> {
    let (pick, end) = (LimitPointKind::Displacement.pick(), segment.end());
    let (first, last) = segment.end_slopes();
    let sign = pick(&first).signum();
    let small = NEARLY * pick(&first).abs().min(pick(&last).abs());
    let mut known = segment.clone();
    let mut last_look = f64::INFINITY;
    for _ in 0..MOST_LOOKS {
        let mut interpolants = known.interpolants(pick);
        let mut slope_at = |label: f64| sign * interpolants.near(label).at(label).1;
        let labels = (1..PLACES).map(|k| end * k as f64 / PLACES as f64);
        let least = labels.map(|label| (slope_at(label), label)).min_by(|a, b| a.0.total_cmp(&b.0));
        let Some((slope, label)) = least.filter(|least| least.0 < small) else { return Ok(None) };
        // between the places the slope is a parabola
        let step = end / PLACES as f64;
        let (before, behind) = (slope_at(label - step), slope_at(label + step));
        let shift = 0.5 * (before - behind) / (before - 2.0 * slope + behind);
        let label = if shift.abs() < 1.0 { label + step * shift } else { label };
        if (label - last_look).abs() < 1e-3 * end {
            return Ok(None);
        }
        last_look = label;
        let between = step_to(problem, &mut known, 0.0, label, ROUGH, ws)?;
        if sign * pick(&between.slope) < 0.0 {
            return Ok(Some(label));
        }
    }
    Ok(None)
}
