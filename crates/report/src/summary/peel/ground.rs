//! How a beam lies on ground that is not flat, as summary.json reports it.

use crate::number::Finite;
use peelkit::study::{Contact, Peel, SMALLEST_RADIUS};

/// [`Contact`] where the path begins, and the largest force of the whole path.
#[derive(Debug, serde::Serialize)]
pub(super) struct GroundSummary {
    adhered_fraction: Finite,
    energy_fraction: Finite,
    #[serde(rename = "least_gap_nm")]
    least_gap: Finite,
    #[serde(rename = "largest_gap_nm")]
    largest_gap: Finite,
    reach: Option<Finite>,
    #[serde(rename = "crest_radius_nm")]
    crest_radius: Option<Finite>,
    #[serde(rename = "valley_radius_nm")]
    valley_radius: Option<Finite>,
    crest_traction_error: Option<Finite>,
    valley_traction_error: Option<Finite>,
    #[serde(rename = "largest_force_nN")]
    largest_force: Option<Finite>,
    warning: Option<String>,
}

impl GroundSummary {
    pub fn of(peel: &Peel) -> Option<Self> {
        let contact = peel.contact(0)?;
        Some(Self {
            adhered_fraction: Finite(contact.adhered_fraction),
            energy_fraction: Finite(contact.energy_fraction),
            least_gap: Finite(contact.least_gap),
            largest_gap: Finite(contact.largest_gap),
            reach: contact.penetration.map(Finite),
            crest_radius: contact.crest_radius.map(Finite),
            valley_radius: contact.valley_radius.map(Finite),
            crest_traction_error: contact.crest_error.map(Finite),
            valley_traction_error: contact.valley_error.map(Finite),
            largest_force: peel.largest_force().map(Finite),
            warning: ground_warning(&contact),
        })
    }
}

/// What to be warned of: ground too sharp for the half space of eq. (9).
pub fn ground_warning(contact: &Contact) -> Option<String> {
    contact.sharp().map(|radius| {
        let worst = [contact.crest_error, contact.valley_error].into_iter().flatten().fold(0.0, |worst: f64, error| worst.max(error.abs()));
        format!(
            "the ground has a radius of curvature of {radius:.2} nm where the beam adheres, less than the {SMALLEST_RADIUS} nm down to which \
             the half space is a good approximation; its traction is wrong by about {:.1} % there",
            100.0 * worst
        )
    })
}
