//! From a tree as plain data to one that can be eliminated, and what of it cannot be computed.

use super::beam_tree::{BeamTree, TreeBranch, TreeEnd};
use super::branching_beam::{Branch, BranchMesh, BranchingBeam, JointCondition, JointUnknown, TreeError, TreeMonitor};
use super::topology::{Topology, TreeBundle, schedule};
use crate::beam::element::basis::{Basis, MOST_ORDER};
use crate::beam::spatial::chain::assembly::Products;
use crate::beam::spatial::chain::spatial_chain::SpatialEnd;
use crate::beam::spatial::end_rotation::EndRotation;
use crate::beam::spatial::rotation::{Quaternion, conjugate, product};
use crate::beam::spatial::section::spatial_profile::Station;
use crate::beam::viscosity::Viscosity;
use crate::solve::frontal::forest::{Bundle, Forest, Piece};
use nalgebra::{Matrix3, Matrix6};
use std::sync::Arc;

/// Ends of branches may miss one another by this share of the branch's length.
const APART: f64 = 1e-9;
/// Axes of a joint may miss length one and a right angle by this much.
const SKEW: f64 = 1e-9;

impl BranchingBeam {
    /// The tree as a system.
    ///
    /// # Errors
    /// What of it cannot be computed, with its numbers.
    pub fn build(&self) -> Result<BeamTree, TreeError> {
        self.check_numbers()?;
        let topology = Topology::new(&self.branches, self.root)?;
        let joints = topology.inward.len();
        let at_rest: Vec<([f64; 3], Quaternion)> = (0..joints).map(|joint| self.at_rest(&topology, joint)).collect();
        self.check_meeting(&topology, &at_rest)?;
        self.check_conditions(&topology)?;
        let (mut nodes, mut elements, mut boundaries) = (joints, 0, 0);
        let mut branches = Vec::with_capacity(self.branches.len());
        for (b, own) in self.branches.iter().enumerate() {
            branches.push(TreeBranch {
                density: own.sections.density(&own.rest),
                adhering: own.sections.adhering().cloned(),
                joints: own.joints,
                near: topology.near[b],
                offsets: std::array::from_fn(|end| offset(at_rest[own.joints[end]].1, end_of(own, end).1)),
                length: own.length,
                elements: own.mesh.elements(),
                mesh: own.mesh.clone(),
                first_boundary: boundaries,
                first_node: nodes,
                first_element: elements,
                rest: own.rest.clone(),
            });
            nodes += own.mesh.elements() * self.order - 1;
            elements += own.mesh.elements();
            if let BranchMesh::Following { .. } = own.mesh {
                boundaries += own.mesh.elements() + 1;
            }
        }
        let free = JointCondition::free(self.root);
        let root = self.conditions.iter().find(|condition| condition.joint == self.root).unwrap_or(&free);
        let others = self.conditions.iter().filter(|condition| condition.joint != self.root);
        let ends: Vec<TreeEnd> =
            std::iter::once(root).chain(others).map(|own| end(own, at_rest[own.joint].1)).collect();
        let mut end_of = vec![None; joints];
        ends.iter().enumerate().for_each(|(k, end)| end_of[end.joint] = Some(k));
        let bundles = schedule(&self.branches, &topology);
        let is_pad = |joint: &usize| {
            let ends = |&b: &usize| self.branches[b].sections.adhering().is_some();
            *joint != self.root
                && end_of[*joint].is_none()
                && topology.meeting[*joint].len() == 1
                && topology.meeting[*joint].iter().all(ends)
        };
        let pads: Vec<usize> = (0..joints).filter(is_pad).collect();
        let basis = Basis::new(self.order);
        Ok(BeamTree {
            forest: Arc::new(forest(&branches, &bundles, self.order, self.root)),
            bundles: bundles.into(),
            products: Products::new(&basis),
            basis,
            branches: branches.into(),
            ends: ends.into(),
            end_of: end_of.into(),
            at_rest: at_rest.into(),
            nodes,
            elements,
            pads: pads.into(),
            monitors: self.monitors,
            scale: self.scale,
            inertia: Arc::default(),
            viscosity: Viscosity::Elastic,
            remembered: None,
        })
    }

