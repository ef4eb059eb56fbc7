//! Whether a model can be peeled in space.

use super::error::{ModelError, ModelErrorKind};
use crate::adhesion::spatial_section::section::SectionShape;
use crate::model::peel::PeelModel;

/// That it is on flat ground without friction, under a law that has an energy there; that only a strip has a section of a shape.
pub(super) fn check(model: &PeelModel) -> Result<(), ModelError> {
    let Some(space) = &model.space else { return Ok(()) };
    let not = |wrong: bool, key: &'static str, why: &'static str| match wrong {
        true => Err(ModelError::new(key, ModelErrorKind::NotInSpace { why })),
        false => Ok(()),
    };
    let shaped = space.section != SectionShape::Rectangle && model.strip().is_none();
    not(shaped, "strip.section", "it is the section of a strip")?;
    not(!model.ground.substrate.is_flat(), "substrate.shape", "the substrate is flat")?;
    not(model.friction.strength.is_some(), "friction.strength", "there is no friction")?;
    not(model.grip.pretension.is_some(), "grip.pretension", "the strip adheres without pretension")?;
    let of_law = |error| ModelError::new("adhesion.law", ModelErrorKind::LawInSpace(error));
    model.spatial_section(space).map(drop).map_err(of_law)
}
