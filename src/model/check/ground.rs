//! Whether the ground fits the rest.

use super::error::{ModelError, ModelErrorKind};
use crate::adhesion::section::line_load::LineLoad;
use crate::model::peel::PeelModel;

/// Most waves or radii, and most process zones, on which a beam lies on ground that is not flat.
const MOST_DETAILS: f64 = 100.0;
const MOST_ZONES: f64 = 3000.0;

/// On ground that is not flat: that the load has a potential, that elements resolve the ground, and that its own numbers fit.
pub(super) fn check(model: &PeelModel) -> Result<(), ModelError> {
    let substrate = &model.ground.substrate;
    if substrate.is_flat() {
        return Ok(());
    }
    if !model.line_law().has_potential() {
        let (key, load) = match model.adhesion.line_load {
            LineLoad::ForceOnly => ("adhesion.line_load", "force-only"),
            LineLoad::Full | LineLoad::AxisGap => ("adhesion.law", model.adhesion.attraction.name()),
        };
        return Err(ModelError::new(key, ModelErrorKind::NoPotentialOnGround { load }));
    }
    let contact_extent = model.contact_extent();
    let details = contact_extent / substrate.feature_length();
    if details > MOST_DETAILS {
        let kind = ModelErrorKind::TooManyDetails { found: details, most: MOST_DETAILS };
        return Err(ModelError::new("substrate.shape", kind));
    }
    let zones = contact_extent / model.process_length();
    if zones > MOST_ZONES {
        let kind = ModelErrorKind::TooManyZones { found: zones, most: MOST_ZONES };
        return Err(ModelError::new("substrate.shape", kind));
    }
    let misfit = substrate.misfit();
    misfit.map_or(Ok(()), |misfit| Err(ModelError::new(misfit.key, ModelErrorKind::Substrate(misfit))))
}
