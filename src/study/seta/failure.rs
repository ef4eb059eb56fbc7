//! Why a pull-off of a seta stopped short. Steps are counted from 0 in the data and from 1 in the messages.

use crate::solve::error::SolveError;
use serde::{Deserialize, Serialize};

/// Why a pull-off of a seta stopped short.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum SetaFailure {
    /// No equilibrium at the start.
    #[error("the seta does not come to rest at the start: {cause}; try a smaller scatter of its tips")]
    NoStart { cause: SolveError },
    /// The branch cannot be followed.
    #[error(
        "in step {} the seta cannot be followed beyond {displacement:.6} nm with {attached} tips attached: {cause}; try more elements", .step + 1
    )]
    Lost { step: usize, displacement: f64, attached: usize, cause: SolveError },
    /// An event has no end.
    #[error(
        "in step {} at {displacement:.6} nm the seta does not come to rest behind an event, after {changes} changes of tips: {cause}; try more elements", .step + 1
    )]
    Restless { step: usize, displacement: f64, changes: usize, cause: SolveError },
    /// The same where the law of tips is an extrapolation.
    #[error(
        "in step {} at {displacement:.6} nm the seta does not come to rest behind an event, where {outside} tips are outside of the table of their spatula: what is extrapolated there need not be stable; press the seta less, or give a table that begins less deep", .step + 1
    )]
    Extrapolated { step: usize, displacement: f64, outside: usize },
    /// A preload that is not reached.
    #[error("in step {} the preload of {preload} nN is not reached within {displacement:.3} nm: ask for less", .step + 1)]
    NoPreload { step: usize, preload: f64, displacement: f64 },
    /// Work and energy differ.
    #[error(
        "in step {} at {displacement:.6} nm work and energy differ by {imbalance:.3e} of the larger: the seta may have gone over to another branch; try shorter steps", .step + 1
    )]
    Unbalanced { step: usize, displacement: f64, imbalance: f64 },
    /// Work that is nowhere at the end.
    #[error(
        "all steps are taken, but {missing:.6} aJ of the {work:.6} aJ that the root has worked are neither stored nor released, {share:.1e} of the work there and back, where steps are held to {balance:.1e}: on the way the seta has gone over to another branch, and neither its peak nor its events can be relied on; try a smaller accuracy.relative"
    )]
    Unaccounted { missing: f64, work: f64, share: f64, balance: f64 },
}
