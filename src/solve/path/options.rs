//! How a path is stepped, why it stops, and by what one that is to go on is kept.

use super::metric::Notice;
use super::near_branch::NearBranch;
use super::predictor::MOST_POINTS;
use crate::solve::error::SolveError;
use crate::solve::newton::Solution;
use crate::solve::workspace::Pace;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// How a path is stepped. Its points follow from this and the problem alone.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PathOptions {
    /// Elements of the chain.
    pub elements: usize,
    /// Error wanted of a prediction, relative as in [`crate::solve::System::size`].
    pub step_tolerance: f64,
    /// Length of a step over that which predictions allow, at most 1.
    pub stride: f64,
    /// Error wanted of a solution, likewise.
    pub tolerance: f64,
    /// Most points that a prediction uses: 2 is the secant
    pub prediction: usize,
    /// First displacement, nm (rad where the rotation is driven); its sign is the direction of the path
    pub first_displacement: f64,
    /// What is tried where a step is not made
    pub pace: Pace,
}

impl Default for PathOptions {
    /// How a peel of the paper's strip is followed at a relative accuracy of 1e-6.
    fn default() -> Self {
        Self {
            elements: 16,
            step_tolerance: 1.2e-2,
            stride: 1.0,
            tolerance: 1e-8,
            prediction: MOST_POINTS,
            first_displacement: 8e-3,
            pace: Pace::Quick,
        }
    }
}

/// Where a path stopped and why.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[error(
    "the path cannot be continued from u = {displacement_nm:.6} nm, P = {force:.6} nN (point {point}): after {tries} ever shorter steps: {cause}"
)]
#[allow(missing_docs)] // the message of each names its numbers
pub struct PathError {
    pub point: usize,
    pub displacement_nm: f64,
    pub force: f64,
    pub tries: usize,
    pub cause: SolveError,
}

/// A point of a path and what the path has learnt there: with the points before, all that it takes to go on.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Waypoint {
    /// The equilibrium
    pub point: Arc<Solution>,
    pub(super) errors: Vec<f64>,
    pub(super) iterations: usize,
    pub(super) careful: bool,
    pub(super) branch: Option<NearBranch>,
    #[serde(default)]
    pub(super) notice: Notice,
    /// What the point before it was replaced by on the step to it.
    pub(super) before: Option<Arc<Solution>>,
}
