//! How a beam has slid, as summary.json reports it.

use crate::number::Finite;
use peelkit::study::{Peel, Sliding};

/// [`Sliding`] at the initiation peak.
#[derive(Debug, serde::Serialize)]
pub(super) struct SlidingSummary {
    #[serde(rename = "free_end_displacement_nm")]
    free_end: Finite,
    #[serde(rename = "friction_force_nN")]
    force: Finite,
    #[serde(rename = "largest_friction_force_nN")]
    capacity: Finite,
    #[serde(rename = "contact_length_nm")]
    contact: Finite,
    #[serde(rename = "sliding_length_nm")]
    sliding: Finite,
    #[serde(rename = "dissipated_aJ")]
    dissipated: Finite,
}

impl SlidingSummary {
    pub fn of(peel: &Peel) -> Option<Self> {
        let Sliding { free_end, force, capacity, contact, sliding, dissipated, .. } = peel.sliding_at_peak()?;
        Some(Self {
            free_end: Finite(free_end),
            force: Finite(force),
            capacity: Finite(capacity),
            contact: Finite(contact),
            sliding: Finite(sliding),
            dissipated: Finite(dissipated),
        })
    }
}
