//! Points between those of a path, where the curve needs them.
//!
//! Steps are as long as predictions allow, which a step that turns by a right angle may be. Between points the curve is
//! interpolated; where that is not good enough, the middle of the step is solved as well.

use crate::solve::error::SolveError;
use crate::solve::newton::Solution;
use crate::solve::observables::Observables;
use crate::solve::path::segment::PathSegment;
use crate::solve::points::locate::step_to;
use crate::solve::problem::Problem;
use crate::solve::workspace::Workspace;
use crate::study::error_bounds::INTERPOLATION_ERROR_FACTOR;
use std::sync::Arc;

/// Most times a step is halved.
const MOST_HALVINGS: usize = 4;
/// Error wanted of the curve between points, over the square root of the accuracy asked for of the points themselves.
const BETWEEN: f64 = 0.1;
/// The least error wanted of it.
const LEAST: f64 = 1e-6;
/// A step that is interpolated no better than this, and in the middle of which no solution is found, is a jump.
const JUMP: f64 = 0.1;
/// Forces below this share of the largest one, and displacements below this share of their scale, count as they are.
const SMALL: f64 = 1e-2;

/// Halves steps on which displacement or force is interpolated too badly for the accuracy `relative`, until there are `most`
/// points, with an error of `tolerance` of their solutions. Returns the Newton iterations that it took, and the point before the
/// first step that seems to be a jump to another part of the path.
pub(super) fn fill_in(
    problem: &Problem,
    points: &mut Vec<Arc<Solution>>,
    relative: f64,
    tolerance: f64,
    most: usize,
    ws: &mut Workspace,
) -> (usize, Option<usize>) {
    let wanted = (BETWEEN * relative.sqrt()).max(LEAST);
    let largest = points.iter().map(|point| point.observables.force.abs()).fold(0.0, f64::max);
    let least = (SMALL * problem.grip.displacement_scale(), SMALL * largest);
    let mut halvings = vec![0; points.len()];
    let (mut index, mut iterations, mut jump) = (0, 0, None);
    while index + 1 < points.len() && points.len() < most {
        let mut segment = PathSegment::around(problem, points, index);
        let error = error(&segment, least);
        let bad =
            halvings[index] < MOST_HALVINGS && error.is_none_or(|error| INTERPOLATION_ERROR_FACTOR * error > wanted);
        // a middle that cannot be found is none of the path's points, and the interpolant stays
        let middle = 0.5 * segment.end();
        match bad.then(|| step_to(problem, &mut segment, 0.0, middle, tolerance, ws)) {
            Some(Ok(middle)) => {
                iterations += middle.iterations;
                points.insert(index + 1, middle);
                halvings[index] += 1;
                halvings.insert(index + 1, halvings[index]);
            }
            not_found => {
                let in_vain = not_found.is_some_and(|found| found.is_err_and(|cause| cause != SolveError::Stopped));
                let jumped = in_vain && error.is_some_and(|error| error > JUMP);
                jump = jump.or(jumped.then_some(index));
                index += 1;
            }
        }
    }
    (iterations, jump)
}

/// The relative error of the interpolated displacement and force, where it can be determined.
fn error(segment: &PathSegment, least: (f64, f64)) -> Option<f64> {
    let Observables { displacement, force, .. } = segment.first().observables;
    let displacement = segment.interpolation_error(|o| o.displacement)? / (displacement.abs() + least.0);
    let force = segment.interpolation_error(|o| o.force)? / (force.abs() + least.1);
    Some(displacement.max(force))
}
