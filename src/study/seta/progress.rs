//! What a pull-off has reached: with it the rest follows bit for bit as if it had not been interrupted.

use super::result::{SetaEffort, SetaEnd, SetaPullOff, SetaState};
use super::standing::Standing;
use crate::model::seta::tip::AdheringTip;
use crate::model::seta::tip_law::TipBranch;
use crate::solve::newton::Solution;
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

/// Where a run is between two steps of its root: a step that is stopped on its way is taken back.
pub(super) struct Mark {
    points: usize,
    events: usize,
    effort: SetaEffort,
    here: Solution,
    tips: Vec<AdheringTip>,
    ahead: f64,
    softest: Option<f64>,
}

impl Mark {
    pub fn of(progress: &SetaProgress, standing: &Standing) -> Self {
        let SetaProgress { result, here, ahead, softest, .. } = progress;
        Self {
            points: result.points.len(),
            events: result.events.len(),
            effort: result.effort,
            here: here.clone(),
            tips: standing.tips.clone(),
            ahead: *ahead,
            softest: *softest,
        }
    }

    pub fn restore(self, progress: &mut SetaProgress, standing: &mut Standing) {
        let SetaProgress { result, here, ahead, softest, .. } = progress;
        result.points.truncate(self.points);
        result.events.truncate(self.events);
        result.effort = self.effort;
        (*here, *ahead, *softest) = (self.here, self.ahead, self.softest);
        standing.tips = self.tips;
    }
}

/// A state of the last step that has a name.
#[derive(Clone, Copy)]
pub(super) enum Named {
    FirstDetachment,
    Peak,
    LastDetachment,
}

impl SetaPullOff {
    pub(super) fn named(&mut self, name: Named) -> &mut Option<SetaState> {
        match name {
            Named::FirstDetachment => &mut self.first_detachment,
            Named::Peak => &mut self.peak,
            Named::LastDetachment => &mut self.last_detachment,
        }
    }
}

impl SetaPullOff {
    /// Of nothing.
    pub(super) fn empty(elements: usize) -> Self {
        Self {
            points: Vec::new(),
            initial_stiffness: None,
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
