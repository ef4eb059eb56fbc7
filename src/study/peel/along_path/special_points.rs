//! The points of a path that have a name: peaks are located limit points, or there are none.

use crate::beam::planar::planar_beam::FRONT;
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::newton::Solution;
use crate::solve::points::locate::difference_on_more_elements;
use crate::solve::points::search::LimitPointKind;
use crate::solve::state::Observables;
use crate::solve::workspace::Workspace;
use crate::study::asked::error_bounds::{DIFFERENCE_BOUND_FACTOR, LEVEL_FACTOR, ROUND_OFF, least};
use crate::study::peel::equilibrium_path::path_end::Followed;
use crate::study::peel::result::{LargestComputedForce, PathEnd, PathFailure, Peel, Plateau};
use crate::study::peel::solution_history::{LimitPoint, PathPoint, Peak};
use crate::study::peel::step_dependence::StepCurve;
use std::ops::Range;
use std::sync::Arc;

/// A force below this share of its scale is round-off.
const PULL: f64 = 1e-6;

/// Names the points of a path with points and limit points.
pub(in crate::study::peel) fn name_special_points(peel: &mut Peel, problem: &BeamProblem, followed: &Followed) {
    let known = steps_known(followed);
    let rises = |at: &LimitPoint, of: fn(&Solution) -> f64| of(&followed.points[at.after]) > 0.0;
    let located: Vec<LimitPoint> = peel.limit_points.iter().filter(|at| at.after < known).copied().collect();
    let maximum = |at: &&LimitPoint| at.kind == LimitPointKind::Load && rises(at, |s| s.slope.force) && at.force > 0.0;
    let turns_back = |at: &&LimitPoint| at.kind == LimitPointKind::Displacement && rises(at, |s| s.slope.displacement);
    let first_maximum = located.iter().filter(maximum).find(|at| stands_out(&peel.points, at, peel.asked)).copied();
    peel.initiation_peak = first_maximum.as_ref().map(peak_of);
    let first_jump = located.iter().position(|at| turns_back(&at));
    peel.snap_off = first_jump.map(|index| located[index]);
    let before = &located[..first_jump.map_or(located.len(), |index| index + 1)];
    // where a path failed before it jumped, the force may go further up; beyond a section that stands upright the model has no force
    let ended = matches!(followed.trouble, None | Some(PathFailure::NearUpright(_)));
    let whole = peel.snap_off.is_some() || (ended && followed.late().is_none());
    let steps = peel.snap_off.map_or(peel.points.len(), |at| at.after + 1);
    let computed = largest(&peel.points[..steps.min(peel.points.len())]);
    peel.peak = if whole { highest(before, computed, peel.asked) } else { None };
    let pulls = |at: &LargestComputedForce| at.force > PULL * problem.measure.force;
    // rest alone is no curve
    peel.largest_computed_force = computed.filter(pulls).filter(|_| peel.peak.is_none() && peel.points.len() > 1);
    let last = followed.points.len().saturating_sub(2);
    let snap = peel.snap_off.map_or(last, |at| at.after);
    // the force of a film that yields falls to a minimum before it has been bent by its front; it is steady behind that
    let first = if problem.system.step_dependence().is_yielding() {
        located.iter().rfind(|at| is_minimum(followed, at))
    } else {
        None
    };
    let before_jump = first_maximum.as_ref().map(|maximum| first.unwrap_or(maximum).after + 1..snap);
    peel.plateau = steady_force(problem, followed, before_jump, known.min(last), peel.asked);
}

/// Whether the force turns from falling to rising there.
fn is_minimum(followed: &Followed, at: &LimitPoint) -> bool {
    let force = |point: Option<&Arc<Solution>>| point.map_or(f64::NEG_INFINITY, |point| point.observables.force);
    let ends = [at.after, at.after + 1].map(|index| force(followed.points.get(index)));
    at.kind == LimitPointKind::Load && ends.into_iter().all(|end| end > at.force)
}

/// Whether the force rises to a maximum, and falls behind it, by more than its error and than was asked: where it does not, as beside the beginning of
/// a path that begins with a level force, another mesh may have the maximum somewhere else or have none.
fn stands_out(points: &[PathPoint], maximum: &LimitPoint, asked: f64) -> bool {
    let known = maximum.force_error + asked * maximum.force;
    let (before, behind) = points.split_at(points.len().min(maximum.after + 1));
    let differs = |point: &&PathPoint| (point.force - maximum.force).abs() > known;
    let is_below = |point: &PathPoint| point.force < maximum.force;
    let rises = before.iter().rev().find(differs).is_some_and(is_below);
    // what the force does beyond the end of a path is not known
    rises && behind.iter().find(differs).is_none_or(is_below)
}

