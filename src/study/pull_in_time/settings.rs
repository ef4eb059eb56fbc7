//! How a grip is pulled in time, and how accurately that is followed.

use crate::solve::time::Ramp;

/// Where a pull in time ends.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Until {
    /// Where nothing adheres any more, or at the end of the way
    #[default]
    ContactLost,
    /// So long after the grip has come to rest, ns
    Held(f64),
}

/// How what moves the grip goes: from rest at one displacement to rest at another, at a constant rate in between.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PullRate {
    /// Displacement at which the beam is in equilibrium before, nm
    pub from: f64,
    /// Displacement of the end of the way, nm
    pub to: f64,
    /// nm/ns = m/s
    pub rate: f64,
    /// Over which share of the way's duration the grip accelerates, and over which it comes to rest: a jump in velocity makes a force of its own
    pub smooth: f64,
    /// Where it ends
    pub until: Until,
}

impl PullRate {
    /// From the displacement zero on until nothing adheres, with accelerations over a tenth of the way.
    pub const fn new(to: f64, rate: f64) -> Self {
        Self { from: 0.0, to, rate, smooth: 0.1, until: Until::ContactLost }
    }

    /// Displacement in time.
    pub fn ramp(&self) -> Ramp {
        Ramp::new(self.from, self.to, self.rate, self.smooth)
    }
}

/// How accurately a pull in time is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeAccuracy {
    /// Elements, of a mesh that stays; none: as many as make them two process lengths long, and a dozen more
    pub elements: Option<usize>,
    /// Order of the elements, 1 to 8
    pub order: usize,
    /// Error of a step in time, in units of the gap at rest next to the substrate
    pub tolerance: f64,
    /// ρ∞: what is left, a step, of vibrations that are faster than steps
    pub spectral_radius: f64,
    /// Most steps
    pub most_steps: usize,
}

impl Default for TimeAccuracy {
    fn default() -> Self {
        Self { elements: None, order: 7, tolerance: 2e-6, spectral_radius: 0.8, most_steps: 100_000 }
    }
}
