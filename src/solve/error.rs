//! Why a computation stopped, with the numbers.

use std::fmt;

/// Where in a system something went wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    pub element: usize,
    /// S of its left end, nm
    pub position: f64,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "element {} near S = {:.6} nm", self.element, self.position)
    }
}

/// Why equilibrium was not found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SolveError {
    /// A number of the system is not finite.
    #[error("not a finite number in {quantity}, {place}")]
    NotFinite { quantity: &'static str, place: Place },
    /// A number of the solution as a whole is not finite.
    #[error("not a finite number in {quantity}")]
    NotFiniteUpdate { quantity: &'static str },
    /// Elimination met a pivot that is zero to rounding.
    #[error("singular tangent: pivot {pivot:.3e} in {place}")]
    Singular { pivot: f64, place: Place },
    /// The last block, with end conditions, force and path constraint, is singular.
    #[error("singular tangent in the grip's equations: the path constraint does not fix the point")]
    SingularGrip,
    /// Newton's iterations did not contract.
    #[error(
        "Newton's method did not converge: last update {update:.3e} of the gap scale after {iterations} iterations"
    )]
    NotConverged { update: f64, iterations: usize },
    /// The caller's [`super::Workspace`] said to stop.
    #[error("the time limit was reached")]
    Stopped,
    /// There is no equilibrium to start from.
    #[error("{0}")]
    NoEquilibrium(String),
    /// A limit point is not there on more elements.
    #[error("a limit point was not found again on more elements: the mesh does not resolve the path")]
    LimitPointNotConfirmed,
}
