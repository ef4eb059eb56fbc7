//! An event of a run: tips change, or beams buckle, and the seta comes to rest.

use super::{Run, SHORTEST};
use crate::solve::error::SolveError;
use crate::solve::state::State;
use crate::study::seta::failure::SetaFailure;
use crate::study::seta::progress::Named;
use crate::study::seta::rest::{Rested, come_to_rest};
use crate::study::seta::result::{EventCause, LocationError, SetaEnd, SetaEvent, SetaPoint};
use crate::study::seta::standing::RootDrive;

/// What a step leads to, and has not happened yet.
pub(super) struct Due {
    /// Where it begins
    pub start: State,
    /// The tips that change first; none where beams buckle
    pub tips: Vec<usize>,
    /// By how much its place is missed
    pub location: Option<LocationError>,
}

impl Run<'_> {
    /// Tips change, or the seta leaves its shape, and comes to rest with its root held.
    pub(super) fn happen(&mut self, drive: &RootDrive, event: Due) -> Result<(), SetaEnd> {
        let Due { start, tips, location } = event;
        let cause = if tips.is_empty() { EventCause::Buckling } else { EventCause::Tips };
        if cause == EventCause::Buckling && self.has_buckled_here() {
            return Err(self.lost(SolveError::LimitPointNotConfirmed));
        }
        let (before, here) = (self.last(), self.progress.here.clone());
        let state = self.state(&here, location);
        let displacement = here.observables.displacement;
        let tolerance = self.options.tolerance;
        let standing = self.standing.tips.clone();
        let rested = come_to_rest(&mut self.standing, drive, (start, displacement), &tips, tolerance, &mut self.ws);
        let Rested { solution, changes, iterations } = rested.map_err(|(cause, changes)| {
            let step = self.progress.step;
            self.standing.tips = standing;
            let outside = self.standing.outside(&here.at);
            match cause {
                SolveError::NotConverged { .. } if outside > 0 => {
                    SetaEnd::Failed(SetaFailure::Extrapolated { step, displacement, outside })
                }
                cause => SetaEnd::Failed(SetaFailure::Restless { step, displacement, changes, cause }),
            }
        })?;
        self.progress.result.effort.newton_iterations += iterations;
        let released = before.energy - solution.energy;
        let mut after = self.point(drive, &solution, before);
        after.released += released;
        let stiffness = solution.slope.force / solution.slope.displacement;
        let late = location.map_or(0.0, |location| location.displacement);
        let location = LocationError { force: (stiffness * late).abs(), displacement: late };
        self.progress.here = solution;
        let detaches = changes.iter().any(|change| !change.to.adheres());
        if detaches && before.step + 1 == self.loading.steps.len() {
            if self.progress.result.first_detachment.is_none() {
                self.keep(Named::FirstDetachment, state.clone());
            }
            self.keep(Named::LastDetachment, state);
        }
        self.progress.result.points.push(after);
        self.progress.result.events.push(SetaEvent { before, after, cause, tips: changes, released });
        self.keep_peak(after, Some(location));
        Ok(())
    }

    /// Whether the last event was one here in which beams buckled and no tip followed: it led back to where it began.
    fn has_buckled_here(&self) -> bool {
        self.progress.result.events.last().is_some_and(|event| {
            let SetaPoint { step, displacement, .. } = event.before;
            let there = self.progress.here.observables.displacement;
            let is_here = step == self.progress.step && (displacement - there).abs() < SHORTEST;
            is_here && event.cause == EventCause::Buckling && event.tips.is_empty()
        })
    }
}
