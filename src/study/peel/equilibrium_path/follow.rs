//! One path on one mesh: followed to its end, every limit point on it located, none missed without a report.

use super::path_refinement::fill_in;
use super::slope_polishing::sharpen;
use super::{Failure, PathEnd, PathFailure};
use crate::beam::{FrictionHistory, Rest, TIP_ROTATION};
use crate::model::PlanarProblem;
use crate::solve::{
    Direction, LimitPointKind, Located, NewtonOptions, Observables, Path, PathConstraint, PathError, PathOptions,
    PathSegment, ROUGH, ShouldStop, Solution, SolveError, Workspace, brackets, locate, solve, solve_on, unlocated,
};
use crate::study::Bound;
use crate::study::checkpoint::Limits;
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

/// A path with its limit points.
pub(super) struct Followed {
    pub points: Vec<Arc<Solution>>,
    /// In path order, each with the index of the point before it.
    pub turns: Vec<(LimitPointKind, usize, Located)>,
    pub end: PathEnd,
    /// Whether time or the user ended it.
    pub cut: bool,
    pub iterations: usize,
    /// Whether it ended with the strip upright, where an eigenvalue is zero by symmetry.
    pub upright: bool,
    /// Load limit points left out because the force hardly changes between them.
    pub ripple: usize,
    /// Largest spread of the first integral along the beam at any point, over the work of adhesion.
    pub spread: f64,
    /// Why the path cannot be used, if it cannot.
    pub trouble: Option<PathFailure>,
    /// Says when its limit points and its work are no longer to be computed.
    should_stop: Option<ShouldStop>,
}

/// A step that contains a limit point.
struct Candidate {
    turn: LimitPointKind,
    index: usize,
    bracket: (f64, f64),
    /// Where an interpolant puts it, and its value there.
    label: f64,
    value: f64,
}

/// Drops pairs of neighbouring load turns between which the force changes by less than `relative` of itself, the smallest
/// change first.
fn without_ripple(candidates: Vec<Candidate>, relative: f64) -> Vec<Candidate> {
    let (mut loads, mut kept): (Vec<_>, Vec<_>) = candidates.into_iter().partition(|c| c.turn == LimitPointKind::Load);
    let change = |pair: &[Candidate]| (pair[1].value - pair[0].value).abs() / pair[0].value.abs();
    while let Some((i, least)) = loads.windows(2).map(change).enumerate().min_by(|a, b| a.1.total_cmp(&b.1))
        && least < relative
    {
        loads.drain(i..i + 2);
    }
    kept.append(&mut loads);
    kept
}

