//! What a pull-off has reached: with it the rest follows bit for bit as if it had not been interrupted.

use super::result::{SetaEffort, SetaEnd, SetaPullOff};
use crate::model::TipBranch;
use crate::solve::Solution;
use serde::{Deserialize, Serialize};

/// What a pull-off has reached.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct SetaProgress {
    /// The result so far
    pub result: SetaPullOff,
    /// The equilibrium that it stands in
    pub(super) here: Solution,
    /// Branch and place of adhesion of each tip, nm
    pub(super) tips: Vec<(TipBranch, [f64; 3])>,
    /// Number of the step that is under way
    pub(super) step: usize,
    /// Where the root was at its beginning, nm
    pub(super) from: [f64; 3],
    /// Length of the next step of the root, nm
    pub(super) ahead: f64,
    /// ∂²E/∂y² of a tip at the last loss of stability, nN/nm
    pub(super) softest: Option<f64>,
}

impl SetaPullOff {
    /// Of nothing.
    pub(super) fn empty(elements: usize) -> Self {
        Self {
            points: Vec::new(),
            events: Vec::new(),
            first_detachment: None,
            peak: None,
            last_detachment: None,
            last: None,
            end: SetaEnd::Completed,
            effort: SetaEffort { newton_iterations: 0, elements },
        }
    }
}
