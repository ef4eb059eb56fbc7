//! The tree of beams as a [`DynamicSystem`]: viscous strains at its Gauss points. Its mass does not count.

use super::beam_tree::BeamTree;
use crate::solve::time::{DynamicSystem, MaterialRate, StepTerms, ViscousPower};
use crate::solve::{Coefficients, CondensedSystem, MONITORS, SolveError, State, System, Workspace};

impl DynamicSystem for BeamTree {
    /// Zeros.
    fn masses(&self, at: &State) -> Vec<f64> {
        vec![0.0; self.unknowns(at)]
    }

    fn stored_energy(&self, at: &State) -> f64 {
        self.strains(&at.values).iter().map(|point| point.stored).sum()
    }

    fn factorise_step(&self, at: &State, terms: &StepTerms, ws: &mut Workspace) -> Result<CondensedSystem, SolveError> {
        self.in_step(terms.rate).factorise(at, Coefficients::STATIC, [0.0; MONITORS], ws)
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
