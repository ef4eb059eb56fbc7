//! Where other branches meet the path.

use crate::number::Finite;
use peelkit::study;

/// A branch point, located.
#[derive(Debug, serde::Serialize)]
pub struct BranchPoint {
    #[serde(rename = "displacement_nm")]
    displacement: Finite,
    #[serde(rename = "force_nN")]
    force: Finite,
    #[serde(rename = "error_nm")]
    displacement_error: Finite,
    #[serde(rename = "error_nN")]
    force_error: Finite,
    /// Before it and behind it.
    negative_eigenvalues: [usize; 2],
}

impl From<&study::BranchPoint> for BranchPoint {
    fn from(at: &study::BranchPoint) -> Self {
        Self {
            displacement: Finite(at.displacement),
            force: Finite(at.force),
            displacement_error: Finite(at.displacement_error),
            force_error: Finite(at.force_error),
            negative_eigenvalues: at.negative_eigenvalues,
        }
    }
}
