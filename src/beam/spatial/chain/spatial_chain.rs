//! The chain and its ends, how a state is laid out in it, and the numbers of its elements, four side by side.

use super::assembly::Products;
use super::projection::SAME;
use crate::beam::element::basis::{Basis, MOST_ORDER};
use crate::beam::element::integrand::Integrand;
use crate::beam::element::integration::{Element, Integration};
use crate::beam::spatial::end_rotation::EndRotation;
use crate::beam::spatial::rotation::{Matrix3, Quaternion};
use crate::beam::spatial::section::density::SpatialDensity;
use crate::beam::spatial::section::kinematics::{SPATIAL_FIELDS, SPATIAL_UNKNOWNS};
use crate::beam::spatial::section::strain_memory::{SpatialKnownStrains, StrainAt, strains_of};
use crate::number::{F64x4, Real};
use crate::solve::frontal::nodes::{AnyNumber, BUNDLE, Fixed, MOST_NODES, Nodes, slot};

/// An end of the chain: along what it moves, how it turns, and which of these are held.
#[derive(Clone, Copy, Debug)]
pub struct SpatialEnd {
    /// Columns: the axes along which the end is moved.
    pub axes: Matrix3,
    /// How it turns
    pub rotation: EndRotation,
    /// The directors at rest
    pub rest: Quaternion,
    /// Force (nN) and moment (nN·nm) on it that keep their directions in space, along and about x, y, z; the moment has no potential.
    pub dead_load: [[f64; 3]; 2],
}

impl SpatialEnd {
    /// Whether its unknowns are those of its node: it turns freely, and its axes are x, y and z.
    pub(crate) fn is_node(&self) -> bool {
        self.rotation == EndRotation::Free && self.axes == SAME
    }
}

/// The order that is used where none is asked for: its loops are compiled for it alone, those of the others for any.
pub(crate) const USUAL_ORDER: usize = 7;

/// The chain.
#[derive(Clone, Debug)]
pub struct SpatialChain {
    /// What is integrated
    pub density: SpatialDensity,
    pub(super) basis: Basis,
    pub(super) products: Products,
    /// The left end and the right end
    pub ends: [SpatialEnd; 2],
    /// Which unknowns of the left end are held, and at what: of its place along its axes, and of its angles.
    pub held_left: [Option<f64>; SPATIAL_UNKNOWNS],
}

/// A configuration as a chain sees it.
#[derive(Clone, Copy, Debug)]
pub struct SpatialConfiguration<'a> {
    /// Reference coordinates S of the ends of the elements, nm
    pub boundaries: &'a [f64],
    /// Fields node by node from left to right
    pub fields: &'a [f64],
    /// Angles of the two ends. Those of an end that turns freely count its turns, and nothing follows from them.
    pub angles: [[f64; 3]; 2],
    /// What strains they had before a step in time, where the material is viscous
    pub known: Option<SpatialKnownStrains<'a>>,
}

/// What the path condition wants of the chain: a linear functional of the coverage and of the unknowns of the left end.
#[derive(Clone, Copy, Debug, Default)]
pub struct SpatialFunctional {
    /// Weight of the coverage, 1/aJ
    pub coverage: f64,
    /// Weights of the unknowns of the left end
    pub left: [f64; SPATIAL_UNKNOWNS],
}

impl SpatialChain {
    /// A chain of elements of an order, 1 to 8.
    pub fn new(
        density: SpatialDensity,
        order: usize,
        ends: [SpatialEnd; 2],
        held_left: [Option<f64>; SPATIAL_UNKNOWNS],
    ) -> Self {
        let basis = Basis::new(order.clamp(1, MOST_ORDER));
        let products = Products::new(&basis);
        Self { density, basis, products, ends, held_left }
    }

    /// Order p of its elements.
    pub fn order(&self) -> usize {
        self.basis.order
    }

    /// Place of the node of a rank in its element, from 0 to 1.
    pub(crate) fn node_fraction(&self, rank: usize) -> f64 {
        0.5 * (1.0 + self.basis.nodes[slot(self.basis.order + 1, rank)])
    }

