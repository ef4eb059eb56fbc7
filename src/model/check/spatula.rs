//! Whether the lengths of a spatula fit one another.

use super::error::{ModelError, ModelErrorKind};
use crate::model::body::Body;
use crate::model::peel::PeelModel;

/// That the tip is rounded within the pad and narrows, and that the bend ends on the shaft.
pub(super) fn check(model: &PeelModel) -> Result<(), ModelError> {
    let Body::Spatula(spatula) = &model.body else { return Ok(()) };
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
