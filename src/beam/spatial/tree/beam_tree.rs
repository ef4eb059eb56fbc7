//! A tree of beams that can be eliminated: its branches, its nodes, and how a state lays them out.

use super::branching_beam::{BranchMesh, EndEnergy, TreeMonitor};
use super::topology::TreeBundle;
use crate::beam::element::basis::Basis;
use crate::beam::element::integrand::Integrand;
use crate::beam::element::integration::{Element, Integration};
use crate::beam::spatial::chain::assembly::Products;
use crate::beam::spatial::chain::spatial_chain::{SpatialEnd, quaternion_of};
use crate::beam::spatial::end_rotation::EndRotation;
use crate::beam::spatial::rest::BranchRest;
use crate::beam::spatial::rotation::{Matrix3, Quaternion, apply, cross, product};
use crate::beam::spatial::section::branch_sections::AdheringSections;
use crate::beam::spatial::section::density::SpatialDensity;
use crate::beam::spatial::section::kinematics::{SPATIAL_FIELDS, SPATIAL_UNKNOWNS};
use crate::beam::spatial::section::strain_memory::{SpatialKnownStrains, StrainAt, strains_of};
use crate::beam::viscosity::Viscosity;
use crate::number::F64x4;
use crate::solve::frontal::forest::Forest;
use crate::solve::frontal::nodes::{AnyNumber, BUNDLE, Nodes, slot};
use crate::solve::state::{MONITORS, Mesh, State};
use crate::solve::time::dynamic_system::MaterialRate;
use std::sync::Arc;

/// z among the unknowns of a joint.
pub(super) const ASIDE: usize = 2;
/// Angles of an end in a state.
pub(super) const ANGLES: usize = 3;

/// A tree of beams as a [`crate::solve::System`]; [`crate::beam::BranchingBeam::build`] makes one.
///
/// Values of a state: x, y, z and the quaternion of each node, the joints first and then the nodes of each branch from S = 0 on; then three
/// angles of the root and of each joint with a condition (zeros where it turns freely). A direction has six numbers a node: of its place, and
/// of its turn in the axes of its directors; of a joint with a condition along the axes and by the angles of that. The interface is the root.
/// The mesh is fixed: the number of elements of each branch is its own, whatever a path asks for.
#[derive(Clone, Debug)]
pub struct BeamTree {
    pub(super) basis: Basis,
    pub(super) products: Products,
    pub(super) branches: Arc<[TreeBranch]>,
    /// Its elements, four at a time, those that are carried first
    pub(super) bundles: Arc<[TreeBundle]>,
    /// How it is eliminated
    pub(super) forest: Arc<Forest>,
    /// The root, then the joints with conditions
    pub(super) ends: Arc<[TreeEnd]>,
    /// Of each joint, its place among the ends
    pub(super) end_of: Arc<[Option<usize>]>,
    /// Of each joint
    pub(super) at_rest: Arc<[([f64; 3], Quaternion)]>,
    pub(super) nodes: usize,
    pub(super) elements: usize,
    /// Joints at which a branch that adheres ends freely
    pub(super) pads: Arc<[usize]>,
    pub(super) monitors: [Option<TreeMonitor>; MONITORS],
    pub(super) scale: [f64; 2],
    /// Of each node; empty where it does not count
    pub(super) inertia: Arc<[NodeInertia]>,
    /// How the material of all branches flows
    pub(super) viscosity: Viscosity,
    /// What it remembers, in a step in time
    pub(super) remembered: Option<RememberedStrains>,
}

/// What a viscous material remembers, with what its stiffness is multiplied with.
#[derive(Clone, Debug)]
pub(super) struct RememberedStrains {
    pub factor: f64,
    pub strains: Arc<[f64]>,
}

