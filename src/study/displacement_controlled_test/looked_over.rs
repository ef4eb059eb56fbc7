//! Stations and events of the user on a stable piece of a test.

use super::result::TestPoint;
use super::stable_branch::{BranchEnd, BranchError, LoadingDirection, Machine, StableBranch};
use crate::beam::planar::planar_beam::FRONT;
use crate::solve::newton::Solution;
use crate::solve::points::passing::FoundValue;
use crate::solve::workspace::Workspace;
use crate::study::asked::error_bounds::least;
use crate::study::asked::events::{EventAction, StationQuantity};
use crate::study::asked::locator::{Bounds, Locator, StationErrors};
use crate::study::asked::measured::named;
use crate::study::asked::stop_criteria::Bound;
use std::sync::Arc;

/// A station, or where an event lies.
pub(super) struct Passed {
    pub event: usize,
    /// It lies behind this point of the piece
    pub after: usize,
    pub solution: Arc<Solution>,
    pub errors: Option<StationErrors>,
}

impl Machine<'_> {
    /// The equilibria of a piece at stations and events, in its order, and the piece: up to the first event that stops the test.
    pub(crate) fn looked_over(
        &self,
        leg: StableBranch,
        way: LoadingDirection,
    ) -> Result<(StableBranch, Vec<Passed>), BranchError> {
        let events = &self.stop.events;
        let bounds = Bounds { asked: self.relative, share: least(self.relative), are_known: true };
        let mut ws = Workspace::default().at(self.options.pace);
        let mut found: Vec<(f64, Passed)> = Vec::new();
        for (event, at) in events.iter().enumerate().filter(|_| leg.points.len() > 1) {
            let locator = Locator::new(self.model, self.problem, &leg.points, Vec::new(), at);
            for after in 0..leg.points.len() - 1 {
                let machine_nm = leg.points[after].observables.displacement;
                let lost = |cause| BranchError::NoEvent { name: at.name.clone(), machine_nm, cause };
                for FoundValue { solution, segment, .. } in locator.sought.on_step(after, &mut ws).map_err(lost)? {
                    let (best, errors) = locator.bounded(&solution, &segment, &bounds, &mut ws);
                    let place = solution.observables.displacement;
                    let ahead = if way == LoadingDirection::Retreat { place } else { -place };
                    // where the piece is cut its mesh stays
                    let solution = if at.action == EventAction::Stop { solution } else { best };
                    found.push((ahead, Passed { event, after, solution, errors }));
                }
            }
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut passed: Vec<Passed> = found.into_iter().map(|(_, passed)| passed).collect();
        let Some(stop) = passed.iter().position(|passed| events[passed.event].action == EventAction::Stop) else {
            return Ok((leg, passed));
        };
        passed.truncate(stop + 1);
        let Passed { event, after, ref solution, .. } = passed[stop];
        let end = BranchEnd::Bound(Bound::Event { name: events[event].name.clone() });
        Ok((self.cut(&leg, after, solution.clone(), end), passed))
    }

    /// An equilibrium of the test, to which the machine has done so much work, aJ.
    pub(crate) fn point(&self, solution: &Solution, way: LoadingDirection, work: f64) -> TestPoint {
        let o = &solution.observables;
        TestPoint {
            way,
            machine: o.displacement,
            displacement: o.displacement - self.problem.grip.compliance * o.force,
            force: o.force,
            work,
            front: o.monitors[FRONT],
            adheres: self.adhering(solution),
            jumped: false,
        }
    }

    /// Of the free end, nm.
    pub(crate) fn free_end_gap(&self, solution: &Solution) -> f64 {
        named(self.model, self.problem, StationQuantity::FreeEndGap).at(solution)
    }
}
