//! A path on one mesh as an attempt: what it was worth, what to try next, and whether it has failed.

use super::assembly::{NO_ACCURACY, Whole, differences, force_round_off, report};
use super::equilibrium_path::path_end::Followed;
use super::result::PathFailure::{Jumped, Missed, NearUpright, NotLocated, Path, TooManyPoints};
use super::result::{Effort, Failure, GivenUp, PathEnd, PathFailure, Peel};
use super::solution_history::{LimitPoint, PathPoint, SolutionHistory};
use crate::beam::planar::model_limits::{PoleInReach, UprightSection};
use crate::model::peel::PeelModel;
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::points::search::LimitPointKind;
use crate::study::asked::accuracy::{Accuracy, Resolution};
use crate::study::asked::error_bounds::{
    DIFFERENCE_BOUND_FACTOR, PLAIN_IMPROVEMENT, STRIDE_BOUND_FACTOR, STRIDE_TOLERANCE_FACTOR, counts,
};
use crate::study::peel::along_path::special_points::{difference_at_start, error_at_start};
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

/// One mesh tried, and what it was worth.
pub(super) struct Attempt {
    pub(super) peel: Peel,
    /// Largest relative difference to more elements, over the accuracy asked for.
    difference: f64,
    /// How many numbers are not as accurate as was asked.
    missed: usize,
    /// Whether the round-off of the force explains that: a force that is small beside the largest is not known better.
    explained: bool,
    /// What other meshes say of its error.
    beside: Beside,
    /// Largest spread of the first integral over what is wanted: the error between the points that `difference` looks at.
    spread: f64,
    /// Why the path is unusable, if it is.
    pub(super) trouble: Option<PathFailure>,
    /// The end that the model gives where the path cannot be continued.
    beyond: Option<PathEnd>,
    /// Whether its path was left before its end for want of time, or because the user wanted it.
    pub(super) cut: bool,
    /// What to try next.
    pub(super) next: Resolution,
    /// Whether its material points remember how they have slid.
    remembers: bool,
}

/// What the other meshes on which the path could be used say of the error of one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Beside {
    /// Nothing: none has many more elements.
    #[default]
    Nothing,
    /// With many more elements the error did not fall.
    NoBetter,
    /// The same, and the finer ones have the same limit points: what it differs by is round-off, however large that is.
    Agreeing,
    /// The path has the same limit points on two meshes, one of which has many more elements, or on two with steps of other lengths where the material
    /// points remember: its bounds say how well they are known.
    Confirmed,
}

impl Attempt {
    pub(super) fn new(
        model: &PeelModel,
        problem: &Arc<BeamProblem>,
        mut followed: Followed,
        resolution: Resolution,
        accuracy: &Accuracy,
    ) -> Self {
        if problem.system.step_dependence().exists() {
            followed.leave_out_unresolved();
        }
        let Resolution { elements, step_tolerance, order, .. } = resolution;
        let relative = accuracy.relative;
        let mut spread = f64::INFINITY;
        let mut peel = report(model, problem, &followed, relative);
        let start = difference_at_start(&peel, problem, &followed.points);
        let at_start = start.map_or(0.0, |(first, difference)| {
            peel.allow_for_start(first, &difference);
            error_at_start(&peel, problem, first, &difference)
        });
        let found = |round_off| differences(&followed, problem, round_off).into_iter().map(|error| error / relative);
        let missed = |round_off| found(round_off).filter(|error| error.is_nan() || *error > 1.0).count();
        let round_off = force_round_off(model, problem, &followed);
        let (missed, explained) = (missed(0.0), missed(round_off) == 0 && at_start <= relative);
        let difference = found(0.0).fold(at_start / relative, f64::max);
        let next = match &followed.trouble {
            None => {
                spread = followed.spread / (SPREAD * relative).max(SPREAD_ROUND_OFF);
                resolution.finer(difference, spread)
            }
            // a displacement that turns nowhere may be a jump as well
            Some(Missed { .. } | Jumped { .. } | NotLocated { turn: LimitPointKind::Displacement, .. }) => {
                Resolution { step_tolerance: 0.3 * step_tolerance, ..resolution.times(1.25) }
            }
            // the path of a beam that is held is seldom lost for its elements
            Some(_) if model.is_held() && accuracy.choice.step.is_none() => {
                Resolution { step_tolerance: 0.5 * step_tolerance, ..resolution.times(1.5) }
            }
            Some(_) => resolution.times(1.5),
        };
        let trouble = followed.trouble.clone().or_else(|| followed.late());
        peel.asked = relative;
        peel.choice = accuracy.choice;
        peel.effort = Effort { points: peel.points.len(), newton_iterations: 0, elements, order, pace: followed.pace };
        let (cut, beyond, remembers) = (followed.cut, followed.beyond, problem.system.step_dependence().exists());
        let first = |place: f64| followed.turns.iter().find(|turn| turn.2.observables.displacement == place);
        let peak = peel.initiation_peak.and_then(|peak| first(peak.displacement)).map(|turn| turn.2.solution.clone());
        let limit_points = followed.turns.iter().map(|turn| turn.2.solution.clone()).collect();
        peel.trace = Some(SolutionHistory { problem: problem.clone(), points: followed.points, peak, limit_points });
        Self {
            peel,
            difference,
            missed,
            explained,
            spread,
            trouble,
            beyond,
            cut,
            next,
            remembers,
            beside: Beside::Nothing,
        }
    }

