//! Where the grip of a planar beam is, and what it exerts on the right end.

use super::{PlanarBeam, SectionState};
use crate::solve::{State, System};
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
    /// What the grip exerts on the beam
    pub forces: GripForces,
}

impl PlanarBeam {
    /// The grip in an equilibrium, seen from an earlier one.
    pub fn grip_state(&self, at: &State, from: &State) -> GripState {
        let (here, there) = (self.interface_values(at), self.interface_values(from));
        let moved = |slot: usize| here[slot] - there[slot];
        GripState {
            x: self.slot_of_x().map(moved),
            y: moved(self.slot_of_height()),
            rotation: here[self.slot_of_rotation()],
            forces: self.grip_forces(at),
        }
    }

    /// An equilibrium of the same beam with x at every node, `of`, as one of this beam, which has condensed that.
    pub fn without_x(&self, at: &State, of: &Self) -> State {
        let mut values: Vec<f64> = at.values.chunks_exact(of.fields()).flat_map(|node| &node[1..]).copied().collect();
        if self.chain.has_border() {
            let x = |node: usize| at.values[node * of.fields()];
            let last = at.values.len() / of.fields() - 1;
            values.extend([of.grip_forces(at).horizontal, x(last) - x(0) - self.span()]);
        }
        State { values, ..at.clone() }
    }

    /// What the grip exerts on the end of an equilibrium.
    pub fn grip_forces(&self, at: &State) -> GripForces {
        let last = at.mesh.elements() - 1;
        let section = self.chain.node_states(self.configuration(at), last..last + 1)[1].section;
        let SectionState { horizontal_force: horizontal, vertical_force: vertical, moment, .. } = section;
        GripForces { horizontal, vertical, moment }
    }
}
