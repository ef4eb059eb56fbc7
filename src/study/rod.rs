//! The path of a rod under its drive, from rest on: every turning point located, none missed without a word.

use crate::solve::{
    LimitPointKind, Located, Path, PathError, PathOptions, PathSegment, Problem, Solution, SolveError, Workspace,
    brackets, locate,
};
use std::sync::Arc;

/// A turning point on the path of a rod.
#[derive(Clone, Debug)]
pub struct RodTurn {
    pub kind: LimitPointKind,
    /// It lies between `points[after]` and `points[after + 1]`.
    pub after: usize,
    pub located: Located,
}

/// A path with its turning points, in path order.
#[derive(Clone, Debug)]
pub struct RodPath {
    pub points: Vec<Arc<Solution>>,
    pub turns: Vec<RodTurn>,
    /// Newton iterations, on the path and to the turning points.
    pub iterations: usize,
}

/// Why the path of a rod cannot be used.
#[derive(Clone, Debug, thiserror::Error)]
pub enum RodTrouble {
    #[error("{0}")]
    Path(#[from] PathError),
    #[error("{points} points were not enough to reach the end that was asked for")]
    TooLong { points: usize },
    #[error("the turning point of the {kind:?} behind path point {after} was not located: {cause}")]
    NotLocated { kind: LimitPointKind, after: usize, cause: SolveError },
    #[error(
        "behind path point {after} the number of negative eigenvalues changes by {change} with {turns} {kind:?} turns"
    )]
    Missed { kind: LimitPointKind, after: usize, change: usize, turns: usize },
}

/// Follows the path of `problem`, which adheres to nothing, from rest until `stop` says so of a point, for at most
/// `most_points` points.
pub fn follow_rod(
    problem: &Problem,
    options: PathOptions,
    most_points: usize,
    stop: impl Fn(&Solution) -> bool,
) -> Result<RodPath, RodTrouble> {
    let mut path = Path::new(problem, options);
    while !stop(&*path.advance()?) {
        if path.points().len() >= most_points {
            return Err(RodTrouble::TooLong { points: most_points });
        }
    }
    let mut followed = RodPath { points: path.points().to_vec(), turns: Vec::new(), iterations: path.iterations() };
    let mut ws = Workspace::default();
    for after in 0..followed.points.len() - 1 {
        let mut turns = turns_of_step(problem, &followed.points, after, &mut ws)?;
        check_inertia(&followed.points, after, &turns)?;
        followed.iterations += turns.iter().map(|turn| turn.located.iterations).sum::<usize>();
        followed.turns.append(&mut turns);
    }
    Ok(followed)
}

/// The turning points between one point and the next.
fn turns_of_step(
    problem: &Problem,
    points: &[Arc<Solution>],
    after: usize,
    ws: &mut Workspace,
) -> Result<Vec<RodTurn>, RodTrouble> {
    let segment = PathSegment::around(problem, points, after);
    let mut turns = Vec::new();
    for kind in [LimitPointKind::Load, LimitPointKind::Displacement] {
        let not_located = |cause| RodTrouble::NotLocated { kind, after, cause };
        for bracket in brackets(problem, points, after, &segment, kind, 0.0, ws).map_err(not_located)? {
            let located = locate(problem, &segment, kind, bracket, None, ws).map_err(not_located)?;
            turns.push(RodTurn { kind, after, located });
        }
    }
    let label = |turn: &RodTurn| segment.label(&turn.located.observables);
    turns.sort_by(|a, b| label(a).total_cmp(&label(b)));
    Ok(turns)
}

/// A turn of the displacement changes the number of negative eigenvalues with the displacement held, a turn of the load
/// that with the load held, each by one; on a path that does not branch nothing else does.
fn check_inertia(points: &[Arc<Solution>], after: usize, turns: &[RodTurn]) -> Result<(), RodTrouble> {
    let (from, to) = (&points[after], &points[after + 1]);
    let changes = [
        (LimitPointKind::Displacement, from.negative.abs_diff(to.negative)),
        (LimitPointKind::Load, from.negative_load.abs_diff(to.negative_load)),
    ];
    for (kind, change) in changes {
        let turns = turns.iter().filter(|turn| turn.kind == kind).count();
        if change > turns || !(turns + change).is_multiple_of(2) {
            return Err(RodTrouble::Missed { kind, after, change, turns });
        }
    }
    Ok(())
}
