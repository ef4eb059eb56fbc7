//! One path on one mesh: followed to its end, every limit point on it located, none missed without a report.

use super::event_end::{end_at_event, event_passed};
use super::path_end::{Followed, is_next_to_plane, step, stopped_by_model};
use super::path_refinement::{fill_in, sharpen};
use crate::beam::planar::chain::NodeState;
use crate::beam::planar::planar_beam::PlanarBeam;
use crate::beam::reference_configuration::ReferenceConfiguration;
use crate::beam::spatial::spatial_beam::SpatialBeam;
use crate::model::peel::PeelModel;
use crate::model::problem::beam_problem::{Beam, BeamProblem};
use crate::solve::newton::Solution;
use crate::solve::path::equilibrium_path::Path;
use crate::solve::path::options::{PathError, PathOptions};
use crate::solve::points::locate::ROUGH;
use crate::solve::points::search::LimitPointKind;
use crate::solve::state::State;
use crate::study::asked::accuracy::Accuracy;
use crate::study::asked::stop_criteria::{Bound, StopCriteria};
use crate::study::peel::budget::{Budget, Checkpoint, Limits};
use crate::study::peel::result::{Failure, PathEnd, PathFailure};
use std::ops::Range;
use std::sync::Arc;

/// Path points after which a mesh is taken to hold the path up: several times what paths take that are resolved. What bounds the steps makes them as
/// many as they are.
fn points_allowed(options: &PathOptions) -> usize {
    if options.longest.is_some() { usize::MAX } else { 400 + 10 * options.elements }
}

/// Follows the path and locates its limit points.
pub(in crate::study::peel) fn follow(
    model: &PeelModel,
    problem: &BeamProblem,
    options: PathOptions,
    far: f64,
    relative: f64,
    limits: &Limits,
    budget: &Budget,
) -> Followed {
    let known = (limits.checkpoint.taken)(&options);
    let taken = known.len();
    let mut path = Path::new(problem, options).until(limits.should_stop()).knowing(known);
    let most = points_allowed(&options);
    let mut cut = false;
    let stopped = loop {
        let points = path.points().len();
        if points >= most && most < limits.stop.points {
            break Err(PathFailure::TooManyPoints { points: most, elements: options.elements });
        }
        if path.iterations() as f64 > budget.iterations(options.elements) {
            break Err(PathFailure::OutOfWork { iterations: path.iterations() });
        }
        if let Some(end) = limits.reached() {
            cut = true;
            break Ok(end);
        }
        let stepped = step(problem, &mut path, options.pace, far, relative, limits);
        if path.points().len() > points.max(taken) {
            path.waypoint().into_iter().for_each(|newest| (limits.checkpoint.keep)(&options, newest));
        }
        let passed = if stepped.is_ok() { event_passed(model, problem, path.points(), limits.stop) } else { None };
        match stepped {
            Ok(_) if let Some(event) = passed => break Ok(event),
            Ok(None) => {}
            // on finer elements the path may turn back before the pole
            Ok(Some(PathEnd::Upright(upright))) => break Err(PathFailure::NearUpright(upright)),
            Ok(Some(end)) => break Ok(end),
            // where a branch meets the planar path no equilibrium is certain
            Err(_) if is_next_to_plane(problem, path.points()) => break Ok(PathEnd::BackInPlane),
            Err(error) => break Err(PathFailure::Path(error)),
        }
    };
    let stopped = match stopped {
        // behind its first jump the path of a film that yields is not what the film does
        Err(PathFailure::Path(_)) if problem.system.step_dependence().is_yielding() && has_jumped(path.points()) => {
            Ok(PathEnd::Snapped)
        }
        stopped => stopped,
    };
    let failed = |trouble: PathFailure| {
        let (elements, order) = (options.elements, problem.beam.order());
        let failure = Failure::Path { cause: trouble.clone(), elements, order, asked: relative, given_up: None };
        (PathEnd::Failed(failure), Some(trouble))
    };
    let beyond = stopped.as_ref().err().and_then(|trouble| stopped_by_model(problem, path.points(), trouble));
    let (end, trouble) = match stopped {
        Ok(end) => (end, None),
        Err(trouble) => failed(trouble),
    };
    let mut points = path.points().to_vec();
    // beyond its model the point says nothing
    if matches!(trouble, Some(PathFailure::NearUpright(_))) {
        points.pop();
    }
    let stays = |pair: &[Arc<Solution>]| pair[1].observables.displacement == pair[0].observables.displacement;
    let (end, trouble) = match trouble {
        _ if points.windows(2).next().is_some_and(stays) => {
            points.truncate(1);
            failed(PathFailure::Stuck { step_nm: options.first_displacement })
        }
        None if end == PathEnd::Pivoting && !has_maximum(path.points()) => failed(PathFailure::LostAtRest {
            displacement_nm: path.points().last().map_or(0.0, |p| p.observables.displacement),
            process_nm: problem.beam.process_length(),
        }),
        trouble => (end, trouble),
    };
    let mut followed = Followed {
        spread: worst_spread(problem, &points),
        points,
        turns: Vec::new(),
        branch_points: Vec::new(),
        end,
        cut,
        iterations: path.iterations(),
        ripple: 0,
        level: false,
        upright: false,
        beyond,
        trouble,
        pace: options.pace,
        should_stop: limits.should_stop(),
    };
    followed.finish(problem, far);
    end_at_event(model, problem, &mut followed, limits.stop);
    // who interrupts it waits for its limit points alone
    if followed.trouble.is_none() && followed.end != PathEnd::Bound(Bound::Interrupted) {
        let mut ws = followed.workspace();
        let (tolerance, most) = (options.tolerance.min(ROUGH), limits.stop.points);
        let (iterations, jump) = fill_in(problem, &mut followed.points, relative, tolerance, most, &mut ws);
        followed.iterations += iterations + sharpen(problem, &mut followed.points, relative, tolerance, &mut ws);
        followed.trouble = jump.map(|after| PathFailure::Jumped {
            after,
            displacement_nm: followed.points[after].observables.displacement,
        });
    }
    let checked = followed.locate_turns(problem, relative).and_then(|()| followed.check_inertia(problem, relative));
    followed.trouble = match (followed.trouble.take(), checked.err()) {
        // what is missing on the way counts before what stops the path, but for what is missing where it stops
        (Some(_), Some(missing)) if followed.beyond.is_some() && followed.is_before_end(&missing, relative) => {
            Some(missing)
        }
        (trouble, missing) => trouble.or(missing),
    };
    if problem.system.step_dependence().is_yielding() {
        followed.end_at_jump();
    }
    followed.end_at_unresolved(problem);
    followed.end_where_drawn(problem);
    followed
}

