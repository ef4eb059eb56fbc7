//! Why a spatula is not solved where its end is held, and why there is no table.

use super::options::OptionsError;
use super::place::TipPlace;
use crate::solve::error::SolveError;
use crate::solve::path::options::PathError;
use crate::solve::points::tracer::TraceError;
use crate::study::initial::error::NoEquilibrium;
use crate::study::stop_criteria::Bound;
use std::fmt;

impl fmt::Display for TipPlace {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { normal, lateral, rotation } = self;
        write!(f, "u = {normal:.6} nm, v = {lateral:.6} nm, θ = {rotation:.6} rad")
    }
}

/// Why a spatula was not solved at a place of its end.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum HeldError {
    #[error("{0}")]
    NoStart(NoEquilibrium),
    #[error("the spatula does not come to rest on the substrate: {0}")]
    NoRest(PathError),
    #[error("no stable equilibrium was reached from {from} at {to}; the last one is at {reached}: {cause}")]
    NotReached { from: TipPlace, to: TipPlace, reached: TipPlace, cause: SolveError },
    #[error("the equilibria from {from} on cannot be followed to a limit point: {cause}")]
    Path { from: TipPlace, cause: TraceError },
    #[error("the equilibria from {from} on have no limit point up to u = {last:.6} nm, after {points} points")]
    NoLimit { from: TipPlace, points: usize, last: f64 },
    #[error(
        "the equilibria from {from} on lose their stability at u = {last:.6} nm, where the displacement does not turn"
    )]
    Unstable { from: TipPlace, last: f64 },
    #[error("the branch from {at} to its limit point has no length")]
    Level { at: TipPlace },
    #[error(
        "at {at} the pad presses on the substrate so that less of it adheres: what the table goes along turns back there. Press less"
    )]
    Folded { at: TipPlace },
    #[error("the equilibrium at the share {share:.6} of the branch that begins at {at} was not found: {cause}")]
    NoNode { at: TipPlace, share: f64, cause: SolveError },
    #[error(
        "the branch ends at {at}, where {adhering:.3} nm of the pad still adhere, of {rest:.3} nm at rest: from there the pad goes over to another attached state, of which there is no table"
    )]
    StillAdheres { at: TipPlace, adhering: f64, rest: f64 },
    #[error("the nodes of the table have no interpolant")]
    NoTable,
    #[error(
        "the table would take {nodes} nodes along its branch, more than {most}: the branch turns sharply where the spatula is pressed far"
    )]
    Rough { nodes: usize, most: usize },
    #[error("solving the spatula was stopped")]
    Stopped,
}

/// Why there is no table of a tip.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CoarseningError {
    /// A number of the options
    #[error("{0}")]
    Options(#[from] OptionsError),
    /// A model of which there is none
    #[error("{what}")]
    Refused {
        /// Why
        what: &'static str,
        /// What to do
        remedy: &'static str,
    },
    /// A criterion that was met
    #[error("{bound}: {equilibria} equilibria on {columns} paths were solved, too few for the table of a tip")]
    Stopped {
        /// Which
        bound: Bound,
        /// Paths that were followed
        columns: usize,
        /// Equilibria that were solved
        equilibria: usize,
    },
    /// A place of the end
    #[error("{0}")]
    Held(#[from] HeldError),
}

impl CoarseningError {
    /// What to try.
    pub fn remedy(&self) -> &'static str {
        match self {
            Self::Options(_) => "peel coarsen --help has the ranges.",
            Self::Refused { remedy, .. } => remedy,
            Self::Stopped { .. } => "Give it more time: bounds.time of the scene.",
            Self::Held(HeldError::NoStart(_) | HeldError::NoRest(_)) => {
                "peel run of the same scene says more about where the path begins."
            }
            Self::Held(_) => "Narrow the ranges of v and θ, or press less.",
        }
    }
}
