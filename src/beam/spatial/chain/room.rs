//! Room for the fronts of beams in space, and how the front of four elements is written.

use super::assembly::Products;
use super::projection::{FieldFront, SpatialFront, project};
use crate::beam::element::integration::{Element, Integration, Responses};
use crate::beam::spatial::section::kinematics::{SPATIAL_FIELDS, SPATIAL_UNKNOWNS};
use crate::number::F64x4;
use crate::solve::frontal::eliminate::FrontalFactors;
use crate::solve::frontal::end_block::Carry;
use crate::solve::frontal::forest::Forest;
use crate::solve::frontal::nodes::{BUNDLE, Nodes};
use std::sync::Arc;

/// Room for four elements.
pub(crate) struct SpatialRoom {
    /// Their numbers
    pub bundle: Element<F64x4, SPATIAL_FIELDS>,
    fields: Box<FieldFront>,
    responses: Box<Responses<SPATIAL_FIELDS>>,
}

/// The factors of a chain or a tree in space, and room for them.
#[derive(Default)]
pub struct SpatialFactors {
    pub(in crate::beam::spatial) frontal: FrontalFactors<SPATIAL_UNKNOWNS>,
    pub(in crate::beam::spatial) room: SpatialRoom,
}

impl SpatialFactors {
    /// Begins an elimination, which knows nothing of what the material remembered in the last one: what joints have of their own, to be filled in.
    pub(in crate::beam::spatial) fn begin(&mut self, forest: Arc<Forest>) -> &mut [Carry<SPATIAL_UNKNOWNS>] {
        self.room.bundle = Element::zero();
        self.frontal.begin(forest)
    }

    /// The direction that solves K q = `scale` R with the interface known: the right end of a chain, the root of a tree.
    pub fn recover(&self, interface: &[f64; SPATIAL_UNKNOWNS], scale: f64, direction: &mut [f64]) {
        self.frontal.recover(interface, scale, direction);
    }

    /// Takes a right-hand side down to the interface.
    pub fn reduce(&self, right: &mut [f64], transposed: bool) -> [f64; SPATIAL_UNKNOWNS] {
        self.frontal.reduce(right, transposed)
    }

    /// From a reduced right-hand side and the solution at the interface to the whole.
    pub fn substitute(&self, interface: &[f64; SPATIAL_UNKNOWNS], right: &mut [f64], transposed: bool) {
        self.frontal.substitute(interface, right, transposed);
    }
}

impl Default for SpatialRoom {
    fn default() -> Self {
        Self { bundle: Element::zero(), fields: Box::new(FieldFront::zero()), responses: Box::default() }
    }
}

impl SpatialRoom {
    /// Writes the front of the four elements in the unknowns of their nodes, with `weight` times the gradient of the coverage in the path row.
    /// Their energies and coverages.
    #[inline(always)]
    pub(in crate::beam::spatial) fn write<N: Nodes>(
        &mut self,
        by: &Integration<N, SPATIAL_FIELDS>,
        products: &Products,
        weight: f64,
        front: &mut SpatialFront,
    ) -> [F64x4; 2] {
        let Self { bundle, fields, responses } = self;
        let (energy, coverage) = bundle.integrate_gradient::<false>(by, weight, responses, fields);
        if by.symmetric {
            products.assemble(by.nodes, by.basis, &by.coupling, bundle, responses, fields);
        } else {
            bundle.assemble(by, responses, fields);
        }
        let mut energies = [energy, coverage];
        if !by.knots().is_empty() {
            for l in 0..BUNDLE {
                bundle.lane(l).piecewise(by, |point| {
                    energies[0].0[l] += point.weight * point.response.energy;
                    energies[1].0[l] += point.weight * point.response.coverage;
                    fields.add_piece(by.nodes, l, point, weight, by.symmetric);
                });
            }
        }
        project(by.nodes, by.symmetric, fields, &bundle.values, front);
        energies
    }
}
