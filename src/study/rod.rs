//! The path of a rod under its drive, from rest on: every limit point located, none missed without a report.

use crate::solve::newton::Solution;
use crate::solve::path::equilibrium_path::Path;
use crate::solve::path::options::PathOptions;
use crate::solve::points::kind::LimitPointKind;
use crate::solve::points::locate::Located;
use crate::solve::points::tracer::{PathEvent, PathTracer, TraceError, TraceOptions};
use crate::solve::problem::Problem;
use std::sync::Arc;

/// A limit point on the path of a rod.
#[derive(Clone, Debug)]
pub struct RodLimitPoint {
    /// Of the displacement or of the force
    pub kind: LimitPointKind,
    /// It lies between `points[after]` and `points[after + 1]`.
    pub after: usize,
    /// The point and the error of its place
    pub located: Located,
}

/// A path with its limit points, in path order.
#[derive(Clone, Debug)]
pub struct RodPath {
    /// From rest on
    pub points: Vec<Arc<Solution>>,
    /// In path order
    pub turns: Vec<RodLimitPoint>,
    /// Newton iterations, on the path and to the limit points.
    pub iterations: usize,
}

/// Why the path of a rod cannot be used.
#[derive(Clone, Debug, thiserror::Error)]
#[allow(missing_docs)] // the text of each names its fields
pub enum RodFailure {
    #[error("{0}")]
    Trace(#[from] TraceError),
    #[error("{points} points were not enough to reach the end that was asked for")]
    TooLong { points: usize },
    #[error(
        "after path point {after} the number of negative eigenvalues goes from {from} to {to} with {limit_points} limit points of the {kind}"
    )]
    Missed { kind: LimitPointKind, after: usize, from: usize, to: usize, limit_points: usize },
}

/// Follows the path of `problem`, which adheres to nothing, from rest until `stop` says so of a point, for at most
/// `most_points` points.
pub fn follow_rod(
    problem: &Problem,
    options: PathOptions,
    most_points: usize,
    stop: impl Fn(&Solution) -> bool,
) -> Result<RodPath, RodFailure> {
    let mut tracer = PathTracer::new(problem, Path::new(problem, options), TraceOptions::default());
    let (mut points, mut turns) = (Vec::new(), Vec::new());
    loop {
        match tracer.advance()? {
            PathEvent::Point(point) => {
                points.push(point.clone());
                if stop(&point) {
                    return Ok(RodPath { points, turns, iterations: tracer.iterations() });
                }
                if points.len() >= most_points {
                    return Err(RodFailure::TooLong { points: most_points });
                }
            }
            PathEvent::LimitPoint { kind, after, located } => turns.push(RodLimitPoint { kind, after, located }),
            PathEvent::InertiaChange { kind, after, from, to, limit_points } => {
                return Err(RodFailure::Missed { kind, after, from, to, limit_points });
            }
            PathEvent::BranchPoint { .. } => {}
        }
    }
}
