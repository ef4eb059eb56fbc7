//! The branches of a tree over the ground: how a state is laid out along them, how far their nodes are from it, and meshes that follow their fronts.
//!
//! The elements of a branch that adheres may follow its peeling front and the edges of its sections, as those of a beam in space: the mesh of a state
//! has the boundaries of one such branch behind those of another, and follows three numbers of each, its front and the two edges from there.

use super::beam_tree::{ANGLES, BeamTree, TreeBranch};
use super::branching_beam::{BranchMesh, TreeMonitor};
use crate::beam::element::integration::Element;
use crate::beam::mesh::MeshPolicy;
use crate::beam::spatial::above_ground::LettingGo;
use crate::beam::spatial::chain::fields_along::FieldsAlong;
use crate::beam::spatial::chain::spatial_chain::no_values;
use crate::beam::spatial::rotation::Quaternion;
use crate::beam::spatial::section::branch_sections::AdheringSections;
use crate::beam::spatial::section::kinematics::SPATIAL_FIELDS;
use crate::beam::spatial::spatial_system::{MOVED, NEARER};
use crate::number::F64x4;
use crate::solve::frontal::nodes::{BUNDLE, slot};
use crate::solve::state::{MONITORS, Mesh, State};
use crate::solve::system::System;

const N: usize = SPATIAL_FIELDS;
/// Numbers that the mesh of a branch follows.
const FOLLOWED: usize = 3;

/// A branch whose mesh follows its front.
struct Following<'a> {
    branch: &'a TreeBranch,
    policy: &'a MeshPolicy,
    sections: &'a AdheringSections,
    /// Where its numbers begin in [`Mesh::follows`]
    first: usize,
}

impl<'a> Following<'a> {
    fn new(branch: &'a TreeBranch) -> Option<Self> {
        match (&branch.mesh, &branch.adhering) {
            (BranchMesh::Following { policy, .. }, Some(sections)) => Some(Self { branch, policy, sections, first: 0 }),
            _ => None,
        }
    }
}

/// Puts the fields of the nodes of a branch into the values of a state; its ends stay where they are.
fn put_inside(values: &mut [f64], branch: &TreeBranch, fields: &[f64]) {
    let inside = &fields[N..fields.len() - N];
    values[branch.first_node * N..][..inside.len()].copy_from_slice(inside);
}

