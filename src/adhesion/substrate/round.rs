//! A sphere or a cylinder.

use super::surface::{ClosestPoint, Misfit, Named, ONE_CREST, Surface, of_one_crest};
use crate::adhesion::levels::curved::BodyShape;
use serde::{Deserialize, Serialize};

/// A sphere, or a cylinder whose axis is across the beam. Its top is at y = 0.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Round {
    /// Which of the two
    pub shape: BodyShape,
    /// R, nm
    pub radius: f64,
    /// x of its top, nm
    pub offset: f64,
}

/// As scenes name them.
pub(super) const NAMED: &[Named<Round>] =
    &[("sphere", || new(BodyShape::Sphere)), ("cylinder", || new(BodyShape::Cylinder))];

fn new(shape: BodyShape) -> Round {
    Round { shape, radius: f64::NAN, offset: 0.0 }
}

impl Surface for Round {
    fn name(&self) -> &'static str {
        match self.shape {
            BodyShape::Sphere => "sphere",
            BodyShape::Cylinder => "cylinder",
        }
    }

    fn keys(&self) -> &'static [&'static str] {
        ONE_CREST
    }

    fn number(&mut self, key: &str) -> Option<&mut f64> {
        of_one_crest(key, &mut self.radius, &mut self.offset)
    }

    fn misfit(&self) -> Option<Misfit> {
        let Self { radius, offset, .. } = self;
        (offset.abs() >= *radius).then(|| Misfit {
            key: "substrate.offset",
            found: format!("is {offset} nm, and the strip begins beside the body, whose radius is {radius} nm"),
            remedy: "Let the strip begin above it: an `offset` less than `radius`.",
        })
    }

    fn clearance(&self, x: f64, y: f64) -> f64 {
        self.project(x, y).distance
    }

    fn feature_length(&self) -> f64 {
        self.radius
    }

    fn crest(&self) -> BodyShape {
        self.shape
    }

    /// d = √(ξ² + (y + R)²) - R with ξ = x - x0, without the difference of two large numbers: κ = -1/R, κ' = 0.
    fn project(&self, x: f64, y: f64) -> ClosestPoint {
        let (across, up) = (x - self.offset, y + self.radius);
        let from_center = across.hypot(up);
        let (sin, cos) = (-across / from_center, up / from_center);
        ClosestPoint {
            distance: (across * across + y * (y + 2.0 * self.radius)) / (from_center + self.radius),
            place: self.offset - self.radius * sin,
            sin,
            cos,
            curvature: -self.radius.recip(),
            curvature_slope: 0.0,
            second_distance: f64::INFINITY,
        }
    }

    /// The equator beside it.
    fn top(&self, from: f64, to: f64) -> f64 {
        let beside = self.offset.clamp(from.min(to), from.max(to)) - self.offset;
        let share = (beside / self.radius).clamp(-1.0, 1.0);
        self.radius * ((1.0 - share * share).sqrt() - 1.0)
    }
}
