//! The grip of a strip in space, beside what it does in the plane.

use super::beam_problem::{ACROSS, BeamProblem, ROLL, SIDEWAYS};
use crate::beam::spatial::rotation::apply_transposed;
use crate::solve::state::State;
use serde::{Deserialize, Serialize};

/// How the right end of a strip in space is turned, beside its rotation in the plane, and what the grip exerts, beside
/// the force along the pull. A reaction is exactly zero where the grip does not hold what it works on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SpatialGrip {
    /// ρ about the axis, rad: of the directors Rz(θ) Ry(ψ) Rx(ρ)
    pub roll: f64,
    /// ψ, rad
    pub yaw: f64,
    /// Moment on the roll, nN·nm
    pub torque: f64,
    /// Force across the pull in its vertical plane, nN: along (sin α cos β, -cos α, sin α sin β) for the elevation α and
    /// the azimuth β
    pub across: f64,
    /// Force normal to the vertical plane of the pull, nN: along (-sin β, 0, cos β)
    pub lateral: f64,
}

impl BeamProblem {
    /// The same strip in space in a grip that holds its end at this roll, rad, or lets it roll.
    pub fn with_roll(&self, roll: Option<f64>) -> Self {
        let mut grip = self.grip;
        grip.held[ROLL] = roll.is_some();
        grip.origin[ROLL] = roll.unwrap_or(0.0);
        self.with_grip(grip)
    }

    /// The grip at an equilibrium of a strip in space; none of one in the plane.
    pub fn spatial_grip(&self, at: &State) -> Option<SpatialGrip> {
        let beam = self.beam.spatial()?;
        let [_, yaw, roll] = beam.angles_of_grip(at);
        let reactions = beam.grip_reactions(at);
        let along = apply_transposed(&beam.chain.ends[1].axes, &reactions.force);
        let held = |slot: usize, value: f64| if self.grip.held[slot] { value } else { 0.0 };
        Some(SpatialGrip {
            roll,
            yaw,
            torque: held(ROLL, reactions.moment[2]),
            across: held(ACROSS, along[ACROSS]),
            lateral: held(SIDEWAYS, along[SIDEWAYS]),
        })
    }
}
