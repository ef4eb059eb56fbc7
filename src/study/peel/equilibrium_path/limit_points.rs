//! The limit points of a path: every one located, none missed without a report.

use super::path_end::Followed;
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::error::SolveError;
use crate::solve::newton::Solution;
use crate::solve::path::segment::PathSegment;
use crate::solve::points::bracket::brackets;
use crate::solve::points::branching::locate_branching;
use crate::solve::points::locate::{locate, unlocated};
use crate::solve::points::search::LimitPointKind;
use crate::solve::points::search::LimitPointKind::{Displacement, Load};
use crate::solve::workspace::Workspace;
use crate::study::asked::error_bounds::DIFFERENCE_BOUND_FACTOR;
use crate::study::peel::result::{PathEnd, PathFailure};
use std::sync::Arc;

/// How far from a branch point the search for it begins, over its displacement.
const CLEAR: f64 = 1e-3;

/// A turn between the ends of a step that an interpolant shows to stand out by so many times its error is none that it makes.
const CLEARLY: f64 = 10.0;

/// A step that contains a limit point.
struct Candidate {
    turn: LimitPointKind,
    index: usize,
    bracket: (f64, f64),
    /// Where an interpolant puts it, and its value there.
    label: f64,
    value: f64,
    /// How much the force changes over pairs of turns beside it, on the same level, that were dropped.
    dropped: f64,
}

/// Drops pairs of neighbouring load turns between which the force changes by less than `relative` of itself, the smallest
/// change first. Which of three turns on one level is left hangs on round-off: it is given what was dropped beside it.
fn without_ripple(candidates: Vec<Candidate>, relative: f64) -> Vec<Candidate> {
    let (mut loads, mut kept): (Vec<_>, Vec<_>) = candidates.into_iter().partition(|c| c.turn == LimitPointKind::Load);
    let change = |pair: &[Candidate]| (pair[1].value - pair[0].value).abs() / pair[0].value.abs();
    while let Some((i, least)) = loads.windows(2).map(change).enumerate().min_by(|a, b| a.1.total_cmp(&b.1))
        && least < relative
    {
        let level = loads[i].value;
        loads.drain(i..i + 2);
        let behind = (i + 1).min(loads.len());
        for neighbour in &mut loads[i.saturating_sub(1)..behind] {
            if (neighbour.value - level).abs() < relative * level.abs() {
                neighbour.dropped = neighbour.dropped.max(least * level.abs());
            }
        }
    }
    kept.append(&mut loads);
    kept
}

/// Whether the displacement of a step is known to `relative` wherever on it one looks.
fn is_within(segment: &PathSegment, relative: f64) -> bool {
    segment.change().displacement.abs() <= relative * segment.first().observables.displacement.abs()
}

impl Followed {
    /// Locates every limit point but those of a flat segment, where the force rises and falls by less than `relative`
    /// of itself: there its slope is the discretisation's. Where that is not possible on a step, those before it are known all the same.
    pub(super) fn locate_turns(&mut self, problem: &BeamProblem, relative: f64) -> Result<(), PathFailure> {
        let mut ws = self.workspace();
        let (candidates, unseen) = self.candidates(problem, relative, &mut ws);
        let located =
            candidates.iter().try_for_each(|candidate| self.locate_turn(problem, candidate, relative, &mut ws));
        self.drop_ripple(LimitPointKind::Load, relative);
        self.drop_ripple(LimitPointKind::Displacement, relative);
        located.and(unseen)
    }

