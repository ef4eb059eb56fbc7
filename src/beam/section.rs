//! Stiffness of a beam section.

/// Section stiffnesses of a planar beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    /// EA, nN
    pub axial: f64,
    /// GA_s, nN
    pub shear: f64,
    /// EI, nN·nm²
    pub bending: f64,
}

/// Second moment of area of a rectangle about its middle, width h³/12, nm⁴.
pub fn rectangle_second_moment(height: f64, width: f64) -> f64 {
    width * height.powi(3) / 12.0
}
