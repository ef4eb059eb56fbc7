//! Whether the numbers of adhesion and grip are asked for.

use super::error::{Measured, ModelError, ModelErrorKind};
use crate::model::peel::{Hold, PeelModel};

/// That work and strength belong to the law, and that what has a pretension is stretched.
pub(super) fn check(model: &PeelModel) -> Result<(), ModelError> {
    let adhesion = &model.adhesion;
    if !adhesion.attraction.takes_work_and_strength() {
        let given = [("adhesion.work", adhesion.work, "J/m2"), ("adhesion.strength", adhesion.strength, "GPa")];
        for (key, value, unit) in given {
            if let Some(value) = value {
                let kind = ModelErrorKind::NotOfCohesiveLaw { found: Measured { value, unit } };
                return Err(ModelError::new(key, kind));
            }
        }
    }
    let stretched = model.strip().is_some() && model.ground.substrate.is_flat();
    match model.grip.pretension {
        Some(value) if !stretched || model.grip.horizontal == Hold::Free => {
            let found = Measured { value, unit: "nN" };
            Err(ModelError::new("grip.pretension", ModelErrorKind::NotStretched { found }))
        }
        _ => Ok(()),
    }
}
