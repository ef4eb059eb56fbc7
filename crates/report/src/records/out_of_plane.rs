//! The stability of a path against leaving its plane, and the branch that leaves it, as objects of summary.json.

use super::located::Place;
use crate::writing::names::{end_reason, end_word};
use crate::writing::record::{Fields, Record};
use peelkit::study::{OutOfPlane, OutOfPlaneBranch, OutOfPlaneLoss, PathPoint};

/// What `--out-of-plane` and `--branch` add.
#[derive(Clone, Copy, Debug)]
pub(super) struct OutOfPlaneFound<'a> {
    pub stability: &'a OutOfPlane,
    pub solve_s: f64,
    /// Where it was asked for: the branch that begins at the first loss, if there is one
    pub branch: Option<Option<BranchFound<'a>>>,
}

/// The branch, which took so many seconds.
#[derive(Clone, Copy, Debug)]
pub(super) struct BranchFound<'a> {
    pub branch: &'a OutOfPlaneBranch,
    pub solve_s: f64,
}

impl Record for OutOfPlaneFound<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("first_loss", "where it is lost first: from there on the path is not that of a beam that is free to leave the plane; null where all of the path is stable", |found| found.stability.first_loss);
        of.field("unstable_points", "how many points of the path are unstable out of the plane", |found| found.stability.unstable_points());
        of.field("most_negative_eigenvalues", "the most unstable directions out of the plane of a point", |found| found.stability.most());
        of.field("solve_s", "time of this analysis, without the path", |found| found.solve_s);
        of.sometimes("branch", "with `--branch`: the branch that leaves the plane at the first loss, followed in space; null where there is no loss", |found| found.branch);
    }
}

impl Record for OutOfPlaneLoss {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.part(Place::from);
        of.field("at_start", "whether the path is unstable from its beginning on, the place given", |at| at.after.is_none());
    }
}

impl Record for BranchFound<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.group("start", "where it leaves the planar path: the first loss", |of| {
            of.part(|found| Place::from(&found.branch.loss));
            of.field("slope_nN_per_nm", "dP/du with which it leaves; without a bound", |found| found.branch.start.slope());
            of.field("negative_eigenvalues", "number of unstable directions in space at its first point under displacement control; 0: stable", |found| found.first(|at| at.negative_eigenvalues));
            of.field("negative_eigenvalues_load", "the same under force control", |found| found.first(|at| at.negative_eigenvalues_load));
        });
        of.field("peak", "the largest force of the branch up to its first jump, where that is a load limit point, else null: a branch whose force falls from its start on has none", |found| found.branch.peak());
        of.field("first_jump", "its first displacement limit point, else null", |found| found.branch.peel.snap_off);
        of.field("limit_points", "all limit points of the branch, in its order", |found| found.branch.peel.limit_points.as_slice());
        of.field("branch_points", "how many further branches meet this one, where its inertia changes without a limit point; it goes on along itself", |found| found.branch.peel.branch_points.len());
        of.field("end", "how it ends: as `end`, or `back-in-plane`", |found| end_word(&found.branch.peel.end));
        of.field("reason", "as `reason`", |found| end_reason(&found.branch.peel.end));
        of.field("rejoins", "where it ends on the planar path, which regains its stability there, with the end `back-in-plane`; else null", |found| found.branch.rejoins.as_ref().map(Place::from));
        of.field("last", "its last point", |found| found.branch.peel.points.last().map(LastPoint));
        of.field("accuracy_reached", "largest relative bound of the limit points of the branch; null where it has none", |found| found.branch.peel.reached_accuracy());
        of.field("points", "its points, on the final mesh", |found| found.branch.peel.effort.points);
        of.field("newton_iterations", "Newton iterations, on all meshes", |found| found.branch.peel.effort.newton_iterations);
        of.field("elements", "elements of the final mesh", |found| found.branch.peel.effort.elements);
        of.field("solve_s", "time of the branch", |found| found.solve_s);
    }
}

impl BranchFound<'_> {
    /// A count of its first point.
    fn first(&self, count: fn(&PathPoint) -> usize) -> usize {
        self.branch.peel.points.first().map_or(0, count)
    }
}

/// The last point of the branch.
struct LastPoint<'a>(&'a PathPoint);

impl Record for LastPoint<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("displacement_nm", "u there", |at| at.0.displacement);
        of.field("force_nN", "P there", |at| at.0.force);
        of.field("roll_deg", "roll of the grip there", |at| at.0.in_space.unwrap_or_default().roll.to_degrees());
        of.field("yaw_deg", "yaw of the grip there", |at| at.0.in_space.unwrap_or_default().yaw.to_degrees());
    }
}
