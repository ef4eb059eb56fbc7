//! A sphere or a cylinder.

use super::Foot;
use crate::adhesion::Shape;

/// A sphere, or a cylinder whose axis is across the beam. Its top is at y = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Round {
    pub shape: Shape,
    /// R, nm
    pub radius: f64,
    /// x of its top, nm
    pub offset: f64,
}

impl Round {
    /// d = √(ξ² + (y + R)²) - R with ξ = x - x0, without the difference of two large numbers: κ = -1/R, κ' = 0.
    pub fn foot(&self, x: f64, y: f64) -> Foot {
        let (across, up) = (x - self.offset, y + self.radius);
        let from_center = across.hypot(up);
        let (sin, cos) = (-across / from_center, up / from_center);
        Foot {
            distance: (across * across + y * (y + 2.0 * self.radius)) / (from_center + self.radius),
            place: self.offset - self.radius * sin,
            sin,
            cos,
            curvature: -self.radius.recip(),
            curvature_slope: 0.0,
            runner_up: f64::INFINITY,
        }
    }

    /// The highest point between two places, nm; its equator beside it.
    pub fn top(&self, from: f64, to: f64) -> f64 {
        let beside = self.offset.clamp(from.min(to), from.max(to)) - self.offset;
        let share = (beside / self.radius).clamp(-1.0, 1.0);
        self.radius * ((1.0 - share * share).sqrt() - 1.0)
    }
}
