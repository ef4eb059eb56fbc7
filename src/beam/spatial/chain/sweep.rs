//! The elimination, from the left end of the chain to the right.

use super::end_block::{Carry, EndBlock, ROOT};
use super::projection::{EndMaps, SpatialFront, project};
use super::spatial_chain::{
    SpatialChain, SpatialConfiguration, SpatialEnd, SpatialFactors, SpatialFunctional, USUAL_ORDER, Usual,
    gather_nodes, no_values, quaternion_of,
};
use crate::beam::element::basis::{AnyNumber, Nodes};
use crate::beam::element::frontal_matrix::FrontalMatrix;
use crate::beam::element::integration::{BUNDLE, Element, ElementEnergy};
use crate::beam::spatial::end_rotation::EndMap;
use crate::beam::spatial::rotation::{Matrix3, apply_transposed, matrix};
use crate::beam::spatial::section::kinematics::{SPATIAL_FIELDS, SPATIAL_UNKNOWNS};
use crate::solve::error::{Place, Quantity, SolveError};
use crate::solve::system::NodalTerms;

/// Pivots below this are zero to rounding.
pub(in crate::beam::spatial) const LEAST_PIVOT: f64 = f64::MIN_POSITIVE * 1e20;

/// What is left of the chain when all but its right end is eliminated.
pub struct CondensedSpatialChain {
    /// The unknowns of the right end, then the residual column and the path row.
    pub matrix: [[f64; ROOT]; ROOT],
    /// Negative eigenvalues with the right end held.
    pub negative: usize,
    /// The smallest pivot without its sign.
    pub least_pivot: f64,
    /// Before the update.
    pub energy: ElementEnergy,
}

impl SpatialChain {
    /// Eliminates all but the right end, with terms of single unknowns added.
    ///
    /// # Errors
    /// A pivot that is zero to rounding, a number that is not finite.
    pub fn eliminate(
        &self,
        at: SpatialConfiguration,
        path: &SpatialFunctional,
        added: NodalTerms,
        factors: &mut SpatialFactors,
    ) -> Result<CondensedSpatialChain, SolveError> {
        if self.basis.order == USUAL_ORDER {
            sweep::<Usual>(self, at, path, added, factors)
        } else {
            sweep::<AnyNumber>(self, at, path, added, factors)
        }
    }

    #[inline(always)]
    fn sweep_with(
        &self,
        nodes: impl Nodes,
        at: SpatialConfiguration,
        path: &SpatialFunctional,
        added: NodalTerms,
        SpatialFactors { fronts, ends, below, field_front, room }: &mut SpatialFactors,
    ) -> Result<CondensedSpatialChain, SolveError> {
        const F: usize = SPATIAL_UNKNOWNS;
        let (elements, order) = (at.boundaries.len() - 1, nodes.count() - 1);
        fronts.resize_with(elements.div_ceil(BUNDLE), FrontalMatrix::zero);
        ends.clear();
        below.clear();
        let (by, mut bundle) = (self.integration(nodes), Element::zero());
        let (mut energy, mut negative, mut least) = (ElementEnergy::default(), 0, f64::INFINITY);
        let mut carry: Carry = [[0.0; ROOT]; ROOT];
        for (first, front) in (0..elements).step_by(BUNDLE).zip(fronts) {
            self.gather(nodes, at, first, &mut bundle);
            let (total, coverage) = bundle.integrate_gradient::<false>(&by, path.coverage, room, field_front);
            self.products.assemble(nodes, &self.basis, &by.coupling, &bundle, room, field_front);
            project(nodes, field_front, &bundle.values, front);
            self.take_ends(nodes, at, (first, elements), front);
            add_inside(nodes, front, added, (first, elements));
            let pivots = front.condense_by_nodes(nodes);
            let mut block = EndBlock::zero();
            for e in first..elements.min(first + BUNDLE) {
                let l = e - first;
                energy.total += total.0[l];
                energy.coverage += coverage.0[l];
                block.take(nodes, front, l, [0, 1]);
                for f in 0..F {
                    let (stiffness, force) = added.at(e * order * F + f);
                    block.0[f][f] += stiffness;
                    block.0[f][2 * F] += force;
                }
                if e == 0 {
                    block.start(&path.left, &self.off(at));
                } else {
                    block.unload(&carry);
                }
                let (negative_end, least_end) = block.eliminate();
                negative += pivots.negative.0[l] as usize + negative_end;
                let smallest = least_end.min(pivots.least.0[l]);
                let place = Place { element: e, position: at.boundaries[e] };
                if smallest < LEAST_PIVOT {
                    return Err(SolveError::Singular { pivot: smallest, place });
                }
                least = least.min(smallest);
                ends.push(std::array::from_fn(|k| block.0[k]));
                below.push(block.below());
                carry = block.load();
                if !(carry[0][0].is_finite() && energy.total.is_finite()) {
                    return Err(SolveError::NotFinite { quantity: Quantity::Tangent, place });
                }
            }
        }
        for f in 0..F {
            let (stiffness, force) = added.at(elements * order * F + f);
            carry[f][f] += stiffness;
            carry[f][F] += force;
        }
        self.load_right(at, &mut carry);
        Ok(CondensedSpatialChain { matrix: carry, negative, least_pivot: least, energy })
    }

