//! A path on one mesh after another: a mesh from the accuracy asked for, the path on it, and, where the error bounds say
//! so, a finer mesh and the path again.

use super::PathFailure::{Jumped, Missed, NearUpright, NotLocated, Path, TooManyPoints};
use super::assembly::{differences, empty, report};
use super::equilibrium_path::{Followed, follow};
use super::solution_history::SolutionHistory;
use super::special_points::{difference_at_start, error_at_start};
use super::{Effort, Failure, LimitPoint, PathEnd, PathFailure, Peel};
use crate::beam::MeshKind;
use crate::model::{BeamProblem, Discretisation, PeelModel};
use crate::solve::{LimitPointKind, MeasuredBeside, Pace, PathOptions};
use crate::study::Accuracy;
use crate::study::accuracy::{Choice, Resolution, most_elements};
use crate::study::checkpoint::Limits;
use crate::study::error_bounds::{
    DIFFERENCE_BOUND_FACTOR, PLAIN_IMPROVEMENT, STRIDE_BOUND_FACTOR, STRIDE_TOLERANCE_FACTOR, counts,
};
use crate::study::initial::{NotPrepared, Prepared, prepared};
use crate::study::refinement::{MOST_FAILED_IN_SPACE, refined};
use std::sync::Arc;

/// The first integral may spread by this many times the accuracy asked for, in units of the work of adhesion, at any point:
/// where it spreads by 1.4e-5, at an edge that carries the strip, the force of that point was wrong by 6e-8.
const SPREAD: f64 = 100.0;
/// Round-off of that spread.
const SPREAD_ROUND_OFF: f64 = 5e-10;
/// Below this relative error, an error that does not fall with more elements is taken for round-off.
const STAGNATION: f64 = 2e-8;
/// The same where the error did not fall with this many times as many elements.
const CERTAIN_STAGNATION: f64 = 1e-6;
const MANY_MORE: usize = 2;
/// Length of the steps of a path that confirms another, over those of the other.
const SHORTER: f64 = 0.5;
/// Most such paths.
const MOST_SHORTER: i32 = 3;
/// Newton iterations after which a path in space is lost that is followed warily, over those of all meshes before.
const WARILY: usize = 2;

/// Error wanted of a prediction on a branch, over that on a path from rest: with longer steps a branch came back to the path that it had left
/// from far away, 0.8 nm before it meets it in the strip 40 nm wide.
const FROM_BRANCH_POINT: f64 = 2.5e-3;

/// A path that begins at an equilibrium that is known, beside a branch point.
pub(in crate::study) struct KnownStart {
    /// With that equilibrium as its start
    pub problem: Arc<BeamProblem>,
    /// Of the first step from there, nm
    pub first_displacement: f64,
}

