//! The grip of a planar beam.

use super::density::energy_density::SectionState;
use super::planar_beam::PlanarBeam;
use crate::beam::grip_state::{GripForces, GripState};
use crate::solve::state::State;
use crate::solve::system::System;

impl PlanarBeam {
    /// The grip in an equilibrium, seen from an earlier one.
    pub fn grip_state(&self, at: &State, from: &State) -> GripState {
        let (here, there) = (self.interface_values(at), self.interface_values(from));
        let moved = |slot: usize| here[slot] - there[slot];
        GripState {
            x: self.slot_of_x().map(moved),
            y: moved(self.slot_of_height()),
            rotation: here[self.slot_of_rotation()],
            in_space: None,
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
        GripForces { horizontal, vertical, moment, in_space: None }
    }
}
