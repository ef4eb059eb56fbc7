//! One search: what all methods share. It evaluates designs, remembers them, and knows the best.

use super::evaluation::{Evaluation, Evaluator, OptimisationOptions};
use super::problem::DesignProblem;
use super::refine::projected_gradient;
use std::cell::{Cell, RefCell};

/// A constraint that is violated by less holds.
pub(super) const FEASIBLE: f64 = 1e-7;
/// A search with gradients ends where the projected gradient of a feasible design is no more than this: ln Q then misses about its square.
const STATIONARY: f64 = 1e-7;
/// It also ends where so many designs bring no more than the tolerance.
const STALLED: usize = 8;
/// What a bad point has beside the worst good one, in ln Q: a search turns back from it.
const WORSE: f64 = 1.0;

/// The designs that one search evaluates.
pub(super) struct Search<'p> {
    pub problem: &'p DesignProblem<'p>,
    pub options: &'p OptimisationOptions<'p>,
    evaluator: &'p Evaluator<'p>,
    /// Which of the searches it is
    number: usize,
    seen: RefCell<Vec<Evaluation>>,
    stopped: Cell<bool>,
    /// Whether it ends where nothing more is gained
    pub gives_up: Cell<bool>,
    /// Whether the newest design fulfils the first-order conditions of an optimum
    is_stationary: Cell<bool>,
}

/// What one search has found.
#[derive(Clone, Debug, PartialEq)]
pub struct SearchResult {
    /// The designs in the order in which they were evaluated
    pub evaluations: Vec<Evaluation>,
    /// Which of them is the best that is feasible
    pub best: Option<usize>,
    /// Why it ended
    pub end: SearchEnd,
}

/// Why a search ended.
#[derive(Clone, Debug, PartialEq)]
pub enum SearchEnd {
    /// ln Q changes by less than the tolerance
    Converged,
    /// The step that the method wants to take makes nothing better: rounding, or a place where ln Q is not smooth
    NoBetterStep(String),
    /// As many designs as are allowed were evaluated
    MostEvaluations,
    /// The caller wanted it to stop
    Interrupted,
}

impl SearchEnd {
    /// Its name in results.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Converged => "converged",
            Self::NoBetterStep(_) => "no-better-step",
            Self::MostEvaluations => "most-evaluations",
            Self::Interrupted => "interrupted",
        }
    }
}

impl<'p> Search<'p> {
    pub(crate) fn new(
        problem: &'p DesignProblem<'p>,
        options: &'p OptimisationOptions<'p>,
        evaluator: &'p Evaluator<'p>,
        number: usize,
    ) -> Self {
        Self {
            problem,
            options,
            evaluator,
            number,
            seen: RefCell::default(),
            stopped: Cell::new(false),
            gives_up: Cell::new(false),
            is_stationary: Cell::new(false),
        }
    }

    pub(crate) fn into_result(self, end: SearchEnd) -> SearchResult {
        let end = match end {
            _ if self.stopped.get() => SearchEnd::Interrupted,
            _ if self.has_converged() => SearchEnd::Converged,
            end => end,
        };
        let best = self.best();
        SearchResult { evaluations: self.seen.into_inner(), best, end }
    }

    /// Whether no further design is evaluated.
    pub(crate) fn is_over(&self) -> bool {
        if !(self.options.go_on)() {
            self.stopped.set(true);
        }
        self.stopped.get() || self.seen.borrow().len() >= self.options.evaluations || self.has_converged()
    }

    fn has_converged(&self) -> bool {
        self.is_stationary.get() || self.is_stalled()
    }

    /// Whether a design fulfils the first-order conditions of an optimum, and is no worse than those before.
    fn fulfils(&self, found: &Evaluation) -> bool {
        let sign = self.problem.goal.sign();
        let is_best = || {
            let value = found.log_value.map_or(f64::INFINITY, |value| sign * value);
            self.least().is_none_or(|(least, _)| value <= least + self.options.tolerance)
        };
        let minimised: Vec<f64> = found.gradient.iter().map(|slope| sign * slope).collect();
        self.gives_up.get()
            && !minimised.is_empty()
            && self.problem.violation(&found.coordinates) <= FEASIBLE
            && is_best()
            && projected_gradient(self.problem, &found.coordinates, &minimised).largest() <= STATIONARY
    }

