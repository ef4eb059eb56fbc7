//! Where the grip of a beam is, and what it exerts on the right end.

use serde::{Deserialize, Serialize};

/// What the grip exerts on the right end.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct GripForces {
    /// H along the substrate, away from the beam, nN
    pub horizontal: f64,
    /// V away from the substrate, nN
    pub vertical: f64,
    /// M, nN·nm, positive where it turns the end anticlockwise
    pub moment: f64,
    /// What it exerts out of the plane; none of a beam in the plane
    #[serde(default)]
    pub in_space: Option<ForcesInSpace>,
}

/// What the grip of a beam in space exerts beside what one in the plane does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ForcesInSpace {
    /// Sideways, along z, nN
    pub lateral: f64,
    /// On the yaw, nN·nm
    pub yaw_moment: f64,
    /// On the roll, nN·nm
    pub torque: f64,
}

/// Where the grip is, and what it exerts.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct GripState {
    /// How far it has come along the substrate, nm; none where it is free there and nothing looks at it
    pub x: Option<f64>,
    /// How far away from the substrate, nm
    pub y: f64,
    /// θ(L), rad
    pub rotation: f64,
    /// Where it is out of the plane; none of a beam in the plane
    #[serde(default)]
    pub in_space: Option<PlaceInSpace>,
    /// What the grip exerts on the beam
    pub forces: GripForces,
}

/// Where the grip of a beam in space is beside where one in the plane is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PlaceInSpace {
    /// How far it has come sideways, along z, nm
    pub z: f64,
    /// ψ, rad
    pub yaw: f64,
    /// ρ, rad
    pub roll: f64,
}

/// Where the equilibria of a step have lost their stability and the beam has jumped, with the grip where it was.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct StepJump {
    /// Number of the step, from 1; that of letting go before the pull is the last one's
    pub step: usize,
    /// Where stability was lost
    pub before: GripState,
    /// Where the beam has come to rest
    pub after: GripState,
    /// Energy that it released, aJ
    pub released: f64,
}

/// The grip in the steps before a pull, seen from where it took hold.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StepsTaken {
    /// Behind each step that came to its end
    pub ends: Vec<GripState>,
    /// At the equilibria of each step, from where it begins; those of a step that has no end as far as they go.
    pub ways: Vec<Vec<GripState>>,
    /// Jumps on the way
    pub jumps: Vec<StepJump>,
}
