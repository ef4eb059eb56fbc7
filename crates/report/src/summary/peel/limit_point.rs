//! A limit point, as part of a summary.

use crate::grip_in_space::GripInSpace;
use crate::names::limit_point_kind_word;
use crate::number::Finite;
use peelkit::study;

/// Where the force or the displacement turns, with the bounds of the errors.
#[derive(Debug, serde::Serialize)]
pub(super) struct LimitPoint {
    kind: &'static str,
    #[serde(rename = "displacement_nm")]
    displacement: Finite,
    #[serde(rename = "force_nN")]
    force: Finite,
    #[serde(rename = "end_rotation_rad")]
    end_rotation: Finite,
    #[serde(rename = "work_aJ")]
    work: Finite,
    #[serde(rename = "error_nm")]
    displacement_error: Finite,
    #[serde(rename = "error_nN")]
    force_error: Finite,
    #[serde(rename = "error_aJ")]
    work_error: Option<Finite>,
    /// Of a load limit point around which the force is so level that its place cannot be determined and does not matter.
    flat: bool,
    /// Of a run in space
    #[serde(flatten)]
    in_space: Option<GripInSpace>,
}

impl From<&study::LimitPoint> for LimitPoint {
    fn from(at: &study::LimitPoint) -> Self {
        Self {
            kind: limit_point_kind_word(at.kind),
            displacement: Finite(at.displacement),
            force: Finite(at.force),
            end_rotation: Finite(at.end_rotation),
            work: Finite(at.work),
            displacement_error: Finite(at.displacement_error),
            force_error: Finite(at.force_error),
            work_error: at.work_error.map(Finite),
            flat: at.flat,
            in_space: at.in_space.map(GripInSpace::from),
        }
    }
}
