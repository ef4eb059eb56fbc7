//! Whether a beam is so short that elements and steps resolve its process zone.

use super::error::{ModelError, ModelErrorKind};
use crate::model::body::Body;
use crate::model::body::profile::ProfileForm;
use crate::model::body::spatula::Spatula;
use crate::model::peel::PeelModel;

/// Most process zones: the strip of the paper of 3 mm is 1.4e6 of them long and has its peak to 1e-10; that of 10 mm, of 4.6e6, has none.
const MOST_ZONES: f64 = 2e6;

/// That the beam is no longer than so many of its process zones, before anything of its size is made.
pub(super) fn check(model: &PeelModel) -> Result<(), ModelError> {
    let zones = model.length() / model.process_length();
    if zones > MOST_ZONES {
        return Err(ModelError::new(key(&model.body), ModelErrorKind::TooLong { found: zones, most: MOST_ZONES }));
    }
    Ok(())
}

/// What makes a body long.
fn key(body: &Body) -> &'static str {
    match body {
        Body::Strip(_) => "strip.length",
        Body::Profile(profile) => match profile.form {
            ProfileForm::Table(_) => "profile.table",
            ProfileForm::Pieces(_) => "profile.pieces",
        },
        Body::Spatula(Spatula { pad_length, neck_length, shaft_length, .. }) => {
            let lengths = [
                ("spatula.pad_length", pad_length),
                ("spatula.neck_length", neck_length),
                ("spatula.shaft_length", shaft_length),
            ];
            lengths.iter().max_by(|a, b| a.1.total_cmp(b.1)).map_or("spatula.pad_length", |longest| longest.0)
        }
    }
}
