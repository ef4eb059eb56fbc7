//! How the results of a peel change with the parameters of its model: exact first derivatives, by the adjoint method.
//!
//! Equilibrium is R(q; x) = f, with the unknowns q, the grip's forces f and a parameter x. With the displacement u of the grip held,
//! multipliers λ with Kᵀλ = e_u make of it
//!
//!   ∂P/∂x at u = λ·∂R/∂x,
//!
//! and likewise ∂u/∂x at P. One transposed solve gives λ for all parameters ([`Tangents`](crate::solve::Tangents)); what a parameter adds is
//! ∂R/∂x alone, at a state that stays ([`residual_change`]). A limit point moves along its path as x changes: its force where that turns,
//! dP = 0, and its displacement where that turns, du = 0, do not change by that, to first order; of the other number
//!
//!   dP*/dx = -U_Px/U_PP at du = 0,   du*/dx = -P_ux/P_uu at dP = 0,
//!
//! with derivatives along the path of what is held (`along_path`). Works are differences of energies, whose derivative at a state that stays is
//! that of the equilibrium, because the energy is stationary.
mod along_path;
pub(in crate::study) mod differences;
pub(in crate::study) mod force;
pub(in crate::study) mod logarithmic;
mod point;
pub(in crate::study) mod quantity;
pub(in crate::study) mod run;

use crate::model::peel::PeelModel;
use quantity::PeelQuantity;

/// A parameter that results are differentiated by.
pub struct Variation<'m> {
    /// What it is called: a key of a scene, say
    pub key: String,
    /// The model with the parameter changed by x, in a coordinate that is near to 1 where it matters: ln p for a number above zero. `model(0.0)` is the
    /// model that was peeled.
    pub model: Box<dyn Fn(f64) -> PeelModel + Send + Sync + 'm>,
}

impl<'m> Variation<'m> {
    /// By the coordinate of `model`.
    pub fn new(key: impl Into<String>, model: impl Fn(f64) -> PeelModel + Send + Sync + 'm) -> Self {
        Self { key: key.into(), model: Box::new(model) }
    }
}

/// The derivative of one number by one parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Derivative {
    /// The number
    pub of: PeelQuantity,
    /// Which of the variations
    pub variation: usize,
    /// dQ/dx, in the unit of the number
    pub value: f64,
    /// Bound on its error
    pub error: f64,
}
