//! The same tree with something else done to its joints: beams, mesh and states stay as they are.

use super::beam_tree::BeamTree;
use super::branching_beam::JointUnknown;
use super::end_energy::EndEnergy;
use crate::beam::spatial::rotation::Matrix3;
use crate::solve::MONITORS;
use std::sync::Arc;

impl BeamTree {
    /// With other energies at joints that have a condition; of a joint without one nothing changes.
    pub fn with_energies(&self, energies: impl IntoIterator<Item = (usize, Option<Arc<dyn EndEnergy>>)>) -> Self {
        let mut tree = self.clone();
        for (joint, energy) in energies {
            if let Some(end) = self.end_of[joint] {
                tree.ends[end].energy = energy;
            }
        }
        tree
    }

    /// With the place of the root counted along other axes, which are the columns, of length one and at right angles.
    pub fn with_root_axes(&self, axes: Matrix3) -> Self {
        let mut tree = self.clone();
        tree.ends[0].own.axes = axes;
        tree
    }

    /// With other monitors; the last three unknowns of a joint are there with angles alone.
    pub fn with_monitors(&self, monitors: [Option<JointUnknown>; MONITORS]) -> Self {
        Self { monitors, ..self.clone() }
    }
}
