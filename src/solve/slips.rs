//! What the material points of a chain remember of their sliding.

use crate::adhesion::Slip;
use serde::{Deserialize, Serialize};

/// The slips along a chain, on a grid of S that no mesh moves. Between its places they are interpolated by cubics.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Slips {
    /// From one place to the next, nm
    spacing: f64,
    known: Vec<Slip>,
    /// Energy dissipated since the beginning, aJ
    pub dissipated: f64,
}

/// Fewest and most steps from place to place.
const FEWEST: usize = 16;
const MOST: usize = 100_000;

impl Slips {
    /// Of a chain of this length (nm) that has not slid, with about `spacing` (nm) from one place to the next.
    pub fn none(length: f64, spacing: f64, at: impl Fn(f64) -> Slip) -> Self {
        let steps = ((length / spacing).ceil() as usize).clamp(FEWEST, MOST);
        let spacing = length / steps as f64;
        Self { spacing, known: (0..=steps).map(|k| at(k as f64 * spacing)).collect(), dissipated: 0.0 }
    }

    /// Where the face was (nm) and the share that it carried, at the material point S.
    pub fn at(&self, s: f64) -> [f64; 2] {
        let along = s / self.spacing;
        let first = (along.floor() as usize).clamp(1, self.known.len() - 3) - 1;
        let t = along - first as f64;
        let weights = [
            (t - 1.0) * (t - 2.0) * (t - 3.0) / -6.0,
            t * (t - 2.0) * (t - 3.0) / 2.0,
            t * (t - 1.0) * (t - 3.0) / -2.0,
            t * (t - 1.0) * (t - 2.0) / 6.0,
        ];
        let mixed = |of: fn(&Slip) -> f64| (0..4).map(|k| weights[k] * of(&self.known[first + k])).sum();
        [mixed(|slip| slip.place), mixed(|slip| slip.share)]
    }

    /// ∫ τ dS, the friction that the contact bears per width, nN/nm.
    pub fn capacity(&self) -> f64 {
        self.spacing * self.known.iter().map(|slip| slip.limit).sum::<f64>()
    }

    /// ∫ t dS, what of it is carried, likewise; its sign is that of the way gone.
    pub fn carried(&self) -> f64 {
        self.spacing * self.known.iter().map(|slip| slip.share * slip.limit).sum::<f64>()
    }

    /// S of each place (nm), with what it remembers.
    pub fn iter(&self) -> impl Iterator<Item = (f64, Slip)> {
        self.known.iter().enumerate().map(|(k, &slip)| (k as f64 * self.spacing, slip))
    }

    /// Behind a step: `remembered` tells of S and what was remembered there what is now, and what was dissipated, nN per length.
    pub(super) fn moved(&self, mut remembered: impl FnMut(f64, Slip) -> (Slip, f64)) -> Self {
        let mut next = self.clone();
        let last = self.known.len() - 1;
        for (k, slip) in next.known.iter_mut().enumerate() {
            let share = if k == 0 || k == last { 0.5 } else { 1.0 };
            let lost;
            (*slip, lost) = remembered(k as f64 * self.spacing, *slip);
            next.dissipated += share * self.spacing * lost;
        }
        next
    }
}
