//! A located place of a path.

use crate::number::Finite;
use peelkit::study::{BranchPoint, JumpEnd, OutOfPlaneLoss};

/// Displacement and force, with the bounds of their errors.
#[derive(Debug, serde::Serialize)]
pub(super) struct Place {
    #[serde(rename = "displacement_nm")]
    displacement: Finite,
    #[serde(rename = "force_nN")]
    force: Finite,
    #[serde(rename = "error_nm")]
    displacement_error: Finite,
    #[serde(rename = "error_nN")]
    force_error: Finite,
}

impl Place {
    fn new([displacement, force]: [f64; 2], [displacement_error, force_error]: [f64; 2]) -> Self {
        Self {
            displacement: Finite(displacement),
            force: Finite(force),
            displacement_error: Finite(displacement_error),
            force_error: Finite(force_error),
        }
    }
}

impl From<&OutOfPlaneLoss> for Place {
    fn from(at: &OutOfPlaneLoss) -> Self {
        Self::new([at.displacement, at.force], [at.displacement_error, at.force_error])
    }
}

impl From<&BranchPoint> for Place {
    fn from(at: &BranchPoint) -> Self {
        Self::new([at.displacement, at.force], [at.displacement_error, at.force_error])
    }
}

impl From<&JumpEnd> for Place {
    fn from(at: &JumpEnd) -> Self {
        Self::new([at.displacement, at.force], [at.displacement_error, at.force_error])
    }
}
