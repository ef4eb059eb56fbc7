//! Potential of a section in space with its first and second derivatives.

/// Ψ per length of beam, with gradient and Hessian by the height y of the axis, the rise a of the width and the rise c
/// of the height.
///
/// The line force on the beam is -Ψ_y e_y, the line moment -(b Ψ_a d2 + h Ψ_c d3) × e_y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpatialSectionResponse<T = f64> {
    /// Ψ, nN
    pub energy: T,
    /// Ψ_y, Ψ_a, Ψ_c, nN/nm
    pub gradient: [T; 3],
    /// Ψ_yy, Ψ_ya, Ψ_yc, Ψ_aa, Ψ_ac, Ψ_cc, nN/nm²
    pub hessian: [T; 6],
}