/// How many steps of a path are behind one another: beyond one on which a limit point is missing, or on which it may have gone to another
/// part of itself, a limit point is not the first of anything.
fn steps_known(followed: &Followed) -> usize {
    followed.trouble.as_ref().and_then(PathFailure::after).unwrap_or(followed.points.len())
}

/// The located point with the largest force, where the computed curve goes no higher than that is known: else the largest force is
/// somewhere else, at an end of the curve or where nothing was located.
fn highest(located: &[LimitPoint], computed: Option<LargestComputedForce>, asked: f64) -> Option<Peak> {
    let highest = located.iter().max_by(|a, b| a.force.total_cmp(&b.force)).filter(|at| at.force > 0.0)?;
    let above = computed.map_or(0.0, |computed| computed.force - highest.force);
    // turns between which the force changes by less than was asked are left out
    let known = highest.force_error + asked * highest.force;
    (above <= known).then(|| Peak { force_error: highest.force_error.max(above), ..peak_of(highest) })
}

/// The point with the largest force.
fn largest(points: &[PathPoint]) -> Option<LargestComputedForce> {
    let at = points.iter().max_by(|a, b| a.force.total_cmp(&b.force))?;
    Some(LargestComputedForce { displacement: at.displacement, force: at.force })
}

/// A limit point as a peak.
pub(in crate::study::peel) fn peak_of(at: &LimitPoint) -> Peak {
    Peak {
        displacement: at.displacement,
        force: at.force,
        end_rotation: at.end_rotation,
        force_error: at.force_error,
        displacement_error: at.displacement_error,
    }
}

/// Whether a path that ended because its force was not above zero never came back to zero: it jumps where the grip pushes, and goes on
/// there.
pub(in crate::study::peel) fn pushes_behind_a_fold(problem: &BeamProblem, followed: &Followed) -> bool {
    let pushes = |point: &Arc<Solution>| point.observables.force < 0.0;
    problem.grip.gear != 0.0
        && followed.end == PathEnd::Pivoting
        && !followed.upright
        && followed.points.iter().rev().take(2).all(pushes)
}

impl Peel {
    /// The largest force of the path up to its first displacement limit point, nN: that of the peak, or where there is none of the computed
    /// curve.
    pub fn largest_force_before_jump(&self) -> Option<f64> {
        self.peak.map(|peak| peak.force).or_else(|| self.largest_computed_force.map(|largest| largest.force))
    }
}

/// What more elements change of the force where a path begins, at that displacement: where it is the largest, and behind steps in space. A mesh has to
/// show that force too.
pub(in crate::study::peel) fn difference_at_start<'p>(
    peel: &Peel,
    problem: &BeamProblem,
    points: &'p [Arc<Solution>],
) -> Option<(&'p Solution, Observables)> {
    let first = points.first().filter(|first| is_largest(peel, first) || begins_turned(peel))?;
    let difference = difference_on_more_elements(problem, first, &mut Workspace::default()).ok()?;
    Some((first, difference))
}

/// Bound on the relative error of that force, in space behind steps over the peak: 0 where there is none to compare it with.
pub(in crate::study::peel) fn error_at_start(
    peel: &Peel,
    problem: &BeamProblem,
    first: &Solution,
    difference: &Observables,
) -> f64 {
    let force = match peel.peak {
        _ if is_largest(peel, first) => first.observables.force,
        Some(peak) => peak.force,
        None => return 0.0,
    };
    (DIFFERENCE_BOUND_FACTOR * difference.force.abs() + ROUND_OFF * force.max(problem.measure.force)) / force
        + least(peel.asked)
}

/// Whether the force where a path begins is the largest that was computed.
fn is_largest(peel: &Peel, first: &Solution) -> bool {
    let here = first.observables.displacement;
    peel.largest_computed_force.is_some_and(|at| at.displacement == here && at.force > 0.0)
}

/// Whether the pull begins behind steps in space, which turn the strip about where it is fixed.
fn begins_turned(peel: &Peel) -> bool {
    peel.model.space.is_some() && !peel.model.steps.is_empty()
}

impl Peel {
    /// Behind steps in space displacements count from where the grip was let go, and that is known as well as its force is: the bounds of all places
    /// hold that too.
    pub(in crate::study::peel) fn allow_for_start(&mut self, first: &Solution, difference: &Observables) {
        let off = DIFFERENCE_BOUND_FACTOR * (difference.force * first.slope.displacement / first.slope.force).abs();
        if begins_turned(self) && off.is_finite() {
            self.limit_points.iter_mut().for_each(|point| point.displacement_error += off);
            self.tell_bounds();
        }
    }
}

