//! Whether the lengths of a body fit one another.

use super::error::{ModelError, ModelErrorKind};
use crate::model::body::Body;
use crate::model::body::spatula::Spatula;
use crate::model::body::strip::Strip;
use crate::model::peel::PeelModel;

/// That of its body.
pub(super) fn check(model: &PeelModel) -> Result<(), ModelError> {
    match &model.body {
        Body::Strip(strip) => strip_with_crack(strip, model),
        Body::Spatula(spatula) => spatula_tip(spatula),
        Body::Profile(_) => Ok(()),
    }
}

/// That a crack leaves a part that adheres, and that the rest of the scene is computed beside one.
fn strip_with_crack(strip: &Strip, model: &PeelModel) -> Result<(), ModelError> {
    let Some(found) = strip.crack else { return Ok(()) };
    let refused = |kind| Err(ModelError::new("strip.crack", kind));
    if found >= strip.length {
        return refused(ModelErrorKind::CrackOfWholeLength { found, length: strip.length });
    }
    let beside = [
        (model.space.is_some(), "a scene in space"),
        (model.friction.strength.is_some(), "friction"),
        (model.grip.pretension.is_some(), "a pretension"),
        (!model.ground.substrate.is_flat(), "ground that is not flat"),
    ];
    let wrong = beside.into_iter().find(|(is_given, _)| *is_given);
    wrong.map_or(Ok(()), |(_, what)| refused(ModelErrorKind::CrackBeside { what }))
}

/// That the tip is rounded within the pad and narrows, and that the bend ends on the shaft.
fn spatula_tip(spatula: &Spatula) -> Result<(), ModelError> {
    let (rounding, pad) = (spatula.tip_rounding_length, spatula.pad_length);
    if rounding > pad {
        let kind = ModelErrorKind::RoundingBeyondPad { found: rounding, pad };
        return Err(ModelError::new("spatula.tip_rounding_length", kind));
    }
    let (width, tip) = (spatula.tip_rounding_width, spatula.tip_width);
    if rounding > 0.0 && width > tip {
        let kind = ModelErrorKind::RoundingWiderThanTip { found: width, tip };
        return Err(ModelError::new("spatula.tip_rounding_width", kind));
    }
    let (bend, behind) = (spatula.bend_length, spatula.neck_length + spatula.shaft_length);
    if bend > behind {
        let kind = ModelErrorKind::BendBeyondShaft { found: bend, behind };
        return Err(ModelError::new("spatula.bend_length", kind));
    }
    Ok(())
}
