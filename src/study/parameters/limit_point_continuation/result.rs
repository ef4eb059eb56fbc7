//! What a sweep that follows one point gives.

use crate::solve::error::SolveError;
use crate::solve::points::search::LimitPointKind;
use crate::solve::points::tracer::TraceError;
use crate::study::asked::stop_criteria::Bound;
use crate::study::initial::error::NoEquilibrium;
use crate::study::peel::result::{Failure, PathEnd};
use crate::study::peel::solution_history::{LimitPoint, Peak};
use serde::{Deserialize, Serialize};

/// The point of a peel that can be followed in a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointKind {
    /// The first local maximum of the force along the path.
    InitiationPeak,
    /// The first displacement limit point.
    SnapOff,
}

impl PointKind {
    /// Which kind of limit point it is.
    pub fn turn(self) -> LimitPointKind {
        match self {
            Self::InitiationPeak => LimitPointKind::Load,
            Self::SnapOff => LimitPointKind::Displacement,
        }
    }

    /// Its name in outputs.
    pub fn word(self) -> &'static str {
        match self {
            Self::InitiationPeak => "initiation peak",
            Self::SnapOff => "snap-off",
        }
    }
}

/// How the values of a parameter are spaced, and in what the point is a smooth function of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spacing {
    /// Evenly; in the parameter
    Linear,
    /// All values are above zero.
    Logarithmic,
}

impl Spacing {
    /// The number in which the values are evenly spaced.
    pub(crate) fn coordinate(self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::Logarithmic => value.ln(),
        }
    }

    /// The value of a coordinate.
    pub fn value(self, coordinate: f64) -> f64 {
        match self {
            Self::Linear => coordinate,
            Self::Logarithmic => coordinate.exp(),
        }
    }
}

/// The point at one value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FollowedPoint {
    /// nm
    pub displacement: f64,
    /// nN
    pub force: f64,
    /// rad
    pub end_rotation: f64,
    /// ∫ P du from rest, aJ; absent where the load has no potential.
    pub work: Option<f64>,
    /// Bound on the error of `displacement`, nm
    pub displacement_error: f64,
    /// Bound on the error of `force`, nN
    pub force_error: f64,
}

impl From<Peak> for FollowedPoint {
    fn from(at: Peak) -> Self {
        Self {
            displacement: at.displacement,
            force: at.force,
            end_rotation: at.end_rotation,
            work: None,
            displacement_error: at.displacement_error,
            force_error: at.force_error,
        }
    }
}

impl From<LimitPoint> for FollowedPoint {
    fn from(at: LimitPoint) -> Self {
        Self {
            displacement: at.displacement,
            force: at.force,
            end_rotation: at.end_rotation,
            work: Some(at.work),
            displacement_error: at.displacement_error,
            force_error: at.force_error,
        }
    }
}

/// One value of the parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FollowedRow {
    /// In the parameter's own unit.
    pub value: f64,
    /// Absent where the path has no such point or could not be computed; a remark says which.
    pub point: Option<FollowedPoint>,
    /// Of this value alone
    pub newton_iterations: usize,
    /// On which the point was solved for
    pub elements: usize,
}

/// All values, and what is to be said about them.
#[derive(Clone, Debug)]
pub struct FollowedSweep {
    /// Which point is followed
    pub kind: PointKind,
    /// One for each value, in their order
    pub rows: Vec<FollowedRow>,
    /// Where the point vanished, was replaced or was not found
    pub remarks: Vec<Remark>,
}

/// What happened to the point on the way.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum Remark {
    /// The limit point meets another one and both vanish.
    #[error(
        "the {} that was followed meets another limit point and vanishes between {} and {}; beyond that it is looked \
         for on the path from rest",
        .kind.word(), .between.0, .between.1
    )]
    Vanished { kind: PointKind, between: (f64, f64) },
    /// The limit point could not be followed.
    #[error(
        "the {} could not be followed from {} to {}: {cause}; beyond that it is looked for on the path from rest",
        .kind.word(), .between.0, .between.1
    )]
    Lost { kind: PointKind, between: (f64, f64), cause: SolveError },
    /// The limit point goes on, but is not the one that it was.
    #[error(
        "the limit point that was followed is the {} up to {} and no longer at {}, where the path from rest has another; \
         from there on that one is followed",
        .kind.word(), .between.0, .between.1
    )]
    Replaced { kind: PointKind, between: (f64, f64) },
    /// The path from rest could not be computed where the point was to be compared with it.
    #[error("at {value} the {} that was followed could not be compared with the path from rest: {reason}", .kind.word())]
    Unconfirmed { kind: PointKind, value: f64, reason: PointNotFound },
    /// The path from rest has no such point at any of the values from the one to the other.
    #[error("from {from} to {to} the path has no {}", .kind.word())]
    Absent { kind: PointKind, from: f64, to: f64 },
    /// The point could not be solved for by itself and is that of a whole peel.
    #[error("at {value} the {} is that of a whole path, because it could not be solved for directly: {reason}", .kind.word())]
    Peeled { kind: PointKind, value: f64, reason: PointNotFound },
    /// The path from rest could not be computed.
    #[error("at {value} the {} was not found: {reason}", .kind.word())]
    NotFound { kind: PointKind, value: f64, reason: PointNotFound },
}

// -- Why a limit point was not found, and why no cusp --

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
