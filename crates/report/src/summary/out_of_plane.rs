//! The stability of the path against leaving its plane, as part of a summary.

use crate::number::Finite;
use peelkit::study::{OutOfPlane, OutOfPlaneLoss};

/// What `--out-of-plane` adds.
#[derive(Debug, serde::Serialize)]
pub(super) struct OutOfPlaneSummary {
    first_loss: Option<Loss>,
    unstable_points: usize,
    most_negative_eigenvalues: usize,
    solve_s: Finite,
}

#[derive(Debug, serde::Serialize)]
struct Loss {
    #[serde(rename = "displacement_nm")]
    displacement: Finite,
    #[serde(rename = "force_nN")]
    force: Finite,
    #[serde(rename = "error_nm")]
    displacement_error: Finite,
    #[serde(rename = "error_nN")]
    force_error: Finite,
    at_start: bool,
}

impl OutOfPlaneSummary {
    pub fn new(stability: &OutOfPlane, solve_s: f64) -> Self {
        Self {
            first_loss: stability.first_loss.map(Loss::from),
            unstable_points: stability.unstable_points(),
            most_negative_eigenvalues: stability.most(),
            solve_s: Finite(solve_s),
        }
    }
}

impl From<OutOfPlaneLoss> for Loss {
    fn from(at: OutOfPlaneLoss) -> Self {
        Self {
            displacement: Finite(at.displacement),
            force: Finite(at.force),
            displacement_error: Finite(at.displacement_error),
            force_error: Finite(at.force_error),
            at_start: at.after.is_none(),
        }
    }
}
