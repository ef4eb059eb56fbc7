//! Why a peel stopped short, with what was computed, where and how far.

use crate::solve::{LimitPointKind, PathError, SolveError};
use crate::study::initial::NoEquilibrium;
use serde::{Deserialize, Serialize};

/// Why a computation stopped short, and what to try.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
pub enum Failure {
    /// The path has no start.
    #[error("{0}")]
    NoStart(NoEquilibrium),
    /// On the best mesh that was tried, of so many elements of this order.
    #[error(
        "{cause}; on {elements} elements of order {order}. What was reached is kept. Try another accuracy.relative than {asked:e}, or \
         bounds.displacement to stop before"
    )]
    Path {
        cause: PathFailure,
        elements: usize,
        order: usize,
        /// Relative accuracy asked for.
        asked: f64,
    },
    /// No mesh was tried.
    #[error("nothing was computed")]
    NothingComputed,
}

/// Why a path on one mesh cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
pub enum PathFailure {
    /// It cannot be continued.
    #[error("{0}")]
    Path(PathError),
    /// A limit point was not located.
    #[error(
        "the turning point of the {turn} behind path point {after} (u = {displacement_nm:.6} nm) was not located: {cause}"
    )]
    NotLocated { turn: LimitPointKind, after: usize, displacement_nm: f64, cause: SolveError },
    /// A limit point was not seen.
    #[error(
        "between path points {after} and {} (u = {displacement_nm:.6} nm) the number of negative eigenvalues goes from \
         {from} to {to}, which {turns} located turning points of the displacement do not explain",
        after + 1
    )]
    Missed { after: usize, displacement_nm: f64, from: usize, to: usize, turns: usize },
    /// A step may have led to another part of the path.
    #[error(
        "between path points {after} and {} (u = {displacement_nm:.6} nm) no solution was found, and neither force nor displacement \
         goes smoothly from one to the other: the path may have jumped over a part of itself",
        after + 1
    )]
    Jumped { after: usize, displacement_nm: f64 },
    /// The force vanishes again before it had a maximum.
    #[error(
        "the path came back to P = 0 at u = {displacement_nm:.6} nm before the force had a maximum: its first step went to \
         another equilibrium, or the strip is too soft for its adhesion (process zone {process_nm:.3e} nm)"
    )]
    LostAtRest { displacement_nm: f64, process_nm: f64 },
    /// The first step is too short for the numbers.
    #[error("the first step, {step_nm:e} nm, is lost in the rounding of the displacement")]
    Stuck { step_nm: f64 },
    /// The caller stopped it at [`crate::study::Stage::Results`].
    #[error(
        "bounds.time, and as long again and a second, were over before the turning points of the path and its work were \
         computed: a larger one leaves more time for them"
    )]
    OutOfTime,
    /// Its steps have become short.
    #[error("{points} path points were not enough on {elements} elements: the mesh holds the path up")]
    TooManyPoints { points: usize, elements: usize },
    /// Numbers of limit points with shorter and with longer steps.
    #[error(
        "with shorter steps the path has {shorter} turning points, with longer ones {longer}: what slides depends on the steps"
    )]
    StepsMatter { shorter: usize, longer: usize },
    /// The error bounds are larger than the accuracy asked for by this factor.
    #[error("the error bounds are {factor:.1} times what was asked for")]
    BoundsMissed { factor: f64 },
}
