//! The tree of beams as a [`DynamicSystem`]: masses in its nodes, if it has any, viscous strains at its Gauss points.

use super::beam_tree::BeamTree;
use super::factors::TreeFactors;
use super::sweep::Added;
use crate::beam::spatial::shared_system::condensed;
use crate::solve::error::SolveError;
use crate::solve::observables::MONITORS;
use crate::solve::state::State;
use crate::solve::system::{CondensedSystem, NodalTerms, System, Workspace};
use crate::solve::time::dynamic_system::{DynamicSystem, MaterialRate, StepTerms, ViscousPower};

impl DynamicSystem for BeamTree {
    fn masses(&self, at: &State) -> Vec<f64> {
        if self.inertia.is_empty() { vec![0.0; self.unknowns(at)] } else { self.nodal_masses(&at.values) }
    }

    fn inertia_forces(&self, at: &State, _: &[f64], velocity: &[f64], acceleration: &[f64]) -> Vec<f64> {
        match self.inertia.is_empty() {
            true => vec![0.0; velocity.len()],
            false => self.forces_of_inertia(&at.values, velocity, acceleration),
        }
    }

    fn kinetic_energy(&self, at: &State, _: &[f64], velocity: &[f64]) -> f64 {
        self.energy_of_motion(&at.values, velocity)
    }

    fn stored_energy(&self, at: &State) -> f64 {
        self.strains(&at.values).iter().map(|point| point.stored).sum()
    }

    fn factorise_step(&self, at: &State, terms: &StepTerms, ws: &mut Workspace) -> Result<CondensedSystem, SolveError> {
        let tree = self.in_step(terms.rate);
        let nodal = if self.inertia.is_empty() { NodalTerms::NONE } else { terms.nodal };
        let added = Added { damping: [0.0; 2], nodal };
        let root = tree.eliminate_with(&at.values, [0.0; MONITORS], added, ws.factors::<TreeFactors>())?;
        Ok(condensed(&root.matrix, (root.negative, root.least_pivot), tree.evaluation(at, root.energy)))
    }

    fn relaxed_memory(&self, at: &State) -> Vec<f64> {
        if !self.viscosity.is_viscous() {
            return Vec::new();
        }
        self.strains(&at.values).into_iter().flat_map(|point| point.strains).collect()
    }

    fn memory(&self, at: &State, rate: &MaterialRate) -> Vec<f64> {
        self.viscosity.remembered_by(&self.relaxed_memory(at), rate)
    }

    fn viscous_power(&self, at: &State, rate: &MaterialRate) -> ViscousPower {
        self.viscosity.power_in(rate, || [self.in_step(rate).energy(&at.values), self.energy(&at.values)])
    }
}
