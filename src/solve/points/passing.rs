//! Where on a path a number of its equilibria passes a value.
//!
//! On a step of the path the number is a polynomial through the solutions that are known, or that of the state that goes through these. Where that
//! passes the value the step is solved at the root, the solution joins those that are known, and so on until the number has the value to round-off.

use super::locate::step_to;
use crate::solve::error::{Quantity, SolveError};
use crate::solve::newton::{FINE, Solution};
use crate::solve::path::segment::PathSegment;
use crate::solve::problem::Problem;
use crate::solve::state::{Observables, State};
use crate::solve::workspace::Workspace;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Pieces of a step in each of which the number may pass a value once.
const PIECES: usize = 16;
/// Most solutions until a value is met.
const MOST_SOLVES: usize = 12;
/// Two equilibria nearer than this share of a step are one.
const ONE: f64 = 1e-9;
/// Step of a difference of a number of the state, over the step of the path.
const APART: f64 = 1e-4;
/// Points that an interpolation of states uses.
const USED: usize = 4;
/// Round-off of a number, over the largest on the path: of an observable, and of a state, which may be read off by differences.
const OF_OBSERVABLE: f64 = 5e-12;
const OF_STATE: f64 = 1e-9;

/// The ways in which a number passes a value that count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Passing {
    /// Either way
    #[default]
    Either,
    /// Upwards alone
    Rising,
    /// Downwards alone
    Falling,
}

impl Passing {
    /// Every one with its sign in a scene.
    pub const NAMED: [(&'static str, Self); 3] = [("=", Self::Either), (">", Self::Rising), ("<", Self::Falling)];

    /// Its sign in a scene.
    pub fn sign(self) -> &'static str {
        Self::NAMED.iter().find(|named| named.1 == self).map_or("", |named| named.0)
    }

    /// Whether it counts where a number goes from so far above a value to so far above it.
    pub(crate) fn counts(self, before: f64, behind: f64) -> bool {
        match self {
            Self::Either => true,
            Self::Rising => before < behind,
            Self::Falling => before > behind,
        }
    }
}

/// A number that the equilibria of a path have: at a solution, between solutions, and how fast it changes.
pub struct PathNumber<'p> {
    problem: &'p Problem,
    of: NumberOf<'p>,
}

enum NumberOf<'p> {
    /// An observable, or what follows from it by a function with its step of a difference
    Observable(fn(&Observables) -> f64, Follows<'p>),
    /// Of the unknowns
    State(Box<dyn Fn(&State) -> f64 + 'p>),
}

impl<'p> PathNumber<'p> {
    /// One of what the path keeps of each of its points: displacement, force, monitors.
    pub fn observable(problem: &'p Problem, pick: fn(&Observables) -> f64) -> Self {
        Self { problem, of: NumberOf::Observable(pick, None) }
    }

    /// What follows from an observable; `step` is that of a difference of the function.
    pub(crate) fn following(
        problem: &'p Problem,
        pick: fn(&Observables) -> f64,
        follows: impl Fn(f64) -> f64 + 'p,
        step: f64,
    ) -> Self {
        Self { problem, of: NumberOf::Observable(pick, Some((Box::new(follows), step))) }
    }

    /// Any number of the unknowns.
    pub fn of_state(problem: &'p Problem, number: impl Fn(&State) -> f64 + 'p) -> Self {
        Self { problem, of: NumberOf::State(Box::new(number)) }
    }

    /// Its value at a solution.
    pub fn at(&self, solution: &Solution) -> f64 {
        match &self.of {
            NumberOf::Observable(pick, follows) => value(follows, pick(&solution.observables)),
            NumberOf::State(number) => number(&solution.at),
        }
    }

    /// Its value at a label of a step, by what is known around it, and how fast it changes with the label.
    fn between(&self, segment: &PathSegment, label: f64) -> (f64, f64) {
        match &self.of {
            NumberOf::Observable(pick, follows) => {
                let (number, rate, _) = segment.observable(*pick, label).at(label);
                (value(follows, number), rate * per_number(follows, number))
            }
            NumberOf::State(_) => {
                let apart = APART * segment.end();
                let [before, behind] = [label - apart, label + apart].map(|label| self.value_between(segment, label));
                (self.value_between(segment, label), (behind - before) / (2.0 * apart))
            }
        }
    }

    /// The same without the rate.
    fn value_between(&self, segment: &PathSegment, label: f64) -> f64 {
        match &self.of {
            NumberOf::Observable(pick, follows) => value(follows, segment.observable(*pick, label).at(label).0),
            NumberOf::State(number) => number(&segment.start(self.problem, label, USED)),
        }
    }

    /// How fast it changes with the label of a segment at a solution, by the tangent there.
    pub(crate) fn rate(&self, solution: &Solution, segment: &PathSegment) -> f64 {
        let per_label = segment.weights.dot(&solution.slope);
        match &self.of {
            NumberOf::Observable(pick, follows) => {
                pick(&solution.slope) * per_number(follows, pick(&solution.observables)) / per_label
            }
            NumberOf::State(number) => {
                let ahead = APART * segment.end() / per_label;
                let at = |ahead: f64| number(&solution.moved(self.problem, ahead));
                (at(ahead) - at(-ahead)) / (2.0 * ahead * per_label)
            }
        }
    }

    /// Its round-off where the largest on the path is so large.
    fn round_off(&self, largest: f64) -> f64 {
        let share = if let NumberOf::State(_) = self.of { OF_STATE } else { OF_OBSERVABLE };
        share * largest
    }
}

type Follows<'p> = Option<(Box<dyn Fn(f64) -> f64 + 'p>, f64)>;

