//! The beam in space as a [`DynamicSystem`]: masses and inertia of sections, lumped in its nodes; viscous strains at its Gauss points.
//!
//! Of a node with the velocity v of its place and the angular velocity Ω in the axes of its directors the forces of inertia are m dv/dt and
//! J dΩ/dt + Ω × JΩ, J = diag(J1, J2, J3). The unknowns of an end are others, with c for its angles: Ω = A dc/dt, where the columns of A are the axes
//! that these turn about, and those change as dA_k/dt = (Σ_{j<k} A_j dc_j/dt - Ω) × A_k.
//!
//! Source: J. C. Simo, L. Vu-Quoc, On the dynamics in space of rods undergoing large motions, Comput. Methods Appl. Mech. Eng. 66 (1988).

use super::chain::spatial_chain::{SpatialConfiguration, quaternion_of};
use super::end_rotation::{EndMap, EndRotation};
use super::rotation::{apply, cross, dot, matrix};
use super::section::kinematics::{SPATIAL_FIELDS, SPATIAL_UNKNOWNS};
use super::section::strain_memory::SpatialKnownStrains;
use super::spatial_beam::{ANGLES, SpatialBeam};
use crate::beam::viscosity::Viscosity;
use crate::solve::error::SolveError;
use crate::solve::state::{MONITORS, State};
use crate::solve::system::{CondensedSystem, System};
use crate::solve::time::dynamic_system::{DynamicSystem, MaterialRate, StepTerms, ViscousPower};
use crate::solve::workspace::Workspace;

const F: usize = SPATIAL_UNKNOWNS;
const N: usize = SPATIAL_FIELDS;

/// How a node moves: velocity of its place, angular velocity in the axes of its directors.
struct NodeRates {
    place: [f64; 3],
    turn: [f64; 3],
}

impl SpatialBeam {
    fn viscosity(&self) -> Viscosity {
        self.inertia.as_ref().map_or(Viscosity::Elastic, |inertia| inertia.viscosity)
    }

    /// A state as its chain sees it in a step in time.
    fn in_step<'a>(&self, at: &'a State, rate: &'a MaterialRate) -> SpatialConfiguration<'a> {
        let factor = self.viscosity().factor(rate.per_time);
        let known = SpatialKnownStrains { factor, strains: rate.known.as_chunks().0 };
        SpatialConfiguration { known: (!rate.known.is_empty()).then_some(known), ..self.configuration(at) }
    }

    /// Mass and the three moments of inertia of each node.
    fn nodal_inertia(&self, at: &State) -> Vec<[f64; 4]> {
        let (order, ends) = (self.chain.order(), &at.mesh.boundaries);
        let mut all = vec![[0.0; 4]; at.mesh.elements() * order + 1];
        let Some(inertia) = &self.inertia else { return all };
        for element in 0..at.mesh.elements() {
            let (from, length) = (ends[element], ends[element + 1] - ends[element]);
            for rank in 0..=order {
                let section = (inertia.section)(from + self.chain.node_fraction(rank) * length);
                let share = self.chain.node_weight(rank) * length;
                (0..4).for_each(|k| all[element * order + rank][k] += share * section[k]);
            }
        }
        all
    }

    /// The map of the end that a node is.
    fn end_of(&self, at: &State, node: usize) -> Option<(usize, EndMap)> {
        let last = (at.values.len() - ANGLES) / N - 1;
        let end = if node == 0 {
            0
        } else if node == last {
            1
        } else {
            return None;
        };
        Some((end, self.chain.end_map(self.configuration(at), end)))
    }

    /// How a node moves, of the rates of its unknowns.
    fn node_rates(&self, at: &State, node: usize, velocity: &[f64]) -> NodeRates {
        let own = &velocity[node * F..][..F];
        let rates = self.end_of(at, node).map_or_else(|| std::array::from_fn(|f| own[f]), |(_, map)| map.forward(own));
        NodeRates { place: [rates[0], rates[1], rates[2]], turn: [rates[3], rates[4], rates[5]] }
    }

    /// Momentum, and angular momentum about the origin, along and about x, y and z.
    pub fn momenta(&self, at: &State, velocity: &[f64]) -> [[f64; 3]; 2] {
        let mut sums = [[0.0; 3]; 2];
        for (node, [mass, moments @ ..]) in self.nodal_inertia(at).into_iter().enumerate() {
            let fields = &at.values[node * N..][..N];
            let rates = self.node_rates(at, node, velocity);
            let momentum = rates.place.map(|v| mass * v);
            let spin = apply(&matrix(quaternion_of(fields)), &std::array::from_fn(|k| moments[k] * rates.turn[k]));
            let about = cross([fields[0], fields[1], fields[2]], momentum);
            for k in 0..3 {
                sums[0][k] += momentum[k];
                sums[1][k] += about[k] + spin[k];
            }
        }
        sums
    }
}

