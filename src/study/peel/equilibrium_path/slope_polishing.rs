//! Slopes of the path where the force is level.
//!
//! A solution's slopes are those of Newton's last matrix, one update back. On a plateau the force changes so little that their
//! error may be larger than they are, and the force would seem to turn where it does not.

use crate::solve::{NewtonOptions, PathConstraint, PathSegment, Problem, Solution, Workspace, solve};
use std::sync::Arc;

/// A step over which the force changes by less than this share of itself is level.
const LEVEL: f64 = 1e-3;

/// Solves the ends of level steps on which the force seems to turn anew, with an error of `tolerance` and slopes at the
/// solutions themselves. Returns the Newton iterations that it took.
pub(super) fn sharpen(problem: &Problem, points: &mut [Arc<Solution>], tolerance: f64, ws: &mut Workspace) -> usize {
    let options = NewtonOptions { tolerance, largest_update: 0.5, most_iterations: 10, exact_slope: true };
    let mut sharp = vec![false; points.len()];
    let (mut index, mut iterations) = (0, 0);
    while index + 1 < points.len() {
        let blurred: Vec<usize> = (index..index + 2).filter(|&end| !sharp[end]).collect();
        if blurred.is_empty() || !seems_to_turn(&points[index], &points[index + 1]) {
            index += 1;
            continue;
        }
        let weights = PathSegment::around(problem, points, index).weights;
        for end in blurred {
            let constraint = PathConstraint { weights, target: weights.dot(&points[end].observables) };
            if let Ok(solution) = solve(problem, points[end].at.clone(), &constraint, &options, ws) {
                iterations += solution.iterations;
                points[end] = Arc::new(solution);
            }
            sharp[end] = true;
        }
        // the step before may have been spoilt by the same slope
        index = index.saturating_sub(1);
    }
    iterations
}

/// Whether the force is level on a step and has slopes of different signs at its ends.
fn seems_to_turn(from: &Solution, to: &Solution) -> bool {
    let (force, change) = (from.observables.force, to.observables.force - from.observables.force);
    (from.slope.force < 0.0) != (to.slope.force < 0.0) && change.abs() < LEVEL * force.abs()
}