// -- The steady force of a peel, its plateau: the force at which the front advances and nothing else changes --

/// A plateau is reported where |d ln P / d ln u| is below this.
const FLAT: f64 = 0.01;

/// Samples of a step.
const SAMPLES: usize = 64;

/// Beyond the first jump the front has to advance by so many lengths of the process zone on a level segment: what a front at one end of it shows of
/// the ends of the beam has faded at the other.
const ADVANCE: f64 = 5.0;

/// The steady force between the initiation peak and the first jump, on the points `before_jump` of a path that has the peak; where the force is level
/// nowhere there, on the level segment up to the point `last` on which the front advances furthest. A strip that hangs from its edge has a level
/// force as well, but its front stays.
pub(in crate::study::peel) fn steady_force(
    problem: &BeamProblem,
    followed: &Followed,
    before_jump: Option<Range<usize>>,
    last: usize,
    relative: f64,
) -> Option<Plateau> {
    let found = before_jump.and_then(|range| plateau(problem, followed, range, relative));
    found.or_else(|| plateau(problem, followed, level_segment(problem, followed, last)?, relative))
}

/// |d ln P / d ln u| of the step behind a point: by differences, since slopes at the points are not exact enough to tell one flat place from another.
fn steepness(points: &[Arc<Solution>], i: usize) -> f64 {
    let (a, b) = (&points[i].observables, &points[i + 1].observables);
    ((b.force / a.force).ln() / (b.displacement / a.displacement).ln()).abs()
}

/// The level segment on which the front advances furthest, and far enough: the points between its ends.
fn level_segment(problem: &BeamProblem, followed: &Followed, last: usize) -> Option<Range<usize>> {
    let points = &followed.points;
    let front = |i: usize| problem.beam.front_place(points[i].observables.monitors[FRONT]);
    let is_level = |i: usize| steepness(points, i) < FLAT && front(i + 1) < front(i);
    let steps: Vec<usize> = (1..last.min(points.len().saturating_sub(1))).filter(|&i| is_level(i)).collect();
    let advance = |run: &&[usize]| front(run[0]) - front(run[run.len() - 1] + 1);
    let runs = steps.chunk_by(|a, b| a + 1 == *b);
    let furthest = runs.max_by(|a, b| advance(a).total_cmp(&advance(b)))?;
    let far_enough = advance(&furthest) >= ADVANCE * problem.beam.process_length();
    far_enough.then(|| furthest[0]..furthest[furthest.len() - 1] + 1)
}

/// The flattest segment of the curve between two points, and on it the place of least steepness. Load limit points are level too, but only for a
/// moment.
fn plateau(problem: &BeamProblem, followed: &Followed, range: Range<usize>, relative: f64) -> Option<Plateau> {
    let points = &followed.points;
    let between = |i: usize| steepness(points, i);
    let inner = || range.start + 1..range.end.saturating_sub(1);
    let least = inner()
        .filter(|&i| between(i) <= between(i - 1) && between(i) <= between(i + 1))
        .min_by(|&a, &b| between(a).total_cmp(&between(b)))?;
    let mut ws = followed.workspace();
    // a step and its neighbours, since the least steepness may lie at an end of it
    let steps = (least - 1..=least + 1).map(|i| (i, StepCurve::behind(problem, points, i, &mut ws)));
    let samples: Vec<Sample> = steps.flat_map(|(i, curve)| (0..=SAMPLES).map(move |k| sample(&curve, i, k))).collect();
    let best =
        samples.iter().min_by(|a, b| a.steepness.total_cmp(&b.steepness)).filter(|best| best.steepness < FLAT)?;
    // another step that is about as level may hold the place as well
    let at = |i: usize, steepness: f64| {
        let o = &points[i].observables;
        Sample { steepness, displacement: o.displacement, force: o.force, after: i }
    };
    let others: Vec<Sample> = inner().flat_map(|i| [at(i, between(i)), at(i + 1, between(i))]).collect();
    let around = &points[least - 1..=least + 2];
    let bounds = bounds(problem, around, [&samples, &others], (best, between(least)), relative, &mut ws);
    // a limit point of the force is level as well, and the more so the shorter the steps are: which of two places is taken depends on them
    let turns = followed.turns.iter().filter(|turn| turn.0 == LimitPointKind::Load && range.contains(&turn.1));
    let turns: Vec<f64> = turns.map(|turn| turn.2.observables.force).collect();
    let level = range.clone().filter(|&i| !turns.is_empty() && between(i) <= FLAT).map(|i| points[i].observables.force);
    let rivals: Vec<f64> = level.chain(turns.iter().copied()).collect();
    let bounds = bounds.filter(|bounds| rivals.iter().all(|force| (force - best.force).abs() <= bounds.0));
    let stable = points[best.after..=best.after + 1].iter().all(|point| point.negative == 0);
    Some(Plateau {
        displacement: best.displacement,
        force: best.force,
        force_error: bounds.map(|bounds| bounds.0),
        displacement_error: bounds.map(|bounds| bounds.1),
        stable,
        after: best.after,
    })
}

