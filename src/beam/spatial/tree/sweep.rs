//! The elimination, from the tips to the root.

use super::beam_tree::{ASIDE, BeamTree, TreeBranch};
use super::branching_beam::TreeMonitor;
use super::factors::TreeFactors;
use super::inside::pack;
use crate::beam::element::basis::{AnyNumber, Fixed, Nodes, slot};
use crate::beam::element::integration::{BUNDLE, Element};
use crate::beam::spatial::chain::end_block::{Carry, EndBlock, ROOT};
use crate::beam::spatial::chain::projection::{SpatialFront, project};
use crate::beam::spatial::chain::sweep::LEAST_PIVOT;
use crate::beam::spatial::section::kinematics::SPATIAL_UNKNOWNS;
use crate::solve::error::{Place, Quantity, SolveError};
use crate::solve::state::{MONITORS, State};
use crate::solve::system::NodalTerms;

const F: usize = SPATIAL_UNKNOWNS;

/// What is left of a tree when all but its root is eliminated.
pub struct CondensedTree {
    /// The unknowns of the root, then the residual column and the path row
    pub matrix: Carry,
    /// Negative eigenvalues with the root held
    pub negative: usize,
    /// The smallest pivot without its sign
    pub least_pivot: f64,
    /// Before the update, aJ
    pub energy: f64,
    /// The length that adheres, of all branches, before the update, nm
    pub adhering: f64,
}

/// What is added to the equations.
#[derive(Clone, Copy)]
pub(super) struct Added<'a> {
    /// To the diagonal, over what damps a branch per length: see [`BeamTree::damping`]
    pub damping: f64,
    /// Of single unknowns
    pub nodal: NodalTerms<'a>,
    /// To the path row: the weight of the length that adheres, 1/nm
    pub adhering: f64,
}

/// What an elimination counts on its way.
struct Count {
    energy: f64,
    adhering: f64,
    negative: usize,
    least: f64,
}

impl BeamTree {
    /// Eliminates all but the root. `weights` are those of the monitors; `damping`, one over a pseudo-time, is added to the diagonal in the scales of
    /// each branch.
    ///
    /// # Errors
    /// A pivot that is zero to rounding, a number that is not finite.
    pub fn eliminate(
        &self,
        at: &State,
        weights: [f64; MONITORS],
        damping: f64,
        factors: &mut TreeFactors,
    ) -> Result<CondensedTree, SolveError> {
        self.eliminate_with(at, weights, Added { damping, nodal: NodalTerms::NONE, adhering: 0.0 }, factors)
    }

    /// The same with whatever is added.
    pub(super) fn eliminate_with(
        &self,
        at: &State,
        weights: [f64; MONITORS],
        added: Added,
        factors: &mut TreeFactors,
    ) -> Result<CondensedTree, SolveError> {
        let adhering = self.weight_of_adhering(weights);
        let added = Added { adhering, ..added };
        factors.resize(self.elements, self.bundles.len() * self.inside);
        let mut carries = std::mem::take(&mut factors.carries);
        let mut count = Count {
            energy: self.load_joints(&at.values, weights, &mut carries),
            adhering: 0.0,
            negative: 0,
            least: f64::INFINITY,
        };
        if !added.nodal.stiffness.is_empty() {
            self.load_with_inertia(&at.values, added.nodal, &mut carries);
        }
        // the loops of the orders that are used where none is asked for, of setae and of trees, are compiled for them alone
        match self.order() {
            2 => sweep::<Fixed<3>>(self, at, added, &mut carries, factors, &mut count),
            3 => sweep::<Fixed<4>>(self, at, added, &mut carries, factors, &mut count),
            5 => sweep::<Fixed<6>>(self, at, added, &mut carries, factors, &mut count),
            _ => sweep::<AnyNumber>(self, at, added, &mut carries, factors, &mut count),
        }?;
        let matrix = carries[self.root()];
        factors.carries = carries;
        let Count { energy, adhering, negative, least } = count;
        Ok(CondensedTree { matrix, negative, least_pivot: least, energy, adhering })
    }

    /// What joints have of their own; their energy.
    fn load_joints(&self, values: &[f64], weights: [f64; MONITORS], carries: &mut Vec<Carry>) -> f64 {
        carries.clear();
        carries.resize(self.joints(), [[0.0; ROOT]; ROOT]);
        let mut energy = 0.0;
        for (end, condition) in self.ends.iter().enumerate() {
            let (own, carry) = (self.own(values, end), &mut carries[condition.joint]);
            energy += own.energy;
            for i in 0..F {
                carry[i][..F].copy_from_slice(&own.tangent[i]);
                carry[i][F] = own.gradient[i];
            }
        }
        for (monitor, weight) in self.monitors.iter().zip(weights) {
            match monitor {
                Some(TreeMonitor::Joint(unknown)) => carries[unknown.joint][F][unknown.slot] += weight,
                Some(TreeMonitor::PadsAside) => {
                    self.pads.iter().for_each(|&pad| carries[pad][F][ASIDE] += weight / self.pads.len() as f64);
                }
                Some(TreeMonitor::AdheringLength) | None => {}
            }
        }
        energy
    }

