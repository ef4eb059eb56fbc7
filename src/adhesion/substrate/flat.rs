//! Level ground.

use super::surface::{Foot, Surface};

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

    fn foot(&self, x: f64, y: f64) -> Foot {
        Foot::level(x, y)
    }

    fn clearance(&self, _x: f64, y: f64) -> f64 {
        y
    }

    fn top(&self, _from: f64, _to: f64) -> f64 {
        0.0
    }

    fn detail(&self) -> f64 {
        f64::INFINITY
    }
}
