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
    /// `None` where no bound was found.
    #[serde(rename = "error_nm")]
    displacement_error: Option<Finite>,
    #[serde(rename = "error_nN")]
    force_error: Option<Finite>,
}

/// A bound that was found.
pub(super) fn known(error: f64) -> Option<Finite> {
    Some(error).filter(|error| error.is_finite()).map(Finite)
}

impl Place {
    fn new([displacement, force]: [f64; 2], [displacement_error, force_error]: [f64; 2]) -> Self {
        Self {
            displacement: Finite(displacement),
            force: Finite(force),
            displacement_error: known(displacement_error),
            force_error: known(force_error),
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