    /// The difference to more elements; infinite where the path is unusable.
    pub(super) fn worst(&self) -> f64 {
        if self.trouble.is_some() { f64::INFINITY } else { self.difference }
    }

    /// Where the path was lost, if it cannot be continued.
    pub(super) fn lost(&self) -> Option<Lost> {
        let stopped = matches!(self.trouble, Some(Path(_))) && self.beyond.is_none();
        self.peel.points.last().filter(|_| stopped).map(|last| self.lost_at(last))
    }

    /// The same where a limit point is missing, or what tells of one.
    pub(super) fn missing(&self) -> Option<Lost> {
        let after = self.trouble.as_ref().and_then(PathFailure::after);
        self.lost().or_else(|| self.peel.points.get(after?).map(|before| self.lost_at(before)))
    }

    fn lost_at(&self, point: &PathPoint) -> Lost {
        let largest = self.peel.points.iter().map(|point| point.force.abs()).fold(0.0, f64::max);
        Lost { displacement: point.displacement, force: point.force, largest }
    }

    /// The section that is so nearly upright that the elements do not resolve it, where the path ends at one.
    pub(super) fn unresolved(&self) -> Option<UprightSection> {
        match self.trouble {
            Some(NearUpright(section)) if matches!(section.pole, PoleInReach::Unresolved { .. }) => Some(section),
            _ => None,
        }
    }

    /// Whether nothing finer is needed, as where a path that cannot be continued ends with its model.
    pub(super) fn is_enough(&self) -> bool {
        let ends = matches!(self.beyond, Some(PathEnd::Upright(_) | PathEnd::Pivoting));
        let stopped = match &self.trouble {
            Some(Path(_)) => ends,
            Some(NearUpright(section)) => section.is_drawn(),
            _ => false,
        };
        self.worst() <= 1.0 && self.spread <= 1.0 || stopped && self.difference <= 1.0
    }

    /// The end that its model gives to a path that cannot be continued.
    fn model_end(&self) -> Option<PathEnd> {
        let stopped = matches!(self.trouble, Some(Path(_) | TooManyPoints { .. } | NearUpright(_)));
        self.beyond.clone().filter(|_| stopped && self.unresolved().is_none())
    }

    /// Whether its path is of no use: it stopped short, and its model gives it no end there.
    fn is_lost(&self) -> bool {
        self.trouble.is_some() && self.model_end().is_none()
    }

