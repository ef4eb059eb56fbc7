//! Slopes of the path where force or displacement are level.
//!
//! A solution's slopes are those of Newton's last matrix, one update back, and of its own mesh. Where a quantity changes little their error may be
//! larger than they are, and it would seem to turn where it does not.
//!
//! The mesh of the path moves with the front. With σ the path's parameter and f the focus of the mesh, a quantity of the path changes by
//!
//!   dq/dσ = ∂q/∂σ + ∂q/∂f df/dσ,
//!
//! where the first term is the slope on one mesh. The second is an error of the discretisation, which comes and goes as elements pass by: on a plateau
//! it may be the larger one. ∂q/∂f is differenced.

use crate::solve::newton::{NewtonOptions, Solution, solve};
use crate::solve::observables::{Observables, PathConstraint};
use crate::solve::path::segment::PathSegment;
use crate::solve::points::kind::LimitPointKind;
use crate::solve::problem::Problem;
use crate::solve::workspace::Workspace;
use std::sync::Arc;

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
