//! Where a run ends, and why.

use super::Run;
use crate::solve::error::SolveError;
use crate::study::seta::advance::Refusal;
use crate::study::seta::failure::SetaFailure;
use crate::study::seta::loading::SetaStart;
use crate::study::seta::progress::SetaProgress;
use crate::study::seta::result::SetaEnd;
use crate::study::stop_criteria::{Bound, Stage};

/// What of all work may be missing at the end, over the tolerance of each step; at least and at most.
const MISSING: f64 = 10.0;
const LEAST_MISSING: f64 = 1e-6;
const MOST_MISSING: f64 = 0.05;
/// Error of the largest energy of a run, over it, that adds up from round-off.
const ROUND_OFF: f64 = 1e-10;

impl Run<'_> {
    /// The end of a run whose steps are all taken: completed, if its work is where it ought to be.
    pub(super) fn finished(&self) -> SetaEnd {
        let result = &self.progress.result;
        let balance = self.options.balance;
        let (missing, turnover) = (result.unaccounted(), result.turnover());
        let round_off = ROUND_OFF * result.points.iter().fold(0.0f64, |most, point| most.max(point.energy.abs()));
        // what is no number is missing as well
        if missing.abs() <= (MISSING * balance).clamp(LEAST_MISSING, MOST_MISSING) * turnover + round_off {
            return SetaEnd::Completed;
        }
        let work = result.points.last().map_or(0.0, |last| last.work);
        let share = missing.abs() / turnover;
        SetaEnd::Failed(SetaFailure::Unaccounted { missing, work, share, balance })
    }

    /// How deep the root can be pressed, nm.
    pub(super) fn deepest(&self) -> f64 {
        let above = if let SetaStart::Above(height) = self.loading.start { height } else { 0.0 };
        above + self.standing.model.seta.brush_height
    }

    pub(super) fn bound(&self) -> Option<Bound> {
        let most = self.stop.points;
        let points = self.progress.result.points.len() >= most;
        let bounded = self.bounded();
        let displacement = self.progress.here.observables.displacement >= bounded;
        points
            .then_some(Bound::Points(most))
            .or(displacement.then_some(Bound::Displacement(bounded)))
            .or_else(|| self.stop.reached_bound(Stage::Path))
    }

    /// The displacement at which the last step is left, nm.
    pub(super) fn bounded(&self) -> f64 {
        let is_last = self.progress.step + 1 == self.loading.steps.len();
        self.stop.displacement.filter(|_| is_last).unwrap_or(f64::INFINITY)
    }

    /// Why no step is short enough.
    pub(super) fn refused(&self, why: Refusal) -> SetaEnd {
        match why {
            Refusal::Unsolved(cause) => self.lost(cause),
            Refusal::TooFar | Refusal::Unstable => self.lost(SolveError::LimitPointNotConfirmed),
            Refusal::Unbalanced(times) => {
                let SetaProgress { step, here, .. } = &self.progress;
                let (displacement, imbalance) = (here.observables.displacement, times * self.options.balance);
                SetaEnd::Failed(SetaFailure::Unbalanced { step: *step, displacement, imbalance })
            }
        }
    }

    pub(super) fn lost(&self, cause: SolveError) -> SetaEnd {
        if cause == SolveError::Stopped {
            return SetaEnd::Bound(self.stop.reached_bound(Stage::Results).unwrap_or(Bound::Interrupted));
        }
        let SetaProgress { step, here, .. } = &self.progress;
        let displacement = here.observables.displacement;
        SetaEnd::Failed(SetaFailure::Lost { step: *step, displacement, attached: self.standing.attached(), cause })
    }
}
