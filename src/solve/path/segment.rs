//! A segment of the path between and around two of its points: interpolation of observables and of states.

use super::hermite::Hermite;
use super::metric::{Metric, Notice};
use super::predictor::{combine, lagrange_weights};
use crate::solve::newton::Solution;
use crate::solve::problem::Problem;
use crate::solve::state::{History, Observables, State};
use std::ops::Range;
use std::sync::Arc;

/// Points around one step of a path, labelled by one path parameter in which all of them go forward.
#[derive(Clone, Debug)]
pub struct PathSegment {
    /// Weights of the parameter.
    pub weights: Observables,
    /// Ascending labels; that of the step's first point is 0.
    labels: Vec<f64>,
    points: Vec<Arc<Solution>>,
    /// Label of the step's second point.
    end: f64,
    /// Change of the observables over the step.
    change: Observables,
    /// Slopes per label at its two ends.
    slopes: (Observables, Observables),
    /// What the material points remember on the step.
    history: Option<Arc<History>>,
}

/// Points on either side of a step that a segment takes in.
const NEIGHBOURS: usize = 3;
/// A neighbour takes part where the path's direction there makes at least this cosine with the step.
const NEIGHBOURS_COSINE: f64 = 0.85;
/// A neighbour nearer to the last than this share of the step adds nothing but noise.
const CROWDED: f64 = 0.25;
/// Points that an interpolation uses.
const USED: usize = 4;
/// Step of a difference of an interpolant, over the step of the path.
const BESIDE: f64 = 1e-3;

impl PathSegment {
    /// The segment around the step from `points[index]` to `points[index + 1]`.
    pub fn around(problem: &Problem, points: &[Arc<Solution>], index: usize) -> Self {
        let (from, to) = (&points[index], &points[index + 1]);
        let secant = to.observables.since(&from.observables);
        let measured = |notice| {
            let around = points[index.saturating_sub(2)..index + 2].iter().map(|p| &p.observables);
            Metric::of(problem, notice, &from.observables, around)
        };
        let metric = measured(Notice::Scale);
        let turns = [from, to].iter().any(|p| metric.cosine(&secant, &p.slope) <= 0.0);
        // the displacement measures no path that turns with it
        let alone = index > 0 && turns && metric.notices_displacement_alone(problem);
        let metric = if alone { measured(Notice::Rest) } else { metric };
        // at rest the front does not move yet: its square root is no label
        let weights = if index == 0 {
            metric.weights(&Observables { displacement: secant.displacement, ..Observables::default() })
        } else {
            metric.weights(&secant)
        };
        let label = |p: &Solution| weights.dot(&p.observables.since(&from.observables));
        let per_label = |p: &Solution| p.slope.times(1.0 / weights.dot(&p.slope));
        let end = label(to);
        let mut segment = Self {
            weights,
            labels: vec![0.0, end],
            points: vec![from.clone(), to.clone()],
            end,
            change: secant,
            slopes: (per_label(from), per_label(to)),
            history: to.at.history.clone(),
        };
        // neighbours, as long as the path has not turned much from the step's direction; those that crowd are passed over
        let along = |p: &Solution| metric.cosine(&secant, &p.slope) > NEIGHBOURS_COSINE;
        for point in points[..index].iter().rev().take(NEIGHBOURS).take_while(|p| along(p)) {
            let gap = (segment.labels[0] - label(point)) / end;
            if gap > CROWDED {
                segment.labels.insert(0, label(point));
                segment.points.insert(0, point.clone());
            }
        }
        for point in points[index + 2..].iter().take(NEIGHBOURS).take_while(|p| along(p)) {
            let gap = (label(point) - segment.labels[segment.labels.len() - 1]) / end;
            if gap > CROWDED {
                segment.labels.push(label(point));
                segment.points.push(point.clone());
            }
        }
        segment
    }

    /// Label of the step's second point; that of its first is 0.
    pub fn end(&self) -> f64 {
        self.end
    }

    /// The step's first point.
    pub fn first(&self) -> Arc<Solution> {
        let index = self.labels.iter().position(|&l| l == 0.0).unwrap_or(0);
        self.points[index].clone()
    }

    /// Change of the observables from the step's first point to its second.
    pub fn change(&self) -> Observables {
        self.change
    }

    /// The known solution between the labels `from` and `to` at which a quantity is least, or largest.
    pub(crate) fn extreme(
        &self,
        pick: fn(&Observables) -> f64,
        least: bool,
        (from, to): (f64, f64),
    ) -> Option<Arc<Solution>> {
        let known = self.labels.iter().zip(&self.points).filter(|&(label, _)| (from..=to).contains(label));
        let value = |point: &Solution| if least { -pick(&point.observables) } else { pick(&point.observables) };
        known.map(|(_, point)| point.clone()).max_by(|a, b| value(a).total_cmp(&value(b)))
    }

    /// The constraint's target for the label `at`.
    pub(crate) fn target(&self, at: f64) -> f64 {
        self.weights.dot(&self.points[0].observables) + at - self.labels[0]
    }

    /// The label of a place on the path.
    pub(crate) fn label(&self, observables: &Observables) -> f64 {
        self.weights.dot(&observables.since(&self.points[0].observables)) + self.labels[0]
    }

