//! Parameters of a model from measured force-displacement curves.
//!
//! A machine with a spring of stiffness k holds the displacement U = u + P/k; its record begins at the displacement zero d and the force zero f. With
//! the measured points (dᵢ, Pᵢ) and the standard errors sᵢ of the forces, the parameters p are those with the least
//!
//! ```text
//! S(p) = Σ ρ([P(dᵢ - d; p) + f - Pᵢ]/sᵢ) + Σ ([U*(p) + d - d*]/s*)²
//! ```
//!
//! where P(U; p) is the first stable branch of the model's path under control of U, U* where that ends in the first jump, d* the displacement at
//! which the measured curve jumps, and ρ the loss: t² for least squares. Each parameter has a coordinate, ln p where it is above zero. The
//! least is found by Levenberg and Marquardt's method with the derivatives of [`crate::study::force_derivatives`].
//!
//! sᵢ² = s² + (P' sᵤ)², with the standard errors s of a force and sᵤ of a displacement, which are known or estimated from the residuals. Where f is
//! free and the record goes on behind the detachment, the mean force there is a datum for f.
//!
//! Of several curves, each of a model of its own that has the same parameters, the sums are over all of them. Each has its own d and f.
//!
//! What is no peel, the pull-off of a seta or a pull at a rate, has its whole curve up to where nothing adheres any more in place of the branch, and
//! that place in place of U*. Its derivatives are differences of whole curves; a point over which an event passes between the two has none.

mod coordinate;
mod curve_trial;
pub(in crate::study) mod curves;
pub(in crate::study) mod problem;
mod residuals;
pub(in crate::study) mod result;
pub(in crate::study) mod run;
mod search;
mod statistics;
pub(in crate::study) mod warnings;
