//! One path on one mesh: followed to its end, every limit point on it located, none missed without a report.

use super::first_integral::worst_spread;
use super::followed::Followed;
use super::model_end::stopped_by_model;
use super::path_end::{is_next_to_plane, step};
use super::path_refinement::fill_in;
use super::slope_polishing::sharpen;
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::newton::Solution;
use crate::solve::path::equilibrium_path::Path;
use crate::solve::path::options::PathOptions;
use crate::solve::points::locate::ROUGH;
use crate::study::checkpoint::Limits;
use crate::study::peel::budget::Budget;
use crate::study::peel::failure::{Failure, PathFailure};
use crate::study::peel::result::PathEnd;
use crate::study::stop_criteria::Bound;
use std::sync::Arc;

/// Path points after which a mesh is taken to hold the path up: several times what paths take that are resolved.
fn points_allowed(elements: usize) -> usize {
    400 + 10 * elements
}

/// Follows the path and locates its limit points.
pub(in crate::study::peel) fn follow(
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
    let most = points_allowed(options.elements);
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
        match stepped {
            Ok(None) => {}
            // on finer elements the path may turn back before the pole
            Ok(Some(PathEnd::Upright(upright))) => break Err(PathFailure::NearUpright(upright)),
            Ok(Some(end)) => break Ok(end),
            // where a branch meets the planar path no equilibrium is certain
            Err(_) if is_next_to_plane(problem, path.points()) => break Ok(PathEnd::BackInPlane),
            Err(error) => break Err(PathFailure::Path(error)),
        }
    };
    let failed = |trouble: PathFailure| {
        let (elements, order) = (options.elements, problem.beam.order());
        let failure = Failure::Path { cause: trouble.clone(), elements, order, asked: relative, given_up: false };
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
    followed.end_at_unresolved(problem);
    followed.end_where_drawn(problem);
    followed
}

/// Whether the force has turned down on the way.
fn has_maximum(points: &[Arc<Solution>]) -> bool {
    points.iter().skip(1).rev().skip(1).any(|p| p.slope.force < 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Form, PeelModel, StripModel};
    use crate::solve::LimitPointKind;
    use crate::study::accuracy::Resolution;
    use crate::study::{Accuracy, Checkpoint, StopCriteria};

    /// What the count of negative eigenvalues is for: limit points that were not located are reported as missing.
    #[test]
    fn a_turning_point_that_was_not_located_is_missed() {
        let (model, accuracy) = (PeelModel::from(StripModel::of_the_paper(100.0, 1.0)), Accuracy::to(1e-6));
        let problem = model.problem(Form::TwoField, accuracy.order()).unwrap();
        let options = Resolution::first(&model, &accuracy).path_options(&model, accuracy.relative);
        let limits = Limits { stop: &StopCriteria::after_points(5000), checkpoint: &Checkpoint::NOTHING };
        let mut followed =
            follow(&problem, options, 4.0, accuracy.relative, &limits, &Budget::of(limits.stop, options.elements));
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
