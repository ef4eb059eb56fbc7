//! The steady force of a peel, its plateau: the force at which the front advances and nothing else changes.

use super::equilibrium_path::followed::Followed;
use super::result::Plateau;
use super::step_curve::StepCurve;
use crate::beam::planar::planar_beam::FRONT;
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::newton::Solution;
use crate::solve::points::kind::LimitPointKind;
use crate::solve::points::locate::difference_on_more_elements;
use crate::solve::workspace::Workspace;
use crate::study::error_bounds::{DIFFERENCE_BOUND_FACTOR, LEVEL_FACTOR, ROUND_OFF, least};
use std::ops::Range;
use std::sync::Arc;

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
pub(super) fn steady_force(
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
    if problem.system.has_history() {
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
