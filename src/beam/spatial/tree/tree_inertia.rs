//! Mass of a tree: of its sections, lumped in its nodes by the Gauss-Lobatto rule of each element.
//!
//! Of a joint all branches that meet there have a part. Their directors differ from those of the joint by R(a), so that its moments of inertia are a
//! full matrix in the axes of the joint, Σ R(a) J Rᵀ(a). Forces of inertia are m dv/dt and J dΩ/dt + Ω × JΩ; of a joint with angles as at the end of a
//! chain.
//!
//! With these masses, if it has any, and viscous strains at its Gauss points the tree is a [`DynamicSystem`].

use super::beam_tree::{BeamTree, NodeInertia, NodeRates};
use super::sweep::Added;
use crate::beam::spatial::chain::room::SpatialFactors;
use crate::beam::spatial::chain::spatial_chain::quaternion_of;
use crate::beam::spatial::end_rotation::{EndMap, EndRotation};
use crate::beam::spatial::rotation::{Matrix3, apply, cross, dot, matrix};
use crate::beam::spatial::section::kinematics::{SPATIAL_FIELDS, SPATIAL_UNKNOWNS};
use crate::beam::spatial::spatial_motion::axes_change;
use crate::solve::error::SolveError;
use crate::solve::frontal::end_block::Carry;
use crate::solve::frontal::nodes::slot;
use crate::solve::state::{MONITORS, State};
use crate::solve::system::{CondensedSystem, NodalTerms, System};
use crate::solve::time::dynamic_system::{DynamicSystem, MaterialRate, StepTerms, ViscousPower};
use crate::solve::workspace::Workspace;

const F: usize = SPATIAL_UNKNOWNS;
const N: usize = SPATIAL_FIELDS;

impl BeamTree {
    /// With a mass: of a branch, by its number, ρA, ρJ1 about the axis, ρJ2 about the width and ρJ3 about the height.
    pub fn with_inertia(&self, section: impl Fn(usize) -> [f64; 4]) -> Self {
        let mut nodes = vec![NodeInertia::default(); self.nodes];
        let (order, mesh) = (self.order(), self.mesh_at_rest());
        for (b, branch) in self.branches.iter().enumerate() {
            let ([mass, moments @ ..], ends) = (section(b), branch.ends(&mesh));
            for e in 0..branch.elements {
                let length = ends[e + 1] - ends[e];
                for rank in 0..=order {
                    let share = self.basis.lobatto_weight(slot(order + 1, rank)) * length;
                    let offset = branch.end_at(order, e, rank).and_then(|end| branch.offsets[end]);
                    let axes = offset.map_or([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], matrix);
                    let node = &mut nodes[branch.node(order, e, rank)];
                    node.mass += share * mass;
                    for i in 0..3 {
                        for j in 0..3 {
                            node.moments[i][j] +=
                                share * (0..3).map(|k| axes[i][k] * moments[k] * axes[j][k]).sum::<f64>();
                        }
                    }
                }
            }
        }
        Self { inertia: nodes.into(), ..self.clone() }
    }

    /// The map of the joint that a node is, where something is done to it, and whether it counts its turn by angles.
    fn map_of(&self, values: &[f64], node: usize) -> Option<(EndMap, EndRotation)> {
        let end = self.end_of.get(node).copied().flatten()?;
        let own = &self.ends[end].own;
        let q = quaternion_of(&values[node * N..(node + 1) * N]);
        let (map, _) = own.rotation.map(own.axes, self.angles(values, end), q, [0.0; 3]);
        Some((map, own.rotation))
    }

    /// How a node moves, of the rates of its unknowns.
    fn node_rates(&self, values: &[f64], node: usize, velocity: &[f64]) -> NodeRates {
        let own = &velocity[node * F..][..F];
        NodeRates::new(
            self.map_of(values, node).map_or_else(|| std::array::from_fn(|f| own[f]), |(map, _)| map.forward(own)),
        )
    }

    /// M, a number an unknown: the diagonal.
    pub(super) fn nodal_masses(&self, values: &[f64]) -> Vec<f64> {
        let mut masses = Vec::with_capacity(self.nodes * F);
        for (node, NodeInertia { mass, moments }) in self.inertia.iter().enumerate() {
            masses.extend([*mass; 3]);
            let moments = self.map_of(values, node).map_or(*moments, |(map, _)| taken_back(&map, moments));
            masses.extend((0..3).map(|k| moments[k][k]));
        }
        masses
    }

    /// M a, with what turning masses add to that.
    pub(super) fn forces_of_inertia(&self, values: &[f64], velocity: &[f64], acceleration: &[f64]) -> Vec<f64> {
        let mut forces = Vec::with_capacity(velocity.len());
        for (node, inertia) in self.inertia.iter().enumerate() {
            let (v, a) = (&velocity[node * F..][..F], &acceleration[node * F..][..F]);
            match self.map_of(values, node) {
                Some((map, rotation)) => {
                    let mut change = NodeRates::new(map.forward(a));
                    if rotation == EndRotation::Angles {
                        let more = axes_change(&map, &v[3..]);
                        (0..3).for_each(|k| change.turn[k] += more[k]);
                    }
                    forces.extend(map.back(&inertia.forces(NodeRates::new(map.forward(v)), change)));
                }
                None => {
                    let of = |rates: &[f64]| NodeRates::new(std::array::from_fn(|k| rates[k]));
                    forces.extend(inertia.forces(of(v), of(a)));
                }
            }
        }
        forces
    }

