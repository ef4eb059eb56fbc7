//! The energies of a pull at a rate, as they stand in curve.csv and in summary.json.

use crate::number::Finite;
use peelkit::solve::time::EnergyBalance;
use serde::Serialize;

/// What becomes of the work.
#[derive(Debug, Default, Serialize)]
pub(super) struct Energies {
    #[serde(rename = "work_aJ")]
    work: Finite,
    #[serde(rename = "stored_aJ")]
    stored: Finite,
    #[serde(rename = "adhesion_aJ")]
    adhesion: Finite,
    #[serde(rename = "spring_aJ")]
    spring: Finite,
    #[serde(rename = "kinetic_aJ")]
    kinetic: Finite,
    #[serde(rename = "dissipated_aJ")]
    dissipated: Finite,
}

impl From<EnergyBalance> for Energies {
    fn from(balance: EnergyBalance) -> Self {
        Self {
            work: Finite(balance.work),
            stored: Finite(balance.stored),
            adhesion: Finite(balance.adhesion),
            spring: Finite(balance.spring),
            kinetic: Finite(balance.kinetic),
            dissipated: Finite(balance.dissipated),
        }
    }
}
