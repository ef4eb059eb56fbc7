//! The planar beam as a [`DynamicSystem`]: masses at its nodes, viscous strains at its Gauss points.

use super::chain::{Configuration, KnownStrains};
use super::planar_beam::{FaceDistance, PlanarBeam};
use crate::beam::viscosity::Viscosity;
use crate::number::gauss::gauss_legendre;
use crate::solve::error::SolveError;
use crate::solve::state::{MONITORS, State};
use crate::solve::system::CondensedSystem;
use crate::solve::time::dynamic_system::{DynamicSystem, MaterialRate, StepTerms, ViscousPower};
use crate::solve::workspace::Workspace;
use std::num::NonZeroUsize;

/// Γ1, Γ2, θ' and the distance of the face at a point, and what is stored there.
struct StrainAt {
    strains: [f64; 4],
    stored: f64,
    /// Reference length that the point stands for, nm
    weight: f64,
}

impl PlanarBeam {
    fn viscosity(&self) -> Viscosity {
        self.inertia.as_ref().map_or(Viscosity::Elastic, |inertia| inertia.viscosity)
    }

    /// As [`BeamInertia::distance`].
    fn face_distance(&self) -> Option<&FaceDistance> {
        self.inertia.as_ref()?.distance.as_ref()
    }

    /// A state as its chain sees it in a step in time.
    fn in_step<'a>(&self, at: &'a State, rate: &'a MaterialRate) -> Configuration<'a> {
        self.in_step_with(self.viscosity().factor(rate.per_time), at, rate)
    }

    /// The same with another factor of its stiffness.
    fn in_step_with<'a>(&self, factor: f64, at: &'a State, rate: &'a MaterialRate) -> Configuration<'a> {
        let per_time = rate.per_time;
        let known = KnownStrains { factor, per_time, strains: rate.known.as_chunks::<4>().0 };
        let strains = (!rate.known.is_empty()).then_some(known);
        Configuration { strains, ..self.configuration(at) }
    }

    /// Strains at all Gauss points, element by element.
    fn strains(&self, at: &State) -> Vec<StrainAt> {
        let (configuration, ends) = (self.configuration(at), &at.mesh.boundaries);
        let distance = self.face_distance();
        let points = NonZeroUsize::new(self.chain.order()).map_or_else(Vec::new, gauss_legendre);
        let mut all = Vec::with_capacity(points.len() * at.mesh.elements());
        for element in 0..at.mesh.elements() {
            for &(local, weight) in &points {
                let (fields, section) = self.chain.sample(configuration, element, local);
                let (sin, cos) = fields[self.rotation].sin_cos();
                let (dx, dy) = (section.horizontal_slope, section.vertical_slope);
                let place = ends[element] + 0.5 * (1.0 + local) * (ends[element + 1] - ends[element]);
                let face = distance.map_or(0.0, |of| of(place, [fields[self.rotation - 1], fields[self.rotation]]));
                all.push(StrainAt {
                    strains: [dx * cos + dy * sin - 1.0, dy * cos - dx * sin, section.curvature, face],
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
        if !self.viscosity().is_viscous() && self.face_distance().is_none() {
            return Vec::new();
        }
        self.strains(at).into_iter().flat_map(|point| point.strains).collect()
    }

    fn memory(&self, at: &State, rate: &MaterialRate) -> Vec<f64> {
        let now = self.relaxed_memory(at);
        let mut memory = self.viscosity().remembered_by(&now, rate);
        // whatever the material, the face is remembered where it is
        memory.chunks_exact_mut(4).zip(now.chunks_exact(4)).for_each(|(memory, now)| memory[3] = now[3]);
        memory
    }

    fn viscous_power(&self, at: &State, rate: &MaterialRate) -> ViscousPower {
        let energy = |configuration| self.chain.energy(configuration, self.nodes(&at.values)).0.total;
        let without_material = || energy(self.in_step_with(0.0, at, rate));
        let material = self.viscosity().power_in(rate, || [energy(self.in_step(at, rate)), without_material()]);
        // what the adhesive adds to the energy of a step is its power over c
        let adhesive = self.face_distance().map_or(0.0, |_| without_material() - energy(self.configuration(at)));
        ViscousPower { dissipated: material.dissipated + rate.per_time * adhesive, ..material }
    }
}