fn value(follows: &Follows, number: f64) -> f64 {
    follows.as_ref().map_or(number, |(follows, _)| follows(number))
}

/// How fast what follows from an observable changes with it.
fn per_number(follows: &Follows, number: f64) -> f64 {
    follows.as_ref().map_or(1.0, |(follows, step)| (follows(number + step) - follows(number - step)) / (2.0 * step))
}

/// A value that is sought on a path.
pub struct SoughtValue<'p> {
    /// The number that is to have it
    pub number: PathNumber<'p>,
    value: f64,
    passing: Passing,
    points: &'p [Arc<Solution>],
    /// Solutions next to limit points, each with the point before it
    turns: Vec<(usize, Arc<Solution>)>,
    /// The least and the largest value on the path
    pub range: [f64; 2],
    /// The number has the value where it is no farther from it
    tolerance: f64,
}

/// An equilibrium at a value that was sought, between `points[after]` and `points[after + 1]`, and the segment that it was located on.
pub struct FoundValue {
    /// The equilibrium
    pub solution: Arc<Solution>,
    /// It lies behind this point
    pub after: usize,
    /// Between and around the two points
    pub segment: PathSegment,
}

impl<'p> SoughtValue<'p> {
    /// A value that a number passes in a way that counts, on a path with these points.
    pub fn new(number: PathNumber<'p>, value: f64, passing: Passing, points: &'p [Arc<Solution>]) -> Self {
        let nothing = [f64::INFINITY, f64::NEG_INFINITY];
        let sought = Self { number, value, passing, points, turns: Vec::new(), range: nothing, tolerance: 0.0 };
        sought.seeing(points.iter())
    }

    /// With the solutions next to limit points, each with the point before it.
    pub(crate) fn with_turns(self, turns: Vec<(usize, Arc<Solution>)>) -> Self {
        let seen = self.seeing(turns.iter().map(|turn| &turn.1));
        Self { turns, ..seen }
    }

    /// Where the number need not be nearer to the value than so far.
    pub fn to(self, tolerance: f64) -> Self {
        Self { tolerance, ..self }
    }

