//! The shape of the substrate: where it is nearest, eq. (8), and how it lies there.
//!
//! A substrate is a curve in the plane of the beam, with the solid below it. Its crests are at y = 0, but for a measured
//! profile, whose heights are its own. At the nearest point of (x, y), with t = (cos φ, sin φ) along the curve, the normal
//! n = (-sin φ, cos φ) away from the solid, κ = dφ/dσ (σ the length along the curve; positive in a valley), κ' = dκ/dσ and
//! μ = κ/(1 - κd):
//!
//!   ∇d = n,   ∇φ = μ t,   ∇∇d = -μ t⊗t,   ∇∇φ = κ'/(1 - κd)³ t⊗t + μ² (t⊗n + n⊗t).
//!
//! They follow from p = c(σ) + d n, whose change is dp = t (1 - κd) dσ + n dd, and dt = n dφ, dn = -t dφ.
//!
//! Several points of the curve may be near, and the nearest counts. Where two are equally near (above a valley, farther from
//! it than its centre of curvature) the distance is continuous and its gradient is not. What that costs is stated in
//! [`Foot::runner_up`].

mod closest;
mod heights;
mod response;
mod round;
mod self_affine;
mod sinusoid;
pub use heights::{Heights, HeightsError};
pub use response::{GroundLaw, GroundResponse};
pub use round::Round;
pub use self_affine::SelfAffine;
pub use sinusoid::Sinusoid;

use std::sync::Arc;

/// What a beam lies on. To add a shape is to add a file with its curve, and a line here and in each `match` below.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Substrate {
    /// y = 0.
    #[default]
    Flat,
    /// A sphere or a cylinder across the beam: for a beam in their plane of symmetry both are a circle.
    Round(Round),
    /// y = H/2 (cos(2π (x - x0)/λ) - 1).
    Sinusoid(Sinusoid),
    /// Heights by a table.
    Profile(Arc<Heights>),
}

/// The nearest point of a substrate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Foot {
    /// d, nm; negative within the solid
    pub distance: f64,
    /// Where it is along x, nm
    pub place: f64,
    /// sin φ and cos φ of the substrate there
    pub sin: f64,
    pub cos: f64,
    /// κ, 1/nm; positive in a valley
    pub curvature: f64,
    /// κ', 1/nm²
    pub curvature_slope: f64,
    /// Distance of the next nearest of the candidates, nm; infinite where there is one alone.
    ///
    /// Where it equals `distance` the energy of a section is continuous and its force jumps from T n₁ to T n₂. That happens
    /// no nearer than the radius of the valley between the two, ρ, so that the jump is at most 2 T(ρ - h/2), to be compared
    /// with the largest attraction T(5^(-1/6) r0): 6e-7 of it for the valleys of the paper's sinusoid, ρ = 63.3 nm, under a
    /// strip 10 nm high.
    pub runner_up: f64,
}

impl Foot {
    /// Level ground with this height above it.
    fn level(place: f64, distance: f64) -> Self {
        let runner_up = f64::INFINITY;
        Self { distance, place, sin: 0.0, cos: 1.0, curvature: 0.0, curvature_slope: 0.0, runner_up }
    }
}

impl Substrate {
    /// Whether it is plane and level.
    pub fn is_flat(&self) -> bool {
        matches!(self, Self::Flat)
    }

    /// The nearest point of (x, y), nm. NaN where a coordinate is.
    #[inline(never)]
    pub fn foot(&self, x: f64, y: f64) -> Foot {
        match self {
            Self::Flat => Foot::level(x, y),
            Self::Round(round) => round.foot(x, y),
            Self::Sinusoid(sinusoid) => sinusoid.foot(x, y),
            Self::Profile(heights) => heights.foot(x, y),
        }
    }

    /// About how far (x, y) is above the substrate, nm: along y, or from the centre of a circle.
    pub fn clearance(&self, x: f64, y: f64) -> f64 {
        match self {
            Self::Flat => y,
            Self::Round(round) => round.foot(x, y).distance,
            Self::Sinusoid(sinusoid) => y - sinusoid.at(x)[0],
            Self::Profile(heights) => y - heights.at(x)[0],
        }
    }

    /// The highest point between two places, nm.
    pub fn top(&self, from: f64, to: f64) -> f64 {
        match self {
            Self::Flat => 0.0,
            Self::Round(round) => round.top(from, to),
            Self::Sinusoid(sinusoid) => sinusoid.top(from, to),
            Self::Profile(heights) => heights.top(from, to),
        }
    }

    /// How high it may rise above where a beam lies on it, nm: from valley to crest; zero where it has no valley.
    pub fn relief(&self) -> f64 {
        match self {
            Self::Flat | Self::Round(_) => 0.0,
            Self::Sinusoid(sinusoid) => sinusoid.height,
            Self::Profile(heights) => heights.relief(),
        }
    }

    /// The length in which it changes, nm: no element may be much longer. Infinite where it is the same everywhere.
    pub fn detail(&self) -> f64 {
        match self {
            Self::Flat => f64::INFINITY,
            Self::Round(round) => round.radius,
            Self::Sinusoid(sinusoid) => sinusoid.wavelength,
            Self::Profile(heights) => heights.detail(),
        }
    }

    /// The place at this distance above x, nm: the y that is `distance` from the substrate.
    pub fn above(&self, x: f64, distance: f64) -> f64 {
        let mut y = self.top(x - distance, x + distance) + distance;
        // the distance is concave along a line on a convex body and at most as steep as the line: the steps stay above
        for _ in 0..MOST_LEVELLING {
            let off = self.foot(x, y).distance - distance;
            y -= off;
            if off.abs() <= LEVELLED * distance {
                break;
            }
        }
        y
    }

    /// The line that keeps this distance to the substrate, from above x = 0 on: x, y and φ at each of the ascending lengths
    /// `places` along it, nm. Valleys narrower than the distance are passed over, as by a ball that rolls.
    pub fn along(&self, distance: f64, places: &[f64]) -> Vec<[f64; 3]> {
        let (mut x, mut y, mut here) = (0.0, self.above(0.0, distance), 0.0);
        let step = (0.02 * distance).min(0.005 * self.detail());
        let line = places.iter().map(|&place| {
            let steps = ((place - here) / step).ceil().clamp(0.0, MOST_A_PLACE);
            for _ in 0..steps as usize {
                let length = (place - here) / steps;
                let from = self.foot(x, y);
                // the middle of the step, its direction, and back to the distance
                let middle = self.foot(x + 0.5 * length * from.cos, y + 0.5 * length * from.sin);
                (x, y) = (x + length * middle.cos, y + length * middle.sin);
                let to = self.foot(x, y);
                (x, y) = (x + (to.distance - distance) * to.sin, y - (to.distance - distance) * to.cos);
            }
            here = place;
            let foot = self.foot(x, y);
            [x, y, foot.sin.atan2(foot.cos)]
        });
        line.collect()
    }
}

/// Steps that lower a point to a distance, and how near they come, relative.
const MOST_LEVELLING: usize = 200;
const LEVELLED: f64 = 1e-13;

/// Steps along a line from place to place.
const MOST_A_PLACE: f64 = 1e3;

#[cfg(test)]
mod tests;