/// Follows the path and locates its limit points.
pub(super) fn follow(
    problem: &PlanarProblem,
    options: PathOptions,
    far: f64,
    relative: f64,
    limits: &Limits,
) -> Followed {
    let known = (limits.keeping.taken)(&options);
    let taken = known.len();
    let mut path = Path::new(problem, options).until(limits.should_stop()).knowing(known);
    let most = points_allowed(options.elements);
    let mut cut = false;
    let stopped = loop {
        let points = path.points().len();
        if points >= most && most < limits.stop.points {
            break Err(PathFailure::TooManyPoints { points: most, elements: options.elements });
        }
        if let Some(end) = limits.reached() {
            cut = true;
            break Ok(end);
        }
        let stepped = step(problem, &mut path, far, limits);
        if path.points().len() > points.max(taken) {
            path.waypoint().into_iter().for_each(|newest| (limits.keeping.keep)(&options, newest));
        }
        match stepped {
            Ok(None) => {}
            Ok(Some(end)) => break Ok(end),
            Err(error) => break Err(PathFailure::Path(error)),
        }
    };
    let failed = |trouble: PathFailure| {
        let (elements, order) = (options.elements, problem.beam.chain.order());
        let failure = Failure::Path { cause: trouble.clone(), elements, order, asked: relative };
        (PathEnd::Failed(failure), Some(trouble))
    };
    let (end, trouble) = match stopped {
        Ok(end) => (end, None),
        Err(trouble) => failed(trouble),
    };
    let mut points = path.points().to_vec();
    let stays = |pair: &[Arc<Solution>]| pair[1].observables.displacement == pair[0].observables.displacement;
    let (end, trouble) = match trouble {
        _ if points.windows(2).next().is_some_and(stays) => {
            points.truncate(1);
            failed(PathFailure::Stuck { step_nm: options.first_displacement })
        }
        None if end == PathEnd::Pivoting && !has_maximum(path.points()) => failed(PathFailure::LostAtRest {
            displacement_nm: path.points().last().map_or(0.0, |p| p.observables.displacement),
            process_nm: problem.beam.process_length,
        }),
        trouble => (end, trouble),
    };
    let mut followed = Followed {
        spread: worst_spread(problem, &points),
        points,
        turns: Vec::new(),
        end,
        cut,
        iterations: path.iterations(),
        ripple: 0,
        upright: false,
        trouble,
        should_stop: limits.should_stop(),
    };
    followed.finish(problem, far);
    if followed.trouble.is_none() {
        let mut ws = followed.workspace();
        let (tolerance, most) = (options.tolerance.min(ROUGH), limits.stop.points);
        let (iterations, jump) = fill_in(problem, &mut followed.points, relative, tolerance, most, &mut ws);
        followed.iterations += iterations + sharpen(problem, &mut followed.points, tolerance, &mut ws);
        followed.trouble = jump.map(|after| PathFailure::Jumped {
            after,
            displacement_nm: followed.points[after].observables.displacement,
        });
    }
    let checked = followed.locate_turns(problem, relative).and_then(|()| followed.check_inertia(problem));
    followed.trouble = followed.trouble.take().or(checked.err());
    followed
}

/// The largest spread of the first integral along the beam at any point of the path, over the work of adhesion: zero where
/// a mesh resolves the beam. Without a potential, along a beam of varying outline and on ground that is not flat there is
/// no such integral.
fn worst_spread(problem: &PlanarProblem, points: &[Arc<Solution>]) -> f64 {
    if !problem.system.is_conservative()
        || matches!(problem.beam.rest, Rest::Varying(_))
        || !problem.beam.substrate.is_flat()
    {
        return 0.0;
    }
    let spread = |point: &Arc<Solution>| {
        let (at, last) = (problem.beam.configuration(&point.at), point.at.mesh.elements() - 1);
        // what is lost on the way shows at the two ends, and most of it is lost in the element at an edge
        let sections = [0..1, last..last + 1].map(|element| problem.beam.chain.node_states(at, element));
        let (low, high) = sections
            .iter()
            .flatten()
            .map(|section| section.first_integral())
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        (high - low) / problem.beam.rest_adhesion.abs()
    };
    points.iter().map(spread).fold(0.0, f64::max)
}

/// Whether the force has turned down on the way.
fn has_maximum(points: &[Arc<Solution>]) -> bool {
    points.iter().skip(1).rev().skip(1).any(|p| p.slope.force < 0.0)
}

/// Most steps of the secant rule to where a beam is clear of the substrate.
const MOST_SECANTS: usize = 20;
/// A force below this share of its scale is none.
const PUSH: f64 = 1e-6;
/// Path points after which a mesh is taken to hold the path up: several times what paths take that are resolved.
fn points_allowed(elements: usize) -> usize {
    400 + 10 * elements
}

/// Takes one step; the end, if it is reached.
fn step(problem: &PlanarProblem, path: &mut Path, far: f64, limits: &Limits) -> Result<Option<PathEnd>, PathError> {
    let stop = limits.stop;
    if path.points().len() >= stop.points {
        return Ok(Some(PathEnd::Bound(Bound::Points(stop.points))));
    }
    let newest = path.advance()?;
    let o = newest.observables;
    if path.points().len() < 3 {
        return Ok(None);
    }
    if is_clear(problem, path, far) {
        return Ok(Some(PathEnd::Detached));
    }
    if slides(problem, path) {
        return Ok(Some(PathEnd::Sliding));
    }
    if problem.system.has_history() && newest.slope.displacement < 0.0 {
        return Ok(Some(PathEnd::Snapped));
    }
    // a strip that has closed again passes u = 0 and P = 0 together
    if o.displacement <= 0.0 {
        return Ok(Some(PathEnd::TurnedBack));
    }
    // a grip that turns may push where its moment peels
    let turns = problem.grip.gear != 0.0 && path.points().iter().all(|point| point.slope.displacement >= 0.0);
    if o.force <= 0.0 && has_pulled(problem, path.points()) && !turns {
        return Ok(Some(PathEnd::Pivoting));
    }
    if stands_upright(problem, path.points()) {
        return Ok(Some(PathEnd::Pivoting));
    }
    let beyond = stop.displacement.filter(|&most| o.displacement > most);
    Ok(beyond.map(|most| PathEnd::Bound(Bound::Displacement(most))))
}