    /// Place and directors of a joint at rest: those of the branch that leads to the root, at the root those of the first branch.
    fn at_rest(&self, topology: &Topology, joint: usize) -> ([f64; 3], Quaternion) {
        let b = topology.inward[joint].unwrap_or(topology.meeting[joint][0]);
        let own = &self.branches[b];
        end_of(own, usize::from(own.joints[1] == joint))
    }

    fn check_numbers(&self) -> Result<(), TreeError> {
        if self.branches.is_empty() {
            return Err(TreeError::Empty);
        }
        if !(1..=MOST_ORDER).contains(&self.order) {
            return Err(TreeError::Order { order: self.order });
        }
        for (branch, own) in self.branches.iter().enumerate() {
            let (length, elements) = (own.length, own.mesh.elements());
            if !(length > 0.0 && length.is_finite() && elements > 0) {
                return Err(TreeError::Length { branch, length, elements });
            }
            match &own.mesh {
                BranchMesh::Fixed(ends) => {
                    let ascend = ends.windows(2).all(|pair| pair[0] < pair[1]);
                    if !(ascend && ends[0] == 0.0 && (ends[elements] - length).abs() <= APART * length) {
                        return Err(TreeError::Ends { branch, length, ends: ends.clone() });
                    }
                }
                BranchMesh::Following { .. } if own.sections.adhering().is_none() => {
                    return Err(TreeError::NoFront { branch });
                }
                BranchMesh::Following { .. } => {}
            }
            if !is_stiff(own) {
                return Err(TreeError::Stiffness { branch });
            }
        }
        let [place, turn] = self.scale;
        if !(place > 0.0 && turn > 0.0 && place.is_finite() && turn.is_finite()) {
            return Err(TreeError::Scale { place, turn });
        }
        Ok(())
    }

    fn check_meeting(&self, topology: &Topology, at_rest: &[([f64; 3], Quaternion)]) -> Result<(), TreeError> {
        for (second, own) in self.branches.iter().enumerate() {
            for (end, joint) in own.joints.into_iter().enumerate() {
                let (place, other) = (end_of(own, end).0, at_rest[joint].0);
                let distance = (0..3).map(|i| (place[i] - other[i]).powi(2)).sum::<f64>().sqrt();
                let first = topology.inward[joint].unwrap_or(topology.meeting[joint][0]);
                let longest = own.length.max(self.branches[first].length);
                if distance > APART * longest {
                    return Err(TreeError::Gap { first, second, joint, distance });
                }
            }
        }
        Ok(())
    }

    fn check_conditions(&self, topology: &Topology) -> Result<(), TreeError> {
        let last = topology.inward.len() - 1;
        let mut counts = vec![0; last + 1];
        for own in &self.conditions {
            let joint = own.joint;
            let count = counts.get_mut(joint).ok_or(TreeError::Condition { joint, count: 1, last })?;
            *count += 1;
            if *count > 1 {
                return Err(TreeError::Condition { joint, count: *count, last });
            }
            let branches = topology.meeting[joint].len();
            if own.held.iter().any(Option::is_some) && (branches > 1 || joint == self.root) {
                return Err(TreeError::Held { joint, branches });
            }
            check_axes(own)?;
        }
        for monitor in self.monitors.into_iter().flatten() {
            let TreeMonitor::Joint(JointUnknown { joint, slot }) = monitor else { continue };
            let condition = self.conditions.iter().find(|own| own.joint == joint);
            let angles = condition.map_or(joint == self.root, |own| own.rotation == EndRotation::Angles);
            if joint > last || slot > 5 || (slot > 2 && !angles) {
                return Err(TreeError::Monitor { joint, slot });
            }
        }
        Ok(())
    }
}

