//! The table of a pull at a rate, curve.csv. Units stand in the names of the columns.

use super::energies::Energies;
use super::pulled::{Contact, PointAtRate, PulledAtRate};
use crate::error::ReportError;
use crate::number::{Finite, S_PER_NS};
use crate::tables::write_table;
use serde::Serialize;
use std::path::{Path, PathBuf};

#[derive(Default, Serialize)]
struct Place {
    time_s: Finite,
    displacement_nm: Finite,
    #[serde(rename = "force_nN")]
    force: Finite,
}

#[derive(Default, Serialize)]
struct Front {
    front_nm: Finite,
}

#[derive(Default, Serialize)]
struct Tips {
    tips_attached: usize,
    #[serde(rename = "tip_forces_nN")]
    force: Finite,
    #[serde(rename = "released_aJ")]
    released: Finite,
}

impl From<&PointAtRate> for Place {
    fn from(point: &PointAtRate) -> Self {
        Self {
            time_s: Finite(S_PER_NS * point.time),
            displacement_nm: Finite(point.displacement),
            force: Finite(point.force),
        }
    }
}

/// Writes curve.csv: one row a step in time, from rest on; of a seta another one behind each event.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_rate_curve(dir: &Path, pulled: &PulledAtRate) -> Result<PathBuf, ReportError> {
    let fronts = pulled.points.iter().filter_map(|point| match point.contact {
        Contact::Front(front) => {
            Some((Place::from(point), Front { front_nm: Finite(front) }, Energies::from(point.balance)))
        }
        Contact::Tips { .. } => None,
    });
    let tips = pulled.points.iter().filter_map(|point| match point.contact {
        Contact::Front(_) => None,
        Contact::Tips { attached, force, released } => {
            let own = Tips { tips_attached: attached, force: Finite(force), released: Finite(released) };
            Some((Place::from(point), own, Energies::from(point.balance)))
        }
    });
    match pulled.points.first().map(|point| point.contact) {
        Some(Contact::Tips { .. }) => write_table(dir, "curve.csv", tips),
        _ => write_table(dir, "curve.csv", fronts),
    }
}