/// Whether no part of the beam is nearer to the substrate than `far`, nm, at the newest point.
pub(in crate::study) fn is_clear(problem: &PlanarProblem, path: &Path, far: f64) -> bool {
    path.points().last().is_none_or(|point| problem.beam.is_clear(&point.at, far))
}

/// Friction that is next to nothing, over that of a process zone at rest.
const LET_GO: f64 = 0.5;

/// Whether all that is in contact slides one way, or next to nothing is left of the friction that alone holds the beam along the
/// substrate.
fn slides(problem: &PlanarProblem, path: &Path) -> bool {
    let (Some(now), Some(rest)) = (path.history(), &problem.beam.history) else { return false };
    let little = LET_GO * problem.beam.process_length / problem.beam.length;
    FrictionHistory(now).slides(little * FrictionHistory(rest).capacity())
}

/// Whether the force has been above zero: where a beam is curved in its stress-free configuration, the grip may have to push at first.
fn has_pulled(problem: &PlanarProblem, points: &[Arc<Solution>]) -> bool {
    let pushes = points[0].observables.force < -PUSH * problem.measure.force;
    !pushes || points.iter().any(|point| point.observables.force > 0.0)
}

/// Whether the strip has just passed the upright position, all of it near 90 degrees: it hangs from its edge, and behind
/// that, on a flat substrate, the path is the mirror image of itself.
fn stands_upright(problem: &PlanarProblem, points: &[Arc<Solution>]) -> bool {
    let [.., before, newest] = points else { return false };
    // only a strip that is pulled straight up from flat ground has a mirror image
    if problem.grip.direction != Direction::UP || !problem.beam.substrate.is_flat() {
        return false;
    }
    let tip = |s: &Solution| s.observables.monitors[TIP_ROTATION] - FRAC_PI_2;
    let away = 3.0 * tip(before).abs().max(tip(newest).abs());
    let beam = &problem.beam;
    let rotations = beam.nodes(&newest.at.values).iter().skip(beam.rotation).step_by(beam.fields());
    tip(before) < 0.0 && tip(newest) >= 0.0 && rotations.into_iter().all(|r| (r - FRAC_PI_2).abs() <= away)
}

impl Followed {
    /// Moves the last point of a path that crossed P = 0, u = 0 or the upright position onto the crossing. Where that fails the point beyond it
    /// stays: it is an equilibrium too.
    fn finish(&mut self, problem: &PlanarProblem, far: f64) {
        let n = self.points.len();
        if self.end == PathEnd::Detached {
            return self.finish_detached(problem, far);
        }
        let (weights, target) = match self.end {
            PathEnd::Pivoting if stands_upright(problem, &self.points) => {
                (Observables::monitor(TIP_ROTATION), FRAC_PI_2)
            }
            PathEnd::Pivoting => (Observables::FORCE, 0.0),
            PathEnd::TurnedBack => (Observables::DISPLACEMENT, 0.0),
            _ => return,
        };
        let (before, beyond) = (&self.points[n - 2], &self.points[n - 1]);
        let segment = PathSegment::around(problem, &self.points, n - 2);
        let (from, to) = (weights.dot(&before.observables) - target, weights.dot(&beyond.observables) - target);
        let start = segment.start(problem, segment.end() * from / (from - to), 4);
        let options = NewtonOptions { tolerance: 1e-10, largest_update: 0.5, most_iterations: 10, exact_slope: false };
        let constraint = PathConstraint { weights, target };
        match solve(problem, start, &constraint, &options, &mut Workspace::default()) {
            Ok(mut last) => {
                self.iterations += last.iterations;
                // where the constraint falls along the path, a slope per unit of it points backwards
                last.slope = last.slope.times((to - from).signum());
                self.points[n - 1] = Arc::new(last);
            }
            // upright the path meets its mirror image and may be singular: it ends before that
            Err(_) if target != 0.0 => {
                self.points.pop();
            }
            Err(_) => {}
        }
        self.upright = target != 0.0;
    }

