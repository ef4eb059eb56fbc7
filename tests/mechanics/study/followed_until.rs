//! Paths that are followed to their first jump, or to where they detach, and no further.
//!
//! Expected: the numbers of the whole path within both bounds, up to there; the end says what was asked for; a path that ends before ends as it does.
//! Why: who tests a tape needs nothing behind its first jump, where most of what fails does.

use super::steady_force::{at, tape};
use crate::common::paper_strip;
use peelkit::model::{Friction, PeelModel};
use peelkit::study::{Accuracy, Bound, FollowedUntil, LimitPoint, LimitPointKind, PathEnd, Peel, StopCriteria, peel};

fn followed(model: &PeelModel, until: FollowedUntil) -> Peel {
    peel(model, &Accuracy::to(1e-5), &StopCriteria { until, ..StopCriteria::default() })
}

fn assert_same(one: &LimitPoint, other: &LimitPoint) {
    assert_eq!(one.kind, other.kind);
    assert!((one.force - other.force).abs() <= one.force_error + other.force_error, "{one:?} {other:?}");
    let bounds = one.displacement_error + other.displacement_error;
    assert!((one.displacement - other.displacement).abs() <= bounds, "{one:?} {other:?}");
}

#[test]
fn a_path_ends_behind_its_first_jump() {
    for model in [paper_strip(100.0, 1.0).into(), at(tape(), 45.0), at(tape(), 90.0)] {
        let [part, whole] = [FollowedUntil::FirstJump, FollowedUntil::End].map(|until| followed(&model, until));
        assert_eq!(part.end, PathEnd::Bound(Bound::Until(FollowedUntil::FirstJump)));
        let jump = part.snap_off.unwrap();
        assert_eq!(part.limit_points.last(), Some(&jump), "nothing is known behind it");
        assert!(part.points.len() < whole.points.len() && part.points.len() <= jump.after + 8);
        assert_same(&jump, &whole.snap_off.unwrap());
        assert_same(&part.limit_points[0], &whole.limit_points[0]);
        assert!(part.peak.is_some() && part.detachment.is_none() && !part.unfinished);
        assert_eq!(part.points.last().unwrap().negative_eigenvalues, 1, "unstable behind it");
    }
}

#[test]
fn a_path_ends_where_nothing_adheres_any_more() {
    let model = at(tape(), 45.0);
    let [part, whole] = [FollowedUntil::Detachment, FollowedUntil::End].map(|until| followed(&model, until));
    assert_same(&part.detachment.unwrap(), &whole.detachment.unwrap());
    let last = part.limit_points.iter().filter(|at| at.kind == LimitPointKind::Displacement).count();
    assert_eq!(last, whole.limit_points.iter().filter(|at| at.kind == LimitPointKind::Displacement).count());
    // a strip that hangs from its edge does not come off
    let hanging = followed(&paper_strip(100.0, 1.0).into(), FollowedUntil::Detachment);
    assert_eq!((hanging.end, hanging.detachment), (PathEnd::Pivoting, None));
}

/// With friction a path ends where it first jumps, whatever is asked for.
#[test]
fn a_path_that_ends_before_ends_as_it_does() {
    let strip = PeelModel::from(paper_strip(100.0, 1.0));
    let friction = Friction { strength: Some(0.05), ..Friction::default() };
    let model = at(PeelModel { friction, ..strip }, 30.0);
    let stop = StopCriteria { until: FollowedUntil::FirstJump, ..StopCriteria::default() };
    let found = peel(&model, &Accuracy::to(1e-3), &stop);
    assert_eq!(found.end, PathEnd::Snapped);
    assert!(found.snap_off.is_some());
}