    /// Takes in a further solution; returns its label.
    pub(crate) fn insert(&mut self, solution: Arc<Solution>) -> f64 {
        let label = self.label(&solution.observables);
        let place = self.labels.partition_point(|&l| l < label);
        if let Some(twin) = self.twin(label, 1e-4) {
            self.labels[twin] = label;
            self.points[twin] = solution;
            return label;
        }
        self.labels.insert(place, label);
        self.points.insert(place, solution);
        label
    }

    /// Slopes per label at the two ends of the step.
    pub(crate) fn end_slopes(&self) -> (Observables, Observables) {
        (self.slopes.0, self.slopes.1)
    }

    /// A point whose label differs by less than `share` of the step.
    fn twin(&self, label: f64, share: f64) -> Option<usize> {
        (0..self.labels.len()).find(|&i| (self.labels[i] - label).abs() < share * self.end)
    }

    /// A start for Newton's method from the tangent of a point so near that interpolation would lose digits.
    pub(crate) fn near(&self, problem: &Problem, at: f64) -> Option<State> {
        let twin = self.twin(at, 1e-2)?;
        let ahead = (at - self.labels[twin]) / self.weights.dot(&self.points[twin].slope);
        Some(self.on_step(self.points[twin].moved(problem, ahead)))
    }

    /// A start for Newton's method at the label `at`, from the nearest `points`.
    pub fn start(&self, problem: &Problem, at: f64, points: usize) -> State {
        let used = self.nearest(at, points);
        self.on_step(combine(problem, &self.points[used.clone()], &lagrange_weights(&self.labels[used], at)))
    }

    /// A configuration with the memory of the step.
    fn on_step(&self, at: State) -> State {
        State { history: self.history.clone(), ..at }
    }

    /// The Hermite interpolant of one observable through the points nearest to `near`.
    pub(crate) fn observable(&self, pick: fn(&Observables) -> f64, near: f64) -> Hermite {
        self.interpolant(pick, near, USED)
    }

    /// The same at many places.
    pub(in crate::solve) fn interpolants(&self, pick: fn(&Observables) -> f64) -> Interpolants<'_> {
        Interpolants { segment: self, pick, newest: None }
    }

    /// How wrong the interpolant of one observable is in the middle of the step, judged by the one through one point less;
    /// none where the path turns away before and behind the step, so that only its ends are known.
    pub(crate) fn interpolation_error(&self, pick: fn(&Observables) -> f64) -> Option<f64> {
        let count = self.points.len().min(USED);
        let middle = 0.5 * self.end;
        let [best, less] = [count, count - 1].map(|points| self.interpolant(pick, middle, points).at(middle).0);
        (count > 2).then_some((best - less).abs())
    }

    /// A quantity that changes by `per_unit` of the parameter of each point, at the label `at`: how fast it changes a label, and how fast
    /// that changes.
    pub fn rate(&self, per_unit: &dyn Fn(&Solution) -> f64, at: f64) -> (f64, f64) {
        let used = self.nearest(at, USED);
        let of = |point: &Arc<Solution>| per_unit(point) / self.weights.dot(&point.slope);
        let rates: Vec<f64> = self.points[used.clone()].iter().map(of).collect();
        let labels = &self.labels[used];
        let value = |at: f64| lagrange_weights(labels, at).iter().zip(&rates).map(|(w, rate)| w * rate).sum::<f64>();
        let step = BESIDE * self.end;
        (value(at), (value(at + step) - value(at - step)) / (2.0 * step))
    }

    /// The Hermite interpolant of one observable through so many points nearest to `near`.
    fn interpolant(&self, pick: fn(&Observables) -> f64, near: f64, points: usize) -> Hermite {
        self.through(pick, self.nearest(near, points))
    }

    /// The Hermite interpolant of one observable through these points.
    fn through(&self, pick: fn(&Observables) -> f64, used: Range<usize>) -> Hermite {
        let data = used.map(|i| {
            let point = &self.points[i];
            (self.labels[i], pick(&point.observables), pick(&point.slope) / self.weights.dot(&point.slope))
        });
        Hermite::new(&data.collect::<Vec<_>>())
    }

    fn nearest(&self, at: f64, count: usize) -> Range<usize> {
        let n = self.labels.len();
        let place = self.labels.partition_point(|&l| l < at);
        let (mut from, mut to) = (place, place);
        while to - from < count.min(n) {
            // labels of an absurd strip may be infinite, or none at all
            let left = to == n || (from > 0 && at - self.labels[from - 1] <= self.labels[to] - at);
            if left { from -= 1 } else { to += 1 }
        }
        from..to
    }
}

/// The interpolants of one observable on a segment, each through the points nearest to a place: made anew where those are others.
pub(in crate::solve) struct Interpolants<'s> {
    segment: &'s PathSegment,
    pick: fn(&Observables) -> f64,
    newest: Option<(Range<usize>, Hermite)>,
}

impl Interpolants<'_> {
    /// The interpolant for the label `near`, as of [`PathSegment::observable`].
    pub(in crate::solve) fn near(&mut self, near: f64) -> &Hermite {
        let used = self.segment.nearest(near, USED);
        let known = self.newest.take().filter(|(of, _)| *of == used);
        let newest = known.unwrap_or_else(|| (used.clone(), self.segment.through(self.pick, used)));
        &self.newest.insert(newest).1
    }
}
