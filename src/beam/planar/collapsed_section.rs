//! Where the end of a beam collapses onto the substrate: a state that the energy of a beam has and no beam.
//!
//! A section that stands upright is attracted with up to b h T per length, T the largest traction of the half space. Where that is more than about ½EA the
//! sections of an upright end gain more by coming down to the equilibrium height, all of them, than it takes to compress the axis between them to nothing,
//! Γ1 = -1: linear elasticity lets sections through one another. Each mesh has another such state, and Newton's method goes from none to the next.

use super::planar_beam::PlanarBeam;
use crate::solve::state::State;
use serde::{Deserialize, Serialize};
use std::fmt;

/// A section at which the axis is compressed, or sheared, as no beam is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct CollapsedSection {
    /// S, nm
    pub place: f64,
    /// Γ1 = x' cosθ + y' sinθ - 1
    pub stretch: f64,
    /// Γ2 = -x' sinθ + y' cosθ
    pub shear: f64,
}

impl fmt::Display for CollapsedSection {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { place, stretch, shear } = self;
        write!(
            f,
            "the beam collapses onto the substrate, where its adhesion is too strong for its stiffness: at S = {place:.3} nm it is compressed by Γ1 = \
             {stretch:.3} and sheared by Γ2 = {shear:.3}, beyond {COLLAPSED}, and no beam is"
        )
    }
}

/// Largest compression -Γ1 and largest shear |Γ2| of a beam, far beyond what a linear material is taken for.
const COLLAPSED: f64 = 0.5;

impl PlanarBeam {
    /// The section, of those between elements, that is compressed or sheared most, where no beam is so.
    pub fn collapsed_section(&self, at: &State) -> Option<CollapsedSection> {
        let nodes = self.chain.node_states(self.configuration(at), 0..at.mesh.elements());
        let sections = nodes.iter().map(|node| {
            let (sin, cos) = node.values[self.rotation].sin_cos();
            let (across, up) = (node.section.horizontal_slope, node.section.vertical_slope);
            CollapsedSection {
                place: node.position,
                stretch: across * cos + up * sin - 1.0,
                shear: up * cos - across * sin,
            }
        });
        let size = |section: &CollapsedSection| section.shear.abs().max(-section.stretch);
        sections.max_by(|a, b| size(a).total_cmp(&size(b))).filter(|section| size(section) > COLLAPSED)
    }
}
