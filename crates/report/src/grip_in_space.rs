//! The grip of a strip in space, as columns and as keys.

use crate::number::Finite;
use peelkit::model::SpatialGrip;
use serde::Serialize;

/// What a point of a path in space has besides one in the plane. Units stand in the names.
#[derive(Debug, Default, Serialize)]
pub(crate) struct GripInSpace {
    #[serde(rename = "torque_nN_nm")]
    torque: Finite,
    roll_deg: Finite,
    yaw_deg: Finite,
    #[serde(rename = "reaction_across_nN")]
    across: Finite,
    #[serde(rename = "reaction_lateral_nN")]
    lateral: Finite,
}

impl From<SpatialGrip> for GripInSpace {
    fn from(grip: SpatialGrip) -> Self {
        Self {
            torque: Finite(grip.torque),
            roll_deg: Finite(grip.roll.to_degrees()),
            yaw_deg: Finite(grip.yaw.to_degrees()),
            across: Finite(grip.across),
            lateral: Finite(grip.lateral),
        }
    }
}
