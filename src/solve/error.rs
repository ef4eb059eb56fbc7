//! Why a computation stopped, with the numbers.

/// What went wrong while equilibrium was sought.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SolveError {
    /// A number is not finite.
    #[error("not a finite number in {quantity}, element {element} near S = {position_nm:.6} nm")]
    NotFinite { quantity: &'static str, element: usize, position_nm: f64 },
    /// Elimination met a pivot that is zero to rounding.
    #[error("singular tangent: pivot {pivot:.3e} in element {element} near S = {position_nm:.6} nm")]
    Singular { pivot: f64, element: usize, position_nm: f64 },
    /// The last block, with grip, force and path condition, is singular.
    #[error("singular tangent in the grip's equations: the path condition does not fix the point")]
    SingularGrip,
    /// Newton's iterations did not contract.
    #[error(
        "Newton's method did not converge: last update {update:.3e} of the gap scale after {iterations} iterations"
    )]
    NotConverged { update: f64, iterations: usize },
    /// The time that was given is over.
    #[error("the time that was given is over")]
    OutOfTime,
    /// A beam found no equilibrium to start from.
    #[error("{0}")]
    NoBeginning(String),
    /// A turning point is not there on more elements.
    #[error("a turning point was not found again on more elements: the mesh does not resolve the path")]
    TurnNotConfirmed,
}