    /// With a range that has these solutions, and the round-off of it.
    fn seeing<'s>(mut self, solutions: impl Iterator<Item = &'s Arc<Solution>>) -> Self {
        let values = solutions.map(|solution| self.number.at(solution));
        self.range = values.fold(self.range, |[low, high], v| [low.min(v), high.max(v)]);
        self.tolerance = self.number.round_off(self.largest());
        self
    }

    /// The largest magnitude on the path.
    pub fn largest(&self) -> f64 {
        self.range[0].abs().max(self.range[1].abs())
    }

    /// By how much the number is above the value.
    pub fn above(&self, solution: &Solution) -> f64 {
        self.number.at(solution) - self.value
    }

    /// Whether the number has the value at an equilibrium, to round-off.
    pub(crate) fn is_met(&self, solution: &Solution) -> bool {
        self.above(solution).abs() <= self.tolerance
    }

    /// All equilibria of the path that have the value, in its order.
    ///
    /// # Errors
    /// Where a step could not be solved, or the number is none.
    pub fn on_path(&self) -> Result<Vec<FoundValue>, SolveError> {
        let mut ws = Workspace::default();
        let steps = (1..self.points.len()).map(|behind| self.on_step(behind - 1, &mut ws));
        Ok(steps.collect::<Result<Vec<_>, _>>()?.into_iter().flatten().collect())
    }

    /// The equilibria on the step behind a point.
    ///
    /// # Errors
    /// Where the step could not be solved, or the number is none.
    pub(crate) fn on_step(&self, after: usize, ws: &mut Workspace) -> Result<Vec<FoundValue>, SolveError> {
        let points = self.points;
        let mut segment = PathSegment::around(self.number.problem, points, after);
        let mut known = vec![(0.0, self.above(&points[after])), (segment.end(), self.above(&points[after + 1]))];
        for (_, solution) in self.turns.iter().filter(|turn| turn.0 == after) {
            known.push((segment.insert(solution.clone()), self.above(solution)));
        }
        let mut found: Vec<FoundValue> = Vec::new();
        // the path begins there, or is stopped there
        let begins = after == 0 && known[0].1 == 0.0;
        let ends = after + 2 == points.len() && known[1].1.abs() <= self.tolerance;
        for (_, index) in [(begins, after), (ends, after + 1)].into_iter().filter(|end| end.0) {
            found.push(FoundValue { solution: points[index].clone(), after, segment: segment.clone() });
        }
        for bracket in self.brackets(&segment, known)? {
            let solution = self.located(&mut segment, bracket, ws)?;
            let label = segment.label(&solution.observables);
            let is_new =
                |other: &FoundValue| (segment.label(&other.solution.observables) - label).abs() > ONE * segment.end();
            if found.iter().all(is_new) {
                found.push(FoundValue { solution, after, segment: segment.clone() });
            }
        }
        found.sort_by(|a, b| {
            let label = |found: &FoundValue| segment.label(&found.solution.observables);
            label(a).total_cmp(&label(b))
        });
        Ok(found)
    }

    /// How far along the step behind a point the number first passes the value, by what is known there; none where it does not. What is no number
    /// passes at once.
    pub(crate) fn first_passing(&self, after: usize) -> Option<f64> {
        let segment = PathSegment::around(self.number.problem, self.points, after);
        let known = vec![(0.0, self.above(&self.points[after])), (segment.end(), self.above(&self.points[after + 1]))];
        match self.brackets(&segment, known) {
            Ok(brackets) => brackets.first().map(|bracket| bracket.0 / segment.end()),
            Err(_) => Some(0.0),
        }
    }

    /// The pieces of a step in which the number passes the value in the way that counts, by what is `known` at labels and by polynomials between.
    fn brackets(&self, segment: &PathSegment, mut known: Vec<(f64, f64)>) -> Result<Vec<(f64, f64)>, SolveError> {
        known.extend((1..PIECES).map(|piece| {
            let label = segment.end() * piece as f64 / PIECES as f64;
            (label, self.number.value_between(segment, label) - self.value)
        }));
        if known.iter().any(|known| !known.1.is_finite()) {
            return Err(SolveError::NotFiniteUpdate { quantity: Quantity::EventQuantity });
        }
        known.sort_by(|a, b| a.0.total_cmp(&b.0));
        let passes = |pair: &&[(f64, f64)]| {
            (pair[0].1 >= 0.0) != (pair[1].1 >= 0.0) && self.passing.counts(pair[0].1, pair[1].1)
        };
        Ok(known.windows(2).filter(passes).map(|pair| (pair[0].0, pair[1].0)).collect())
    }

    /// The equilibrium in a piece of a step: at the root of the polynomial, which takes in one solution after the other.
    fn located(
        &self,
        segment: &mut PathSegment,
        (from, to): (f64, f64),
        ws: &mut Workspace,
    ) -> Result<Arc<Solution>, SolveError> {
        // a polynomial knows where the value is passed no better than it knows the curve
        let reach = [(2.0 * from - to).max(0.0), (2.0 * to - from).min(segment.end())];
        let (mut label, mut known) = (0.5 * (from + to), from);
        let mut off = f64::INFINITY;
        for iterations in 0..MOST_SOLVES {
            for _ in 0..MOST_SOLVES {
                let (value, rate) = self.number.between(segment, label);
                let next = (label - (value - self.value) / rate).clamp(reach[0], reach[1]);
                if !next.is_finite() || next == label {
                    break;
                }
                label = next;
            }
            let solution = step_to(self.number.problem, segment, known, label, FINE, ws)?;
            let above = self.above(&solution).abs();
            // what no further solution brings down is round-off
            let settled = above <= self.tolerance || iterations > 2 && above >= 0.5 * off;
            if settled && above <= MOST_SOLVES as f64 * self.tolerance {
                return Ok(solution);
            }
            (known, off) = (label, above);
        }
        Err(SolveError::NotConverged { update: off, iterations: MOST_SOLVES })
    }
}
