//! Why a peel stopped short, with what was computed, where and how far.

use crate::beam::planar::model_limits::UprightSection;
use crate::solve::error::SolveError;
use crate::solve::path::options::PathError;
use crate::solve::points::kind::LimitPointKind;
use crate::study::initial::error::NoEquilibrium;
use serde::{Deserialize, Serialize};

/// Why a computation stopped short, and what to try.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum Failure {
    /// The model, or the accuracy asked for, cannot be computed: the key of a scene, what was found, and what would be right.
    #[error("`{key}` {found}. {remedy}")]
    Refused { key: String, found: String, remedy: String },
    /// The path has no start.
    #[error("{0}")]
    NoStart(NoEquilibrium),
    /// On the best mesh that was tried, of so many elements of this order.
    #[error(
        "{cause}; on {elements} elements of order {order}. The results so far are kept. Try another accuracy.relative than {asked:e}, or \
         bounds.displacement to stop before{}",
        if *given_up { ", or bounds.time = \"60 s\": this run was given up after a hundred times the usual work" } else { "" }
    )]
    Path {
        cause: PathFailure,
        elements: usize,
        order: usize,
        /// Relative accuracy asked for.
        asked: f64,
        /// Whether more would have been tried, had there been more time.
        given_up: bool,
    },
    /// No mesh was tried.
    #[error("nothing was computed")]
    NothingComputed,
}

impl Failure {
    /// Whether nothing was tried, because of what the model or the accuracy asks: by a criterion with a name, and not for want of a solution.
    pub fn is_refusal(&self) -> bool {
        match self {
            Self::Refused { .. } => true,
            Self::NoStart(why) => why.is_refusal(),
            Self::Path { .. } | Self::NothingComputed => false,
        }
    }
}

impl PathFailure {
    /// The path point behind which the trouble is, where that is known.
    pub(super) fn after(&self) -> Option<usize> {
        match self {
            Self::Missed { after, .. } | Self::NotLocated { after, .. } | Self::Jumped { after, .. } => Some(*after),
            Self::Path(_)
            | Self::LostAtRest { .. }
            | Self::Stuck { .. }
            | Self::OutOfTime
            | Self::OutOfWork { .. }
            | Self::NearUpright(_)
            | Self::TooManyPoints { .. }
            | Self::StepsMatter { .. }
            | Self::BoundsMissed { .. } => None,
        }
    }
}

/// Why a path on one mesh cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum PathFailure {
    /// It cannot be continued.
    #[error("{0}")]
    Path(PathError),
    /// A limit point was not located.
    #[error(
        "the limit point of the {turn} after path point {after} (u = {displacement_nm:.6} nm) was not located: {cause}"
    )]
    NotLocated { turn: LimitPointKind, after: usize, displacement_nm: f64, cause: SolveError },
    /// A limit point was not seen.
    #[error(
        "between path points {after} and {} (u = {displacement_nm:.6} nm) the number of negative eigenvalues goes from \
         {from} to {to}, which {turns} located displacement limit points do not explain",
        after + 1
    )]
    Missed { after: usize, displacement_nm: f64, from: usize, to: usize, turns: usize },
    /// A step may have led to another part of the path.
    #[error(
        "between path points {after} and {} (u = {displacement_nm:.6} nm) no solution was found, and force and displacement do \
         not change smoothly: the path may have skipped a part of itself",
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
        "the limit points and the work of the path were not computed before the run was stopped, within twice bounds.time and a second or \
         soon behind Ctrl-C: a larger bounds.time allows more time"
    )]
    OutOfTime,
    /// It took too much work.
    #[error("the path is not at its end after {iterations} Newton iterations")]
    OutOfWork { iterations: usize },
    /// It comes near a pole of its law that the elements do not resolve.
    #[error("{0}")]
    NearUpright(UprightSection),
    /// Its steps have become short.
    #[error("{points} path points were not enough on {elements} elements: the continuation steps have collapsed")]
    TooManyPoints { points: usize, elements: usize },
    /// Numbers of limit points with shorter and with longer steps, and of those that are the same with both.
    #[error(
        "with shorter steps the path has {shorter} limit points, with longer ones {longer}, of which the first {same} are the same: what slides \
         behind these depends on the steps"
    )]
    StepsMatter { shorter: usize, longer: usize, same: usize },
    /// The error bounds are larger than the accuracy asked for by this factor.
    #[error("the error bounds are {factor:.1} times the requested tolerance")]
    BoundsMissed { factor: f64 },
}
