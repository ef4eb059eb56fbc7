//! What the grip of a beam in space exerts, and its sections as they lie.

use super::chain::read::normalise;
use super::chain::spatial_chain::quaternion_of;
use super::end_rotation::{EndRotation, angles};
use super::rotation::{apply, cross, matrix};
use super::spatial_beam::SpatialBeam;
use crate::beam::grip_state::{ForcesInSpace, GripForces, GripState, PlaceInSpace};
use crate::solve::state::State;
use crate::solve::system::EndRoll;
use std::f64::consts::TAU;

/// What the grip exerts on the right end of a beam in space.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GripReactions {
    /// Along x, y and z, nN
    pub force: [f64; 3],
    /// What works on the end's rotation θ, yaw and roll, nN·nm; zeros of an end that turns freely
    pub moment: [f64; 3],
}

/// A section of a beam in space as it lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpatialSectionPlace {
    /// S, nm
    pub arc_length: f64,
    /// x, y, z of the axis, nm
    pub place: [f64; 3],
    /// d1 along the axis, d2 along the width, d3 along the height: x, y, z of each
    pub directors: [[f64; 3]; 3],
    /// b, nm
    pub width: f64,
    /// h, nm
    pub height: f64,
    /// Section forces along the directors, nN: axial, along the width, along the height
    pub force: [f64; 3],
    /// Section moments about the directors, nN·nm: torsion, about the width, about the height
    pub moment: [f64; 3],
}

/// An angle with as many whole turns more as bring it nearest to another one, rad.
fn nearest_turn(angle: f64, other: f64) -> f64 {
    angle + TAU * ((other - angle) / TAU).round()
}

impl SpatialBeam {
    /// What the grip exerts on the end of an equilibrium.
    pub fn grip_reactions(&self, at: &State) -> GripReactions {
        let end = self.chain.residual_of_right_end(self.configuration(at));
        GripReactions {
            force: apply(&self.chain.ends[1].axes, &[end[0], end[1], end[2]]),
            moment: [end[3], end[4], end[5]],
        }
    }

    /// θ, yaw and roll of the right end, rad. Where it turns freely, θ and roll are what the directors say, with as many whole turns as the
    /// state has counted.
    pub fn angles_of_grip(&self, at: &State) -> [f64; 3] {
        let (end, configuration) = (&self.chain.ends[1], self.configuration(at));
        let counted = configuration.angles[1];
        match end.rotation {
            EndRotation::Angles => counted,
            EndRotation::Free => {
                let [rotation, yaw, roll] = angles(quaternion_of(self.chain.end_node(configuration, 1)), end.rest);
                [nearest_turn(rotation, counted[0]), yaw, nearest_turn(roll, counted[2])]
            }
        }
    }

    /// Counts the turns of a right end that turns freely on, from those of the state before it was moved by less than half of one.
    pub(super) fn count_turns(&self, at: &mut State) {
        if self.chain.ends[1].rotation == EndRotation::Free {
            let (angles, from) = (self.angles_of_grip(at), at.values.len() - 3);
            at.values[from..].copy_from_slice(&angles);
        }
    }

    /// The roll of the right end with how it changes with the three turns there.
    pub(super) fn roll_of_grip(&self, at: &State) -> EndRoll {
        let end = &self.chain.ends[1];
        let by_turns = if end.rotation == EndRotation::Angles {
            [0.0, 0.0, 1.0]
        } else {
            let rest = matrix(end.rest);
            let r = matrix(quaternion_of(self.chain.end_node(self.configuration(at), 1)));
            // what lies along y and z at rest rises above the plane by sine and cosine of the roll, both times the cosine of the yaw
            let [(sin, by_sin), (cos, by_cos)] =
                [rest[1], rest[2]].map(|along| (apply(&r, &along)[2], cross(along, r[2])));
            let square = (sin * sin + cos * cos).max(f64::MIN_POSITIVE);
            std::array::from_fn(|k| (cos * by_sin[k] - sin * by_cos[k]) / square)
        };
        let gradient = std::array::from_fn(|slot| if slot < 3 { 0.0 } else { by_turns[slot - 3] });
        EndRoll { angle: self.angles_of_grip(at)[2], gradient }
    }

    /// A state whose right end is turned by angles, for this beam, whose right end turns freely.
    pub fn without_angles_of_grip(&self, mut at: State) -> State {
        let angles = at.values.len() - 3;
        at.values[angles..].fill(0.0);
        at
    }

    /// What the grip exerts along x, y and z, and on the end's angles.
    pub fn grip_forces(&self, at: &State) -> GripForces {
        let reactions = self.grip_reactions(at);
        let ([horizontal, vertical, lateral], [moment, yaw_moment, torque]) = (reactions.force, reactions.moment);
        GripForces { horizontal, vertical, moment, in_space: Some(ForcesInSpace { lateral, yaw_moment, torque }) }
    }

    /// The grip in an equilibrium, seen from an earlier one.
    pub fn grip_state(&self, at: &State, from: &State) -> GripState {
        let place = |state: &State| -> [f64; 3] {
            let node = self.chain.end_node(self.configuration(state), 1);
            [node[0], node[1], node[2]]
        };
        let (here, there, [rotation, yaw, roll]) = (place(at), place(from), self.angles_of_grip(at));
        GripState {
            x: Some(here[0] - there[0]),
            y: here[1] - there[1],
            rotation,
            in_space: Some(PlaceInSpace { z: here[2] - there[2], yaw, roll }),
            forces: self.grip_forces(at),
        }
    }

    /// The section at a share of an element, from 0 to 1.
    pub fn section_at(&self, at: &State, element: usize, share: f64) -> SpatialSectionPlace {
        let boundaries = &at.mesh.boundaries;
        let arc_length = boundaries[element] + share * (boundaries[element + 1] - boundaries[element]);
        let (value, slope) = self.chain.sample(self.configuration(at), element, 2.0 * share - 1.0);
        let [force, moment] = self.chain.density.section_forces(arc_length, &value, &slope);
        let mut node = value;
        normalise(&mut node);
        self.section_of(arc_length, &node, force, moment)
    }

    /// A section with these fields, forces along and moments about the directors.
    pub(super) fn section_of(
        &self,
        arc_length: f64,
        node: &[f64],
        force: [f64; 3],
        moment: [f64; 3],
    ) -> SpatialSectionPlace {
        let frame = matrix(quaternion_of(node));
        let station = self.chain.density.profile.at(arc_length);
        SpatialSectionPlace {
            arc_length,
            place: [node[0], node[1], node[2]],
            directors: std::array::from_fn(|d| std::array::from_fn(|i| frame[i][d])),
            width: station.width,
            height: station.height,
            force,
            moment,
        }
    }
}
