//! Why a computation stopped, with the numbers.

use serde::{Deserialize, Serialize};
use std::fmt;

/// Where in a system something went wrong.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Place {
    /// Counted from the left end from 0
    pub element: usize,
    /// S of its left end, nm
    pub position: f64,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "element {} near S = {:.6} nm", self.element, self.position)
    }
}

/// What turned out not to be a finite number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Quantity {
    /// The second derivatives of the energy.
    Tangent,
    /// A step of Newton's method.
    NewtonUpdate,
    /// A shortened step of it.
    DampedUpdate,
    /// The direction of the path.
    PathTangent,
    /// What passes a value in an event.
    EventQuantity,
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            Self::Tangent => "the tangent",
            Self::NewtonUpdate => "Newton's update",
            Self::DampedUpdate => "a damped update",
            Self::PathTangent => "the path's tangent",
            Self::EventQuantity => "the quantity of an event",
        })
    }
}

/// Why equilibrium was not found.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum SolveError {
    /// A number of the system is not finite.
    #[error("not a finite number in {quantity}, {place}")]
    NotFinite { quantity: Quantity, place: Place },
    /// A number of the solution as a whole is not finite.
    #[error("not a finite number in {quantity}")]
    NotFiniteUpdate { quantity: Quantity },
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
    /// A limit point is not there on more elements.
    #[error("a limit point was not found again on more elements: the mesh does not resolve the path")]
    LimitPointNotConfirmed,
}