fn check_axes(own: &JointCondition) -> Result<(), TreeError> {
    let axes = Matrix3::from_fn(|i, j| own.axes[i][j]);
    let skew = (axes.transpose() * axes - Matrix3::identity()).abs().max();
    let problem = if skew.is_nan() || skew >= SKEW {
        "its axes have to be of length one and at right angles"
    } else if own.rotation == EndRotation::Free && own.held[3..].iter().any(Option::is_some) {
        "its rotation is counted freely and cannot be held: give it angles"
    } else if own.held.iter().flatten().chain(own.dead_load.as_flattened()).any(|number| !number.is_finite()) {
        "a number of what is held or of the load is not finite"
    } else {
        return Ok(());
    };
    Err(TreeError::Axes { joint: own.joint, problem })
}

/// Place and directors of an end of a branch at rest.
fn end_of(branch: &Branch, end: usize) -> ([f64; 3], Quaternion) {
    branch.rest.at(if end == 0 { 0.0 } else { branch.length })
}

/// From the directors of a joint to those of a branch; none where they are the same.
fn offset(joint: Quaternion, branch: Quaternion) -> Option<Quaternion> {
    (joint != branch).then(|| product(conjugate(joint), branch))
}

/// Places along a branch at which it is looked at.
const LOOKED_AT: usize = 8;

/// Whether its stiffness is positive definite, and its curve finite, at a few places.
fn is_stiff(branch: &Branch) -> bool {
    let density = branch.sections.density(&branch.rest);
    (0..=LOOKED_AT).map(|k| branch.length * k as f64 / LOOKED_AT as f64).all(|place| {
        let Station { stiffness, rest_curvature, .. } = density.profile.at(place);
        let (start, directors) = branch.rest.at(place);
        let stiffness = Matrix6::from_fn(|i, j| stiffness[i][j]);
        let curve = start.iter().chain(&directors).chain(&rest_curvature);
        let is_finite = curve.into_iter().all(|number| number.is_finite());
        is_finite && stiffness == stiffness.transpose() && stiffness.cholesky().is_some()
    })
}

fn end(own: &JointCondition, rest: Quaternion) -> TreeEnd {
    TreeEnd {
        joint: own.joint,
        own: SpatialEnd { axes: own.axes, rotation: own.rotation, rest, dead_load: own.dead_load },
        held: own.held,
        energy: own.energy.clone(),
    }
}

/// How the elements of a tree are eliminated. Nodes are numbered as in its directions, joints as nodes.
fn forest(branches: &[TreeBranch], bundles: &[TreeBundle], order: usize, root: usize) -> Forest {
    let pieces = |branch: &TreeBranch| {
        let piece = |e: usize| {
            let (node, near) = (|rank| branch.node(order, e, rank), branch.near);
            let is_last = branch.inwards(branch.elements - 1) == e;
            Piece {
                ends: if near == 1 { [node(0), node(order)] } else { [node(order), node(0)] },
                near,
                inside: branch.first_node + e * order,
                from: branch.far_joint(),
                onto: if is_last { branch.near_joint() } else { branch.far_joint() },
                is_first: branch.inwards(0) == e,
            }
        };
        (0..branch.elements).map(piece).collect::<Vec<_>>()
    };
    let bundle = |own: &TreeBundle| {
        let number = |&(branch, k): &(usize, usize)| branches[branch].first_element + branches[branch].inwards(k);
        Bundle::of(&own.lanes[..own.count].iter().map(number).collect::<Vec<_>>())
    };
    Forest {
        order,
        pieces: branches.iter().flat_map(pieces).collect(),
        bundles: bundles.iter().map(bundle).collect(),
        joints: branches.len() + 1,
        root: [root, root],
    }
}
