//! How the force at a held displacement changes with parameters, on the first stable branch of a path.

use super::differences::{Beside, Stencil};
use super::point::{Adjoint, Held, solved};
use super::quantity::NoSensitivities;
use super::quantity::Variation;
use super::run::{discretisation, solutions};
use crate::model::problem::beam_problem::BeamProblem;
use crate::number::root::Bracket;
use crate::solve::newton::Solution;
use crate::solve::path::segment::PathSegment;
use crate::solve::points::passing::{Passing, PathNumber, SoughtValue};
use crate::solve::points::search::LimitPointKind;
use crate::solve::state::State;
use crate::solve::workspace::Workspace;
use crate::study::peel::result::Peel;
use crate::study::peel::solution_history::SolutionHistory;
use rayon::prelude::*;
use std::sync::Arc;

/// Solutions that a start for Newton's method is interpolated between.
const INTERPOLATED: usize = 4;
/// How sharp its place on a step is looked for, over the step.
const SHARP: f64 = 1e-12;

/// The force P (nN) at displacements (nm) on the first stable branch of the path, from its beginning to its first displacement limit point, and
/// dP/dx there with the displacement held: one row a displacement, one column a variation.
///
/// # Errors
/// As of [`crate::study::sensitivities`], and for a displacement that is not on that branch.
pub fn force_derivatives(
    peel: &Peel,
    displacements: &[f64],
    variations: &[Variation],
) -> Result<Vec<(f64, Vec<f64>)>, NoSensitivities> {
    let found = forces_on_branch(peel, displacements, variations)?;
    Ok(found.into_iter().map(|at| (at.force, at.derivatives)).collect())
}

/// The force at a displacement.
pub(in crate::study) struct ForceOnBranch {
    /// P, nN
    pub force: f64,
    /// dP/du, nN/nm
    pub slope: f64,
    /// dP/dx with the displacement held, one a variation
    pub derivatives: Vec<f64>,
}

/// The same with the slope of the force, at the same solutions.
pub(in crate::study) fn forces_on_branch(
    peel: &Peel,
    displacements: &[f64],
    variations: &[Variation],
) -> Result<Vec<ForceOnBranch>, NoSensitivities> {
    let history = solutions(peel)?;
    let problem = &history.problem;
    let turn = peel.limit_points.iter().find(|point| point.kind == LimitPointKind::Displacement);
    let last = turn.map_or(history.points.len(), |turn| turn.after + 1);
    let branch = &history.points[..last];
    let most = turn.map(|turn| turn.displacement);
    let most = most.or_else(|| branch.last().map(|point| point.observables.displacement)).unwrap_or(0.0);
    let adjoint = |&displacement: &f64| {
        let missing = NoSensitivities::NotOnBranch { displacement, most };
        if displacement.is_nan() || displacement > most {
            return Err(missing);
        }
        let next = branch.partition_point(|point| point.observables.displacement <= displacement);
        branch.first().ok_or(missing)?;
        let mut ws = Workspace::default();
        let not_solved = |cause| NoSensitivities::NotSolved { of: "the force", cause };
        let index = next.saturating_sub(1);
        let folds = turn.is_some_and(|turn| turn.after == index);
        let found = if folds { before_the_fold(peel, history, index, displacement, &mut ws) } else { None };
        let found = match found {
            Some(found) => found,
            None => {
                let start = interpolated(problem, &history.points, index, displacement);
                solved(problem, start, Held::Displacement, displacement, &mut ws).map_err(not_solved)?
            }
        };
        let adjoint = Adjoint::new(problem, &found.at, Held::Displacement, &mut ws).map_err(not_solved)?;
        Ok((found.observables.force, found.slope.force, adjoint))
    };
    let points: Vec<(f64, f64, Adjoint)> = displacements.par_iter().map(adjoint).collect::<Result<_, _>>()?;
    let (base, how) = (Beside::base(problem, &peel.model), discretisation(peel));
    let column = |variation: &Variation| -> Result<Vec<f64>, NoSensitivities> {
        let beside = Stencil::beside(variation, &base, how)?;
        let stencil = Stencil::new(&base, &beside);
        if points.iter().any(|(.., point)| !stencil.has_unknowns_of(&point.at)) {
            return Err(NoSensitivities::AnotherKind { key: variation.key.clone() });
        }
        let one = |(.., point): &(f64, f64, Adjoint)| {
            let value = stencil.force(point).estimate().value;
            let not_finite = || NoSensitivities::NotFinite { key: variation.key.clone(), of: "the force" };
            if value.is_finite() { Ok(value) } else { Err(not_finite()) }
        };
        points.iter().map(one).collect()
    };
    let columns: Vec<Vec<f64>> = variations.par_iter().map(column).collect::<Result<_, _>>()?;
    let on_branch = |(k, (force, slope, _)): (usize, &(f64, f64, Adjoint))| ForceOnBranch {
        force: *force,
        slope: *slope,
        derivatives: columns.iter().map(|column| column[k]).collect(),
    };
    Ok(points.iter().enumerate().map(on_branch).collect())
}

/// The equilibrium at a displacement on the step behind `points[index]`, before the displacement turns there. Next to that it cannot be held at its
/// displacement, or is one behind the limit point: it is picked by its place on the step.
fn before_the_fold(
    peel: &Peel,
    SolutionHistory { problem, points, limit_points, .. }: &SolutionHistory,
    index: usize,
    displacement: f64,
    ws: &mut Workspace,
) -> Option<Solution> {
    points.get(index + 1)?;
    let turns = peel.limit_points.iter().map(|at| at.after).zip(limit_points.iter().cloned());
    let number = PathNumber::observable(problem, |o| o.displacement);
    let sought = SoughtValue::new(number, displacement, Passing::Rising, points).with_turns(turns.collect());
    let found = sought.on_step(index, ws).ok()?;
    let mut found = Solution::clone(&found.first()?.solution);
    found.slope = found.slope.times(found.slope.displacement.recip());
    Some(found)
}

/// A state between solutions of a path at a displacement that the step behind `points[index]` comes to first: the curve may be steep, and bends
/// sharply before a limit point, so that a tangent is no start.
fn interpolated(problem: &BeamProblem, points: &[Arc<Solution>], index: usize, displacement: f64) -> State {
    if index + 1 >= points.len() {
        let last = &points[points.len() - 1];
        return last.moved(problem, (displacement - last.observables.displacement) / last.slope.displacement);
    }
    let segment = PathSegment::around(problem, points, index);
    let curve = segment.observable(|o| o.displacement, 0.5 * segment.end());
    let end = segment.end();
    let high = if curve.at(end).1 < 0.0 { curve.turning_point(0.0, end) } else { end };
    let is_before = |label: f64| curve.at(label).0 < displacement;
    let place = Bracket { low: 0.0, high }.bisected(is_before, |left| left.width() <= SHARP * end);
    segment.start(problem, place.middle(), INTERPOLATED)
}
