//! A section that lies on the flat ground, where that neither pulls nor pushes, and the scales of a beam that follow from it.

use super::spatial_profile::SpatialStiffness;
use crate::adhesion::spatial_section::section::SpatialSection;

/// Lengths of the process zone: as long as the ground bends a beam, or shears it where that is less.
const ZONE: f64 = 0.7;
const SHEARED: f64 = 3.0;

/// A section as it lies on the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LyingSection {
    /// Height of the axis, nm
    pub height: f64,
    /// Gap of the lower face, nm
    pub gap: f64,
    /// Ψ, nN: below zero
    pub energy: f64,
    /// ∂²Ψ/∂y², nN/nm²
    pub stiffness: f64,
    /// r0, or what stands for it in the law: over it the law changes, nm
    pub gap_scale: f64,
    /// Length ℓ of the process zone of a beam with this section, nm
    pub process_length: f64,
}

impl LyingSection {
    /// Of a section with this stiffness.
    pub fn of(section: &SpatialSection, SpatialStiffness(stiffness): &SpatialStiffness) -> Self {
        let thickness = section.law().height;
        let height = rest_height(section, 0.5 * thickness + section.law().rest_gap());
        let at_rest = section.response(height, 0.0, thickness);
        let [foundation, ..] = at_rest.hessian;
        let bent = (stiffness[4][4] / foundation).powf(0.25);
        let sheared = SHEARED * (stiffness[2][2] / foundation).sqrt();
        Self {
            height,
            gap: height - 0.5 * thickness,
            energy: at_rest.energy,
            stiffness: foundation,
            gap_scale: section.law().gap_scale(),
            process_length: ZONE * bent.min(sheared),
        }
    }
}

/// Height of the axis at which the ground neither pulls nor pushes, from the one of the law in the plane: Newton's method.
fn rest_height(section: &SpatialSection, start: f64) -> f64 {
    const MOST: usize = 100;
    let (mut y, height) = (start, section.law().height);
    for _ in 0..MOST {
        let at = section.response(y, 0.0, height);
        let step = at.gradient[0] / at.hessian[0];
        y -= step;
        if step.abs() <= 4.0 * f64::EPSILON * y {
            break;
        }
    }
    y
}