/// A place of the curve.
struct Sample {
    /// |d ln P / d ln u|
    steepness: f64,
    displacement: f64,
    force: f64,
    /// The step that it lies on
    after: usize,
}

/// One of the samples of the step behind a point.
fn sample(curve: &StepCurve, after: usize, k: usize) -> Sample {
    let (u, rise, p, fall) = curve.at(2.0 * k as f64 / SAMPLES as f64 - 1.0);
    Sample { steepness: (fall * u / (rise * p)).abs(), displacement: u, force: p, after }
}

/// Bounds on the errors of force (nN) and displacement (nm) of a plateau among the samples of the steps between some points, or at an end of
/// any other step, with the steepness of that step's chord; none where the material points remember, whose path depends on its steps.
///
/// Two points whose forces are wrong by δP each make the steepness between them wrong by 2 δP/P over the difference of their ln u: a place that
/// is less steep than the best by no more than that may be the true one. The force is wrong by what more elements change of it, and by what it
/// changes up to there.
fn bounds(
    problem: &BeamProblem,
    around: &[Arc<Solution>],
    [samples, others]: [&[Sample]; 2],
    (best, chord): (&Sample, f64),
    relative: f64,
    ws: &mut Workspace,
) -> Option<(f64, f64)> {
    if problem.system.step_dependence().exists() {
        return None;
    }
    let mut wrong = (ROUND_OFF + least(relative)) * best.force;
    for point in around {
        let difference = difference_on_more_elements(problem, point, ws).ok()?;
        wrong = wrong.max(DIFFERENCE_BOUND_FACTOR * difference.force.abs());
    }
    let u = |point: &Arc<Solution>| point.observables.displacement;
    let shortest = around.windows(2).map(|pair| (u(&pair[1]) / u(&pair[0])).ln().abs()).fold(f64::INFINITY, f64::min);
    // which of the steps is the least steep depends on where they begin
    let uncertain = best.steepness.max(LEVEL_FACTOR * chord) + 2.0 * wrong / (best.force * shortest);
    let level = || samples.iter().chain(others).filter(|sample| sample.steepness <= uncertain);
    let away = level().map(|sample| (sample.displacement - best.displacement).abs()).fold(0.0, f64::max);
    let spacing =
        samples.windows(2).map(|pair| (pair[1].displacement - pair[0].displacement).abs()).fold(0.0, f64::max);
    let change = level().map(|sample| (sample.force - best.force).abs()).fold(0.0, f64::max);
    let force = wrong + change + best.steepness * best.force * spacing / best.displacement;
    let displacement = away + spacing;
    (force.is_finite() && displacement.is_finite()).then_some((force, displacement))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A load limit point with this force between the first two of points with these forces, and whether it is a maximum that stands out.
    fn stands(forces: &[f64], maximum: f64, force_error: f64) -> bool {
        let point = |(k, &force): (usize, &f64)| PathPoint {
            displacement: k as f64,
            force,
            end_rotation: 0.0,
            work: 0.0,
            negative_eigenvalues: 0,
            negative_eigenvalues_load: 0,
            front: 0.0,
            iterations: 0,
            in_space: None,
        };
        let points: Vec<PathPoint> = forces.iter().enumerate().map(point).collect();
        let at = LimitPoint {
            kind: LimitPointKind::Load,
            displacement: 0.5,
            force: maximum,
            end_rotation: 0.0,
            work: 0.0,
            displacement_error: 0.0,
            force_error,
            work_error: None,
            flat: false,
            after: 0,
            in_space: None,
        };
        stands_out(&points, &at, 1e-6)
    }

    /// The spatula of which one accuracy in five had its first maximum, 3.844904 nN ± 4e-6, on the level force with which its path begins.
    #[test]
    fn a_maximum_within_its_error_of_a_level_force_is_none() {
        assert!(!stands(&[3.844902, 3.844903, 3.844901, 3.83], 3.844904, 4e-6));
        // it rises from below its error and falls behind it
        assert!(stands(&[3.80, 3.844903, 3.83], 3.844904, 4e-6));
        assert!(!stands(&[3.80, 3.844903, 3.85], 3.844904, 4e-6));
        // what comes behind the end of a path is not known
        assert!(stands(&[3.80, 3.844903], 3.844904, 4e-6));
    }
}