impl BeamTree {
    /// The branches whose meshes follow their fronts.
    fn following(&self) -> impl Iterator<Item = Following<'_>> {
        let found = self.branches.iter().filter_map(Following::new).enumerate();
        found.map(|(k, own)| Following { first: FOLLOWED * k, ..own })
    }

    /// The mesh in the stress-free configuration.
    pub(super) fn mesh_at_rest(&self) -> Mesh {
        let mut follows = Vec::new();
        for Following { branch, .. } in self.following() {
            follows.extend([branch.rest.front_at_rest(branch.length), 0.0, 0.0]);
        }
        self.mesh_near(&follows, &Mesh::default())
    }

    /// The mesh that follows these numbers, found faster near to another one.
    pub(super) fn mesh_near(&self, follows: &[f64], near: &Mesh) -> Mesh {
        let mut boundaries = Vec::with_capacity(near.boundaries.len());
        for Following { branch, policy, first, .. } in self.following() {
            let BranchMesh::Following { elements, .. } = branch.mesh else { continue };
            let counts = policy.pieces.shared_out(elements);
            let near = near.boundaries.get(branch.first_boundary..=branch.first_boundary + branch.elements);
            let front = branch.rest.place_of_front(follows[first], branch.length);
            boundaries.extend(policy.ends(
                Some(front),
                &follows[first + 1..first + FOLLOWED],
                &counts,
                near.unwrap_or(&[]),
            ));
        }
        Mesh { boundaries, focus: 0.0, follows: follows.to_vec() }
    }

    /// What the mesh of a state is to follow.
    pub(super) fn follows(&self, at: &State) -> Vec<f64> {
        let mut follows = Vec::with_capacity(at.mesh.follows.len());
        for Following { branch, sections, .. } in self.following() {
            let front = self.coverage(at, branch) / sections.lying.energy;
            let place = branch.rest.place_of_front(front, branch.length);
            let own = LettingGo {
                profile: &sections.profile,
                shape: sections.law.shape(),
                gap_scale: sections.lying.gap_scale,
                gap: sections.lying.gap,
            };
            let fields = self.along(at, branch);
            let (order, ends) = (self.order(), branch.ends(&at.mesh));
            let places = fields.chunks_exact(N).enumerate().map(|(k, node)| {
                let e = (k / order).min(branch.elements - 1);
                (self.place(ends, e, k - e * order), node)
            });
            let [one, other] = own.edges(places).map(|edge| edge - place);
            follows.extend([front, one, other]);
        }
        follows
    }

    /// Whether a front has moved so far from where a mesh follows it that this is to be another.
    pub(super) fn has_moved(&self, follows: &[f64], mesh: &Mesh) -> bool {
        let mut all = self.following();
        all.any(|Following { branch, sections, first, .. }| {
            let place = |front: f64| branch.rest.place_of_front(front, branch.length);
            let moved = place(follows[first]) - place(mesh.follows[first]);
            moved.abs() > MOVED * sections.lying.process_length
        })
    }

    /// A state on a mesh that is a little beside its own.
    pub(super) fn shifted(&self, at: &State, mesh: Mesh) -> State {
        self.on_mesh(at, mesh, |from, ends| from.shifted(ends))
    }

    /// A state read off on another mesh.
    pub(super) fn resampled(&self, at: &State, mesh: Mesh) -> State {
        self.on_mesh(at, mesh, |from, ends| from.resampled(ends))
    }

    /// A state of a tree with the same joints and branches, read off on the elements of this one, whose order is the same.
    pub(crate) fn read_from(&self, other: &Self, at: &State) -> State {
        let mesh = self.mesh_near(&at.mesh.follows, &Mesh::default());
        let (joints, angles) = (self.joints() * N, self.ends.len() * ANGLES);
        let mut values = vec![0.0; self.nodes * N + angles];
        values[..joints].copy_from_slice(&at.values[..joints]);
        values[self.nodes * N..].copy_from_slice(&at.values[other.nodes * N..]);
        for (branch, from) in self.branches.iter().zip(other.branches.iter()) {
            let fields = other.along(at, from);
            let along = FieldsAlong { basis: &self.basis, boundaries: from.ends(&at.mesh), fields: &fields };
            put_inside(&mut values, branch, &along.resampled(branch.ends(&mesh)));
        }
        State { values, mesh, ..at.clone() }
    }

    fn on_mesh(&self, at: &State, mesh: Mesh, read: impl Fn(&FieldsAlong, &[f64]) -> Vec<f64>) -> State {
        let mut next = State { mesh, ..at.clone() };
        for Following { branch, .. } in self.following() {
            let fields = self.along(at, branch);
            let from = FieldsAlong { basis: &self.basis, boundaries: branch.ends(&at.mesh), fields: &fields };
            let read = read(&from, branch.ends(&next.mesh));
            put_inside(&mut next.values, branch, &read);
        }
        next
    }

    /// The fields of the nodes of a branch in its own directors, from S = 0 on.
    fn along(&self, at: &State, branch: &TreeBranch) -> Vec<f64> {
        let order = self.order();
        let nodes = 0..=branch.elements * order;
        let own = nodes.flat_map(|k| {
            let e = (k / order).min(branch.elements - 1);
            self.fields(&at.values, branch, e, k - e * order)
        });
        own.collect()
    }

    /// S of a node of an element.
    fn place(&self, ends: &[f64], e: usize, rank: usize) -> f64 {
        let share = 0.5 * (1.0 + self.basis.nodes[slot(self.order() + 1, rank)]);
        ends[e] + share * (ends[e + 1] - ends[e])
    }

    /// The weight of that length among those of the monitors.
    pub(super) fn weight_of_adhering(&self, weights: [f64; MONITORS]) -> f64 {
        let of = |(monitor, weight): (&Option<TreeMonitor>, f64)| {
            if *monitor == Some(TreeMonitor::AdheringLength) { weight } else { 0.0 }
        };
        self.monitors.iter().zip(weights).map(of).sum()
    }

    /// What adheres of a branch: its energy, each section of it as far as its axis covers the ground, aJ.
    fn coverage(&self, at: &State, branch: &TreeBranch) -> f64 {
        let (mut sum, mut bundle) = (0.0, Element::<F64x4, N>::zero());
        let by = self.integration(self.count(), branch);
        for first in (0..branch.elements).step_by(BUNDLE) {
            self.gather(at, &self.lanes_of(branch, first), &mut bundle);
            let [_, coverage, _] = bundle.energy_in_pieces(&by, &no_values::<N>());
            sum += coverage.0[..BUNDLE.min(branch.elements - first)].iter().sum::<f64>();
        }
        sum
    }

    /// A state whose joints, and sections of branches at S (nm), have these places and directors. Nothing says that it is in equilibrium. Angles
    /// of ends are zero.
    pub(crate) fn laid_along(
        &self,
        joint: impl Fn(usize) -> ([f64; 3], Quaternion),
        section: impl Fn(usize, f64) -> ([f64; 3], Quaternion),
    ) -> State {
        let mesh = self.mesh_at_rest();
        let mut values = vec![0.0; self.nodes * N + self.ends.len() * ANGLES];
        let mut put = |node: usize, (place, q): ([f64; 3], Quaternion)| {
            values[node * N..node * N + 3].copy_from_slice(&place);
            values[node * N + 3..(node + 1) * N].copy_from_slice(&q);
        };
        (0..self.joints()).for_each(|own| put(own, joint(own)));
        let (order, last) = (self.order(), self.order() + 1);
        for (b, branch) in self.branches.iter().enumerate() {
            let ends = branch.ends(&mesh);
            for e in 0..branch.elements {
                for rank in (0..last).filter(|&rank| branch.end_at(order, e, rank).is_none()) {
                    put(branch.node(order, e, rank), section(b, self.place(ends, e, rank)));
                }
            }
        }
        State { values, mesh, force: 0.0, history: None }
    }

    /// The stress-free state, with all nodes higher, nm.
    pub(crate) fn stress_free_above(&self, height: f64) -> State {
        let mut at = self.stress_free(0);
        at.values[..self.nodes * N].chunks_exact_mut(N).for_each(|node| node[1] += height);
        at
    }

    /// What the heights of the nodes are measured by, nm: by the scale of the tree, or, where a branch adheres, by how far the lowest point of the
    /// section is from where it is at rest, and the gap scale of the law, if that is less. Along the ground nothing changes as they slide.
    pub(super) fn height_units(&self, at: &State) -> Vec<f64> {
        let (order, mut units) = (self.order(), vec![self.scale[0]; self.nodes]);
        for branch in self.branches.iter() {
            let Some(sections) = &branch.adhering else { continue };
            let ends = branch.ends(&at.mesh);
            for e in 0..branch.elements {
                for rank in usize::from(e > 0)..=order {
                    let fields = self.fields(&at.values, branch, e, rank);
                    let lowest = sections.lowest(self.place(ends, e, rank), &fields);
                    let unit = &mut units[branch.node(order, e, rank)];
                    *unit = unit.min(sections.lying.gap_scale + (lowest - sections.lying.gap).abs());
                }
            }
        }
        units
    }

    /// Distance of a branch that adheres from the ground, nm: of the lowest points of its sections, at its nodes and at the Gauss points between them; infinite of one
    /// that does not.
    pub(crate) fn nearest(&self, at: &State, branch: usize) -> f64 {
        let (own, order) = (&self.branches[branch], self.order());
        let (Some(sections), mut nearest) = (&own.adhering, f64::INFINITY) else { return f64::INFINITY };
        let ends = own.ends(&at.mesh);
        for e in 0..own.elements {
            let element = self.element(at, own, e);
            for rank in 0..=order {
                let fields = &element.values[slot(order + 1, rank)];
                nearest = nearest.min(sections.lowest(self.place(ends, e, rank), fields));
            }
            for q in 0..order {
                let point = element.point(self.count(), &self.basis, q);
                nearest = nearest.min(sections.lowest(point.place, &point.value));
            }
        }
        nearest
    }

    /// The branches that adhere where they are near to the ground, each by its number.
    fn over_ground(&self) -> impl Iterator<Item = (usize, &AdheringSections)> {
        let adheres = |(b, branch): (usize, &'_ TreeBranch)| branch.density.adhesion.is_some().then_some(b);
        let all = self.branches.iter().enumerate().filter_map(adheres);
        all.filter_map(|b| Some((b, &**self.branches[b].adhering.as_ref()?)))
    }

    /// Whether no branch that adheres is where its law has no place for it.
    pub(super) fn is_above_ground(&self, at: &State) -> bool {
        self.over_ground().all(|(b, own)| own.barrier().clearance(self.nearest(at, b)) > 0.0)
    }

    /// Whether a step takes no branch that is beyond the reach of its law much nearer to the ground.
    pub(super) fn stays_clear(&self, from: &State, to: &State) -> bool {
        self.over_ground().all(|(b, own)| {
            let nearest = self.nearest(from, b);
            let clearance = |height: f64| own.barrier().clearance(height);
            nearest < own.law.law().adhering_distance() || clearance(self.nearest(to, b)) >= NEARER * clearance(nearest)
        })
    }
}
