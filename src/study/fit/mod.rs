//! Parameters of a model from a measured force-displacement curve.
//!
//! A machine with a spring of stiffness k holds the displacement U = u + P/k; its record begins at the displacement zero d. With the measured
//! points (dᵢ, Pᵢ) and the standard errors sᵢ of the forces, the parameters p are those with the least
//!
//! ```text
//! S(p) = Σ ρ([P(dᵢ - d; p) - Pᵢ]/sᵢ) + ([U*(p) + d - d*]/s*)²
//! ```
//!
//! where P(U; p) is the first stable branch of the model's path under control of U, U* where that ends in the first jump, d* the displacement at
//! which the measured curve jumps, and ρ the loss: t² for least squares. Each parameter has a coordinate, ln p where it is above zero. The
//! least is found by Levenberg and Marquardt's method with the derivatives of [`crate::study::force_derivatives`].

mod at_jump;
mod coordinate;
mod error;
mod loss;
mod machine_curve;
mod measured_curve;
mod modelled;
mod poorly_determined;
mod problem;
mod profile;
mod residuals;
mod result;
mod run;
mod search;
mod statistics;
mod warnings;

pub use error::{FitDataError, NoFit};
pub use loss::Loss;
pub use measured_curve::{MeasuredCurve, MeasuredJump, MeasuredPoint};
pub use problem::{FitOptions, FitParameter, FitProblem, ModelOf, ParameterOf, ProfileChoice};
pub use result::{
    Combination, Fit, FitEnd, FittedJump, FittedParameter, FittedPoint, PairDetermined, PointPlace, Profile,
};
pub use run::fit;
pub use warnings::FitWarning;
