//! A path with what happens on it: points, limit points, branch points and changes of inertia, as an iterator that is driven and stopped
//! at will.
//!
//! A step of the path is looked at as soon as its second point is there. Where a quantity turns on it, a few points behind it are computed
//! first, so that what lies between is well interpolated.

use super::bracket::brackets;
use super::branching::locate_branching;
use super::locate::{Located, locate};
use super::search::LimitPointKind;
use crate::solve::error::SolveError;
use crate::solve::newton::Solution;
use crate::solve::path::equilibrium_path::Path;
use crate::solve::path::options::{PathError, PathOptions, Waypoint};
use crate::solve::path::segment::PathSegment;
use crate::solve::problem::Problem;
use crate::solve::workspace::Workspace;
use serde::{Deserialize, Serialize};
use std::collections::VecDeque;
use std::sync::Arc;

/// What happens on a path, in its order.
#[derive(Clone, Debug)]
#[allow(missing_docs)] // the text of each names its fields
pub enum PathEvent {
    /// The next equilibrium.
    Point(Arc<Solution>),
    /// A quantity turns between `points[after]` and the next point.
    LimitPoint { kind: LimitPointKind, after: usize, located: Located },
    /// Stability is lost there although the displacement does not turn.
    BranchPoint { after: usize, located: Located },
    /// The number of negative eigenvalues with this quantity held changes there, by more or less than its limit points explain: something
    /// was missed.
    InertiaChange { kind: LimitPointKind, after: usize, from: usize, to: usize, limit_points: usize },
}

/// What is looked for on a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TraceOptions {
    /// Which limit points are located.
    pub kinds: &'static [LimitPointKind],
    /// Whether a loss of stability without a limit point is located as a branch point; the displacement must not turn there.
    pub branches: bool,
    /// A force that changes by less than this share of itself does not turn.
    pub relative: f64,
    /// Points beyond a limit point that its interpolation may use.
    pub behind: usize,
}

impl Default for TraceOptions {
    /// All limit points, no branch points.
    fn default() -> Self {
        Self { kinds: &[LimitPointKind::Load, LimitPointKind::Displacement], branches: false, relative: 0.0, behind: 3 }
    }
}

/// Why a path was not traced further.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum TraceError {
    #[error("{0}")]
    Path(#[from] PathError),
    #[error("the limit point of the {kind} after path point {after} (u = {displacement:.6}) was not located: {cause}")]
    NotLocated { kind: LimitPointKind, after: usize, displacement: f64, cause: SolveError },
    #[error(
        "stability is lost between u = {from:.6} and {to:.6}, where the displacement has no limit point, and the bifurcation was not \
         located: {cause}"
    )]
    NoBranching { from: f64, to: f64, cause: SolveError },
}

impl TraceError {
    /// What of it a solver says.
    pub(crate) fn cause(self) -> SolveError {
        match self {
            Self::Path(PathError { cause, .. }) | Self::NotLocated { cause, .. } | Self::NoBranching { cause, .. } => {
                cause
            }
        }
    }
}

/// A path being traced: an iterator over its events.
pub struct PathTracer<'p> {
    problem: &'p Problem,
    path: Path<'p>,
    options: TraceOptions,
    /// Steps that have been looked at.
    looked: usize,
    events: VecDeque<PathEvent>,
    ws: Workspace,
    iterations: usize,
    /// Whether the path could not be continued beyond a limit point; reported after its last point.
    broken: Option<PathError>,
    /// What the path has learnt at its newest points, those that [`PathTracer::new_waypoints`] has not given yet
    waypoints: Vec<Waypoint>,
}

impl<'p> PathTracer<'p> {
    /// Of a path from where it is; its first point is the first event.
    pub fn new(problem: &'p Problem, path: Path<'p>, options: TraceOptions) -> Self {
        let (events, ws) = (VecDeque::new(), Workspace::default());
        Self { problem, path, options, looked: 0, events, ws, iterations: 0, broken: None, waypoints: Vec::new() }
    }