    /// By how much what is held of the left end is off.
    pub(super) fn off(&self, at: SpatialConfiguration) -> [Option<f64>; SPATIAL_UNKNOWNS] {
        let here = self.end_values(at, 0);
        std::array::from_fn(|f| self.held_left[f].map(|held| here[f] - held))
    }

    /// Where an end is along its axes, and its angles.
    pub fn end_values(&self, at: SpatialConfiguration, end: usize) -> [f64; SPATIAL_UNKNOWNS] {
        let node = self.end_node(at, end);
        let place = apply_transposed(&self.ends[end].axes, &[node[0], node[1], node[2]]);
        std::array::from_fn(|f| if f < 3 { place[f] } else { at.angles[end][f - 3] })
    }

    pub(in crate::beam::spatial) fn end_node<'a>(&self, at: SpatialConfiguration<'a>, end: usize) -> &'a [f64] {
        let from = if end == 0 { 0 } else { at.fields.len() - SPATIAL_FIELDS };
        &at.fields[from..from + SPATIAL_FIELDS]
    }

    /// From the unknowns of the last nodes to those of the ends.
    fn take_ends(
        &self,
        nodes: impl Nodes,
        at: SpatialConfiguration,
        (first, elements): (usize, usize),
        front: &mut SpatialFront,
    ) {
        for (end, element) in [(0, 0), (1, elements - 1)] {
            if !(first..first + BUNDLE).contains(&element) {
                continue;
            }
            let (l, node) = (element - first, nodes.count() - 2 + end);
            let gradient = std::array::from_fn(|f| front.rows[node][3 + f].residual.0[l]);
            let SpatialEnd { axes, rotation, .. } = self.ends[end];
            let (map, bent) = rotation.map(axes, at.angles[end], quaternion_of(self.end_node(at, end)), gradient);
            let mut maps = EndMaps::same();
            maps.set(l, &map, &bent);
            maps.apply(nodes, node, front);
        }
    }

    /// From the unknowns of an end to those of its node.
    pub(in crate::beam::spatial) fn end_map(&self, at: SpatialConfiguration, end: usize) -> EndMap {
        let SpatialEnd { axes, rotation, .. } = self.ends[end];
        rotation.map(axes, at.angles[end], quaternion_of(self.end_node(at, end)), [0.0; 3]).0
    }

    /// The dead load of the right end by its unknowns, and what its moment adds to the tangent by the turn.
    pub(super) fn dead_load(&self, at: SpatialConfiguration) -> ([f64; SPATIAL_UNKNOWNS], Matrix3) {
        let SpatialEnd { rotation, dead_load: [force, moment], .. } = self.ends[1];
        let own = apply_transposed(&matrix(quaternion_of(self.end_node(at, 1))), &moment);
        let map = self.end_map(at, 1);
        let load = map.back(&[force[0], force[1], force[2], own[0], own[1], own[2]]);
        (load, rotation.moment_change(&map.turn, own))
    }

    /// Takes the dead load off the residual and the tangent of the right end.
    fn load_right(&self, at: SpatialConfiguration, carry: &mut Carry) {
        if self.ends[1].dead_load == [[0.0; 3]; 2] {
            return;
        }
        let (load, turned) = self.dead_load(at);
        for i in 0..SPATIAL_UNKNOWNS {
            carry[i][SPATIAL_UNKNOWNS] -= load[i];
        }
        for i in 0..3 {
            for j in 0..3 {
                carry[3 + i][3 + j] -= turned[i][j];
            }
        }
    }
}

/// [`SpatialChain::sweep_with`] compiled for the vector units that the machine may have, chosen when it runs.
#[cfg_attr(
    not(any(test, feature = "portable", debug_assertions)),
    multiversion::multiversion(targets("x86_64+avx2+fma"))
)]
fn sweep<N: Nodes>(
    chain: &SpatialChain,
    at: SpatialConfiguration,
    path: &SpatialFunctional,
    added: NodalTerms,
    factors: &mut SpatialFactors,
) -> Result<CondensedSpatialChain, SolveError> {
    chain.sweep_with(N::of_order(chain.basis.order), at, path, added, factors)
}

/// Adds to the interior nodes of four elements; the ends of elements are left to the chain.
#[inline(always)]
fn add_inside(nodes: impl Nodes, front: &mut SpatialFront, added: NodalTerms, elements: (usize, usize)) {
    let mut own = no_values::<SPATIAL_UNKNOWNS>();
    if !added.stiffness.is_empty() {
        gather_nodes(nodes, added.stiffness, elements, &mut own);
        for (node, rows) in front.rows[..nodes.count() - 2].iter_mut().enumerate() {
            for f in 0..SPATIAL_UNKNOWNS {
                rows[f].fields[node][f] = rows[f].fields[node][f] + own[node][f];
            }
        }
    }
    if !added.force.is_empty() {
        gather_nodes(nodes, added.force, elements, &mut own);
        for (node, rows) in front.rows[..nodes.count() - 2].iter_mut().enumerate() {
            for f in 0..SPATIAL_UNKNOWNS {
                rows[f].residual = rows[f].residual + own[node][f];
            }
        }
    }
}