    /// Weight of the node of a rank in the Gauss-Lobatto rule of its element, as a fraction of its length.
    pub(crate) fn node_weight(&self, rank: usize) -> f64 {
        self.basis.lobatto_weight(slot(self.basis.order + 1, rank))
    }

    pub(super) fn integration<N: Nodes>(&self, nodes: N) -> Integration<'_, N, SPATIAL_FIELDS> {
        let (density, coupling): (&dyn Integrand<SPATIAL_FIELDS>, _) = (&self.density, self.density.coupling());
        let symmetric = density.is_symmetric();
        Integration { nodes, basis: &self.basis, density, coupling, symmetric, history: None, in_pieces: true }
    }

    /// Strains at all Gauss points, element by element.
    pub(in crate::beam::spatial) fn strains(&self, at: SpatialConfiguration) -> Vec<StrainAt> {
        let mut all = Vec::with_capacity((at.boundaries.len() - 1) * self.basis.order);
        for e in 0..at.boundaries.len() - 1 {
            all.extend(strains_of(&self.density, &self.element(at, e), self.nodes(), &self.basis));
        }
        all
    }

    pub(super) fn nodes(&self) -> AnyNumber {
        AnyNumber::of_order(self.basis.order)
    }

    /// Elements `first` to `first + 3`; behind the last one it is repeated.
    #[inline(always)]
    pub(super) fn gather(
        &self,
        nodes: impl Nodes,
        at: SpatialConfiguration,
        first: usize,
        bundle: &mut Element<F64x4, SPATIAL_FIELDS>,
    ) {
        let elements = at.boundaries.len() - 1;
        for l in 0..BUNDLE {
            let e = (first + l).min(elements - 1);
            bundle.from.0[l] = at.boundaries[e];
            bundle.length.0[l] = at.boundaries[e + 1] - at.boundaries[e];
            if let Some(known) = &at.known {
                known.put_lane(self.basis.order, e, l, &mut bundle.memories);
            }
        }
        gather_nodes(nodes, at.fields, (first, elements), &mut bundle.values);
    }

    /// One element.
    pub(super) fn element(&self, at: SpatialConfiguration, e: usize) -> Element<f64, SPATIAL_FIELDS> {
        let mut element = Element::zero();
        element.from = at.boundaries[e];
        element.length = at.boundaries[e + 1] - at.boundaries[e];
        let count = self.basis.order + 1;
        for rank in 0..count {
            let from = (e * self.basis.order + rank) * SPATIAL_FIELDS;
            element.values[slot(count, rank)].copy_from_slice(&at.fields[from..from + SPATIAL_FIELDS]);
        }
        if let Some(known) = &at.known {
            known.put(self.basis.order, e, &mut element.memories);
        }
        element
    }
}

/// Numbers of the nodes of four elements, in elimination order.
#[inline(always)]
pub(super) fn gather_nodes<const F: usize>(
    nodes: impl Nodes,
    all: &[f64],
    (first, elements): (usize, usize),
    out: &mut [[F64x4; F]; MOST_NODES],
) {
    let count = nodes.count();
    for l in 0..BUNDLE {
        let e = (first + l).min(elements - 1);
        let own = &all[e * (count - 1) * F..][..count * F];
        for rank in 0..count {
            for f in 0..F {
                out[slot(count, rank)][f].0[l] = own[rank * F + f];
            }
        }
    }
}

/// The quaternion of a node's fields.
pub(crate) fn quaternion_of(node: &[f64]) -> Quaternion {
    [node[3], node[4], node[5], node[6]]
}

/// Nodes whose number is known, for the usual order.
pub(super) type Usual = Fixed<{ USUAL_ORDER + 1 }>;

pub(crate) fn no_values<const F: usize>() -> [[F64x4; F]; MOST_NODES] {
    [[F64x4::splat(0.0); F]; MOST_NODES]
}
