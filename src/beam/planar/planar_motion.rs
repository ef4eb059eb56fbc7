//! The planar beam as a [`DynamicSystem`]: masses at its nodes, viscous strains at its Gauss points.

use super::chain::{Configuration, KnownStrains};
use super::planar_beam::PlanarBeam;
use crate::beam::viscosity::Viscosity;
use crate::number::gauss::gauss_legendre;
use crate::solve::error::SolveError;
use crate::solve::state::{MONITORS, State};
use crate::solve::system::CondensedSystem;
use crate::solve::time::dynamic_system::{DynamicSystem, MaterialRate, StepTerms, ViscousPower};
use crate::solve::workspace::Workspace;
use std::num::NonZeroUsize;

/// Γ1, Γ2 and θ' at a point, and what is stored there.
struct StrainAt {
    strains: [f64; 3],
    stored: f64,
    /// Reference length that the point stands for, nm
    weight: f64,
}

impl PlanarBeam {
    fn viscosity(&self) -> Viscosity {
        self.inertia.as_ref().map_or(Viscosity::Elastic, |inertia| inertia.viscosity)
    }

    /// A state as its chain sees it in a step in time.
    fn in_step<'a>(&self, at: &'a State, rate: &'a MaterialRate) -> Configuration<'a> {
        let factor = self.viscosity().factor(rate.per_time);
        let known = KnownStrains { factor, strains: rate.known.as_chunks::<3>().0 };
        let strains = (!rate.known.is_empty()).then_some(known);
        Configuration { strains, ..self.configuration(at) }
    }

    /// Strains at all Gauss points, element by element.
    fn strains(&self, at: &State) -> Vec<StrainAt> {
        let (configuration, ends) = (self.configuration(at), &at.mesh.boundaries);
        let points = NonZeroUsize::new(self.chain.order()).map_or_else(Vec::new, gauss_legendre);
        let mut all = Vec::with_capacity(points.len() * at.mesh.elements());
        for element in 0..at.mesh.elements() {
            for &(local, weight) in &points {
                let (fields, section) = self.chain.sample(configuration, element, local);
                let (sin, cos) = fields[self.rotation].sin_cos();
                let (dx, dy) = (section.horizontal_slope, section.vertical_slope);
                all.push(StrainAt {
                    strains: [dx * cos + dy * sin - 1.0, dy * cos - dx * sin, section.curvature],
                    stored: section.stored,
                    weight: 0.5 * weight * (ends[element + 1] - ends[element]),
                });
            }
        }
        all
    }
}

impl DynamicSystem for PlanarBeam {
    fn masses(&self, at: &State) -> Vec<f64> {
        let (fields, order, ends) = (self.fields(), self.chain.order(), &at.mesh.boundaries);
        let mut masses = vec![0.0; at.values.len()];
        let Some(inertia) = &self.inertia else { return masses };
        for element in 0..at.mesh.elements() {
            let (from, length) = (ends[element], ends[element + 1] - ends[element]);
            for rank in 0..=order {
                let [mass, rotary] = (inertia.section)(from + self.chain.node_fraction(rank) * length);
                let share = self.chain.node_weight(rank) * length;
                for f in 0..fields {
                    let own = if f == self.rotation { rotary } else { mass };
                    masses[(element * order + rank) * fields + f] += own * share;
                }
            }
        }
        masses
    }

    fn stored_energy(&self, at: &State) -> f64 {
        self.strains(at).iter().map(|point| point.weight * point.stored).sum()
    }

    fn factorise_step(&self, at: &State, terms: &StepTerms, ws: &mut Workspace) -> Result<CondensedSystem, SolveError> {
        self.condensed(at, self.in_step(at, terms.rate), terms.nodal, [0.0; MONITORS], ws)
    }

    fn relaxed_memory(&self, at: &State) -> Vec<f64> {
        if !self.viscosity().is_viscous() {
            return Vec::new();
        }
        self.strains(at).into_iter().flat_map(|point| point.strains).collect()
    }

    fn memory(&self, at: &State, rate: &MaterialRate) -> Vec<f64> {
        self.viscosity().remembered_by(&self.relaxed_memory(at), rate)
    }

    fn viscous_power(&self, at: &State, rate: &MaterialRate) -> ViscousPower {
        self.viscosity().power_in(rate, || {
            let configurations = [self.in_step(at, rate), self.configuration(at)];
            configurations.map(|configuration| self.chain.energy(configuration, self.nodes(&at.values)).0.total)
        })
    }
}
