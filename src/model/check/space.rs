//! Whether a model can be peeled in space.

use super::{ModelError, ModelErrorKind};
use crate::model::PeelModel;

/// That it is a strip on flat ground without friction, under a law that has an energy there.
pub(super) fn check(model: &PeelModel) -> Result<(), ModelError> {
    let Some(space) = &model.space else { return Ok(()) };
    let not = |wrong: bool, key: &'static str, why: &'static str| match wrong {
        true => Err(ModelError::new(key, ModelErrorKind::NotInSpace { why })),
        false => Ok(()),
    };
    not(model.strip().is_none(), model.body.geometry().name(), "the body is a strip")?;
    not(!model.ground.substrate.is_flat(), "substrate.shape", "the substrate is flat")?;
    not(model.friction.strength.is_some(), "friction.strength", "there is no friction")?;
    not(model.grip.pretension.is_some(), "grip.pretension", "the strip adheres without pretension")?;
    let of_law = |error| ModelError::new("adhesion.law", ModelErrorKind::LawInSpace(error));
    model.spatial_section(space).map(drop).map_err(of_law)
}