    /// All bundles in their order. A branch's far joint carries what is behind the elements of it that are eliminated.
    #[inline(always)]
    fn sweep_bundles(
        &self,
        nodes: impl Nodes,
        at: &State,
        added: Added,
        carries: &mut [Carry],
        TreeFactors { inside, ends, below, front, field_front, room, .. }: &mut TreeFactors,
        count: &mut Count,
    ) -> Result<(), SolveError> {
        let (order, mut bundle) = (nodes.count() - 1, Element::zero());
        let mut block = EndBlock::zero();
        for (b, own) in self.bundles.iter().enumerate() {
            let lanes = self.lanes(own);
            self.gather(at, &lanes, &mut bundle);
            let by = self.integration(nodes, lanes[0].0);
            let per_energy = lanes[0].0.adhering.as_ref().map_or(0.0, |own| 1.0 / own.lying.energy);
            let (energy, coverage) =
                bundle.integrate_gradient::<false>(&by, added.adhering * per_energy, room, field_front);
            self.products.assemble(nodes, &self.basis, &by.coupling, &bundle, room, field_front);
            project(nodes, field_front, &bundle.values, front);
            self.take_ends(nodes, &at.values, &lanes, front);
            if added.damping != 0.0 {
                damp(nodes, front, self.damping(lanes[0].0).map(|own| added.damping * own), bundle.length.0);
            }
            if !added.nodal.stiffness.is_empty() {
                self.load_inside(nodes, &lanes, added.nodal, front);
            }
            let pivots = front.condense_by_nodes(nodes);
            pack(order, front, &mut inside[b * self.inside..][..self.inside]);
            for (l, &(branch, e)) in lanes.iter().enumerate().take(own.count) {
                let (id, k) = (branch.first_element + e, own.lanes[l].1);
                block.take(nodes, front, l, [1 - branch.near, branch.near]);
                if k > 0 {
                    let far = self.end_places(branch, e)[0];
                    for f in 0..F {
                        let (stiffness, force) = added.nodal.at(far + f);
                        block.0[f][f] += stiffness;
                        block.0[f][2 * F] += force;
                    }
                }
                block.unload(&carries[branch.far_joint()]);
                if k == 0 {
                    block.start(&[0.0; F], &self.joint_off(&at.values, branch.far_joint()));
                }
                let (negative, least) = block.eliminate();
                count.energy += energy.0[l];
                count.adhering += per_energy * coverage.0[l];
                count.negative += pivots.negative.0[l] as usize + negative;
                let smallest = least.min(pivots.least.0[l]);
                let place = Place { element: id, position: branch.ends(&at.mesh)[e] };
                if smallest < LEAST_PIVOT {
                    return Err(SolveError::Singular { pivot: smallest, place });
                }
                count.least = count.least.min(smallest);
                ends[id].copy_from_slice(&block.0[..F]);
                below[id] = block.below();
                let carry = block.load();
                if !(carry[0][0].is_finite() && count.energy.is_finite()) {
                    return Err(SolveError::NotFinite { quantity: Quantity::Tangent, place });
                }
                if k + 1 < branch.elements {
                    carries[branch.far_joint()] = carry;
                } else {
                    let near = &mut carries[branch.near_joint()];
                    for (sum, part) in near.as_flattened_mut().iter_mut().zip(carry.as_flattened()) {
                        *sum += part;
                    }
                }
            }
        }
        Ok(())
    }

    /// Adds to four elements what is added to the equations of their interior nodes.
    fn load_inside(
        &self,
        nodes: impl Nodes,
        lanes: &[(&TreeBranch, usize)],
        nodal: NodalTerms,
        front: &mut SpatialFront,
    ) {
        let order = nodes.count() - 1;
        for (l, &(branch, e)) in lanes.iter().enumerate() {
            for rank in 1..order {
                let (row, node) = (slot(order + 1, rank), branch.node(order, e, rank));
                for f in 0..F {
                    let (stiffness, force) = nodal.at(node * F + f);
                    front.rows[row][f].fields[row][f].0[l] += stiffness;
                    front.rows[row][f].residual.0[l] += force;
                }
            }
        }
    }
}

/// [`BeamTree::sweep_bundles`] compiled for the vector units that the machine may have, chosen when it runs.
#[cfg_attr(
    not(any(test, feature = "portable", debug_assertions)),
    multiversion::multiversion(targets("x86_64+avx2+fma"))
)]
fn sweep<N: Nodes>(
    tree: &BeamTree,
    at: &State,
    added: Added,
    carries: &mut [Carry],
    factors: &mut TreeFactors,
    count: &mut Count,
) -> Result<(), SolveError> {
    tree.sweep_bundles(N::of_order(tree.basis.order), at, added, carries, factors, count)
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