impl Followed {
    /// Ends the path of a film that yields at a turn of the displacement that was not located: how it yields in a jump no equilibrium determines.
    fn end_at_jump(&mut self) {
        let Some(PathFailure::NotLocated { turn: LimitPointKind::Displacement, after, .. }) = self.trouble else {
            return;
        };
        self.points.truncate(after + 1);
        self.turns.retain(|turn| turn.1 < after);
        self.branch_points.retain(|branch| branch.0 < after);
        (self.end, self.trouble) = (PathEnd::Snapped, None);
    }
}

/// Whether the displacement has turned back on the way.
fn has_jumped(points: &[Arc<Solution>]) -> bool {
    points.iter().skip(1).any(|p| p.slope.displacement < 0.0)
}

/// Whether the force has turned down on the way.
fn has_maximum(points: &[Arc<Solution>]) -> bool {
    points.iter().skip(1).rev().skip(1).any(|p| p.slope.force < 0.0)
}

// -- The first integral along the beam at the points of a path: what it spreads by is the error of a mesh between its points --

/// The largest spread of the first integral along the beam at any point of the path, over the work of adhesion: zero where
/// a mesh resolves the beam. Without a potential, along a beam of varying outline and on ground that is not flat there is
/// no such integral.
pub(super) fn worst_spread(problem: &BeamProblem, points: &[Arc<Solution>]) -> f64 {
    if !problem.system.is_conservative() {
        return 0.0;
    }
    let spread = |point: &Arc<Solution>| match &problem.beam {
        Beam::Planar(beam) => planar(beam, &point.at),
        Beam::Spatial(beam) => spatial(beam, &point.at),
    };
    points.iter().map(spread).fold(0.0, f64::max) / problem.beam.rest_adhesion().abs()
}

/// What is lost on the way shows at the two ends, and most of it is lost in the element at an edge.
fn at_ends(at: &State) -> [Range<usize>; 2] {
    let last = at.mesh.elements() - 1;
    [0..1, last..last + 1]
}

fn planar(beam: &PlanarBeam, at: &State) -> f64 {
    if matches!(beam.rest, ReferenceConfiguration::Varying(_)) || !beam.substrate.is_flat() {
        return 0.0;
    }
    let sections = at_ends(at).map(|elements| beam.chain.node_states(beam.configuration(at), elements));
    // H x' becomes H (x' - 1)
    let displaced = |node: &NodeState| node.first_integral() - node.section.horizontal_force;
    let nodes = sections.iter().flatten();
    if beam.slip_reach.is_some() { range(nodes.map(displaced)) } else { range(nodes.map(NodeState::first_integral)) }
}

