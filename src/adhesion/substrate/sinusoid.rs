//! A wavy substrate.

use super::closest::{Graph, closest};
use super::surface::{ClosestPoint, Named, Surface};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// y = H/2 (cos(2π (x - x0)/λ) - 1): crests at y = 0, valleys at y = -H.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sinusoid {
    /// H from crest to valley, nm
    pub height: f64,
    /// λ, nm
    pub wavelength: f64,
    /// x0 of a crest, nm
    pub offset: f64,
}

/// Samples a wavelength, which separate the nearest points.
const SAMPLES: f64 = 48.0;

impl Sinusoid {
    /// y and its first three derivatives.
    pub fn at(&self, x: f64) -> [f64; 4] {
        let k = TAU / self.wavelength;
        let (sin, cos) = (k * (x - self.offset)).sin_cos();
        let a = 0.5 * self.height;
        // cos - 1 without cancellation near a crest
        let down = if cos > 0.0 { -sin * sin / (1.0 + cos) } else { cos - 1.0 };
        [a * down, -a * k * sin, -a * k * k * cos, a * k * k * k * sin]
    }

    /// The smallest radius of curvature, of crests and of valleys alike, nm: λ²/(2π² H).
    pub fn radius(&self) -> f64 {
        (self.wavelength / TAU).powi(2) / (0.5 * self.height)
    }
}

/// As scenes name it.
pub(super) const NAMED: &[Named<Sinusoid>] =
    &[("sinusoid", || Sinusoid { height: f64::NAN, wavelength: f64::NAN, offset: 0.0 })];

impl Surface for Sinusoid {
    fn name(&self) -> &'static str {
        "sinusoid"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["height", "wavelength", "offset", "start"]
    }

    fn number(&mut self, key: &str) -> Option<&mut f64> {
        match key {
            "height" => Some(&mut self.height),
            "wavelength" => Some(&mut self.wavelength),
            "offset" => Some(&mut self.offset),
            _ => None,
        }
    }

    fn clearance(&self, x: f64, y: f64) -> f64 {
        y - self.at(x)[0]
    }

    fn peak_to_valley(&self) -> f64 {
        self.height
    }

    fn feature_length(&self) -> f64 {
        self.wavelength
    }

    fn project(&self, x: f64, y: f64) -> ClosestPoint {
        let k = TAU / self.wavelength;
        let bend = 0.5 * self.height * k * k;
        let graph = Graph { ceiling: 0.0, top: 0.0, bottom: -self.height, bend, step: self.wavelength / SAMPLES };
        // from far away, the nearest crest is a good first guess
        let crest = self.offset + ((x - self.offset) / self.wavelength).round() * self.wavelength;
        closest(|s| self.at(s), &graph, [x, crest], (x, y))
    }

    fn top(&self, from: f64, to: f64) -> f64 {
        let crest = self.offset + ((from - self.offset) / self.wavelength).ceil() * self.wavelength;
        if crest <= to { 0.0 } else { self.at(from)[0].max(self.at(to)[0]) }
    }
}