    /// The path, with the points so far; there may be a few behind the last event.
    pub fn path(&self) -> &Path<'p> {
        &self.path
    }

    /// The points that the path has come to since it was asked last, for one that is to go on from there.
    pub fn new_waypoints(&mut self) -> Vec<Waypoint> {
        std::mem::take(&mut self.waypoints)
    }

    fn step(&mut self) -> Result<Arc<Solution>, PathError> {
        let point = self.path.advance()?;
        self.waypoints.extend(self.path.waypoint());
        Ok(point)
    }

    /// Newton iterations on the path and to its limit points.
    pub fn iterations(&self) -> usize {
        self.path.iterations() + self.iterations
    }

    /// The next event.
    pub fn advance(&mut self) -> Result<PathEvent, TraceError> {
        loop {
            if let Some(event) = self.events.pop_front() {
                return Ok(event);
            }
            let after = self.looked;
            if self.path.points().is_empty() {
                let first = self.step()?;
                self.events.push_back(PathEvent::Point(first));
                continue;
            }
            if self.path.points().len() < after + 2 {
                self.proceed()?;
            }
            self.looked += 1;
            for &kind in self.look(after)? {
                let limit_points = self.events.iter().filter(|event| event.is_limit_point(kind)).count();
                self.check_inertia(after, kind, limit_points)?;
            }
            self.events.push_back(PathEvent::Point(self.path.points()[after + 1].clone()));
        }
    }

    fn proceed(&mut self) -> Result<(), PathError> {
        match self.broken.take() {
            Some(error) => Err(error),
            None => self.step().map(drop),
        }
    }

    /// The limit points on a step, as events; the kinds that were looked for.
    fn look(&mut self, after: usize) -> Result<&'static [LimitPointKind], TraceError> {
        let mut found: Vec<(f64, LimitPointKind, Located)> = Vec::new();
        for &kind in self.options.kinds {
            let displacement = self.path.points()[after].observables.displacement;
            let not_located = |cause| TraceError::NotLocated { kind, after, displacement, cause };
            let (mut segment, mut brackets) = self.bracketed(after, kind).map_err(not_located)?;
            if brackets.is_empty() {
                continue;
            }
            if self.wait_behind(after + 1) {
                let again = self.bracketed(after, kind);
                if let Some(again) = again.ok().filter(|(_, brackets)| !brackets.is_empty()) {
                    (segment, brackets) = again;
                }
            }
            for bracket in brackets {
                let located = locate(self.problem, &segment, kind, bracket, None, &mut self.ws).map_err(not_located)?;
                self.iterations += located.iterations;
                found.push((segment.label(&located.observables) / segment.end(), kind, located));
            }
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let events = found.into_iter().map(|(_, kind, located)| PathEvent::LimitPoint { kind, after, located });
        self.events.extend(events);
        Ok(self.options.kinds)
    }

    fn bracketed(&mut self, after: usize, kind: LimitPointKind) -> Result<(PathSegment, Vec<(f64, f64)>), SolveError> {
        let segment = PathSegment::around(self.problem, self.path.points(), after);
        let points = self.path.points();
        let found = brackets(self.problem, points, after, &segment, kind, self.options.relative, &mut self.ws)?;
        Ok((segment, found))
    }

    /// Computes the points beyond a limit point that are missing; whether there are any.
    fn wait_behind(&mut self, second: usize) -> bool {
        while self.broken.is_none() && self.path.points().len() <= second + self.options.behind {
            self.broken = self.step().err();
        }
        self.path.points().len() > second + 1
    }

    /// What limit points of a quantity do not explain of a change of the number of negative eigenvalues with it held.
    fn check_inertia(&mut self, after: usize, kind: LimitPointKind, limit_points: usize) -> Result<(), TraceError> {
        let (before, behind) = (self.path.points()[after].clone(), &self.path.points()[after + 1]);
        let (from, to) = (kind.negative(&before), kind.negative(behind));
        let change = from.abs_diff(to);
        let explained = change <= limit_points && (limit_points + change).is_multiple_of(2);
        if explained || !self.problem.system.is_conservative() {
            return Ok(());
        }
        if self.options.branches && kind == LimitPointKind::Displacement && from == 0 && limit_points == 0 {
            let (from, to) = (before.observables.displacement, behind.observables.displacement);
            let located = locate_branching(self.problem, &before, to, &mut self.ws)
                .map_err(|cause| TraceError::NoBranching { from, to, cause })?;
            self.iterations += located.iterations;
            self.events.push_back(PathEvent::BranchPoint { after, located });
        } else {
            self.events.push_back(PathEvent::InertiaChange { kind, after, from, to, limit_points });
        }
        Ok(())
    }
}

impl PathEvent {
    fn is_limit_point(&self, wanted: LimitPointKind) -> bool {
        matches!(self, Self::LimitPoint { kind, .. } if *kind == wanted)
    }
}

impl Iterator for PathTracer<'_> {
    type Item = Result<PathEvent, TraceError>;

    fn next(&mut self) -> Option<Self::Item> {
        Some(self.advance())
    }
}

// -- The path of a rod under its drive, from rest on: every limit point located, none missed without a report --

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