/// A branch of it.
#[derive(Clone, Debug)]
pub(super) struct TreeBranch {
    pub density: Arc<SpatialDensity>,
    /// What of it adheres
    pub adhering: Option<Arc<AdheringSections>>,
    /// At S = 0 and at S = L
    pub joints: [usize; 2],
    /// Which of these is nearer to the root
    pub near: usize,
    /// From the directors of a joint to those of the branch; none where they are the same.
    pub offsets: [Option<Quaternion>; 2],
    pub length: f64,
    pub elements: usize,
    pub mesh: BranchMesh,
    /// Where its boundaries begin in the mesh of a state, where they move
    pub first_boundary: usize,
    /// Number of its first node that is no joint
    pub first_node: usize,
    pub first_element: usize,
    pub rest: BranchRest,
}

/// A joint with a condition, or the root.
#[derive(Clone, Debug)]
pub(super) struct TreeEnd {
    pub joint: usize,
    pub own: SpatialEnd,
    pub held: [Option<f64>; SPATIAL_UNKNOWNS],
    pub energy: Option<Arc<dyn EndEnergy>>,
}

impl TreeBranch {
    /// The joint that is farther from the root.
    pub(crate) fn far_joint(&self) -> usize {
        self.joints[1 - self.near]
    }

    /// The joint that is nearer to the root.
    pub(crate) fn near_joint(&self) -> usize {
        self.joints[self.near]
    }

    /// The k-th of its elements, counted from the far joint on.
    pub(crate) fn inwards(&self, k: usize) -> usize {
        if self.near == 1 { k } else { self.elements - 1 - k }
    }

    /// S of the ends of its elements in a mesh, nm.
    pub(crate) fn ends<'a>(&'a self, mesh: &'a Mesh) -> &'a [f64] {
        match &self.mesh {
            BranchMesh::Fixed(ends) => ends,
            BranchMesh::Following { .. } => &mesh.boundaries[self.first_boundary..][..=self.elements],
        }
    }

    /// Number of a node of an element: of a rank from 0 to p.
    pub(crate) fn node(&self, order: usize, element: usize, rank: usize) -> usize {
        match element * order + rank {
            0 => self.joints[0],
            k if k == self.elements * order => self.joints[1],
            k => self.first_node + k - 1,
        }
    }

    /// Which joint a node of an element is, as an end of the branch.
    pub(crate) fn end_at(&self, order: usize, element: usize, rank: usize) -> Option<usize> {
        match element * order + rank {
            0 => Some(0),
            k if k == self.elements * order => Some(1),
            _ => None,
        }
    }
}

impl BeamTree {
    /// Order p of its elements.
    pub fn order(&self) -> usize {
        self.basis.order
    }

    /// Elements of all branches.
    pub fn elements(&self) -> usize {
        self.elements
    }

    /// Joints: one more than branches.
    pub fn joints(&self) -> usize {
        self.end_of.len()
    }

    /// Number of the joint whose unknowns are the interface.
    pub fn root(&self) -> usize {
        self.ends[0].joint
    }

    /// Where a joint is, and its directors: those of the branch that leads to the root, at the root those of its first branch.
    pub fn joint(&self, at: &State, joint: usize) -> ([f64; 3], Quaternion) {
        let node = &at.values[joint * SPATIAL_FIELDS..][..SPATIAL_FIELDS];
        ([node[0], node[1], node[2]], quaternion_of(node))
    }

    /// Length of a branch, nm.
    pub fn length(&self, branch: usize) -> f64 {
        self.branches[branch].length
    }

    /// Place (nm) and directors of a branch in the stress-free configuration, at S.
    pub(crate) fn rest_at(&self, branch: usize, place: f64) -> ([f64; 3], Quaternion) {
        self.branches[branch].rest.at(place)
    }

    /// Places and directors of a branch between its joints, where two elements meet.
    pub(crate) fn between_joints(&self, at: &State, branch: usize) -> Vec<([f64; 3], Quaternion)> {
        let own = &self.branches[branch];
        let end = |element| {
            let node = self.fields(&at.values, own, element, self.order());
            ([node[0], node[1], node[2]], quaternion_of(&node))
        };
        (0..own.elements - 1).map(end).collect()
    }

