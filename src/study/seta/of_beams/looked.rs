//! Stations and events of the user on a stable piece.

use super::piece::Stretch;
use super::progress::Run;
use crate::solve::error::SolveError;
use crate::solve::newton::Solution;
use crate::solve::path::segment::PathSegment;
use crate::solve::points::passing::{PathNumber, SoughtValue};
use crate::solve::workspace::Workspace;
use crate::study::asked::events::{EventAction, EventAt, EventQuantity, StationQuantity};
use crate::study::peel::step_dependence::StepCurve;
use crate::study::seta::result::{SetaEnd, SetaStation};
use crate::study::seta::standing::RootDrive;
use crate::study::states::seta_state::LocationError;
use std::sync::Arc;

/// Two equilibria of a step nearer than this share of it are one.
const ONE: f64 = 1e-9;
/// A value is met to this share of itself.
const MET: f64 = 1e-11;
/// Points before and behind a step that its interpolation may use.
const AROUND: usize = 4;

/// An event on a step.
#[derive(Clone)]
struct Passed {
    label: f64,
    /// Which one
    event: usize,
    location: LocationError,
    solution: Arc<Solution>,
}

impl Run<'_> {
    /// Keeps the stations and events on the way to this label of a step; where the first one lies that stops the run, with its name.
    pub(crate) fn look(
        &mut self,
        drive: &RootDrive,
        (stretch, segment): (Stretch, &PathSegment),
        to: f64,
    ) -> Result<Option<(f64, Arc<Solution>, String)>, SetaEnd> {
        let (stop, mut ws) = (self.stop, std::mem::take(&mut self.ws));
        let events = stop.events.iter().enumerate();
        let found: Result<Vec<_>, SolveError> =
            events.map(|(event, at)| self.passed(drive, (stretch, segment), (event, at), &mut ws)).collect();
        self.ws = ws;
        let mut found = found.map_err(|cause| self.lost(cause))?.concat();
        found.sort_by(|a, b| a.label.total_cmp(&b.label));
        // what lies at the beginning of a step is that at the end of the one before
        let is_first = self.reached.result.points.len() < 2;
        let before = self.last();
        for Passed { label, event, location, solution } in found.into_iter().filter(|found| found.label <= to) {
            if label <= ONE * segment.end() && !is_first {
                continue;
            }
            let mut point = self.point(drive, &solution, before);
            point.work += StepCurve::interpolated(segment, label, &solution).work();
            let after = self.reached.result.points.len() - 1;
            let station = SetaStation { event, point, location: Some(location), jumped: false, after };
            self.reached.result.stations.push(station);
            if stop.events[event].action == EventAction::Stop {
                return Ok(Some((label, solution, stop.events[event].name.clone())));
            }
        }
        Ok(None)
    }

    /// Where on a step an event is.
    fn passed(
        &self,
        drive: &RootDrive,
        (stretch, segment): (Stretch, &PathSegment),
        (event, at): (usize, &EventAt),
        ws: &mut Workspace,
    ) -> Result<Vec<Passed>, SolveError> {
        let (Stretch { problem, points, after }, before) = (stretch, self.last());
        let number = match &at.quantity {
            EventQuantity::Named(StationQuantity::Displacement) => PathNumber::observable(problem, |o| o.displacement),
            EventQuantity::Named(StationQuantity::Force) => PathNumber::observable(problem, |o| o.force),
            EventQuantity::OfSeta(of) => PathNumber::of_state(problem, move |at| {
                of(&self.state(at, self.point_of(problem, drive, at, before), None))
            }),
            EventQuantity::Named(_) | EventQuantity::OfBeam(_) => return Ok(Vec::new()),
        };
        let (first, last) = (after.saturating_sub(AROUND), (after + AROUND).min(points.len()));
        let sought = SoughtValue::new(number, at.value, at.passing, &points[first..last]);
        let located = |solution: Arc<Solution>| {
            let off = sought.above(&solution).abs().max(MET * at.value.abs());
            let ahead = off / sought.number.rate(&solution, segment).abs();
            let per = solution.slope.times(ahead / segment.weights.dot(&solution.slope));
            let location = LocationError { force: per.force.abs(), displacement: per.displacement.abs() };
            Passed { label: segment.label(&solution.observables), event, location, solution }
        };
        Ok(sought.on_step(after - first, ws)?.into_iter().map(|found| located(found.solution)).collect())
    }
}
