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
mod point;
pub(in crate::study) mod quantity;
pub(in crate::study) mod run;
