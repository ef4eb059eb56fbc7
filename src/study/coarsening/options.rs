//! Which places of its end a table of a tip holds, and how accurately.

use super::place::PadEnd;
use serde::{Deserialize, Serialize};

/// Which places of its end a table holds.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct TipRange {
    /// How far below the height without a normal force it begins, nm, zero or above
    pub press: f64,
    /// v, from and to, nm; of no use where the pad slides
    pub lateral: [f64; 2],
    /// θ, from and to, rad
    pub rotation: [f64; 2],
}

impl TipRange {
    /// Of a pad whose end slides: pressed by 50 nm, ±0.4 rad.
    pub const SLIDING: Self = Self { press: 50.0, lateral: [0.0; 2], rotation: [-0.4, 0.4] };
    /// Of a pad whose end is held: pressed by 5 nm, ±10 nm along the substrate, ±0.1 rad.
    pub const HELD: Self = Self { press: 5.0, lateral: [-10.0, 10.0], rotation: [-0.1, 0.1] };

    /// The default for a pad end.
    pub const fn of(pad_end: PadEnd) -> Self {
        match pad_end {
            PadEnd::Held => Self::HELD,
            PadEnd::Sliding => Self::SLIDING,
        }
    }
}

/// How a table of a tip is made.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct CoarseningOptions {
    /// What the free end of the pad does
    pub pad_end: PadEnd,
    /// Which places it holds
    pub range: TipRange,
    /// Error wanted of forces and moment, over the largest of each in the table
    pub tolerance: f64,
    /// Most columns, pairs of v and θ at which a branch is followed, those that check the table among them
    pub most_columns: usize,
}

impl CoarseningOptions {
    /// What a tolerance may be.
    pub const TOLERANCES: [f64; 2] = [1e-6, 0.1];

    /// The default ranges of a pad end, to 1e-3.
    pub const fn of(pad_end: PadEnd) -> Self {
        Self { pad_end, range: TipRange::of(pad_end), tolerance: 1e-3, most_columns: 4000 }
    }

    /// Whether its numbers have a meaning.
    ///
    /// # Errors
    /// The number that has none.
    pub fn check(&self) -> Result<(), OptionsError> {
        let [least, most] = Self::TOLERANCES;
        let TipRange { press, lateral, rotation } = self.range;
        if !(least..=most).contains(&self.tolerance) {
            return Err(OptionsError::Tolerance { tolerance: self.tolerance, least, most });
        }
        if !(press.is_finite() && press >= 0.0) {
            return Err(OptionsError::Press { press });
        }
        let ranges = [("lateral", lateral, "nm"), ("rotation", rotation, "rad")];
        for (name, [from, to], unit) in ranges {
            let needed = name == "rotation" || self.pad_end == PadEnd::Held;
            if needed && !(from.is_finite() && to.is_finite() && from <= 0.0 && 0.0 <= to && from < to) {
                return Err(OptionsError::Range { name, from, to, unit });
            }
        }
        Ok(())
    }
}

/// Why options have no meaning.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum OptionsError {
    #[error("the tolerance {tolerance} is out of range: give {least} to {most}")]
    Tolerance { tolerance: f64, least: f64, most: f64 },
    #[error("the spatula is pressed by {press} nm: give a length of zero or above")]
    Press { press: f64 },
    #[error("the {name} range from {from} to {to} {unit} does not hold zero with room about it: give it as from,to")]
    Range { name: &'static str, from: f64, to: f64, unit: &'static str },
}