    /// Fields of a node of a branch, in the directors of the branch.
    pub(super) fn fields(
        &self,
        values: &[f64],
        branch: &TreeBranch,
        element: usize,
        rank: usize,
    ) -> [f64; SPATIAL_FIELDS] {
        let from = branch.node(self.order(), element, rank) * SPATIAL_FIELDS;
        let mut own = [0.0; SPATIAL_FIELDS];
        own.copy_from_slice(&values[from..from + SPATIAL_FIELDS]);
        if let Some(offset) = branch.end_at(self.order(), element, rank).and_then(|end| branch.offsets[end]) {
            let turned = product(quaternion_of(&own), offset);
            own[3..].copy_from_slice(&turned);
        }
        own
    }

    /// What its material remembers in a step in time, laid out by [`TreeBranch::first_element`].
    fn known(&self) -> Option<SpatialKnownStrains<'_>> {
        let RememberedStrains { factor, strains } = self.remembered.as_ref()?;
        Some(SpatialKnownStrains { factor: *factor, strains: strains.as_chunks().0 })
    }

    /// Strains at all Gauss points, element by element, with what they store.
    pub(super) fn strains(&self, at: &State) -> Vec<StrainAt> {
        let mut all = Vec::with_capacity(self.elements * self.order());
        for branch in self.branches.iter() {
            for e in 0..branch.elements {
                let element = self.element(at, branch, e);
                all.extend(strains_of(&branch.density, &element, self.count(), &self.basis));
            }
        }
        all
    }

    /// The branch of an element, and which of its elements it is.
    pub(super) fn branch_of(&self, element: usize) -> (&TreeBranch, usize) {
        let branch = &self.branches[self.branches.partition_point(|own| own.first_element <= element) - 1];
        (branch, element - branch.first_element)
    }

    /// Four elements of a branch from the k-th on, counted from the far joint; behind the last one it is repeated.
    pub(super) fn lanes_of<'a>(&self, branch: &'a TreeBranch, first: usize) -> [(&'a TreeBranch, usize); BUNDLE] {
        std::array::from_fn(|l| (branch, branch.inwards((first + l).min(branch.elements - 1))))
    }

    /// The four elements of a bundle.
    pub(super) fn lanes(&self, bundle: &TreeBundle) -> [(&TreeBranch, usize); BUNDLE] {
        bundle.lanes.map(|(branch, k)| {
            let branch = &self.branches[branch];
            (branch, branch.inwards(k))
        })
    }

    /// The values of four elements.
    pub(super) fn gather(
        &self,
        at: &State,
        lanes: &[(&TreeBranch, usize); BUNDLE],
        bundle: &mut Element<F64x4, SPATIAL_FIELDS>,
    ) {
        let count = self.order() + 1;
        for (l, &(branch, e)) in lanes.iter().enumerate() {
            let ends = branch.ends(&at.mesh);
            (bundle.from.0[l], bundle.length.0[l]) = (ends[e], ends[e + 1] - ends[e]);
            if let Some(known) = self.known() {
                known.put_lane(self.order(), branch.first_element + e, l, &mut bundle.memories);
            }
            for rank in 0..count {
                let own = self.fields(&at.values, branch, e, rank);
                (0..SPATIAL_FIELDS).for_each(|f| bundle.values[slot(count, rank)][f].0[l] = own[f]);
            }
        }
    }

    /// One element of a branch.
    pub(super) fn element(&self, at: &State, branch: &TreeBranch, e: usize) -> Element<f64, SPATIAL_FIELDS> {
        let (count, mut element) = (self.order() + 1, Element::zero());
        let ends = branch.ends(&at.mesh);
        (element.from, element.length) = (ends[e], ends[e + 1] - ends[e]);
        for rank in 0..count {
            element.values[slot(count, rank)] = self.fields(&at.values, branch, e, rank);
        }
        if let Some(known) = self.known() {
            known.put(self.order(), branch.first_element + e, &mut element.memories);
        }
        element
    }

    pub(super) fn integration<'a, N: Nodes>(
        &'a self,
        nodes: N,
        branch: &'a TreeBranch,
    ) -> Integration<'a, N, SPATIAL_FIELDS> {
        let density: &dyn Integrand<SPATIAL_FIELDS> = &*branch.density;
        Integration {
            nodes,
            basis: &self.basis,
            density,
            coupling: density.coupling(),
            symmetric: true,
            history: None,
            in_pieces: false,
        }
    }

    pub(super) fn count(&self) -> AnyNumber {
        AnyNumber::of_order(self.order())
    }

    /// The three angles of an end.
    pub(super) fn angles(&self, values: &[f64], end: usize) -> [f64; ANGLES] {
        let from = self.nodes * SPATIAL_FIELDS + end * ANGLES;
        [values[from], values[from + 1], values[from + 2]]
    }

    /// Where an end with a condition is along its axes, and its angles.
    pub(super) fn end_values(&self, values: &[f64], end: usize) -> [f64; SPATIAL_UNKNOWNS] {
        let TreeEnd { joint, own, .. } = &self.ends[end];
        let node = &values[joint * SPATIAL_FIELDS..];
        let angles = self.angles(values, end);
        std::array::from_fn(|f| match f {
            0..3 => (0..3).map(|i| own.axes[i][f] * node[i]).sum(),
            _ if own.rotation == EndRotation::Angles => angles[f - 3],
            _ => 0.0,
        })
    }
}

