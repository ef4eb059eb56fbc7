//! A uniform strip of rectangular section, of which a part at the grip may not adhere.

use super::geometry::Geometry;
use super::laminate::Laminate;
use crate::beam::section::Material;
use crate::beam::varying::{BeamGeometry, SectionGeometry};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Geometry and material of a uniform strip of rectangular section.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Strip {
    /// nm
    pub length: f64,
    /// h, nm; of layers [`Laminate::height`]
    pub height: f64,
    /// nm
    pub width: f64,
    /// What it is made of; of layers [`Laminate::material`]
    pub material: Material,
    /// The layers, where it has several
    #[serde(default)]
    pub layers: Option<Laminate>,
    /// Length at the grip that does not adhere, an initial crack, nm
    pub crack: Option<f64>,
}

impl Strip {
    /// The same of layers: with their height and their material, and its own law of stretch and yielding.
    pub fn of_layers(self, layers: Laminate) -> Self {
        let Material { stretch, yield_strength, tangent_modulus, .. } = self.material;
        let material = Material { stretch, yield_strength, tangent_modulus, ..layers.material() };
        Self { height: layers.height(), material, layers: Some(layers), ..self }
    }
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

    fn thickness_over_height(&self) -> f64 {
        self.layers.map_or(1.0, |layers| layers.thickness() / self.height)
    }

    fn shared(&self) -> Arc<dyn BeamGeometry> {
        Arc::new(*self)
    }

    fn is_uniform(&self) -> bool {
        self.crack.is_none()
    }
}