    /// Moves the last point of a path that has left the substrate to where its distance is `far`, by the secant rule.
    fn finish_detached(&mut self, problem: &PlanarProblem, far: f64) {
        let n = self.points.len();
        let segment = PathSegment::around(problem, &self.points, n - 2);
        let mut ws = Workspace::default();
        let beyond = |s: &Solution| problem.beam.nearest(&s.at) - far;
        let (mut low, mut high) = ((0.0, beyond(&self.points[n - 2])), (segment.end(), beyond(&self.points[n - 1])));
        for _ in 0..MOST_SECANTS {
            let label = (low.0 - low.1 * (high.0 - low.0) / (high.1 - low.1)).clamp(0.0, segment.end());
            let Ok(solution) = solve_on(problem, &segment, label, ROUGH, &mut ws) else { return };
            self.iterations += solution.iterations;
            let value = beyond(&solution);
            if value.abs() < 1e-6 * far {
                self.points[n - 1] = solution;
                return;
            }
            // an end that stays has half of its value, so that the other does not creep (Illinois)
            if value < 0.0 {
                (low, high.1) = ((label, value), 0.5 * high.1);
            } else {
                (high, low.1) = ((label, value), 0.5 * low.1);
            }
        }
    }

    /// What looks around on the path with, until it is late.
    pub fn workspace(&self) -> Workspace {
        Workspace::until(self.should_stop.clone())
    }

    /// What came out too late may be a ripple that is a turn, or an interpolant for a solution: to be asked in the end.
    pub fn late(&self) -> Option<PathFailure> {
        self.workspace().is_stopped().then_some(PathFailure::OutOfTime)
    }

    /// Locates every limit point but those of a flat segment, where the force rises and falls by less than `relative`
    /// of itself: there its slope is the discretisation's.
    fn locate_turns(&mut self, problem: &PlanarProblem, relative: f64) -> Result<(), PathFailure> {
        let mut ws = self.workspace();
        let mut candidates = Vec::new();
        for index in 0..self.points.len().saturating_sub(1) {
            let segment = PathSegment::around(problem, &self.points, index);
            for turn in [LimitPointKind::Load, LimitPointKind::Displacement] {
                let brackets = brackets(problem, &self.points, index, &segment, turn, relative, &mut ws);
                let brackets = match (brackets, turn) {
                    // a pair of turns of the force that only the interpolant sees
                    (Err(_), LimitPointKind::Load) => {
                        self.ripple += 2;
                        Vec::new()
                    }
                    (found, _) => found.map_err(|cause| self.not_located(turn, index, cause))?,
                };
                for bracket in brackets {
                    let near = segment.observable(turn.pick(), 0.5 * (bracket.0 + bracket.1));
                    let label = near.turning_point(bracket.0, bracket.1);
                    let (a, b) = (pick_at(&self.points[index], turn), pick_at(&self.points[index + 1], turn));
                    let maximum = turn.pick()(&self.points[index].slope) > 0.0;
                    let value = if maximum == (bracket.0 == 0.0) { a.max(b) } else { a.min(b) };
                    candidates.push(Candidate { turn, index, bracket, label, value });
                }
            }
        }
        let all = candidates.len();
        let mut candidates = without_ripple(candidates, relative);
        self.ripple += all - candidates.len();
        candidates.sort_by(|a, b| a.index.cmp(&b.index).then(a.label.total_cmp(&b.label)));
        for c in candidates {
            let segment = PathSegment::around(problem, &self.points, c.index);
            let first = self.turns.iter().all(|t| t.0 != LimitPointKind::Load);
            // the first turn of the force is the initiation peak and wanted sharp
            let flat = (c.turn == LimitPointKind::Load && !first).then_some(relative);
            let mut located = match locate(problem, &segment, c.turn, c.bracket, flat, &mut ws) {
                Err(_) if flat.is_some() => unlocated(problem, &segment, &mut ws),
                located => located,
            }
            .and_then(|located| if located.is_finite() { Ok(located) } else { Err(SolveError::LimitPointNotConfirmed) })
            .map_err(|cause| self.not_located(c.turn, c.index, cause))?;
            located.flat |= flat.is_some_and(|relative| located.is_flat(relative));
            self.iterations += located.iterations;
            self.turns.push((c.turn, c.index, located));
        }
        self.drop_ripple(relative);
        Ok(())
    }

