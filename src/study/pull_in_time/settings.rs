//! How a grip is pulled in time, and how accurately that is followed.

#[cfg(doc)]
use crate::model::peel::PeelModel;
use crate::solve::time::drive::Ramp;

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
    /// On how much of the way the grip accelerates, and on how much it comes to rest, nm; none: a tenth of [`PeelModel::first_way`]. A jump in
    /// velocity makes a force of its own.
    pub accelerates: Option<f64>,
    /// Where it ends
    pub until: Until,
}

impl PullRate {
    /// From the displacement zero on until nothing adheres.
    pub const fn new(to: f64, rate: f64) -> Self {
        Self { from: 0.0, to, rate, accelerates: None, until: Until::ContactLost }
    }

    /// Displacement in time, with accelerations on so much of the way, at most a quarter of it.
    pub(super) fn ramp(&self, accelerates: f64) -> Ramp {
        let way = (self.to - self.from).abs();
        Ramp::new(self.from, self.to, self.rate, 2.0 * accelerates / way)
    }
}

/// How accurately a pull in time is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeAccuracy {
    /// Elements, of a fixed mesh; none: as many as make them two process lengths long, and a dozen more
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
