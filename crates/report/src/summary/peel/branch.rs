//! The branch on which a strip leaves its plane, as part of a summary.

use super::limit_point::LimitPoint;
use super::place::Place;
use crate::names::{end_reason, end_word};
use crate::number::Finite;
use peelkit::study::{OutOfPlaneBranch, PathPoint};

/// What `--branch` adds.
#[derive(Debug, serde::Serialize)]
pub(super) struct BranchSummary {
    start: Start,
    peak: Option<LimitPoint>,
    first_jump: Option<LimitPoint>,
    limit_points: Vec<LimitPoint>,
    branch_points: usize,
    end: &'static str,
    reason: Option<String>,
    rejoins: Option<Place>,
    last: Option<Last>,
    accuracy_reached: Option<Finite>,
    points: usize,
    newton_iterations: usize,
    elements: usize,
    solve_s: Finite,
}

/// Where it leaves the planar path, and how.
#[derive(Debug, serde::Serialize)]
struct Start {
    #[serde(flatten)]
    place: Place,
    #[serde(rename = "slope_nN_per_nm")]
    slope: Finite,
    negative_eigenvalues: usize,
    negative_eigenvalues_load: usize,
}

/// The last point of the branch.
#[derive(Debug, serde::Serialize)]
struct Last {
    #[serde(rename = "displacement_nm")]
    displacement: Finite,
    #[serde(rename = "force_nN")]
    force: Finite,
    roll_deg: Finite,
    yaw_deg: Finite,
}

impl BranchSummary {
    pub fn new(branch: &OutOfPlaneBranch, solve_s: f64) -> Self {
        let peel = &branch.peel;
        let negative = |of: fn(&PathPoint) -> usize| peel.points.first().map_or(0, of);
        Self {
            start: Start {
                place: Place::from(&branch.loss),
                slope: Finite(branch.start.slope()),
                negative_eigenvalues: negative(|point| point.negative_eigenvalues),
                negative_eigenvalues_load: negative(|point| point.negative_eigenvalues_load),
            },
            peak: branch.peak().map(LimitPoint::from),
            first_jump: peel.snap_off.as_ref().map(LimitPoint::from),
            limit_points: peel.limit_points.iter().map(LimitPoint::from).collect(),
            branch_points: peel.branch_points.len(),
            end: end_word(&peel.end),
            reason: end_reason(&peel.end),
            rejoins: branch.rejoins.as_ref().map(Place::from),
            last: peel.points.last().map(Last::from),
            accuracy_reached: peel.reached_accuracy().map(Finite),
            points: peel.effort.points,
            newton_iterations: peel.effort.newton_iterations,
            elements: peel.effort.elements,
            solve_s: Finite(solve_s),
        }
    }
}

impl From<&PathPoint> for Last {
    fn from(at: &PathPoint) -> Self {
        let grip = at.in_space.unwrap_or_default();
        Self {
            displacement: Finite(at.displacement),
            force: Finite(at.force),
            roll_deg: Finite(grip.roll.to_degrees()),
            yaw_deg: Finite(grip.yaw.to_degrees()),
        }
    }
}
