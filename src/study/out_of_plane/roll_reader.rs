//! The roll of a beam in a planar equilibrium.

use super::roll_elements::{RollElements, RollStability};
use super::roll_section::RollSection;
use crate::adhesion::section::line_load::LineLaw;
use crate::beam::lateral_stiffness::LateralStiffness;
use crate::beam::planar::planar_beam::PlanarBeam;
use crate::beam::section::Material;
use crate::model::peel::{Hold, PeelModel};
use crate::solve::problem::Direction;
use crate::solve::state::State;
use std::num::NonZeroUsize;

/// What the roll of all equilibria of one peel is computed with.
pub(super) struct RollReader<'p> {
    model: &'p PeelModel,
    beam: &'p PlanarBeam,
    law: LineLaw,
    material: Material,
    elements: RollElements,
}

/// A beam in a planar equilibrium as its roll sees it, at the points of the rule of every element.
pub(super) struct RollingBeam {
    ends: Vec<f64>,
    sections: Vec<RollSection>,
}

impl<'p> RollReader<'p> {
    /// With a degree more than the planar elements have.
    pub fn new(model: &'p PeelModel, beam: &'p PlanarBeam) -> Self {
        let degree = NonZeroUsize::MIN.saturating_add(beam.chain.order());
        let elements = RollElements::new(degree);
        Self { model, beam, law: model.line_law(), material: model.material(), elements }
    }

    /// The stability of an equilibrium. Nothing where a number is not finite.
    pub fn stability(&self, at: &State) -> Option<RollStability> {
        self.stability_of(&self.rolling(at))
    }

    /// The same of what was read before.
    pub fn stability_of(&self, beam: &RollingBeam) -> Option<RollStability> {
        self.stability_of_sections(&beam.ends, beam.sections.iter().copied())
    }

    /// The same where a straight beam of one section is of another width, nm.
    pub fn stability_of_width(&self, beam: &RollingBeam, width: f64) -> Option<RollStability> {
        let outline = self.model.body.geometry().at(0.0);
        let lateral = LateralStiffness::of(&self.material, width, outline.height[0], outline.roundness);
        self.stability_of_sections(&beam.ends, beam.sections.iter().map(|section| section.widened(width, lateral)))
    }

    /// Without a force along the strip the roll alone is left, with one the turn about the normal as well.
    fn stability_of_sections(
        &self,
        ends: &[f64],
        sections: impl Iterator<Item = RollSection>,
    ) -> Option<RollStability> {
        if self.model.pull.direction() == Direction::UP && self.model.grip.horizontal == Hold::Free {
            self.elements.stability(ends, sections.map(|section| section.density()))
        } else {
            self.elements.coupled_stability(ends, sections.map(|section| section.coupled()))
        }
    }

    /// The sections of an equilibrium.
    pub fn rolling(&self, at: &State) -> RollingBeam {
        let beam = self.beam;
        let configuration = beam.configuration(at);
        let mut sections = Vec::with_capacity(at.mesh.elements() * self.elements.places_of_element());
        for (element, pair) in at.mesh.boundaries.windows(2).enumerate() {
            for local in self.elements.places() {
                let (values, state) = beam.chain.sample(configuration, element, local);
                let outline = self.model.body.geometry().at(pair[0] + 0.5 * (1.0 + local) * (pair[1] - pair[0]));
                let (sin, cos) = values[beam.rotation].sin_cos();
                let adhesion = self.law.response_of(outline.height[0], values[beam.rotation - 1], sin, cos);
                sections.push(RollSection::new(&self.material, &outline, &state, [sin, cos], &adhesion));
            }
        }
        RollingBeam { ends: at.mesh.boundaries.clone(), sections }
    }
}
