//! What a path that is to go on is kept by.

use super::metric::Notice;
use super::near_branch::NearBranch;
use crate::solve::newton::Solution;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

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