    /// The steps with a limit point in path order, up to the first one of which that cannot be told.
    fn candidates(
        &mut self,
        problem: &BeamProblem,
        relative: f64,
        ws: &mut Workspace,
    ) -> (Vec<Candidate>, Result<(), PathFailure>) {
        let (mut candidates, mut unseen) = (Vec::new(), Ok(()));
        let last = self.points.len().saturating_sub(1);
        'steps: for index in 0..last {
            let segment = PathSegment::around(problem, &self.points, index);
            for turn in [Load, Displacement] {
                let brackets = match brackets(problem, &self.points, index, &segment, turn, relative, ws) {
                    Ok(found) => found,
                    // a pair of turns of the force that only the interpolant sees
                    Err(_) if turn == Load => {
                        self.ripple += 2;
                        continue;
                    }
                    Err(cause) => {
                        unseen = Err(self.not_located(turn, index, cause));
                        break 'steps;
                    }
                };
                for bracket in brackets {
                    let near = segment.observable(turn.pick(), 0.5 * (bracket.0 + bracket.1));
                    let label = near.turning_point(bracket.0, bracket.1);
                    let (a, b) = (pick_at(&self.points[index], turn), pick_at(&self.points[index + 1], turn));
                    let maximum = turn.pick()(&self.points[index].slope) > 0.0;
                    // neighbouring turns may share an end of their steps, and differ between these by far more than the interpolant is wrong
                    let wrong = segment.interpolation_error(turn.pick()).map_or(f64::INFINITY, |error| CLEARLY * error);
                    let there = near.at(label).0;
                    let value = match maximum == (bracket.0 == 0.0) {
                        true => a.max(b).max(there - wrong),
                        false => a.min(b).min(there + wrong),
                    };
                    candidates.push(Candidate { turn, index, bracket, label, value, dropped: 0.0 });
                }
            }
        }
        let all = candidates.len();
        let mut candidates = without_ripple(candidates, relative);
        self.ripple += all - candidates.len();
        candidates.sort_by(|a, b| a.index.cmp(&b.index).then(a.label.total_cmp(&b.label)));
        (candidates, unseen)
    }

    fn locate_turn(
        &mut self,
        problem: &BeamProblem,
        c: &Candidate,
        relative: f64,
        ws: &mut Workspace,
    ) -> Result<(), PathFailure> {
        let segment = PathSegment::around(problem, &self.points, c.index);
        let first = self.turns.iter().all(|t| t.0 != Load);
        // the first turn of the force is the initiation peak and wanted sharp
        let flat = (c.turn == Load && !first).then_some(relative);
        let mut located = match locate(problem, &segment, c.turn, c.bracket, flat, ws) {
            Err(_) if flat.is_some() => unlocated(problem, &segment, c.turn, ws),
            // next to a corner of the law round-off may hide where the displacement turns, within a step that is as short as what was asked
            Err(cause) if c.turn == Displacement && is_within(&segment, relative) => {
                unlocated(problem, &segment, c.turn, ws).map_err(|_| cause)
            }
            // a stiff beam under a level traction has no place where its force is largest
            Err(cause) if c.turn == Load => {
                let level = locate(problem, &segment, c.turn, c.bracket, Some(relative), ws);
                self.level = level.as_ref().is_ok_and(|located| located.flat);
                level.map_err(|_| cause)
            }
            located => located,
        }
        .and_then(|located| if located.is_finite() { Ok(located) } else { Err(SolveError::LimitPointNotConfirmed) })
        .map_err(|cause| self.not_located(c.turn, c.index, cause))?;
        located.left_out = c.dropped;
        located.flat |= flat.is_some_and(|relative| located.is_flat(relative));
        self.iterations += located.iterations;
        self.turns.push((c.turn, c.index, located));
        Ok(())
    }

    /// Ends the path where the elements do not resolve a pole of the law: before the first limit point there, at which two meshes may agree on a number
    /// that finer ones do not give, or where the path is in trouble there.
    pub(super) fn end_at_unresolved(&mut self, problem: &BeamProblem) {
        let Some(beam) = problem.beam.planar() else { return };
        let unresolved = |solution: &Solution| beam.unresolved_section(&solution.at);
        let turns = self.turns.iter().map(|(_, after, located)| (*after, unresolved(&located.solution)));
        let last = self.points.len().saturating_sub(1);
        let trouble = self.trouble.as_ref().filter(|trouble| **trouble != PathFailure::OutOfTime);
        let trouble = trouble.map(|trouble| trouble.after().unwrap_or(last)).map(|after| {
            let around = self.points.get(after..(after + 2).min(self.points.len())).unwrap_or_default();
            (after, around.iter().find_map(|point| unresolved(point)))
        });
        let places = turns.chain(trouble).filter_map(|(after, section)| Some((after, section?)));
        let Some((after, section)) = places.min_by_key(|&(after, _)| after) else { return };
        self.points.truncate(after + 1);
        self.turns.retain(|turn| turn.1 < after);
        self.branch_points.retain(|branch| branch.0 < after);
        self.trouble = Some(PathFailure::NearUpright(section));
        self.beyond = Some(PathEnd::Upright(section));
    }

    /// Ends a path that stops with its model where the pole of its law draws a section upright, whatever the elements. What is held meets what is not at a
    /// displacement limit point: where a path stops before one is located, the elements do not resolve that section.
    pub(super) fn end_where_drawn(&mut self, problem: &BeamProblem) {
        let turned = self.turns.iter().any(|turn| turn.0 == Displacement);
        let (Some(beam), Some(last)) = (problem.beam.planar(), self.points.last()) else { return };
        let section = match self.trouble {
            Some(PathFailure::Path(_) | PathFailure::NearUpright(_)) if turned && last.slope.displacement < 0.0 => {
                beam.drawn_section(&last.at).map(|[drawn, _]| drawn)
            }
            Some(PathFailure::Path(_)) if self.beyond.is_none() => {
                beam.drawn_section(&last.at).map(|[_, nearly]| nearly)
            }
            _ => None,
        };
        if let Some(section) = section {
            self.trouble = Some(PathFailure::NearUpright(section));
            self.beyond = Some(PathEnd::Upright(section));
        }
    }

    /// Whether a failure lies on the way: where force or displacement differ from those of the last point by more than `relative`.
    pub(super) fn is_before_end(&self, failure: &PathFailure, relative: f64) -> bool {
        let (Some(after), Some(last)) = (failure.after(), self.points.last()) else { return false };
        let differs = |here: f64, there: f64| (here - there).abs() > relative * there.abs();
        let (here, there) = (&self.points[after].observables, &last.observables);
        differs(here.displacement, there.displacement) || differs(here.force, there.force)
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

    /// The same filter on what was located: an interpolant over a long step can make a ripple look large. Turns of the displacement are
    /// left out where no path point lies between them, whose negative eigenvalues would tell of the first, and
    /// where both are not known better than they differ: next to a cusp there are two.
    fn drop_ripple(&mut self, kind: LimitPointKind, relative: f64) {
        loop {
            let of_kind: Vec<usize> = (0..self.turns.len()).filter(|&i| self.turns[i].0 == kind).collect();
            let value = |i: usize| kind.pick()(&self.turns[i].2.observables);
            let missed = |i: usize| kind.pick()(&self.turns[i].2.difference).abs();
            let unsure = |pair: &[usize]| DIFFERENCE_BOUND_FACTOR * (missed(pair[0]) + missed(pair[1]));
            let is_weak = |pair: &&[usize]| {
                let (first, second) = (pair[0], pair[1]);
                let change = (value(first) - value(second)).abs();
                let in_one_step = kind == LimitPointKind::Load || self.turns[first].1 == self.turns[second].1;
                in_one_step
                    && change < relative * value(first).abs()
                    && (kind == LimitPointKind::Load || change < unsure(pair))
            };
            let weak = of_kind.windows(2).find(is_weak);
            let Some(&[first, second]) = weak else { return };
            let (level, change) = (value(first), (value(first) - value(second)).abs());
            let beside =
                |i: &&usize| **i != first && **i != second && (value(**i) - level).abs() < relative * level.abs();
            let beside: Vec<usize> = of_kind.iter().filter(beside).copied().collect();
            for i in beside {
                let left_out = &mut self.turns[i].2.left_out;
                *left_out = left_out.max(change);
            }
            self.turns.remove(second);
            self.turns.remove(first);
            self.ripple += 2;
        }
    }

    /// Each displacement limit point changes the number of negative eigenvalues by one; beside them branch points alone do, which are located
    /// here. Not so at a corner of a path that remembers, where much that slid sticks. A limit point is known to `relative` of its displacement at
    /// best: points that are nearer to it may be counted as before it or behind it.
    pub(super) fn check_inertia(&mut self, problem: &BeamProblem, relative: f64) -> Result<(), PathFailure> {
        if problem.system.step_dependence().exists() {
            return Ok(());
        }
        let (mut ws, conservative) = (self.workspace(), problem.system.is_conservative());
        let checked = self.points.len() - usize::from(self.upright);
        let mut after = 0;
        while after + 1 < checked {
            let here = self.inertia_over(after, after + 1);
            if here.is_explained(conservative) {
                after += 1;
                continue;
            }
            if let Some(behind) = self.explained_around_turn(after, checked, conservative, relative) {
                after = behind;
                continue;
            }
            let alone = here.turns == 0 && conservative;
            let start = &self.points[clear_of_branching(&self.points, after)];
            let limit = clear_behind_branching(&self.points, after);
            let located = alone.then(|| locate_branching(problem, start, limit, &mut ws)).transpose();
            match located {
                Ok(Some(located)) => {
                    self.iterations += located.iterations;
                    self.branch_points.push((after, located));
                }
                Err(SolveError::Stopped) => return Err(PathFailure::OutOfTime),
                Ok(None) | Err(_) => {
                    let displacement_nm = self.points[after].observables.displacement;
                    let Inertia { from, to, turns } = here;
                    return Err(PathFailure::Missed { after, displacement_nm, from, to, turns });
                }
            }
            after += 1;
        }
        Ok(())
    }

    /// How the number of negative eigenvalues changes from one point to another, and how many limit points lie between.
    fn inertia_over(&self, before: usize, behind: usize) -> Inertia {
        let turns =
            self.turns.iter().filter(|t| t.0 == LimitPointKind::Displacement && (before..behind).contains(&t.1));
        Inertia { from: self.points[before].negative, to: self.points[behind].negative, turns: turns.count() }
    }

    /// The first of the `checked` points behind the limit point next to which a step lies, if what is counted there agrees with what is counted
    /// before the limit point.
    fn explained_around_turn(&self, after: usize, checked: usize, conservative: bool, relative: f64) -> Option<usize> {
        let place = |index: usize| self.points[index].observables.displacement;
        let turns = self.turns.iter().filter(|turn| turn.0 == LimitPointKind::Displacement);
        let (_, index, turn) = turns.min_by_key(|turn| turn.1.abs_diff(after))?;
        let turn = turn.observables.displacement;
        let is_near = |index: &usize| (place(*index) - turn).abs() <= relative * turn.abs();
        let before = (0..=*index).rev().find(|index| !is_near(index))?;
        let behind = (index + 1..checked).find(|index| !is_near(index))?;
        let lies_between = (before..behind).contains(&after);
        (lies_between && self.inertia_over(before, behind).is_explained(conservative)).then_some(behind)
    }
}

