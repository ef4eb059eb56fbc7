//! A uniform strip of rectangular section, of which a part at the grip may not adhere.

use super::geometry::Geometry;
use crate::beam::section::Material;
use crate::beam::varying::{BeamGeometry, SectionGeometry};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Geometry and material of a uniform strip of rectangular section.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Strip {
    /// nm
    pub length: f64,
    /// nm
    pub height: f64,
    /// nm
    pub width: f64,
    /// What it is made of
    pub material: Material,
    /// Length at the grip that does not adhere, an initial crack, nm
    pub crack: Option<f64>,
}

impl BeamGeometry for Strip {
    fn length(&self) -> f64 {
        self.length
    }

    fn breaks(&self) -> Vec<f64> {
        self.crack.map(|_| self.adhering_length()).into_iter().collect()
    }

    fn adhering_length(&self) -> f64 {
        self.length - self.crack.unwrap_or(0.0)
    }

    fn at(&self, _place: f64) -> SectionGeometry {
        SectionGeometry { width: self.width, height: [self.height, 0.0, 0.0], roundness: 0.0, underside: [0.0; 2] }
    }
}

impl Geometry for Strip {
    fn name(&self) -> &'static str {
        "strip"
    }

    fn material(&self) -> Material {
        self.material
    }

    fn shared(&self) -> Arc<dyn BeamGeometry> {
        Arc::new(*self)
    }

    fn is_uniform(&self) -> bool {
        self.crack.is_none()
    }
}
