//! Why a design problem is refused, or no optimum was found.

use crate::model::check::error::ModelError;
use crate::study::peel::result::PathEnd;

/// Why there is no optimum.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum NoOptimum {
    #[error("nothing is free: no variable is given; name at least one parameter or a profile")]
    NothingFree,
    #[error(
        "`{name}` has the bounds {lower} and {upper}; the lower one has to be below the upper one, and both finite"
    )]
    Bounds { name: String, lower: f64, upper: f64 },
    #[error(
        "`{name}` may go from {lower} to {upper}, and next to {at} there is no such model: {cause}; leave a margin of a thousandth inside its range"
    )]
    OutsideRange { name: String, lower: f64, upper: f64, at: f64, cause: String },
    #[error("the design at the start cannot be computed: {0}")]
    Start(#[from] ModelError),
    #[error("the design at the start has no model")]
    NoModel,
    #[error(
        "the peel of the design at the start has no {name}: it ended {end}; choose another objective, or another start"
    )]
    NoObjective { name: &'static str, end: String },
    #[error("the design at the start has no {name}: {why}; choose another objective, or another start")]
    NoNumber { name: &'static str, why: String },
    #[error("{name} is {value:e} at the start, and an objective has to be above zero")]
    NotPositive { name: &'static str, value: f64 },
    #[error(
        "no design meets all constraints: {name} is violated by {violation:.3e} at the design that comes nearest; widen the bounds or drop it"
    )]
    Contradictory { name: String, violation: f64 },
    #[error("the objective cannot be differentiated here: {why}; use the search without gradients")]
    NoGradient { why: String },
    #[error("none of {evaluations} designs could be computed")]
    AllBad { evaluations: usize },
}

/// How a path ended, in a word or with its reason.
pub(super) fn end_text(end: &PathEnd) -> String {
    match end {
        PathEnd::Failed(failure) => format!("failed, {failure}"),
        other => format!("{other:?}").to_lowercase(),
    }
}
