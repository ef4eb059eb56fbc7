//! The fields of one equilibrium along a beam in space, sampled as those of a planar beam are.

use crate::adhesion::spatial_section::section::SectionShape;
use crate::beam::spatial::section_state::SpatialSectionState;
use crate::beam::spatial::spatial_beam::SpatialBeam;
use crate::model::peel::PeelModel;
use crate::number::gauss::gauss_legendre;
use crate::solve::state::State;
use std::num::NonZeroUsize;

/// The beam in space at one place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpatialSectionFields {
    /// Where the section lies, what it carries, and what it exerts on the ground
    pub state: SpatialSectionState,
    /// Distance of its lowest point from the ground, nm
    pub gap: f64,
    /// Of the quadrature along S, nm: the integral of a field is the sum of this times the field
    pub weight: f64,
}

/// What the fields of all states of one peel in space are read with.
pub(super) struct SpatialReader<'p> {
    beam: &'p SpatialBeam,
    pub outline: SectionShape,
    /// Shares of an element at its Gauss points, from 0 to 1, and their weights.
    gauss: Vec<(f64, f64)>,
}

impl<'p> SpatialReader<'p> {
    pub fn new(model: &PeelModel, beam: &'p SpatialBeam) -> Self {
        let gauss = NonZeroUsize::new(beam.chain.order()).map_or_else(Vec::new, gauss_legendre);
        let gauss = gauss.into_iter().map(|(local, weight)| (0.5 * (1.0 + local), 0.5 * weight)).collect();
        Self { beam, outline: model.space.map_or(SectionShape::Rectangle, |space| space.section), gauss }
    }

    /// The fields from S = 0 to S = L.
    pub fn sections(&self, at: &State) -> Vec<SpatialSectionFields> {
        let elements = at.mesh.elements();
        let mut ends = self.beam.end_states(at, 0..elements).into_iter();
        let mut sections = Vec::with_capacity(elements * (1 + self.gauss.len()) + 1);
        for (element, pair) in at.mesh.boundaries.windows(2).enumerate() {
            sections.extend(ends.next().map(|end| self.fields(end, 0.0)));
            let inside = self.gauss.iter().map(|&(share, weight)| {
                self.fields(self.beam.state_at(at, element, share), weight * (pair[1] - pair[0]))
            });
            sections.extend(inside);
        }
        sections.extend(ends.next().map(|end| self.fields(end, 0.0)));
        sections
    }

    fn fields(&self, state: SpatialSectionState, weight: f64) -> SpatialSectionFields {
        let section = &state.section;
        let (across, up) = (section.width * section.directors[1][1], section.height * section.directors[2][1]);
        let below = match self.outline {
            SectionShape::Rectangle => across.abs() + up.abs(),
            SectionShape::Ellipse => across.hypot(up),
        };
        SpatialSectionFields { state, gap: section.place[1] - 0.5 * below, weight }
    }
}
