//! Level ground.

use super::surface::{ClosestPoint, Surface};

/// y = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Flat;

impl Surface for Flat {
    fn name(&self) -> &'static str {
        "flat"
    }

    fn keys(&self) -> &'static [&'static str] {
        &[]
    }

    fn project(&self, x: f64, y: f64) -> ClosestPoint {
        ClosestPoint::level(x, y)
    }

    fn clearance(&self, _x: f64, y: f64) -> f64 {
        y
    }

    fn top(&self, _from: f64, _to: f64) -> f64 {
        0.0
    }

    fn feature_length(&self) -> f64 {
        f64::INFINITY
    }
}
