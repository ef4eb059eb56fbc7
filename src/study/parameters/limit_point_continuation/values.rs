//! The values of a sweep, with the model at each and what the path from rest has there.

use super::result::{PointKind, PointNotFound, Spacing};
use crate::model::check::error::ModelError;
use crate::model::peel::{Form, PeelModel};
use crate::model::problem::build::Discretisation;
use crate::solve::path::equilibrium_path::Path;
use crate::solve::path::segment::PathSegment;
use crate::solve::points::bracket::brackets;
use crate::solve::points::locate::{Located, locate};
use crate::solve::points::search::LimitPointKind;
use crate::solve::points::tracer::{PathEvent, PathTracer, TraceOptions};
use crate::solve::problem::Problem;
use crate::solve::workspace::Workspace;
use crate::study::asked::accuracy::{Accuracy, ORDER, Resolution};
use crate::study::asked::stop_criteria::{Bound, StopCriteria};
use crate::study::initial::prepared::prepared;
use crate::study::terms::term_selection::{checked, peel};

/// Parts of the sweep at whose ends the point is held against the path from rest.
const PARTS: usize = 4;

/// What is followed, over which values, and how well.
pub(super) struct Sweep<'a> {
    pub kind: PointKind,
    pub values: &'a [f64],
    pub spacing: Spacing,
    pub model: &'a dyn Fn(f64) -> PeelModel,
    pub at_coordinate: &'a dyn Fn(f64) -> PeelModel,
    pub accuracy: &'a Accuracy,
    pub stop: &'a dyn Fn() -> StopCriteria,
    pub solved: &'a dyn Fn(usize),
}

impl Sweep<'_> {
    pub(crate) fn coordinate(&self, index: usize) -> f64 {
        self.spacing.coordinate(self.values[index])
    }

    /// Whether the model at a value can be computed.
    pub(crate) fn check(&self, index: usize) -> Result<(), ModelError> {
        checked(&(self.model)(self.values[index]), self.accuracy)
    }

    /// The point where the path from rest has it at a value.
    pub(crate) fn initial_limit_point_of(&self, index: usize) -> Result<Option<Located>, PointNotFound> {
        initial_limit_point(&(self.model)(self.values[index]), self.kind, self.accuracy, &(self.stop)())
    }

    /// Whether the point is held against the path from rest at this value.
    pub(crate) fn is_milestone(&self, index: usize) -> bool {
        let last = self.values.len() - 1;
        index == last || index.is_multiple_of(last.div_ceil(PARTS).max(1))
    }
}

// -- Where the path from rest has the point that is to be followed --

/// The accuracy of the beginning of the path that finds the first maximum; the point is solved for again on a mesh of its
/// own.
const ROUGH: f64 = 1e-6;
/// Path points behind the maximum that interpolation may use.
const BEHIND: usize = 2;

/// The point on the path from rest, or nothing where the path has none; an error where the path cannot be computed.
pub(super) fn initial_limit_point(
    model: &PeelModel,
    kind: PointKind,
    accuracy: &Accuracy,
    stop: &StopCriteria,
) -> Result<Option<Located>, PointNotFound> {
    match kind {
        PointKind::InitiationPeak => first_maximum(model, stop),
        PointKind::SnapOff => snap_off(model, accuracy, stop),
    }
}

/// The first maximum of the force, from the beginning of the path.
fn first_maximum(model: &PeelModel, stop: &StopCriteria) -> Result<Option<Located>, PointNotFound> {
    let how = Discretisation::moving(Form::TwoField, ORDER);
    let problem = prepared(model, how, None).map_err(|failed| PointNotFound::NoStart(failed.why))?.problem;
    let far = model.line_law().cutoff_distance();
    let path = Path::new(&problem, Resolution::first(model, &Accuracy::to(ROUGH)).path_options(model, ROUGH));
    let trace = TraceOptions { kinds: &[LimitPointKind::Load], branches: false, relative: ROUGH, behind: BEHIND };
    let mut tracer = PathTracer::new(&problem, path, trace);
    loop {
        if tracer.path().points().len() >= stop.points {
            return Err(PointNotFound::NoMaximum(Bound::Points(stop.points)));
        }
        match tracer.advance().map_err(PointNotFound::Trace)? {
            PathEvent::LimitPoint { located, .. } => return Ok(Some(located)),
            PathEvent::Point(point) => {
                let o = point.observables;
                if let Some(most) = stop.displacement.filter(|&most| o.displacement > most) {
                    return Err(PointNotFound::NoMaximum(Bound::Displacement(most)));
                }
                let ended = problem.beam.is_clear(&point.at, far) || o.displacement <= 0.0 || o.force <= 0.0;
                if ended && tracer.path().points().len() > 2 {
                    return Ok(None);
                }
            }
            PathEvent::BranchPoint { .. } | PathEvent::InertiaChange { .. } => {}
        }
    }
}

/// The first displacement limit point, from the whole path.
fn snap_off(model: &PeelModel, accuracy: &Accuracy, stop: &StopCriteria) -> Result<Option<Located>, PointNotFound> {
    let peel = peel(model, accuracy, stop);
    let (Some(at), Some(trace)) = (peel.snap_off, &peel.trace) else {
        return PointNotFound::unknown_behind(peel.end).map_or(Ok(None), Err);
    };
    // what stays in the plane was computed there, and is followed in space
    if model.space.is_some() && trace.problem.beam.planar().is_some() {
        return Err(PointNotFound::NotFoundAgain);
    }
    let problem: &Problem = &trace.problem;
    let segment = PathSegment::around(problem, &trace.points, at.after);
    let mut ws = Workspace::default();
    let found =
        brackets(problem, &trace.points, at.after, &segment, LimitPointKind::Displacement, accuracy.relative, &mut ws);
    let bracket = found?.first().copied().ok_or(PointNotFound::NotFoundAgain)?;
    let located = locate(problem, &segment, LimitPointKind::Displacement, bracket, None, &mut ws);
    Ok(Some(located?))
}
