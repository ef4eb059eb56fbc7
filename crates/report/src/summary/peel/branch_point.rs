//! Where other branches meet the path.

use super::place::Place;
use peelkit::study;

/// A branch point, located.
#[derive(Debug, serde::Serialize)]
pub struct BranchPoint {
    #[serde(flatten)]
    place: Place,
    /// Before it and behind it.
    negative_eigenvalues: [usize; 2],
}

impl From<&study::BranchPoint> for BranchPoint {
    fn from(at: &study::BranchPoint) -> Self {
        Self { place: Place::from(at), negative_eigenvalues: at.negative_eigenvalues }
    }
}
