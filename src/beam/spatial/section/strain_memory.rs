//! What a viscous material of beams in space remembers: Γ and K - K0 at each Gauss point, in the axes of the directors.
//!
//! As in the plane a step strains from known ε_k, with a factor f: section forces are C ε + f C (ε - ε_k), with the energy
//! ½ ε · C ε + ½ f (ε - ε_k) · C (ε - ε_k). Strains in the axes of the directors do not change where a body turns as a whole, and neither does their rate.

use super::density::{FACTOR, SpatialDensity};
use super::kinematics::SPATIAL_FIELDS;
use crate::beam::element::basis::Basis;
use crate::beam::element::energy_density::MEMORY;
use crate::beam::element::integration::Element;
use crate::number::F64x4;
use crate::solve::frontal::nodes::{MOST_NODES, Nodes};

/// Numbers that are remembered at a point.
pub(crate) const STRAINS: usize = 6;

/// What a viscous material remembers before a step in time.
#[derive(Clone, Copy, Debug)]
pub struct SpatialKnownStrains<'a> {
    /// f: what the stiffness is multiplied with, without a unit
    pub factor: f64,
    /// Γ and K - K0 (1/nm) from which the step strains, Gauss point by Gauss point and element by element
    pub strains: &'a [[f64; STRAINS]],
}

impl SpatialKnownStrains<'_> {
    /// [`Element::memories`] of an element of an order.
    #[inline(always)]
    fn of_element(&self, order: usize, element: usize, mut put: impl FnMut(usize, [f64; MEMORY])) {
        for (q, strains) in self.strains[element * order..][..order].iter().enumerate() {
            let mut memory = [0.0; MEMORY];
            memory[..STRAINS].copy_from_slice(strains);
            memory[FACTOR] = self.factor;
            put(q, memory);
        }
    }

    /// Puts it into lane `l` of four elements.
    #[inline(always)]
    pub(crate) fn put_lane(
        &self,
        order: usize,
        element: usize,
        l: usize,
        memories: &mut [[F64x4; MEMORY]; MOST_NODES],
    ) {
        self.of_element(order, element, |q, memory| (0..MEMORY).for_each(|k| memories[q][k].0[l] = memory[k]));
    }

    /// Puts it into an element.
    pub(crate) fn put(&self, order: usize, element: usize, memories: &mut [[f64; MEMORY]; MOST_NODES]) {
        self.of_element(order, element, |q, memory| memories[q] = memory);
    }
}

/// Strains at a point of an element, and what they store.
pub(crate) struct StrainAt {
    pub strains: [f64; STRAINS],
    /// ½ ε · C ε, aJ
    pub stored: f64,
}

/// Strains at the Gauss points of an element.
pub(crate) fn strains_of<'a>(
    density: &'a SpatialDensity,
    element: &'a Element<f64, SPATIAL_FIELDS>,
    nodes: impl Nodes + 'a,
    basis: &'a Basis,
) -> impl Iterator<Item = StrainAt> + 'a {
    element.points(nodes, basis).map(|(point, weight)| {
        let (strains, stored) = density.strains(&point);
        StrainAt { strains, stored: weight * stored }
    })
}