    fn not_located(&self, turn: LimitPointKind, after: usize, cause: SolveError) -> PathFailure {
        match cause {
            SolveError::Stopped => PathFailure::OutOfTime,
            cause => {
                let displacement_nm = self.points[after].observables.displacement;
                PathFailure::NotLocated { turn, after, displacement_nm, cause }
            }
        }
    }

    /// The same filter on what was located: an interpolant over a long step can make a ripple look large.
    fn drop_ripple(&mut self, relative: f64) {
        loop {
            let loads: Vec<usize> =
                (0..self.turns.len()).filter(|&i| self.turns[i].0 == LimitPointKind::Load).collect();
            let force = |i: usize| self.turns[i].2.observables.force;
            let weak = loads.windows(2).find(|w| (force(w[0]) - force(w[1])).abs() < relative * force(w[0]).abs());
            let Some(&[first, second]) = weak else { return };
            self.turns.remove(second);
            self.turns.remove(first);
            self.ripple += 2;
        }
    }

    /// Each displacement limit point changes the number of negative eigenvalues by one; nothing else does. Not so at a corner of a path
    /// that remembers, where much that slid sticks.
    fn check_inertia(&self, problem: &PlanarProblem) -> Result<(), PathFailure> {
        if problem.system.has_history() {
            return Ok(());
        }
        let checked = self.points.len() - usize::from(self.upright);
        for (after, pair) in self.points[..checked].windows(2).enumerate() {
            let change = pair[0].negative.abs_diff(pair[1].negative);
            let turns = self.turns.iter().filter(|t| t.0 == LimitPointKind::Displacement && t.1 == after).count();
            let explained =
                (turns + change).is_multiple_of(2) && (change <= turns || !problem.system.is_conservative());
            if !explained {
                return Err(PathFailure::Missed {
                    after,
                    displacement_nm: pair[0].observables.displacement,
                    from: pair[0].negative,
                    to: pair[1].negative,
                    turns,
                });
            }
        }
        Ok(())
    }
}

fn pick_at(solution: &Solution, turn: LimitPointKind) -> f64 {
    turn.pick()(&solution.observables)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Form, PeelModel, StripModel};
    use crate::study::accuracy::Resolution;
    use crate::study::{Accuracy, Checkpoint, StopCriteria};

    /// What the count of negative eigenvalues is for: limit points that were not located are reported as missing.
    #[test]
    fn a_turning_point_that_was_not_located_is_missed() {
        let (model, accuracy) = (PeelModel::from(StripModel::of_the_paper(100.0, 1.0)), Accuracy::to(1e-6));
        let problem = model.problem(Form::TwoField, accuracy.order()).unwrap();
        let options = Resolution::first(&model, &accuracy).path_options(&model, accuracy.relative);
        let limits = Limits { stop: &StopCriteria::after_points(5000), keeping: &Checkpoint::NOTHING };
        let mut followed = follow(&problem, options, 4.0, accuracy.relative, &limits);
        assert!(followed.check_inertia(&problem).is_ok());
        let located = followed.turns.iter().position(|turn| turn.0 == LimitPointKind::Displacement).unwrap();
        let (_, after, _) = followed.turns.remove(located);
        let missed = followed.check_inertia(&problem).unwrap_err();
        assert!(
            matches!(missed, PathFailure::Missed { after: a, from: 0, to: 1, turns: 0, .. } if a == after),
            "{missed}"
        );
    }
}
