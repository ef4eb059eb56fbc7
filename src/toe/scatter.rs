//! Heights and strengths of setae that differ: from a fixed sequence, the same on every machine.

use serde::{Deserialize, Serialize};

/// One over the golden section, (√5 - 1)/2.
const GOLDEN: f64 = 0.618_033_988_749_894_8;
/// One over the plastic number: its multiples are spread evenly beside those of the golden section.
const PLASTIC: f64 = 0.754_877_666_246_692_7;

/// How far setae differ from one another.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Scatter {
    /// Heights are spread evenly over ± this, nm
    pub height: f64,
    /// Strengths are spread evenly over 1 ± this
    pub strength: f64,
    /// How far the sequence is shifted
    pub seed: u64,
}

/// A seta among others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RootOffset {
    /// How far its place of rest is above the others', nm
    pub height: f64,
    /// What scales its exits
    pub strength: f64,
}

impl Scatter {
    /// Of the seta with a number, from 0 on.
    ///
    /// With i one more than number and seed, its strength is 1 + a (2 frac(0.6180339887 i) - 1). So is its height without scatter of strengths;
    /// with both, heights take frac(0.7548776662 i): strong setae are not the high ones.
    pub fn of(&self, number: usize) -> RootOffset {
        let i = (number as u64 + self.seed + 1) as f64;
        let even = |step: f64| 2.0 * (step * i).fract() - 1.0;
        let of_heights = if self.strength == 0.0 { GOLDEN } else { PLASTIC };
        RootOffset { height: self.height * even(of_heights), strength: 1.0 + self.strength * even(GOLDEN) }
    }
}
