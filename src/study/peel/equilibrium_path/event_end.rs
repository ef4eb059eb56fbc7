//! Where an event of the user ends a path.

use super::path_end::Followed;
use crate::model::peel::PeelModel;
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::newton::Solution;
use crate::study::asked::locator::Locator;
use crate::study::asked::stop_criteria::{Bound, StopCriteria};
use crate::study::peel::result::PathEnd;
use std::sync::Arc;

/// Points whose values say how large a quantity is, and that a polynomial goes through.
const AROUND: usize = 6;

/// The newest points of a path, of which the last two make its newest step.
fn newest(points: &[Arc<Solution>]) -> &[Arc<Solution>] {
    &points[points.len().saturating_sub(AROUND)..]
}

/// The end by the first event that a path passes on its newest step, if it passes one that ends it.
pub(super) fn event_passed(
    model: &PeelModel,
    problem: &BeamProblem,
    points: &[Arc<Solution>],
    stop: &StopCriteria,
) -> Option<PathEnd> {
    let newest = newest(points);
    let after = newest.len().checked_sub(2)?;
    let event = stop.first_passed(after, |event| Locator::new(model, problem, newest, Vec::new(), event).sought)?;
    Some(PathEnd::Bound(Bound::Event { name: event.name.clone() }))
}

/// Moves the last point of a path that an event has ended onto the event. Where that fails the point beyond it stays: it is an equilibrium too.
pub(super) fn end_at_event(model: &PeelModel, problem: &BeamProblem, followed: &mut Followed, stop: &StopCriteria) {
    let PathEnd::Bound(Bound::Event { name }) = &followed.end else { return };
    let Some(event) = stop.ending().find(|event| event.name == *name) else { return };
    let newest = newest(&followed.points);
    let Some(after) = newest.len().checked_sub(2) else { return };
    let sought = Locator::new(model, problem, newest, Vec::new(), event).sought;
    let found = sought.on_step(after, &mut followed.workspace());
    drop(sought);
    let Some(first) = found.ok().and_then(|found| found.into_iter().next()) else { return };
    followed.iterations += first.solution.iterations;
    if let Some(last) = followed.points.last_mut() {
        *last = first.solution;
    }
}