/// The path on one mesh after another, until its bounds are what is wanted; where no mesh gives one that can be used, at the next of the `paces`.
pub(super) fn on_meshes(
    model: &PeelModel,
    accuracy: &Accuracy,
    limits: &Limits,
    start: Option<&KnownStart>,
    paces: &[Pace],
) -> Peel {
    let accuracy = &accuracy.fitted(model);
    let Choice { mesh, form, .. } = accuracy.choice;
    let first = Resolution::first(model, accuracy);
    let how = Discretisation { form, order: first.order, mesh };
    let prepared = match start {
        Some(known) => Ok((known.problem.clone(), Vec::new(), None)),
        None => prepared(model, how, limits.should_stop())
            .map(|Prepared { problem, steps, relaxed }| (Arc::new(problem), steps, relaxed)),
    };
    let (problem, steps, relaxed) = match prepared {
        Ok(prepared) => prepared,
        Err(NotPrepared { why, steps }) => {
            let (end, asked) = (PathEnd::Failed(Failure::NoStart(why)), accuracy.relative);
            return Peel { steps, end, asked, choice: accuracy.choice, ..empty(model) };
        }
    };
    let far = model.line_law().cutoff_distance();
    let mut others: Vec<Vec<LimitPoint>> = Vec::new();
    let (mut iterations, mut unfinished, mut finest) = (0, false, 0);
    let mut followed_at = |pace: Pace, first: Resolution| {
        // where a strip turns about its axis, or a plane nearly loses its stability, its roll alone goes forward
        let (problem, most) = match (pace, model.space) {
            (Pace::Wary, Some(_)) => (&Arc::new(problem.measured_beside(MeasuredBeside::Roll)), WARILY * iterations),
            _ => (&problem, usize::MAX),
        };
        let mut failed = 0;
        refined(first, most_elements(model), Attempt::is_better_than, |resolution, best: Option<&Attempt>| {
            let mut options = PathOptions { pace, ..resolution.path_options(model, accuracy.relative) };
            if let Some(known) = start {
                options.first_displacement = known.first_displacement;
                options.step_tolerance *= FROM_BRANCH_POINT;
            }
            let followed = follow(problem, options, far, accuracy.relative, limits);
            iterations += followed.iterations;
            let attempt = Attempt::new(model, problem, followed, resolution, accuracy);
            let enough = accuracy.choice.elements.is_some()
                || attempt.is_enough()
                || best.is_some_and(|best| attempt.is_stuck_behind(best));
            let over = attempt.cut || limits.reached().is_some();
            unfinished = over && (attempt.cut || attempt.trouble.is_some() || !enough);
            let hopeless = attempt.trouble.is_some() && model.space.is_some() && {
                failed += 1;
                failed == MOST_FAILED_IN_SPACE || iterations > most
            };
            if attempt.trouble.is_none() {
                finest = finest.max(attempt.peel.effort.elements);
                others.push(attempt.peel.limit_points.clone());
            }
            let finer = (!enough && !over && !hopeless).then_some(attempt.next);
            (attempt, finer)
        })
        .map(|best| Attempt { finest, ..best })
    };
    let mut best: Option<Attempt> = None;
    for &pace in paces {
        // a mesh that stays and is too coarse is so at any pace: watched, a path begins on the one that came farthest
        let farthest = best.as_ref().filter(|_| pace == Pace::Watchful && mesh != MeshKind::Moving);
        let reached = farthest.map(|best| best.peel.effort.elements);
        let again = followed_at(pace, Resolution { elements: reached.unwrap_or(first.elements), ..first });
        best = best.into_iter().chain(again).reduce(|one, other| if other.is_better_than(&one) { other } else { one });
        let lost = best.as_ref().is_some_and(|best| best.failure().is_some());
        if !lost || limits.reached().is_some() {
            break;
        }
    }
    if let Some(best) = best.as_mut().filter(|best| best.worst() > 1.0) {
        best.widen(&others);
    }
    if problem.system.has_history() && accuracy.choice.step.is_none() && !unfinished {
        best = best.map(|best| {
            let shorter = Shorter { model, problem: &problem, accuracy, limits, far };
            let (confirmed, further) = shorter.confirmed(best);
            iterations += further;
            unfinished = confirmed.cut;
            confirmed
        });
    }
    if let Some(best) = &mut best {
        let late = best.peel.integrate_works(limits.should_stop());
        best.trouble = best.trouble.take().or(late);
    }
    let mut peel = best.map_or_else(|| empty(model), Attempt::into_peel);
    (peel.steps, peel.relaxed_start) = (steps, relaxed);
    peel.effort.newton_iterations = iterations;
    peel.unfinished = unfinished;
    peel
}

/// Where the material points remember how they have slid, what a path ends in depends on its steps: it is followed again with shorter
/// ones.
struct Shorter<'r> {
    model: &'r PeelModel,
    problem: &'r Arc<BeamProblem>,
    accuracy: &'r Accuracy,
    limits: &'r Limits<'r>,
    far: f64,
}

impl Shorter<'_> {
    /// The same path with shorter steps, until what that changes is within the accuracy asked for, with bounds that hold it; and the
    /// Newton iterations it took. One that cannot be confirmed has failed.
    fn confirmed(&self, mut best: Attempt) -> (Attempt, usize) {
        let mut iterations = 0;
        let relative = self.accuracy.relative;
        let first = Resolution::first(self.model, self.accuracy);
        for tries in 1..=MOST_SHORTER {
            if best.trouble.is_some() || best.cut {
                break;
            }
            let Effort { elements, order, .. } = best.peel.effort;
            let resolution = Resolution { elements, order, stride: SHORTER.powi(tries), ..first };
            let options = resolution.path_options(self.model, relative);
            let followed = follow(self.problem, options, self.far, relative, self.limits);
            iterations += followed.iterations;
            let mut next = Attempt::new(self.model, self.problem, followed, resolution, self.accuracy);
            let change = next.allow_for(&best, self.problem);
            best = next;
            if change <= relative {
                break;
            }
        }
        (best, iterations)
    }
}

/// One mesh tried, and what it was worth.
struct Attempt {
    peel: Peel,
    /// Largest relative difference to more elements, over the accuracy asked for.
    difference: f64,
    /// How many numbers are not as accurate as was asked.
    missed: usize,
    /// Most elements on which the path could be used.
    finest: usize,
    /// Largest spread of the first integral over what is wanted: the error between the points that `difference` looks at.
    spread: f64,
    /// Why the path is unusable, if it is.
    trouble: Option<PathFailure>,
    /// The end that the model gives where the path cannot be continued.
    beyond: Option<PathEnd>,
    /// Whether its path was left before its end for want of time, or because the user wanted it.
    cut: bool,
    /// What to try next.
    next: Resolution,
    /// Whether its material points remember how they have slid.
    remembers: bool,
}

