//! The stability of the path against leaving its plane, as part of a summary.

use super::branch::BranchSummary;
use super::place::Place;
use crate::number::Finite;
use peelkit::study::{OutOfPlane, OutOfPlaneBranch, OutOfPlaneLoss};

/// What `--out-of-plane` adds.
#[derive(Debug, serde::Serialize)]
pub(super) struct OutOfPlaneSummary {
    first_loss: Option<Loss>,
    unstable_points: usize,
    most_negative_eigenvalues: usize,
    solve_s: Finite,
    /// Where it was asked for: the branch that begins at the first loss, if there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    branch: Option<Option<BranchSummary>>,
}

#[derive(Debug, serde::Serialize)]
struct Loss {
    #[serde(flatten)]
    place: Place,
    at_start: bool,
}

impl OutOfPlaneSummary {
    pub fn new(stability: &OutOfPlane, solve_s: f64) -> Self {
        Self {
            first_loss: stability.first_loss.map(Loss::from),
            unstable_points: stability.unstable_points(),
            most_negative_eigenvalues: stability.most(),
            solve_s: Finite(solve_s),
            branch: None,
        }
    }

    /// The same with the branch, which took so many seconds.
    pub fn with_branch(self, branch: Option<&OutOfPlaneBranch>, solve_s: f64) -> Self {
        Self { branch: Some(branch.map(|branch| BranchSummary::new(branch, solve_s))), ..self }
    }
}

impl From<OutOfPlaneLoss> for Loss {
    fn from(at: OutOfPlaneLoss) -> Self {
        Self { place: Place::from(&at), at_start: at.after.is_none() }
    }
}
