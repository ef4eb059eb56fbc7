//! Why a limit point was not found, and why no cusp.

use crate::solve::error::SolveError;
use crate::solve::points::tracer::TraceError;
use crate::study::initial::error::NoEquilibrium;
use crate::study::peel::failure::Failure;
use crate::study::peel::result::PathEnd;
use crate::study::stop_criteria::Bound;
use serde::{Deserialize, Serialize};

/// Why the point to be followed is not known from the path from rest.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
pub enum PointNotFound {
    /// The path has no start.
    #[error("{0}")]
    NoStart(NoEquilibrium),
    /// The beginning of the path could not be traced.
    #[error("{0}")]
    Trace(TraceError),
    /// The beginning of the path was given up.
    #[error("the path has no maximum of the force within {0}")]
    NoMaximum(Bound),
    /// The whole path met a stop criterion.
    #[error("{0}")]
    Bound(Bound),
    /// The whole path could not be computed.
    #[error("{0}")]
    Failed(Box<Failure>),
    /// A limit point of the path is not there on its segment.
    #[error("the snap-off was not found again on its path")]
    NotFoundAgain,
    /// The point could not be solved for by itself.
    #[error("{0}")]
    Solve(#[from] SolveError),
}

impl PointNotFound {
    /// Why a path that ended so may have the point all the same; none where it went on until there is none.
    pub(super) fn unknown_behind(end: PathEnd) -> Option<Self> {
        match end {
            PathEnd::Failed(failure) => Some(Self::Failed(Box::new(failure))),
            PathEnd::Bound(bound) => Some(Self::Bound(bound)),
            PathEnd::Detached
            | PathEnd::Pivoting
            | PathEnd::Pushing
            | PathEnd::TurnedBack
            | PathEnd::BackInPlane
            | PathEnd::Sliding
            | PathEnd::Snapped
            | PathEnd::BondedPartUnstable(_)
            | PathEnd::Upright(_) => None,
        }
    }
}

/// Why no cusp was found.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum CuspError {
    /// The path to begin with could not be computed.
    #[error("{0}")]
    Path(Box<Failure>),
    /// It has fewer than two limit points of the displacement.
    #[error("the path has no snap-back to begin with")]
    NoSnapBack,
    /// There is no path point between those.
    #[error("the path has no point on its snap-back")]
    NoPoint,
    /// du/dP has a minimum there, or no curvature; nN
    #[error("du/dP has no maximum near P = {force:.6} nN")]
    NoMaximum { force: f64 },
    /// The search for it did not end; nN
    #[error("the maximum of du/dP near P = {force:.6} nN was not found in {tries} steps")]
    MaximumNotFound { force: f64, tries: usize },
    /// A point between the limit points was not found.
    #[error("{0}")]
    Solve(#[from] SolveError),
    /// The search for the parameter did not end.
    #[error("the snap-back did not vanish near {value:.6}, the last value tried")]
    NotVanished { value: f64 },
}