/// Mass of a node, and its moments of inertia in the axes of its directors.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct NodeInertia {
    pub mass: f64,
    pub moments: Matrix3,
}

/// How a node moves, or is accelerated: along x, y and z, and about its directors.
#[derive(Clone, Copy)]
pub(super) struct NodeRates {
    pub place: [f64; 3],
    pub turn: [f64; 3],
}

impl NodeRates {
    pub(crate) fn new([x, y, z, a, b, c]: [f64; SPATIAL_UNKNOWNS]) -> Self {
        Self { place: [x, y, z], turn: [a, b, c] }
    }
}

impl NodeInertia {
    /// m dv/dt, and J dΩ/dt + Ω × JΩ.
    pub(crate) fn forces(&self, rates: NodeRates, change: NodeRates) -> [f64; SPATIAL_UNKNOWNS] {
        let (spin, torque) = (apply(&self.moments, &rates.turn), apply(&self.moments, &change.turn));
        let gyroscopic = cross(rates.turn, spin);
        std::array::from_fn(|k| if k < 3 { self.mass * change.place[k] } else { torque[k - 3] + gyroscopic[k - 3] })
    }
}

impl BeamTree {
    /// With other energies at joints that have a condition; of a joint without one nothing changes.
    pub(crate) fn with_energies(
        &self,
        energies: impl IntoIterator<Item = (usize, Option<Arc<dyn EndEnergy>>)>,
    ) -> Self {
        let mut tree = self.clone();
        let ends = Arc::make_mut(&mut tree.ends);
        for (joint, energy) in energies {
            if let Some(end) = self.end_of[joint] {
                ends[end].energy = energy;
            }
        }
        tree
    }

    /// With adhesion along the branches that adhere as far as `adheres` says so of their numbers: the others are beams on their own until then.
    pub(crate) fn with_adhesion(&self, adheres: impl Fn(usize) -> bool) -> Self {
        let mut tree = self.clone();
        let branches = Arc::make_mut(&mut tree.branches);
        for (b, branch) in branches.iter_mut().enumerate() {
            let Some(sections) = &branch.adhering else { continue };
            let law = adheres(b).then_some(sections.law);
            if branch.density.adhesion.is_some() != law.is_some() {
                branch.density = Arc::new(SpatialDensity { adhesion: law, ..(*branch.density).clone() });
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
    pub(crate) fn in_jump(&self, memory: &[f64]) -> Option<Self> {
        let factor = match self.viscosity {
            Viscosity::Elastic => return Some(self.clone()),
            Viscosity::KelvinVoigt { .. } => return None,
            Viscosity::StandardLinearSolid { stiffness_ratio, .. } => stiffness_ratio - 1.0,
        };
        let remembered = Some(RememberedStrains { factor, strains: memory.into() });
        Some(Self { remembered, viscosity: Viscosity::Elastic, ..self.clone() })
    }

    /// With other monitors; the last three unknowns of a joint are there with angles alone.
    pub fn with_monitors(&self, monitors: [Option<TreeMonitor>; MONITORS]) -> Self {
        Self { monitors, ..self.clone() }
    }
}