impl Attempt {
    fn new(
        model: &PeelModel,
        problem: &Arc<BeamProblem>,
        followed: Followed,
        resolution: Resolution,
        accuracy: &Accuracy,
    ) -> Self {
        let Resolution { elements, step_tolerance, order, .. } = resolution;
        let relative = accuracy.relative;
        let mut spread = f64::INFINITY;
        let mut peel = report(model, problem, &followed, relative);
        let start = difference_at_start(&peel, problem, &followed.points);
        let at_start = start.map_or(0.0, |(first, difference)| {
            peel.allow_for_start(first, &difference);
            error_at_start(&peel, problem, first, &difference)
        });
        let differences = differences(&followed, problem).into_iter().map(|d| DIFFERENCE_BOUND_FACTOR * d / relative);
        let missed = differences.clone().filter(|difference| difference.is_nan() || *difference > 1.0).count();
        let difference = differences.fold(at_start / relative, f64::max);
        let next = match &followed.trouble {
            None => {
                spread = followed.spread / (SPREAD * relative).max(SPREAD_ROUND_OFF);
                resolution.finer(difference, spread)
            }
            // a displacement that turns nowhere may be a jump as well
            Some(Missed { .. } | Jumped { .. } | NotLocated { turn: LimitPointKind::Displacement, .. }) => {
                Resolution { step_tolerance: 0.3 * step_tolerance, ..resolution.times(1.25) }
            }
            Some(_) => resolution.times(1.5),
        };
        let trouble = followed.trouble.clone().or_else(|| followed.late());
        peel.asked = relative;
        peel.choice = accuracy.choice;
        peel.effort = Effort { points: peel.points.len(), newton_iterations: 0, elements, order, pace: followed.pace };
        let (cut, beyond, remembers) = (followed.cut, followed.beyond, problem.system.has_history());
        let first = |place: f64| followed.turns.iter().find(|turn| turn.2.observables.displacement == place);
        let peak = peel.initiation_peak.and_then(|peak| first(peak.displacement)).map(|turn| turn.2.solution.clone());
        let limit_points = followed.turns.iter().map(|turn| turn.2.solution.clone()).collect();
        peel.trace = Some(SolutionHistory { problem: problem.clone(), points: followed.points, peak, limit_points });
        Self { peel, difference, missed, spread, trouble, beyond, cut, next, remembers, finest: elements }
    }

    /// The difference to more elements; infinite where the path is unusable.
    fn worst(&self) -> f64 {
        if self.trouble.is_some() { f64::INFINITY } else { self.difference }
    }

    /// Whether nothing finer is needed, as where a path that cannot be continued ends with its model.
    fn is_enough(&self) -> bool {
        let ends = matches!(self.beyond, Some(PathEnd::Upright(_) | PathEnd::Pivoting));
        let stopped = ends && matches!(self.trouble, Some(Path(_)));
        self.worst() <= 1.0 && self.spread <= 1.0 || stopped && self.difference <= 1.0
    }

    /// The end that its model gives to a path that cannot be continued.
    fn model_end(&self) -> Option<PathEnd> {
        let stopped = matches!(self.trouble, Some(Path(_) | TooManyPoints { .. } | NearUpright(_)));
        self.beyond.clone().filter(|_| stopped)
    }

    /// A whole path comes before one that was cut, then the error bounds; among those that are met, the first integral.
    fn is_better_than(&self, best: &Self) -> bool {
        let met = |attempt: &Self| attempt.worst() <= 1.0;
        let small = |attempt: &Self| attempt.worst() * attempt.peel.asked < STAGNATION;
        if self.cut && best.trouble.is_none() {
            false
        } else if self.trouble.is_some() && best.trouble.is_some() {
            let reached = |attempt: &Self| {
                attempt.peel.limit_points.iter().filter(|p| p.kind == LimitPointKind::Displacement).count()
            };
            // where the model ends, no finer mesh goes on
            let named = |attempt: &Self| attempt.beyond.is_some();
            (named(self), reached(self), best.difference) > (named(best), reached(best), self.difference)
        } else if met(self) && met(best) {
            self.spread <= best.spread
        } else if met(self) || !small(best) {
            (self.missed, self.worst()) <= (best.missed, best.worst())
        } else if best.spread > 1.0 {
            self.spread < best.spread
        } else {
            // of two that have come down to round-off the one with fewer elements, unless the difference is plain
            self.worst() <= PLAIN_IMPROVEMENT * best.worst() && self.spread <= 1.0
        }
    }