/// The number of negative eigenvalues at two points of a path, and of the displacement limit points between them.
struct Inertia {
    from: usize,
    to: usize,
    turns: usize,
}

impl Inertia {
    /// Whether the limit points explain the change.
    fn is_explained(&self, conservative: bool) -> bool {
        let change = self.from.abs_diff(self.to);
        (self.turns + change).is_multiple_of(2) && (change <= self.turns || !conservative)
    }
}

/// The point to look for a branch point from that lies behind `after`: close by, equilibria are not certain.
fn clear_of_branching(points: &[Arc<Solution>], after: usize) -> usize {
    let (place, negative) = (|index: usize| points[index].observables.displacement, points[after].negative);
    let far = place(after + 1);
    let forward = (far - place(after)).signum();
    let too_near = |index: usize| (far - place(index)).abs() < CLEAR * far.abs();
    let leads_here =
        |index: usize| points[index].negative == negative && (place(index + 1) - place(index)) * forward > 0.0;
    (1..=after)
        .rev()
        .take_while(|&index| too_near(index) && leads_here(index - 1))
        .last()
        .map_or(after, |index| index - 1)
}

/// The displacement up to which to look for it: a point next to it may lie before it on another mesh.
fn clear_behind_branching(points: &[Arc<Solution>], after: usize) -> f64 {
    let (place, negative) = (|index: usize| points[index].observables.displacement, points[after + 1].negative);
    let behind = place(after + 1);
    let forward = (behind - place(after)).signum();
    let most = behind + forward * CLEAR * behind.abs();
    let goes_on = |index: &usize| {
        points[index + 1].negative == negative
            && (place(index + 1) - place(*index)) * forward > 0.0
            && (most - place(*index)) * forward > 0.0
    };
    let last = (after + 1..points.len() - 1).take_while(goes_on).last().map_or(after + 1, |index| index + 1);
    if (most - place(last)) * forward > 0.0 { place(last) } else { most }
}

fn pick_at(solution: &Solution, turn: LimitPointKind) -> f64 {
    turn.pick()(&solution.observables)
}