    /// Whether the newest designs have brought nothing.
    fn is_stalled(&self) -> bool {
        let seen = self.seen.borrow();
        let before = seen.len().saturating_sub(STALLED);
        let value = |range: &[Evaluation]| self.best_of(range).and_then(|k| range[k].log_value);
        let (Some(then), Some(now)) = (value(&seen[..before]), value(&seen)) else { return false };
        self.gives_up.get() && self.problem.goal.sign() * (then - now) <= self.options.tolerance
    }

    /// What is minimised, with its gradient where that is asked for. A bad point is worse than all good ones, in a bowl around the best of them:
    /// value and gradient fit each other, so that a search along a line turns back.
    pub(crate) fn minimised(&self, coordinates: &[f64], with_gradient: bool) -> (f64, Vec<f64>) {
        let sign = self.problem.goal.sign();
        match self.evaluated(coordinates, with_gradient) {
            Some(Evaluation { log_value: Some(value), gradient, .. }) => {
                (sign * value, gradient.iter().map(|slope| sign * slope).collect())
            }
            _ => self.in_bowl(coordinates),
        }
    }

    fn evaluated(&self, coordinates: &[f64], with_gradient: bool) -> Option<Evaluation> {
        let enough = |known: &Evaluation| {
            known.coordinates == coordinates
                && (!with_gradient || known.log_value.is_none() || !known.gradient.is_empty())
        };
        if let Some(known) = self.seen.borrow().iter().rev().find(|known| enough(known)) {
            return Some(known.clone());
        }
        if self.is_over() {
            return None;
        }
        let found = (self.options.known)(coordinates, with_gradient).unwrap_or_else(|| {
            let found = self.evaluator.evaluate(coordinates, with_gradient);
            (self.options.keep)(self.number, &found);
            found
        });
        self.is_stationary.set(self.fulfils(&found));
        self.seen.borrow_mut().push(found.clone());
        Some(found)
    }

    /// worst + WORSE (1 + |c - best|²) and its gradient.
    fn in_bowl(&self, coordinates: &[f64]) -> (f64, Vec<f64>) {
        let best = self.least().map_or_else(|| coordinates.to_vec(), |(_, at)| at);
        let away: Vec<f64> = coordinates.iter().zip(&best).map(|(c, best)| c - best).collect();
        let square: f64 = away.iter().map(|away| away * away).sum();
        (self.worst() + WORSE * (1.0 + square), away.iter().map(|away| 2.0 * WORSE * away).collect())
    }

    /// The least of what is minimised over the feasible designs, and where it is.
    pub(crate) fn least(&self) -> Option<(f64, Vec<f64>)> {
        let seen = self.seen.borrow();
        let best = &seen[self.best()?];
        Some((self.problem.goal.sign() * best.log_value?, best.coordinates.clone()))
    }

    /// The worst of what is minimised, among good points.
    fn worst(&self) -> f64 {
        let sign = self.problem.goal.sign();
        let seen = self.seen.borrow();
        let worst = seen.iter().filter_map(|known| Some(sign * known.log_value?)).reduce(f64::max);
        worst.unwrap_or(0.0)
    }

    /// The best feasible design.
    fn best(&self) -> Option<usize> {
        self.best_of(&self.seen.borrow())
    }

    fn best_of(&self, seen: &[Evaluation]) -> Option<usize> {
        let sign = self.problem.goal.sign();
        let value = |k: &usize| seen[*k].log_value.map_or(f64::INFINITY, |value| sign * value);
        let good =
            |k: &usize| seen[*k].log_value.is_some() && self.problem.violation(&seen[*k].coordinates) <= FEASIBLE;
        (0..seen.len()).filter(good).min_by(|a, b| value(a).total_cmp(&value(b)))
    }
}
