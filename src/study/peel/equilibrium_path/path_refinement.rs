//! Points between those of a path, where the curve needs them.
//!
//! Steps are as long as predictions allow, which a step that turns by a right angle may be. Between points the curve is
//! interpolated; where that is not good enough, the middle of the step is solved as well.

use crate::solve::error::SolveError;
use crate::solve::newton::{NewtonOptions, Solution, solve};
use crate::solve::path::segment::PathSegment;
use crate::solve::points::locate::step_to;
use crate::solve::points::search::LimitPointKind;
use crate::solve::problem::Problem;
use crate::solve::state::{Observables, PathConstraint};
use crate::solve::workspace::Workspace;
use crate::study::asked::error_bounds::INTERPOLATION_ERROR_FACTOR;
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

// -- Slopes of the path where force or displacement are level --
//
// A solution's slopes are those of Newton's last matrix, one update back, and of its own mesh. Where a quantity changes little their error may be
// larger than they are, and it would seem to turn where it does not.
//
// The mesh of the path moves with the front. With σ the path's parameter and f the focus of the mesh, a quantity of the path changes by
//
// dq/dσ = ∂q/∂σ + ∂q/∂f df/dσ,
//
// where the first term is the slope on one mesh. The second is an error of the discretisation, which comes and goes as elements pass by: on a plateau
// it may be the larger one. ∂q/∂f is differenced.

/// A step over which the force changes by less than this share of itself is level.
const LEVEL: f64 = 1e-3;
/// The same of the displacement, whose slopes on one mesh are good but at folds so flat as this.
const LEVEL_PLACE: f64 = 1e-6;
/// A step over which the force changes by less than this many times the accuracy asked for may turn because its mesh moves.
const RIPPLE: f64 = 100.0;
/// How far a mesh is moved, over the scale of the front.
const BESIDE: f64 = 0.1;

/// What the slopes at a point are.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Slopes {
    /// Those of Newton's last matrix, one update back
    Before,
    /// Those at the solution, on its mesh
    OnMesh,
    /// Those of the path, whose mesh moves
    OfPath,
}

/// Solves the ends of level steps on which a quantity seems to turn anew, with an error of `tolerance` and slopes at the solutions themselves; where
/// the force still turns, and changes by next to the accuracy `relative`, with those of the path. Returns the Newton iterations that it took.
pub(super) fn sharpen(
    problem: &Problem,
    points: &mut [Arc<Solution>],
    relative: f64,
    tolerance: f64,
    ws: &mut Workspace,
) -> usize {
    let options = NewtonOptions { tolerance, largest_update: 0.5, most_iterations: 10, exact_slope: true };
    let mut slopes = vec![Slopes::Before; points.len()];
    let (mut index, mut iterations) = (0, 0);
    while index + 1 < points.len() {
        let wanted = wanted(&points[index], &points[index + 1], &slopes[index..index + 2], relative);
        let blurred: Vec<usize> = (index..index + 2).filter(|&end| slopes[end] < wanted).collect();
        if blurred.is_empty() {
            index += 1;
            continue;
        }
        let weights = PathSegment::around(problem, points, index).weights;
        for end in blurred {
            let constraint = PathConstraint { weights, target: weights.dot(&points[end].observables) };
            if let Ok(mut solution) = solve(problem, points[end].at.clone(), &constraint, &options, ws) {
                iterations += solution.iterations;
                if wanted == Slopes::OfPath
                    && let Some((by_mesh, further)) = slope_by_mesh(problem, &solution, &constraint, &options, ws)
                {
                    solution.slope = solution.slope.plus(&by_mesh);
                    iterations += further;
                }
                points[end] = Arc::new(solution);
            }
            slopes[end] = wanted;
        }
        // the step before may have been spoilt by the same slope
        index = index.saturating_sub(1);
    }
    iterations
}

/// The slopes that a step needs at its ends, which have those that are `known`.
fn wanted(from: &Solution, to: &Solution, known: &[Slopes], relative: f64) -> Slopes {
    let load = |level| seems_to_turn(LimitPointKind::Load, from, to, level);
    if !load(LEVEL) && !seems_to_turn(LimitPointKind::Displacement, from, to, LEVEL_PLACE) {
        Slopes::Before
    } else if !known.contains(&Slopes::Before) && load(RIPPLE * relative) {
        Slopes::OfPath
    } else {
        Slopes::OnMesh
    }
}

/// ∂q/∂f df/dσ at a solution, and the Newton iterations that it took; nothing where its mesh stays.
fn slope_by_mesh(
    problem: &Problem,
    solution: &Solution,
    constraint: &PathConstraint,
    options: &NewtonOptions,
    ws: &mut Workspace,
) -> Option<(Observables, usize)> {
    let mut monitors = solution.observables.monitors;
    monitors[0] = solution.at.mesh.focus + BESIDE * problem.measure.monitors[0];
    let beside = problem.system.refocused(&solution.at, monitors);
    let moved = beside.mesh.focus - solution.at.mesh.focus;
    if moved == 0.0 || beside.mesh.boundaries == solution.at.mesh.boundaries {
        return None;
    }
    let beside = solve(problem, beside, constraint, options, ws).ok()?;
    let by_focus = beside.observables.since(&solution.observables).times(1.0 / moved);
    Some((by_focus.times(solution.slope.monitors[0]), beside.iterations))
}

/// Whether a quantity changes on a step by less than the share `level` of itself and has slopes of different signs at its ends.
fn seems_to_turn(kind: LimitPointKind, from: &Solution, to: &Solution, level: f64) -> bool {
    let pick = kind.pick();
    let (value, change) = (pick(&from.observables), pick(&to.observables) - pick(&from.observables));
    (pick(&from.slope) < 0.0) != (pick(&to.slope) < 0.0) && change.abs() < level * value.abs()
}
