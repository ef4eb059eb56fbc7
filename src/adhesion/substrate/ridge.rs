//! A parabolic ridge.

use super::closest::{Graph, closest};
use super::surface::{ClosestPoint, Named, ONE_CREST, Surface, of_one_crest};
use serde::{Deserialize, Serialize};

/// y = -(x - x0)²/(2R): an asperity across the beam, whose flanks fall away without an end, unlike those of a cylinder. Its crest is at y = 0.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ridge {
    /// R, radius of curvature of the crest, nm
    pub radius: f64,
    /// x0 of the crest, nm
    pub offset: f64,
}

impl Ridge {
    /// y and its first three derivatives.
    pub fn at(&self, x: f64) -> [f64; 4] {
        let across = x - self.offset;
        [-0.5 * across * across / self.radius, -across / self.radius, -self.radius.recip(), 0.0]
    }
}

/// As scenes name it.
pub(super) const NAMED: &[Named<Ridge>] = &[("ridge", || Ridge { radius: f64::NAN, offset: 0.0 })];

impl Surface for Ridge {
    fn name(&self) -> &'static str {
        "ridge"
    }

    fn keys(&self) -> &'static [&'static str] {
        ONE_CREST
    }

    fn number(&mut self, key: &str) -> Option<&mut f64> {
        of_one_crest(key, &mut self.radius, &mut self.offset)
    }

    fn clearance(&self, x: f64, y: f64) -> f64 {
        y - self.at(x)[0]
    }

    fn feature_length(&self) -> f64 {
        self.radius
    }

    /// In front of a convex curve there is one nearest point: it is looked for as where nothing bends.
    fn project(&self, x: f64, y: f64) -> ClosestPoint {
        let graph = Graph { ceiling: 0.0, top: 0.0, bottom: 0.0, bend: 0.0, step: self.radius };
        closest(|s| self.at(s), &graph, [x; 2], (x, y))
    }

    fn top(&self, from: f64, to: f64) -> f64 {
        self.at(self.offset.clamp(from.min(to), from.max(to)))[0]
    }
}
