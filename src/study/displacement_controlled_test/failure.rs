//! Why a test stopped short, with what was computed, where and how far.

use super::balance::{Balance, LoadingDirection};
use crate::solve::error::SolveError;
use crate::solve::points::tracer::TraceError;
use crate::solve::relax::RelaxError;
use crate::study::initial::error::NoEquilibrium;
use serde::{Deserialize, Serialize};

/// Most jumps on one way.
pub(super) const MOST_JUMPS: usize = 50;

/// Why a test stopped short, on the best mesh that was tried, and what to try.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[error(
    "{cause}; on {elements} elements of order {order}. The results so far are kept. Try another accuracy.relative than {asked:e}"
)]
#[allow(missing_docs)] // the message of each names its numbers
pub struct TestFailure {
    pub cause: TestError,
    pub elements: usize,
    pub order: usize,
    /// Relative accuracy asked for.
    pub asked: f64,
}

/// Why a test on one mesh stopped.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum TestError {
    /// No mesh was tried.
    #[error("nothing was computed")]
    NothingComputed,
    /// There is no equilibrium to start from.
    #[error(
        "the path cannot be continued from u = 0.000000 nm, P = 0.000000 nN (point 0): after 1 shorter and shorter steps: {0}"
    )]
    NoStart(NoEquilibrium),
    /// A stable branch was not followed to its end.
    #[error("{0}")]
    Branch(#[from] BranchError),
    /// The structure does not come to rest.
    #[error("the state after the jump at U = {machine_nm:.6} nm was not found: {cause}")]
    Relax { machine_nm: f64, cause: RelaxError },
    /// A jump takes energy, aJ.
    #[error("the jump at U = {machine_nm:.6} nm releases {released:.3e} aJ: that is no jump")]
    NoRelease { machine_nm: f64, released: f64 },
    /// One jump comes after another.
    #[error("there were {MOST_JUMPS} jumps on the {}, more than are computed", .way.word())]
    TooManyJumps { way: LoadingDirection },
    /// The work is not the energy.
    #[error(
        "work and energy do not balance: ∫ P dU = {:.9e} aJ, change of energy {:.9e} aJ, released {:.9e} aJ; the difference is \
         {:.1e} of the largest term", .0.work, .0.energy_change, .0.released, .0.error()
    )]
    Unbalanced(Balance),
}

/// Why a stable branch could not be followed.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum BranchError {
    /// Its path, or where that loses its stability.
    #[error("{0}")]
    Trace(#[from] TraceError),
    /// Its largest force.
    #[error("the largest force on the stable branch near U = {machine_nm:.6} nm was not located: {cause}")]
    NoPeak { machine_nm: f64, cause: SolveError },
    /// Its last point.
    #[error("the last point, at U = {machine_nm:.6} nm, was not found: {cause}")]
    NotArrived { machine_nm: f64, cause: SolveError },
}
