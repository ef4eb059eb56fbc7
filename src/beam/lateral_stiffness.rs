//! The stiffness of a section that a planar beam does not have.

use super::section::{Material, rectangle_second_moment};
use super::torsion::torsion_constant;
use crate::adhesion::spatial_section::section::SectionShape;
use std::f64::consts::PI;

/// Of torsion, and of bending along the width.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LateralStiffness {
    /// GJ, nN nm²
    pub torsion: f64,
    /// EI3, of bending along the width, nN nm²
    pub bending: f64,
}

impl LateralStiffness {
    /// Of a section between a rectangle (`roundness` 0) and an ellipse (1) of this width and height, nm, as [`Material::section`] has it:
    /// J is between those of the two, I3 = (h b³/12)(1 + (12π/64 - 1) q). The factor of the planar bending stiffness has no part in it.
    pub fn of(material: &Material, width: f64, height: f64, roundness: f64) -> Self {
        let torsion_constant = match roundness {
            1.0 => torsion_constant(SectionShape::Ellipse, width, height),
            0.0 => torsion_constant(SectionShape::Rectangle, width, height),
            between => {
                let rectangle = torsion_constant(SectionShape::Rectangle, width, height);
                rectangle + between * (torsion_constant(SectionShape::Ellipse, width, height) - rectangle)
            }
        };
        let second_moment = rectangle_second_moment(width, height) * (1.0 + (12.0 * PI / 64.0 - 1.0) * roundness);
        let shear_modulus = material.youngs_modulus / (2.0 * (1.0 + material.poissons_ratio));
        Self { torsion: shear_modulus * torsion_constant, bending: material.youngs_modulus * second_moment }
    }
}