    /// Where more elements did not bring the error down to what was asked for, it is round-off: no bound is less than twice the
    /// difference to what other meshes gave.
    fn widen(&mut self, others: &[Vec<LimitPoint>]) {
        let Peel { asked, limit_points, .. } = &mut self.peel;
        let count = limit_points.len();
        for other in others.iter().filter(|other| other.len() == count) {
            for (point, twin) in limit_points.iter_mut().zip(other) {
                let (force, displacement) = (point.force - twin.force, point.displacement - twin.displacement);
                let near = force.abs() < STAGNATION.max(*asked) * point.force.abs();
                if point.kind == twin.kind && near {
                    point.force_error = point.force_error.max(DIFFERENCE_BOUND_FACTOR * force.abs());
                    if !point.flat {
                        point.displacement_error =
                            point.displacement_error.max(DIFFERENCE_BOUND_FACTOR * displacement.abs());
                        let work = DIFFERENCE_BOUND_FACTOR * (point.work - twin.work).abs();
                        point.work_error = point.work_error.map(|error| error.max(work));
                    }
                }
            }
        }
        self.peel.tell_bounds();
    }

    /// Widens the bounds to what another choice of steps changed; returns the largest relative change of a limit point that counts.
    fn allow_for(&mut self, other: &Self, problem: &BeamProblem) -> f64 {
        let mut largest = 0.0f64;
        for (point, twin) in self.peel.limit_points.iter_mut().zip(&other.peel.limit_points) {
            let (force, displacement) = (point.force - twin.force, point.displacement - twin.displacement);
            point.force_error = point.force_error.max(STRIDE_BOUND_FACTOR * force.abs());
            point.displacement_error = point.displacement_error.max(STRIDE_BOUND_FACTOR * displacement.abs());
            if !counts(problem, point.kind) {
                // at a corner of the path two strides may agree by luck: what was not certain stays so, and no bound is below what was
                // asked for
                let asked = self.peel.asked;
                point.force_error = point.force_error.max(twin.force_error).max(asked * point.force.abs());
                let least = asked * point.displacement.abs();
                point.displacement_error = point.displacement_error.max(twin.displacement_error).max(least);
            }
            let place = if point.flat { 0.0 } else { (displacement / point.displacement).abs() };
            if counts(problem, point.kind) {
                largest = largest.max(STRIDE_BOUND_FACTOR * (force / point.force).abs().max(place));
            }
        }
        self.peel.tell_bounds();
        let kinds = |attempt: &Self| attempt.peel.limit_points.iter().map(|point| point.kind).collect::<Vec<_>>();
        if self.trouble.is_none() && !self.cut && kinds(self) != kinds(other) {
            let (shorter, longer) = (self.peel.limit_points.len(), other.peel.limit_points.len());
            self.trouble = Some(PathFailure::StepsMatter { shorter, longer });
        }
        largest
    }

    /// Whether more elements did not help. Where the error is small, what is left is round-off, which grows with them; where
    /// the bounds are met and the first integral is not, the path has come upon a pole of its law.
    fn is_stuck_behind(&self, best: &Self) -> bool {
        if best.worst() <= 1.0 {
            return self.spread > 0.5 * best.spread;
        }
        let small = self.worst() * self.peel.asked < STAGNATION;
        let many_more = 2 * self.peel.effort.elements >= 3 * best.peel.effort.elements;
        small && many_more && self.worst() > 0.5 * best.worst()
    }

    /// Whether more elements were tried, and brought nothing: the error is round-off, as of a force that is small beside the largest.
    fn is_at_round_off(&self) -> bool {
        self.finest >= MANY_MORE * self.peel.effort.elements
    }

    /// Why it is a failure, if it is.
    fn failure(&self) -> Option<PathFailure> {
        // a path that cannot be continued because its model ends has not failed
        let ended = self.model_end().is_some();
        let trouble = self.trouble.clone().filter(|_| !ended);
        let worst = if ended { self.difference } else { self.worst() };
        // a path that remembers has been followed again with other steps, whose mesh may be a little worse
        let missed = worst > if self.remembers { STRIDE_TOLERANCE_FACTOR } else { 1.0 }
            && worst * self.peel.asked > if self.is_at_round_off() { CERTAIN_STAGNATION } else { STAGNATION }
            && self.peel.choice.elements.is_none();
        let bounded = matches!(self.peel.end, PathEnd::Bound(_)) && !ended;
        trouble.or((missed && !bounded).then_some(PathFailure::BoundsMissed { factor: worst }))
    }

    /// The result, as a failure where the path cannot be used.
    fn into_peel(self) -> Peel {
        let (failure, model_end) = (self.failure(), self.model_end());
        let mut peel = self.peel;
        peel.end = model_end.unwrap_or(peel.end);
        if let Some(cause) = failure {
            if matches!(cause, PathFailure::StepsMatter { .. }) {
                // which of the limit points are there depends on the steps
                peel.forget_special_points();
            }
            let Effort { elements, order, .. } = peel.effort;
            peel.end = PathEnd::Failed(Failure::Path { cause, elements, order, asked: peel.asked });
        }
        peel
    }
}