    /// By how much the unknowns of a joint are accelerated by a force along x, y and z and a moment about its directors.
    pub(crate) fn accelerated(&self, at: &State, joint: usize, force: &[f64; F]) -> [f64; F] {
        let NodeInertia { mass, moments } = self.inertia[joint];
        let map = self.map_of(&at.values, joint).map(|(map, _)| map);
        let force = map.as_ref().map_or(*force, |map| map.back(force));
        let moments = map.map_or(moments, |map| taken_back(&map, &moments));
        let inverse = nalgebra::Matrix3::from_fn(|i, j| moments[i][j]).try_inverse().unwrap_or_default();
        let turn = inverse * nalgebra::Vector3::new(force[3], force[4], force[5]);
        std::array::from_fn(|k| if k < 3 { force[k] / mass } else { turn[k - 3] })
    }

    /// ½ v · M v, aJ
    pub(super) fn energy_of_motion(&self, values: &[f64], velocity: &[f64]) -> f64 {
        let of = |(node, inertia): (usize, &NodeInertia)| {
            let NodeRates { place, turn } = self.node_rates(values, node, velocity);
            0.5 * (inertia.mass * dot(place, place) + dot(turn, apply(&inertia.moments, &turn)))
        };
        self.inertia.iter().enumerate().map(of).sum()
    }

    /// Momentum, and angular momentum about the origin, along and about x, y and z.
    pub fn momenta(&self, at: &State, velocity: &[f64]) -> [[f64; 3]; 2] {
        let mut sums = [[0.0; 3]; 2];
        for (node, inertia) in self.inertia.iter().enumerate() {
            let fields = &at.values[node * N..][..N];
            let NodeRates { place, turn } = self.node_rates(&at.values, node, velocity);
            let momentum = place.map(|v| inertia.mass * v);
            let spin = apply(&matrix(quaternion_of(fields)), &apply(&inertia.moments, &turn));
            let about = cross([fields[0], fields[1], fields[2]], momentum);
            for k in 0..3 {
                sums[0][k] += momentum[k];
                sums[1][k] += about[k] + spin[k];
            }
        }
        sums
    }

    /// Adds to joints what a step in time adds to their equations: forces, and the mass over β' h², with what couples the turns of a joint.
    pub(super) fn load_with_inertia(&self, values: &[f64], nodal: NodalTerms, carries: &mut [Carry<F>]) {
        for (joint, carry) in carries.iter_mut().enumerate() {
            for f in 0..F {
                let (stiffness, force) = nodal.at(joint * F + f);
                carry.tangent[f][f] += stiffness;
                carry.residual[f] += force;
            }
            let Some(NodeInertia { mass, moments }) = self.inertia.get(joint).filter(|own| own.mass > 0.0) else {
                continue;
            };
            let factor = nodal.at(joint * F).0 / mass;
            let moments = self.map_of(values, joint).map_or(*moments, |(map, _)| taken_back(&map, moments));
            for i in 0..3 {
                for j in (0..3).filter(|&j| j != i) {
                    carry.tangent[3 + i][3 + j] += factor * moments[i][j];
                }
            }
        }
    }
}

/// Moments of inertia of a node by the turns of its joint: Aᵀ J A.
fn taken_back(map: &EndMap, moments: &Matrix3) -> Matrix3 {
    let entry = |i: usize, j: usize| {
        let row = |k: usize| (0..3).map(|l| moments[k][l] * map.turn[l][j]).sum::<f64>();
        (0..3).map(|k| map.turn[k][i] * row(k)).sum()
    };
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
}

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
        self.strains(at).iter().map(|point| point.stored).sum()
    }

    fn factorise_step(&self, at: &State, terms: &StepTerms, ws: &mut Workspace) -> Result<CondensedSystem, SolveError> {
        let tree = self.in_step(terms.rate);
        let nodal = if self.inertia.is_empty() { NodalTerms::NONE } else { terms.nodal };
        let added = Added { damping: 0.0, nodal };
        let root = tree.eliminate_with(at, [0.0; MONITORS], added, ws.factors::<SpatialFactors>())?;
        Ok(root.condensed(tree.evaluation(at, root.integrals)))
    }

    fn relaxed_memory(&self, at: &State) -> Vec<f64> {
        if !self.viscosity.is_viscous() {
            return Vec::new();
        }
        self.strains(at).into_iter().flat_map(|point| point.strains).collect()
    }

    fn memory(&self, at: &State, rate: &MaterialRate) -> Vec<f64> {
        self.viscosity.remembered_by(&self.relaxed_memory(at), rate)
    }

    fn viscous_power(&self, at: &State, rate: &MaterialRate) -> ViscousPower {
        self.viscosity.power_in(rate, || [self.in_step(rate).energy(at), self.energy(at)])
    }
}