    /// A whole path comes before one that was cut or is lost, then the error bounds; among those that are met, the first integral.
    pub(super) fn is_better_than(&self, best: &Self) -> bool {
        let met = |attempt: &Self| attempt.worst() <= 1.0;
        let small = |attempt: &Self| attempt.worst() * attempt.peel.asked < STAGNATION;
        if self.cut && best.trouble.is_none() {
            false
        } else if self.trouble.is_none() && !self.cut && best.is_lost() {
            // a lost path misses no bounds, because next to nothing on it was located
            true
        } else if best.trouble.is_none() && self.is_lost() {
            false
        } else if self.trouble.is_some() && best.trouble.is_some() {
            let reached = |attempt: &Self| {
                attempt.peel.limit_points.iter().filter(|p| p.kind == LimitPointKind::Displacement).count()
            };
            // where the model ends, no finer mesh goes on
            let named = |attempt: &Self| attempt.beyond.is_some() && attempt.unresolved().is_none();
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
    pub(super) fn widen(&mut self, wholes: &[Whole]) {
        let worst = self.worst();
        let Peel { asked, limit_points, effort, .. } = &mut self.peel;
        let count = limit_points.len();
        for Whole { elements, limit_points: other } in wholes.iter().filter(|other| other.limit_points.len() == count) {
            // round-off larger than what is taken for it elsewhere shows on the finer meshes
            let certain = self.beside == Beside::Agreeing && worst * *asked > CERTAIN_STAGNATION;
            let widest = if certain && *elements >= effort.elements { NO_ACCURACY } else { STAGNATION.max(*asked) };
            for (point, twin) in limit_points.iter_mut().zip(other) {
                let (force, displacement) = (point.force - twin.force, point.displacement - twin.displacement);
                let near = force.abs() < widest * point.force.abs();
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

    /// Widens the bounds to what another choice of steps changed of the limit points that both paths have; returns the largest relative change of
    /// one that counts.
    pub(super) fn allow_for(&mut self, others: &[LimitPoint], problem: &BeamProblem) -> f64 {
        let mut largest = 0.0f64;
        for (point, twin) in self.peel.limit_points.iter_mut().zip(others) {
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
        largest
    }

    /// Whether more elements did not help. Where the error is small, what is left is round-off, which grows with them; where
    /// the bounds are met and the first integral is not, the path has come upon a pole of its law.
    pub(super) fn is_stuck_behind(&self, best: &Self) -> bool {
        if best.worst() <= 1.0 {
            return self.spread > 0.5 * best.spread;
        }
        let small = self.worst() * self.peel.asked < STAGNATION;
        let many_more = 2 * self.peel.effort.elements >= 3 * best.peel.effort.elements;
        small && many_more && self.worst() > 0.5 * best.worst()
    }

    /// The path, where it can be used.
    pub(super) fn whole(&self) -> Option<Whole> {
        let whole = || Whole { elements: self.peel.effort.elements, limit_points: self.peel.limit_points.clone() };
        self.trouble.is_none().then(whole)
    }

    /// Looks at what other meshes gave: where many more elements brought nothing the error is round-off, as of a force that is small beside the largest.
    pub(super) fn compare(&mut self, wholes: &[Whole]) {
        let own = self.peel.effort.elements;
        let finer: Vec<&Whole> = wholes.iter().filter(|other| other.elements >= MANY_MORE * own).collect();
        let agrees = finer.iter().any(|other| other.agrees_with(&self.peel.limit_points));
        self.beside = match (finer.is_empty(), agrees) {
            (true, _) => Beside::Nothing,
            (false, false) => Beside::NoBetter,
            (false, true) => Beside::Agreeing,
        };
    }

    /// Looks once more at all meshes, where nothing but its bounds makes a path a failure: it may have the same limit points on two of them, one with
    /// many more elements than the other. Bounds that do not explain by how much they differ there are widened.
    pub(super) fn confirm(&mut self, wholes: &[Whole]) {
        if !self.remembers && matches!(self.failure(), Some(PathFailure::BoundsMissed { .. })) {
            self.confirm_by(wholes, |least, most| most >= MANY_MORE * least);
        }
    }

    /// The same where material points remember: beside a path with other steps on another mesh, for whose difference its bounds allow.
    pub(super) fn confirm_steps(&mut self, wholes: &[Whole]) {
        self.confirm_by(wholes, |least, most| most > least);
    }

    /// Confirms it by those that have the same limit points, where the least and the most elements of them and of its own mesh are so far apart.
    fn confirm_by(&mut self, wholes: &[Whole], are_apart: fn(usize, usize) -> bool) {
        let Peel { limit_points, effort, .. } = &mut self.peel;
        let same: Vec<&Whole> = wholes.iter().filter(|other| other.agrees_with(limit_points)).collect();
        let own = effort.elements;
        let (least, most) =
            same.iter().fold((own, own), |(a, b), other| (a.min(other.elements), b.max(other.elements)));
        if are_apart(least, most) {
            same.iter().for_each(|other| other.widen_unexplained(limit_points));
            self.peel.tell_bounds();
            self.beside = Beside::Confirmed;
        }
    }

    /// Whether the mesh lies beside the front at the newest point, by more than the length of the process zone: as far as its front is from that of
    /// `finely`, the same beam with tilted sections counted finely.
    pub(super) fn is_beside_front(&self, finely: &BeamProblem) -> bool {
        let newest = self.peel.trace.as_ref().and_then(|SolutionHistory { problem, points, .. }| {
            let at = &points.last()?.at;
            Some((problem.beam.planar()?.front_of(at), finely.beam.planar()?.front_of(at)))
        });
        newest.is_some_and(|(counted, fine)| (counted - fine).abs() > finely.beam.process_length())
    }

    /// The relative error up to which it is taken for round-off. Where the material points remember, it may be of the steps.
    fn round_off(&self) -> f64 {
        match self.beside {
            Beside::Nothing => STAGNATION,
            Beside::Confirmed => NO_ACCURACY,
            Beside::Agreeing if !self.remembers => NO_ACCURACY,
            Beside::NoBetter | Beside::Agreeing => CERTAIN_STAGNATION,
        }
    }

    /// Whether its bounds are farther from what was asked than another choice of steps explains.
    pub(super) fn misses_by_far(&self) -> bool {
        self.trouble.is_none() && self.difference > STRIDE_TOLERANCE_FACTOR && !self.explained
    }

    /// Why it is a failure, if it is.
    pub(super) fn failure(&self) -> Option<PathFailure> {
        // a path that cannot be continued because its model ends has not failed
        let ended = self.model_end().is_some();
        let trouble = self.trouble.clone().filter(|_| !ended);
        let worst = if ended { self.difference } else { self.worst() };
        // a path that remembers has been followed again with other steps, whose mesh may be a little worse
        let missed = worst > if self.remembers { STRIDE_TOLERANCE_FACTOR } else { 1.0 }
            && worst * self.peel.asked > self.round_off()
            && !self.explained
            && self.peel.choice.elements.is_none();
        let bounded = matches!(self.peel.end, PathEnd::Bound(_)) && !ended;
        trouble.or((missed && !bounded).then_some(PathFailure::BoundsMissed { factor: worst }))
    }

    /// The result, as a failure where the path cannot be used; `given_up` says why no more was tried, where more would have been.
    pub(super) fn into_peel(self, given_up: Option<GivenUp>) -> Peel {
        let (failure, model_end) = (self.failure(), self.model_end());
        let mut peel = self.peel;
        peel.end = model_end.unwrap_or(peel.end);
        if let Some(cause) = failure {
            let Effort { elements, order, .. } = peel.effort;
            peel.end = PathEnd::Failed(Failure::Path { cause, elements, order, asked: peel.asked, given_up });
        }
        peel
    }
}

// -- Where a path was lost on one mesh, beside where it was lost on another --

/// Relative difference of two places at which two meshes lose a path for one reason: in the random samples they lay within 1e-9 to 3e-4 of each other.
const SAME_PLACE: f64 = 1e-3;

/// The newest point of a path that cannot be continued.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lost {
    pub(super) displacement: f64,
    pub(super) force: f64,
    /// The largest force on the path, nN
    pub(super) largest: f64,
}

impl Lost {
    /// Whether this is the same place, as far as two meshes can tell.
    pub(super) fn is_near(&self, other: &Self) -> bool {
        let near = |one: f64, other: f64| (one - other).abs() <= SAME_PLACE * one.abs();
        near(self.displacement, other.displacement) && near(self.force, other.force)
    }

    /// The same where the force is small beside the largest one, as of a tape that hangs by its edge: neither mesh knows it better than that.
    pub(super) fn is_near_by_largest(&self, other: &Self) -> bool {
        let place = (self.displacement - other.displacement).abs() <= SAME_PLACE * self.displacement.abs();
        place && (self.force - other.force).abs() <= SAME_PLACE * self.largest
    }
}

#[cfg(test)]
mod lost_tests {
    use super::*;

    /// On a plateau the force is the same everywhere, and on the way back the displacement is passed twice: both count.
    #[test]
    fn the_same_place_has_the_same_force_and_displacement() {
        let lost = Lost { displacement: 4.108591, force: 0.0343317, largest: 1.0 };
        assert!(lost.is_near(&Lost { displacement: 4.108925, force: 0.0343314, ..lost }));
        assert!(!lost.is_near(&Lost { displacement: 4.15, ..lost }));
        assert!(!lost.is_near(&Lost { force: 0.0344, ..lost }));
        assert!(lost.is_near_by_largest(&Lost { force: 0.0344, ..lost }));
        assert!(!lost.is_near_by_largest(&Lost { force: 0.0364, ..lost }));
        assert!(!lost.is_near_by_largest(&Lost { displacement: 4.15, ..lost }));
    }
}

#[cfg(test)]
mod tests {
    use super::super::assembly::empty;
    use super::*;
    use crate::model::StripModel;
    use crate::solve::SolveError;

    /// A path on so many elements, of which so many numbers differ by `difference` times what was asked.
    fn attempt(elements: usize, difference: f64, missed: usize, trouble: Option<PathFailure>) -> Attempt {
        let model = PeelModel::from(StripModel::of_the_paper(100.0, 1.0));
        let accuracy = Accuracy::to(1e-9);
        let mut peel = Peel { asked: 1e-9, ..empty(&model) };
        peel.effort.elements = elements;
        Attempt {
            peel,
            difference,
            missed,
            explained: false,
            beside: Beside::Nothing,
            spread: 0.0,
            trouble,
            beyond: None,
            cut: false,
            next: Resolution::first(&model, &accuracy),
            remembers: false,
        }
    }

    fn lost(elements: usize) -> Attempt {
        let cause = SolveError::SingularGrip;
        let trouble = NotLocated { turn: LimitPointKind::Displacement, after: 3, displacement_nm: 0.6, cause };
        attempt(elements, 0.0, 0, Some(trouble))
    }

    /// A path on which nothing was located misses no bound; one that is whole is better all the same, in either order, unless it was cut.
    #[test]
    fn a_lost_path_is_no_better_than_a_whole_one() {
        let whole = attempt(104, 13.0, 1, None);
        assert!(whole.is_better_than(&lost(68)));
        assert!(!lost(68).is_better_than(&whole));
        assert!(!lost(68).is_better_than(&attempt(104, 1e5, 3, None)));
        assert!(!Attempt { cut: true, ..attempt(104, 13.0, 1, None) }.is_better_than(&lost(68)));
        let ended = Attempt { beyond: Some(PathEnd::Pivoting), ..attempt(68, 0.5, 0, lost(68).trouble) };
        assert!(whole.is_better_than(&ended), "a limit point that was not located is no end of a model");
    }

    /// Bounds above what was asked for are a failure unless two meshes have the same limit points, one with twice the elements of the other.
    #[test]
    fn a_whole_path_is_confirmed_by_two_meshes_far_apart() {
        let on = |elements| Whole { elements, limit_points: Vec::new() };
        let failure = |wholes: &[Whole]| {
            let mut attempt = attempt(336, 110.0, 1, None);
            attempt.confirm(wholes);
            attempt.failure()
        };
        assert_eq!(failure(&[on(336), on(200)]), Some(PathFailure::BoundsMissed { factor: 110.0 }));
        assert_eq!(failure(&[on(336), on(168)]), None);
        assert_eq!(failure(&[on(672)]), None);
        assert_eq!(failure(&[on(336), on(200), on(400)]), None);
    }
}
