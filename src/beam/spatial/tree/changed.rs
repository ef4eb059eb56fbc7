//! The same tree with something else done to its joints: beams, mesh and states stay as they are.

use super::beam_tree::{BeamTree, RememberedStrains};
use super::branching_beam::JointUnknown;
use super::end_energy::EndEnergy;
use crate::beam::spatial::rotation::Matrix3;
use crate::beam::viscosity::Viscosity;
use crate::solve::observables::MONITORS;
use crate::solve::time::dynamic_system::MaterialRate;
use std::sync::Arc;

impl BeamTree {
    /// With other energies at joints that have a condition; of a joint without one nothing changes.
    pub fn with_energies(&self, energies: impl IntoIterator<Item = (usize, Option<Arc<dyn EndEnergy>>)>) -> Self {
        let mut tree = self.clone();
        let ends = Arc::make_mut(&mut tree.ends);
        for (joint, energy) in energies {
            if let Some(end) = self.end_of[joint] {
                ends[end].energy = energy;
            }
        }
        tree
    }

    /// With the place of the root counted along other axes, which are the columns, of length one and at right angles.
    pub fn with_root_axes(&self, axes: Matrix3) -> Self {
        let mut tree = self.clone();
        Arc::make_mut(&mut tree.ends)[0].own.axes = axes;
        tree
    }

    /// Of a material that flows in this way, in all its branches.
    pub fn with_viscosity(&self, viscosity: Viscosity) -> Self {
        Self { viscosity, ..self.clone() }
    }

    /// As it is in a step in time with this rule: elastic, with the energy of the step.
    pub(super) fn in_step(&self, rate: &MaterialRate) -> Self {
        let factor = self.viscosity.factor(rate.per_time);
        let remembered = RememberedStrains { factor, strains: Arc::clone(&rate.known) };
        Self { remembered: (!rate.known.is_empty()).then_some(remembered), ..self.clone() }
    }

    /// As it answers a jump, within which what it remembers stays the same: with the stiffness of fast loading. None where a dashpot stands beside
    /// every spring: such a material does not jump.
    pub fn in_jump(&self, memory: &[f64]) -> Option<Self> {
        let factor = match self.viscosity {
            Viscosity::Elastic => return Some(self.clone()),
            Viscosity::KelvinVoigt { .. } => return None,
            Viscosity::StandardLinearSolid { stiffness_ratio, .. } => stiffness_ratio - 1.0,
        };
        let remembered = Some(RememberedStrains { factor, strains: memory.into() });
        Some(Self { remembered, viscosity: Viscosity::Elastic, ..self.clone() })
    }

    /// With other monitors; the last three unknowns of a joint are there with angles alone.
    pub fn with_monitors(&self, monitors: [Option<JointUnknown>; MONITORS]) -> Self {
        Self { monitors, ..self.clone() }
    }
}
