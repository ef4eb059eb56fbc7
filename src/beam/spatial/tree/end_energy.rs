//! An energy of the place and the rotation of a joint: what adheres a tip, for one.

use crate::beam::spatial::rotation::Quaternion;
use std::fmt::Debug;

/// An energy at a joint with its derivatives.
///
/// By δ, a change of the place along x, y and z (nm), and φ, a turn in the axes of the directors (rad): of E(r + δ, q ∘ exp(φ)), where exp(φ)
/// turns by |φ| about φ, at δ = φ = 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EndResponse {
    /// E, aJ
    pub energy: f64,
    /// ∂E/∂(δ, φ): nN and nN·nm
    pub gradient: [f64; 6],
    /// ∂²E/∂(δ, φ)², symmetric: nN/nm, nN, nN·nm
    pub hessian: [[f64; 6]; 6],
}

/// An energy of the place and the rotation of a joint.
pub trait EndEnergy: Send + Sync + Debug {
    /// The energy at a place (nm) and with directors q, of length one.
    fn response(&self, place: [f64; 3], directors: Quaternion) -> EndResponse;
}
