//! The fronts of a chain, and its ends; it is eliminated from the left end to the right.

use super::projection::{EndMaps, SpatialFront};
use super::room::{SpatialFactors, SpatialRoom};
use super::spatial_chain::{
    SpatialChain, SpatialConfiguration, SpatialEnd, SpatialFunctional, USUAL_ORDER, Usual, quaternion_of,
};
use crate::beam::element::integrand::Integrand;
use crate::beam::spatial::end_rotation::EndMap;
use crate::beam::spatial::rotation::{Matrix3, apply_transposed, matrix};
use crate::beam::spatial::section::kinematics::{SPATIAL_FIELDS, SPATIAL_UNKNOWNS};
use crate::number::F64x4;
use crate::solve::error::{Place, SolveError};
use crate::solve::frontal::eliminate::{Eliminated, Fronts};
use crate::solve::frontal::end_block::Carry;
use crate::solve::frontal::forest::Forest;
use crate::solve::frontal::nodes::{AnyNumber, BUNDLE, Nodes};
use crate::solve::system::NodalTerms;
use std::sync::Arc;

/// A chain in a configuration, as its elimination sees it.
struct ChainFronts<'a> {
    chain: &'a SpatialChain,
    at: SpatialConfiguration<'a>,
    /// Weight of the coverage in the path row
    coverage: f64,
}

impl Fronts<SPATIAL_UNKNOWNS> for ChainFronts<'_> {
    type Room = SpatialRoom;

    #[inline(always)]
    fn write(&self, nodes: impl Nodes, bundle: usize, room: &mut SpatialRoom, front: &mut SpatialFront) -> [F64x4; 2] {
        let (first, elements) = (bundle * BUNDLE, self.at.boundaries.len() - 1);
        self.chain.gather(nodes, self.at, first, &mut room.bundle);
        let integrals = room.write(&self.chain.integration(nodes), &self.chain.products, self.coverage, front);
        self.chain.take_ends(nodes, self.at, (first, elements), front);
        integrals
    }

    fn is_symmetric(&self) -> bool {
        self.chain.density.is_symmetric()
    }

    fn off(&self, _: usize) -> [Option<f64>; SPATIAL_UNKNOWNS] {
        self.chain.off(self.at)
    }

    fn place(&self, element: usize) -> Place {
        Place { element, position: self.at.boundaries[element] }
    }
}

impl SpatialChain {
    /// Eliminates all but the right end, with terms of single unknowns added. The integrals are the energy and the coverage.
    ///
    /// # Errors
    /// A pivot that is zero to rounding, a number that is not finite.
    pub fn eliminate(
        &self,
        at: SpatialConfiguration,
        path: &SpatialFunctional,
        added: NodalTerms,
        factors: &mut SpatialFactors,
    ) -> Result<Eliminated<SPATIAL_UNKNOWNS>, SolveError> {
        let (elements, order) = (at.boundaries.len() - 1, self.basis.order);
        let ends = factors.begin(Arc::new(Forest::chain(elements, order)));
        for (carry, node) in ends.iter_mut().zip([0, elements * order]) {
            for f in 0..SPATIAL_UNKNOWNS {
                (carry.tangent[f][f], carry.residual[f]) = added.at(node * SPATIAL_UNKNOWNS + f);
            }
        }
        ends[0].path = path.left;
        self.load_right(at, &mut ends[1]);
        let SpatialFactors { frontal, room } = factors;
        let fronts = ChainFronts { chain: self, at, coverage: path.coverage };
        if order == USUAL_ORDER {
            frontal.eliminate::<_, Usual>(&fronts, added, room)
        } else {
            frontal.eliminate::<_, AnyNumber>(&fronts, added, room)
        }
    }

    /// By how much what is held of the left end is off.
    pub(super) fn off(&self, at: SpatialConfiguration) -> [Option<f64>; SPATIAL_UNKNOWNS] {
        let here = self.end_values(at, 0);
        std::array::from_fn(|f| self.held_left[f].map(|held| here[f] - held))
    }

    /// Where an end is along its axes, and its angles.
    pub(crate) fn end_values(&self, at: SpatialConfiguration, end: usize) -> [f64; SPATIAL_UNKNOWNS] {
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
            maps.apply(nodes, node, self.density.is_symmetric(), front);
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
    fn load_right(&self, at: SpatialConfiguration, carry: &mut Carry<SPATIAL_UNKNOWNS>) {
        if self.ends[1].dead_load == [[0.0; 3]; 2] {
            return;
        }
        let (load, turned) = self.dead_load(at);
        for i in 0..SPATIAL_UNKNOWNS {
            carry.residual[i] -= load[i];
        }
        for i in 0..3 {
            for j in 0..3 {
                carry.tangent[3 + i][3 + j] -= turned[i][j];
            }
        }
    }
}
