//! The fronts of a tree, and what its joints have of their own; it is eliminated from the tips to the root.

use super::beam_tree::{ASIDE, BeamTree};
use super::branching_beam::TreeMonitor;
use crate::beam::spatial::chain::projection::SpatialFront;
use crate::beam::spatial::chain::room::{SpatialFactors, SpatialRoom};
use crate::beam::spatial::section::kinematics::SPATIAL_UNKNOWNS;
use crate::number::F64x4;
use crate::solve::error::{Place, SolveError};
use crate::solve::frontal::eliminate::{Eliminated, Fronts};
use crate::solve::frontal::end_block::Carry;
use crate::solve::frontal::nodes::{AnyNumber, BUNDLE, Fixed, Nodes};
use crate::solve::state::{MONITORS, State};
use crate::solve::system::NodalTerms;

const F: usize = SPATIAL_UNKNOWNS;

/// What is added to the equations.
#[derive(Clone, Copy)]
pub(super) struct Added<'a> {
    /// To the diagonal, over what damps a branch per length: see [`BeamTree::damping`]
    pub damping: f64,
    /// Of single unknowns
    pub nodal: NodalTerms<'a>,
}

/// A tree in a state, as its elimination sees it.
struct TreeFronts<'a> {
    tree: &'a BeamTree,
    at: &'a State,
    /// [`Added::damping`]
    damping: f64,
    /// Weight of the length that adheres in the path row, 1/nm
    adhering: f64,
}

impl Fronts<F> for TreeFronts<'_> {
    type Room = SpatialRoom;

    #[inline(always)]
    fn write(&self, nodes: impl Nodes, bundle: usize, room: &mut SpatialRoom, front: &mut SpatialFront) -> [F64x4; 2] {
        let Self { tree, at, .. } = self;
        let lanes = tree.lanes(&tree.bundles[bundle]);
        let branch = lanes[0].0;
        tree.gather(at, &lanes, &mut room.bundle);
        let per_energy = branch.adhering.as_ref().map_or(0.0, |own| 1.0 / own.lying.energy);
        let by = tree.integration(nodes, branch);
        let [energy, coverage] = room.write(&by, &tree.products, self.adhering * per_energy, front);
        tree.take_ends(nodes, &at.values, &lanes, front);
        if self.damping != 0.0 {
            damp(nodes, front, tree.damping(branch).map(|own| self.damping * own), room.bundle.length.0);
        }
        [energy, coverage * per_energy]
    }

    /// Nothing that adheres along a branch is without a potential: [`crate::model::PeelModel::branch`].
    fn is_symmetric(&self) -> bool {
        true
    }

    fn off(&self, joint: usize) -> [Option<f64>; F] {
        self.tree.joint_off(&self.at.values, joint)
    }

    fn place(&self, element: usize) -> Place {
        let (branch, e) = self.tree.branch_of(element);
        Place { element, position: branch.ends(&self.at.mesh)[e] }
    }
}

impl BeamTree {
    /// Eliminates all but the root. `weights` are those of the monitors; `damping`, one over a pseudo-time, is added to the diagonal in the scales of
    /// each branch. The integrals are the energy, of elements and joints, and the length that adheres, of all branches, nm.
    ///
    /// # Errors
    /// A pivot that is zero to rounding, a number that is not finite.
    pub fn eliminate(
        &self,
        at: &State,
        weights: [f64; MONITORS],
        damping: f64,
        factors: &mut SpatialFactors,
    ) -> Result<Eliminated<F>, SolveError> {
        self.eliminate_with(at, weights, Added { damping, nodal: NodalTerms::NONE }, factors)
    }

    /// The same with whatever is added.
    pub(super) fn eliminate_with(
        &self,
        at: &State,
        weights: [f64; MONITORS],
        Added { damping, nodal }: Added,
        factors: &mut SpatialFactors,
    ) -> Result<Eliminated<F>, SolveError> {
        let carries = factors.begin(self.forest.clone());
        let of_joints = self.load_joints(&at.values, weights, carries);
        if !nodal.stiffness.is_empty() {
            self.load_with_inertia(&at.values, nodal, carries);
        }
        let SpatialFactors { frontal, room } = factors;
        let fronts = TreeFronts { tree: self, at, damping, adhering: self.weight_of_adhering(weights) };
        // the loops of the orders that are used where none is asked for, of setae and of trees, are compiled for them alone
        let mut found = match self.order() {
            2 => frontal.eliminate::<_, Fixed<3>>(&fronts, nodal, room),
            3 => frontal.eliminate::<_, Fixed<4>>(&fronts, nodal, room),
            5 => frontal.eliminate::<_, Fixed<6>>(&fronts, nodal, room),
            _ => frontal.eliminate::<_, AnyNumber>(&fronts, nodal, room),
        }?;
        found.integrals[0] += of_joints;
        Ok(found)
    }

    /// What joints have of their own; their energy.
    fn load_joints(&self, values: &[f64], weights: [f64; MONITORS], carries: &mut [Carry<F>]) -> f64 {
        let mut energy = 0.0;
        for (end, condition) in self.ends.iter().enumerate() {
            let (own, carry) = (self.own(values, end), &mut carries[condition.joint]);
            energy += own.energy;
            (carry.tangent, carry.residual) = (own.tangent, own.gradient);
        }
        for (monitor, weight) in self.monitors.iter().zip(weights) {
            match monitor {
                Some(TreeMonitor::Joint(unknown)) => carries[unknown.joint].path[unknown.slot] += weight,
                Some(TreeMonitor::PadsAside) => {
                    self.pads.iter().for_each(|&pad| carries[pad].path[ASIDE] += weight / self.pads.len() as f64);
                }
                Some(TreeMonitor::AdheringLength) | None => {}
            }
        }
        energy
    }
}

/// Adds to the diagonals of four elements their part of a matrix that is `damping` times the length of each node.
fn damp(nodes: impl Nodes, front: &mut SpatialFront, damping: [f64; F], lengths: [f64; BUNDLE]) {
    let (count, inner) = (nodes.count(), nodes.count() - 2);
    for a in 0..count {
        let share = if a < inner { 1.0 } else { 0.5 } / (count - 1) as f64;
        for f in 0..F {
            for l in 0..BUNDLE {
                front.rows[a][f].fields[a][f].0[l] += share * damping[f] * lengths[l];
            }
        }
    }
}