/// Forces along the ground spread by round-off alone, up to 2e-9 of the adhesion in a strip that is 40 nm wide: what the first integral has of
/// that is taken off.
fn spatial(beam: &SpatialBeam, at: &State) -> f64 {
    let Some(rest_curvature) = beam.uniform_rest_curvature() else { return 0.0 };
    let sections = at_ends(at).map(|elements| beam.end_states(at, elements));
    let integrals: Vec<_> = sections.iter().flatten().map(|section| section.integrals(rest_curvature)).collect();
    if beam.chain.density.held.is_some() {
        return range(integrals.iter().map(|at| at.energy - at.force[0]));
    }
    let along = |k: usize| range(integrals.iter().map(|at| at.force[k]));
    (range(integrals.iter().map(|at| at.energy)) - along(0) - along(1)).max(0.0)
}

/// Largest less least.
fn range(values: impl Iterator<Item = f64>) -> f64 {
    let (low, high) =
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
    high - low
}

// -- A path that is computed as far as it is asked for, up to where a whole peel ends --

/// The points of a path, one after the other, on one mesh: nothing is located or bounded on it. It ends by the rules of [`crate::study::peel`]; its
/// last point is the first beyond its end.
pub struct PathPoints<'p> {
    problem: &'p BeamProblem,
    path: Path<'p>,
    options: PathOptions,
    /// What is farther from the ground does not adhere, nm
    far: f64,
    relative: f64,
    stop: StopCriteria,
    end: Option<PathEnd>,
    failed: bool,
}

impl<'p> PathPoints<'p> {
    /// The path of a problem of this model; `stop` ends it before its end.
    pub fn new(
        model: &PeelModel,
        problem: &'p BeamProblem,
        options: PathOptions,
        accuracy: &Accuracy,
        stop: StopCriteria,
    ) -> Self {
        let limits = Limits { stop: &stop, checkpoint: &Checkpoint::NOTHING };
        let path = Path::new(problem, options).until(limits.should_stop());
        let (far, relative) = (model.line_law().cutoff_distance(), accuracy.relative);
        Self { problem, path, options, far, relative, stop, end: None, failed: false }
    }

    /// How it has ended, if it has.
    pub fn end(&self) -> Option<&PathEnd> {
        self.end.as_ref()
    }
}

impl Iterator for PathPoints<'_> {
    type Item = Result<Arc<Solution>, PathError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.end.is_some() || self.failed {
            return None;
        }
        let limits = Limits { stop: &self.stop, checkpoint: &Checkpoint::NOTHING };
        let before = self.path.points().len();
        match step(self.problem, &mut self.path, self.options.pace, self.far, self.relative, &limits) {
            Ok(end) => self.end = end,
            Err(error) => {
                self.failed = true;
                return Some(Err(error));
            }
        }
        self.path.points().get(before).map(|newest| Ok(Arc::clone(newest)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Form, PeelModel, StripModel};
    use crate::study::asked::accuracy::Resolution;
    use crate::study::{Accuracy, Checkpoint, StopCriteria};

    /// What the count of negative eigenvalues is for: limit points that were not located are reported as missing.
    #[test]
    fn a_turning_point_that_was_not_located_is_missed() {
        let (model, accuracy) = (PeelModel::from(StripModel::of_the_paper(100.0, 1.0)), Accuracy::to(1e-6));
        let problem = model.problem(Form::TwoField, accuracy.order(&model)).unwrap();
        let options = Resolution::first(&model, &accuracy).path_options(&model, accuracy.relative);
        let limits = Limits { stop: &StopCriteria::after_points(5000), checkpoint: &Checkpoint::NOTHING };
        let mut followed = follow(
            &model,
            &problem,
            options,
            4.0,
            accuracy.relative,
            &limits,
            &Budget::of(limits.stop, options.elements),
        );
        assert!(followed.check_inertia(&problem, accuracy.relative).is_ok());
        let located = followed.turns.iter().position(|turn| turn.0 == LimitPointKind::Displacement).unwrap();
        let (_, after, _) = followed.turns.remove(located);
        let missed = followed.check_inertia(&problem, accuracy.relative).unwrap_err();
        assert!(
            matches!(missed, PathFailure::Missed { after: a, from: 0, to: 1, turns: 0, .. } if a == after),
            "{missed}"
        );
    }
}
