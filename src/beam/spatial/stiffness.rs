//! Stiffness of the section of a beam in space.

use crate::beam::section::Material;

/// Stiffness of a section: section forces and moments are C (Γ, K - K0), in the axes of the directors.
///
/// Order: Γ1 along the axis, Γ2 along the width, Γ3 along the height, the twist K1, and the curvatures K2 about the width and K3 about the
/// height. Symmetric and positive definite; entries beside the diagonal couple, as in a section that bends when it is twisted. Units: nN of
/// Γ by Γ, nN·nm between Γ and K, nN·nm² of K by K.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpatialStiffness(pub [[f64; 6]; 6]);

impl SpatialStiffness {
    /// Without coupling: axial EA, shear GA2 and GA3 (nN), torsion GJ, bending EI2 and EI3 (nN·nm²).
    pub fn diagonal(axial: f64, shear: [f64; 2], torsion: f64, bending: [f64; 2]) -> Self {
        let mut c = [[0.0; 6]; 6];
        for (k, entry) in [axial, shear[0], shear[1], torsion, bending[0], bending[1]].into_iter().enumerate() {
            c[k][k] = entry;
        }
        Self(c)
    }

    /// Of a section of area A (nm²) with the second moments I2 = ∫ (height)² dA and I3 = ∫ (width)² dA and the torsion constant J (nm⁴), of one
    /// isotropic material.
    pub fn isotropic(material: &Material, area: f64, [second, third]: [f64; 2], torsion_constant: f64) -> Self {
        let Material { youngs_modulus: e, poissons_ratio, shear_correction, bending_stiffness_factor } = *material;
        let g = e / (2.0 * (1.0 + poissons_ratio));
        let shear = shear_correction * g * area;
        let bending = [e * second * bending_stiffness_factor, e * third];
        Self::diagonal(e * area, [shear; 2], g * torsion_constant, bending)
    }
}