/// J dΩ/dt + Ω × JΩ
fn turning(moments: [f64; 3], turn: [f64; 3], change: [f64; 3]) -> [f64; 3] {
    let gyroscopic = cross(turn, std::array::from_fn(|k| moments[k] * turn[k]));
    std::array::from_fn(|k| moments[k] * change[k] + gyroscopic[k])
}

/// dA/dt dc/dt of an end with angles.
pub(super) fn axes_change(map: &EndMap, rates: &[f64]) -> [f64; 3] {
    let axis = |k: usize| -> [f64; 3] { std::array::from_fn(|i| map.turn[i][k]) };
    let mut sum = [0.0; 3];
    for k in 0..3 {
        // Σ_{j<k} - Σ_j is less those from k on
        let mut behind = [0.0; 3];
        for j in k..3 {
            (0..3).for_each(|i| behind[i] -= axis(j)[i] * rates[j]);
        }
        let change = cross(behind, axis(k));
        (0..3).for_each(|i| sum[i] += change[i] * rates[k]);
    }
    sum
}

impl DynamicSystem for SpatialBeam {
    fn masses(&self, at: &State) -> Vec<f64> {
        let mut masses = Vec::with_capacity(at.values.len());
        for (node, [mass, moments @ ..]) in self.nodal_inertia(at).into_iter().enumerate() {
            masses.extend([mass; 3]);
            match self.end_of(at, node) {
                Some((_, map)) => {
                    let about = |k: usize| (0..3).map(|i| moments[i] * map.turn[i][k].powi(2)).sum::<f64>();
                    masses.extend((0..3).map(about));
                }
                None => masses.extend(moments),
            }
        }
        masses
    }

    fn inertia_forces(&self, at: &State, _: &[f64], velocity: &[f64], acceleration: &[f64]) -> Vec<f64> {
        let mut forces = Vec::with_capacity(velocity.len());
        for (node, [mass, moments @ ..]) in self.nodal_inertia(at).into_iter().enumerate() {
            let (v, a) = (&velocity[node * F..][..F], &acceleration[node * F..][..F]);
            let own = |v: [f64; F], a: [f64; F]| {
                let [x, y, z, turn @ ..] = a;
                let torque = turning(moments, [v[3], v[4], v[5]], turn);
                [mass * x, mass * y, mass * z, torque[0], torque[1], torque[2]]
            };
            match self.end_of(at, node) {
                Some((end, map)) => {
                    let mut change = map.forward(a);
                    if self.chain.ends[end].rotation == EndRotation::Angles {
                        let more = axes_change(&map, &v[3..]);
                        (0..3).for_each(|k| change[3 + k] += more[k]);
                    }
                    forces.extend(map.back(&own(map.forward(v), change)));
                }
                None => forces.extend(own(std::array::from_fn(|k| v[k]), std::array::from_fn(|k| a[k]))),
            }
        }
        forces
    }

    fn kinetic_energy(&self, at: &State, _: &[f64], velocity: &[f64]) -> f64 {
        let of = |(node, [mass, moments @ ..]): (usize, [f64; 4])| {
            let NodeRates { place, turn } = self.node_rates(at, node, velocity);
            0.5 * (mass * dot(place, place) + (0..3).map(|k| moments[k] * turn[k] * turn[k]).sum::<f64>())
        };
        self.nodal_inertia(at).into_iter().enumerate().map(of).sum()
    }

    fn stored_energy(&self, at: &State) -> f64 {
        self.chain.strains(self.configuration(at)).iter().map(|point| point.stored).sum()
    }

    fn factorise_step(&self, at: &State, terms: &StepTerms, ws: &mut Workspace) -> Result<CondensedSystem, SolveError> {
        self.condensed_with(at, self.in_step(at, terms.rate), terms.nodal, [0.0; MONITORS], ws)
    }

    fn relaxed_memory(&self, at: &State) -> Vec<f64> {
        if !self.viscosity().is_viscous() {
            return Vec::new();
        }
        self.chain.strains(self.configuration(at)).into_iter().flat_map(|point| point.strains).collect()
    }

    fn memory(&self, at: &State, rate: &MaterialRate) -> Vec<f64> {
        self.viscosity().remembered_by(&self.relaxed_memory(at), rate)
    }

    fn viscous_power(&self, at: &State, rate: &MaterialRate) -> ViscousPower {
        self.viscosity().power_in(rate, || {
            let still = vec![0.0; self.unknowns(at)];
            let configurations = [self.in_step(at, rate), self.configuration(at)];
            configurations.map(|configuration| self.chain.energy(configuration, &still).0.total)
        })
    }
}
