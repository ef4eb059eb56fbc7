//! Whether the numbers of adhesion and grip are asked for.

use super::error::{Measured, ModelError, ModelErrorKind};
use crate::adhesion::section::line_load::LineLoad;
use crate::model::peel::{Hold, PeelModel};

/// That work and strength belong to the law, and that what has a pretension is stretched.
pub(super) fn check(model: &PeelModel) -> Result<(), ModelError> {
    let adhesion = &model.adhesion;
    if !adhesion.attraction.takes_work_and_strength() {
        let given = [
            ("adhesion.work", adhesion.work, "J/m2"),
            ("adhesion.strength", adhesion.strength, "GPa"),
            ("adhesion.shear_strength", adhesion.shear_strength, "GPa"),
        ];
        for (key, value, unit) in given {
            if let Some(value) = value {
                let kind = ModelErrorKind::NotOfCohesiveLaw { found: Measured { value, unit } };
                return Err(ModelError::new(key, kind));
            }
        }
    }
    shear_strength(model)?;
    let stretched = model.strip().is_some() && model.ground.substrate.is_flat();
    match model.grip.pretension {
        Some(value) if !stretched || model.grip.horizontal == Hold::Free => {
            let found = Measured { value, unit: "nN" };
            Err(ModelError::new("grip.pretension", ModelErrorKind::NotStretched { found }))
        }
        _ => Ok(()),
    }
}

/// That what holds along the ground is a strip on flat ground in the plane, with the contact moment and without pretension.
fn shear_strength(model: &PeelModel) -> Result<(), ModelError> {
    if model.adhesion.shear_strength.is_none() {
        return Ok(());
    }
    let beside = [
        (model.strip().is_none(), "a body that is no strip"),
        (model.space.is_some(), "`space`"),
        (!model.ground.substrate.is_flat(), "ground that is not flat"),
        (model.grip.pretension.is_some(), "`grip.pretension`"),
        (model.adhesion.line_load != LineLoad::Full, "a `line_load` that is not \"full\""),
    ];
    let wrong = beside.into_iter().find(|(is_given, _)| *is_given);
    let refused = |what| Err(ModelError::new("adhesion.shear_strength", ModelErrorKind::ShearBeside { what }));
    wrong.map_or(Ok(()), |(_, what)| refused(what))
}
