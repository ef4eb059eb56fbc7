//! Whether friction fits the rest.

use super::error::{Measured, ModelError, ModelErrorKind};
use crate::model::peel::PeelModel;

/// That it has a strength, on flat ground, under the half space, and without a pretension.
pub(super) fn check(model: &PeelModel) -> Result<(), ModelError> {
    let friction = &model.friction;
    let Some(strength) = friction.strength else {
        let coefficient = Some(friction.coefficient).filter(|&coefficient| coefficient > 0.0);
        let given = [("friction.coefficient", coefficient, ""), ("friction.presliding", friction.presliding, "nm")];
        let first = given.into_iter().find_map(|(key, value, unit)| Some((key, Measured { value: value?, unit })));
        let error = |(key, found)| Err(ModelError::new(key, ModelErrorKind::NoShearStrength { found }));
        return first.map_or(Ok(()), error);
    };
    let found = Measured { value: strength, unit: "GPa" };
    if !model.ground.substrate.is_flat() {
        return Err(ModelError::new("friction.strength", ModelErrorKind::FrictionOffFlatGround { found }));
    }
    if !model.adhesion.attraction.takes_friction() {
        return Err(ModelError::new("friction.strength", ModelErrorKind::FrictionBesideLaw { found }));
    }
    match model.grip.pretension {
        Some(value) => {
            let found = Measured { value, unit: "nN" };
            Err(ModelError::new("grip.pretension", ModelErrorKind::PretensionUnderFriction { found }))
        }
        None => Ok(()),
    }
}
