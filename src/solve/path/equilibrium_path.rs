//! The path of equilibria from its start, point by point, through every limit point.
//!
//! The path parameter is a linear functional of observables that do not all turn at once: the monitors of the system, the displacement,
//! and of a system whose monitors do not go forward the force. Its weights are renewed at every step from the tangent, each
//! observable measured by its own recent changes.

use super::metric::{Metric, Notice};
use super::near_branch::{NearBranch, StepSeen, leads_elsewhere, settled};
use super::options::{PathError, PathOptions, Waypoint};
use super::predictor::MOST_POINTS;
use super::{near_branch, predictor};
use crate::solve::error::SolveError;
use crate::solve::newton::{NewtonOptions, Solution, solve, solve_warily};
use crate::solve::problem::Problem;
use crate::solve::state::{History, Observables, PathConstraint, State};
use crate::solve::workspace::{Pace, ShouldStop, Workspace};
use std::sync::Arc;
use std::vec;

/// A path being followed: an iterator over its points, to be driven and stopped at will. All points stay in it.
pub struct Path<'p> {
    problem: &'p Problem,
    options: PathOptions,
    start: State,
    /// Points that need not be computed.
    known: vec::IntoIter<Waypoint>,
    points: Vec<Arc<Solution>>,
    /// Errors at the newest point of predictions through 1, 2, … points.
    errors: Vec<f64>,
    ws: Workspace,
    iterations: usize,
    /// What the material points remember behind the newest point.
    history: Option<Arc<History>>,
    /// Whether a step has been refused because Newton's method did not converge from where it was predicted to lead.
    careful: bool,
    /// Where sections yield: how long a step was at which Newton's method found no equilibrium, over the newest step
    refused: Option<f64>,
    /// Where a step has led to another branch, until that lies behind.
    branch: Option<NearBranch>,
    /// What the path is measured by.
    notice: Notice,
    /// Whether the point before the newest has been replaced on the step to it, because it was no equilibrium.
    mended: bool,
}

/// Tries of one step after which points of a path that asks for close ones are closer than its slopes are known.
const CLOSE: usize = 5;
/// Most tries of one step, each shorter.
const MOST_TRIES: usize = 14;
/// The try before which the slope at the newest point is computed anew.
const DOUBTFUL: usize = 3;
/// The try from which on solves go at the pace of the path.
const WARY: usize = 2;
/// A step is refused when its prediction was wrong by this multiple of the step tolerance.
const REFUSE: f64 = 12.0;
/// A step is refused when the path turns from its chord by more than the angle of this cosine.
const LEAST_COSINE: f64 = 0.5;
/// Most growth of a step.
const MOST_GROWTH: f64 = 3.5;
/// The longest step over one that was refused, and by how much that counts as longer with each step since.
const OF_REFUSED: f64 = 0.5;
const LESS_WARY: f64 = 1.1;
/// Points at the beginning of a path that are stepped by the displacement alone: the monitors may not move yet.
const OUTSET: usize = 3;
/// The same for the second, before anything is known of the force's curvature.
const OUTSET_GROWTH: f64 = 2.0;
/// Points over which the path's direction is taken.
const CHORD: usize = 4;
/// Segments on which a point may lie that leads back, and how far beside one, over its length.
const LOOKED_BACK: usize = 8;
const BESIDE: f64 = 0.05;

impl<'p> Path<'p> {
    /// A path that starts at rest.
    pub fn new(problem: &'p Problem, options: PathOptions) -> Self {
        Self::from(problem, options, problem.initial(options.elements))
    }

    /// A path that starts at the equilibrium next to `start`, on its elements, with its displacement, where it must have no limit point. A beam that is
    /// curved in its stress-free configuration bends towards the substrate.
    pub fn from(problem: &'p Problem, options: PathOptions, start: State) -> Self {
        let (known, points, errors) = (Vec::new().into_iter(), Vec::new(), Vec::new());
        Self {
            problem,
            options,
            start,
            known,
            points,
            errors,
            ws: Workspace::default(),
            iterations: 0,
            history: None,
            careful: false,
            refused: None,
            branch: None,
            notice: Notice::default(),
            mended: false,
        }
    }

    /// The same path where its first points are known, from another run with the same options: all behind them is as if they had been computed.
    pub fn knowing(self, first: Vec<Waypoint>) -> Self {
        Self { known: first.into_iter(), ..self }
    }

    /// The same, with no solve begun once `should_stop` says so.
    pub(crate) fn until(self, should_stop: Option<ShouldStop>) -> Self {
        Self { ws: Workspace::until(should_stop), ..self }
    }

    /// The points so far.
    pub fn points(&self) -> &[Arc<Solution>] {
        &self.points
    }

    /// What the material points remember behind the newest point.
    pub(crate) fn history(&self) -> Option<&History> {
        self.history.as_deref()
    }

    /// Newton iterations so far, of refused steps too.
    pub fn iterations(&self) -> usize {
        self.iterations
    }

    fn newton(&self) -> NewtonOptions {
        let PathOptions { tolerance, pace, .. } = self.options;
        // next to a branch the tangent turns with the least error
        let exact_slope = self.branch.is_some() || pace == Pace::Watchful;
        NewtonOptions { tolerance, largest_update: 0.5, most_iterations: 9, exact_slope }
    }

    /// The newest point, for a path that is to go on from there.
    pub fn waypoint(&self) -> Option<Waypoint> {
        let point = self.points.last()?.clone();
        let Self { iterations, careful, refused, branch, notice, .. } = *self;
        let before = self.points.len().checked_sub(2).filter(|_| self.mended).map(|k| self.points[k].clone());
        Some(Waypoint { point, errors: self.errors.clone(), iterations, careful, refused, branch, notice, before })
    }

    /// Computes the next point, where it is not known.
    pub fn advance(&mut self) -> Result<Arc<Solution>, PathError> {
        self.mended = false;
        let point = match self.known.next() {
            Some(Waypoint { point, errors, iterations, careful, refused, branch, notice, before }) => {
                before.into_iter().for_each(|mended| self.mend(mended));
                (self.errors, self.iterations) = (errors, iterations);
                (self.careful, self.refused) = (careful, refused);
                (self.branch, self.notice) = (branch, notice);
                point
            }
            None if self.points.is_empty() => Arc::new(self.first()?),
            None => {
                let next = self.step()?;
                Arc::new(match self.problem.system.corner_before(&next.at) {
                    Some(memory) => self.step_behind_corner(&next, memory)?,
                    None => next,
                })
            }
        };
        self.history = self.problem.system.commit(&point.at);
        self.points.push(point.clone());
        Ok(point)
    }

    fn first(&mut self) -> Result<Solution, PathError> {
        let start = self.start.clone();
        let weights = self.outset();
        let target = weights.displacement * self.problem.displacement(&start);
        let constraint = PathConstraint { weights, target };
        let solved = if self.problem.start.settles() {
            settled(self.problem, start, &constraint, &self.newton(), &mut self.ws)
        } else {
            solve(self.problem, start, &constraint, &self.newton(), &mut self.ws)
        };
        solved.inspect(|s| self.iterations += s.iterations).map_err(|cause| self.stopped(1, cause))
    }

    /// The next point; a path that is watched and cannot be continued goes on by what is left of its observables.
    fn step(&mut self) -> Result<Solution, PathError> {
        let branch = self.branch;
        let mut stepped = self.step_noticing();
        while stepped.is_err()
            && self.options.pace == Pace::Watchful
            && let Some(finer) = self.notice.finer()
        {
            (self.notice, self.branch) = (finer, branch);
            stepped = self.step_noticing().or(stepped);
        }
        stepped
    }

    /// The point in place of one that passed a corner, with what is remembered at the newest point: next to it where the corner is slight. Else the
    /// path goes on in another direction, so that nothing is predicted, to its displacement or less far.
    fn step_behind_corner(&mut self, passed: &Solution, memory: Arc<History>) -> Result<Solution, PathError> {
        self.history = Some(memory);
        let newest = self.points[self.points.len() - 1].clone();
        let (from, to) = (newest.observables.displacement, passed.observables.displacement);
        let (mut part, mut cause) = (1.0, SolveError::SingularGrip);
        self.ws.set_pace(Pace::Quick);
        let along = self.weights(&newest.slope);
        let onward = Observables { displacement: (to - from).signum(), ..Observables::default() };
        for tries in 0..MOST_TRIES {
            let (from_which, weights, target) = match tries {
                0 => (passed, along, along.dot(&passed.observables)),
                _ => (&*newest, onward, onward.displacement * (from + part * (to - from))),
            };
            let start = State { history: self.history.clone(), ..from_which.at.clone() };
            match solve(self.problem, start, &PathConstraint { weights, target }, &self.newton(), &mut self.ws) {
                Ok(next) => {
                    self.iterations += next.iterations;
                    return Ok(next);
                }
                Err(_) if tries == 0 => {}
                Err(error) => (cause, part) = (error, 0.25 * part),
            }
        }
        Err(self.stopped(MOST_TRIES, cause))
    }

    fn step_noticing(&mut self) -> Result<Solution, PathError> {
        let mut newest = self.points[self.points.len() - 1].clone();
        let mut slope = newest.slope;
        let mut weights = self.weights(&slope);
        let (mut points, mut labels) = self.labelled(&weights);
        let outset = self.points.len() <= 2;
        let (mut count, mut step) = if outset { (1, self.first_step(&labels)) } else { self.choose(&labels) };
        step = step.abs().min(self.longest(&weights, &slope)).copysign(step);
        let (mut cause, mut crosses) = (SolveError::SingularGrip, false);
        let newest_step = labels.get(1).map_or(step.abs(), |label| label.abs());
        for tries in 0..MOST_TRIES {
            if tries == DOUBTFUL
                && let Ok(exact) = self.again(&newest, &weights)
            {
                slope = exact;
                newest = self.points[self.points.len() - 1].clone();
                weights = self.weights(&slope);
                (points, labels) = self.labelled(&weights);
                count = count.min(labels.len());
            }
            let mut start = if outset {
                newest.moved(self.problem, step / weights.dot(&newest.slope))
            } else {
                predictor::predicted(self.problem, &points, &labels, count, step)
            };
            start.history.clone_from(&self.history);
            if !self.problem.system.admits(&newest.at, newest.observables.monitors, &start) {
                step *= 0.4;
                continue;
            }
            let constraint = PathConstraint { weights, target: weights.dot(&newest.observables) + step };
            self.ws.set_pace(if tries >= WARY { self.options.pace } else { Pace::Quick });
            match solve(self.problem, start, &constraint, &self.newton(), &mut self.ws) {
                Ok(next) => {
                    self.iterations += next.iterations;
                    // points that are as close as that to one another have slopes that are not those of the path
                    let close = tries > CLOSE && self.problem.system.step_dependence().is_yielding();
                    let turned = points.len() > 1 && !close && self.turns_sharply(&slope, &next);
                    let refused = SolveError::NotConverged { update: next.correction, iterations: next.iterations };
                    let seen = self.seen(&newest, &next, crosses);
                    if let StepSeen::Elsewhere { across } = seen {
                        (cause, step) = (refused, step * near_branch::SHORTER);
                        if let (true, Some(near)) = (across, &self.branch) {
                            (crosses, step) = (true, near.step_across(self.problem, &weights, &slope));
                        }
                    } else if turned
                        || self.notice != Notice::Scale && !close && self.leads_back(&next)
                        || next.correction > REFUSE * self.step_tolerance() && points.len() > 1
                    {
                        (cause, step) = (refused, step * 0.4);
                    } else {
                        self.refused = self.refused.map(|refused| LESS_WARY * refused * newest_step / step.abs());
                        self.errors = predictor::errors(self.problem, &points, &labels, &next, step);
                        self.branch = self.branch.filter(|near| !near.is_behind(self.problem, &newest, &next));
                        return Ok(next);
                    }
                }
                Err(error) => {
                    self.iterations += 3;
                    // the path of a structure that remembers has corners, across which fewer points predict better
                    let dependence = self.problem.system.step_dependence();
                    self.careful = !dependence.exists();
                    self.refused = dependence.is_yielding().then_some(step.abs() / newest_step);
                    cause = error;
                    step *= 0.25;
                    // next to a branch point no equilibrium is certain, beyond it there is one
                    let near = self.branch.filter(|_| !crosses);
                    if let Some(near) = near.filter(|near| near.is_short(self.problem, &weights, &slope, step)) {
                        (crosses, step) = (true, near.step_across(self.problem, &weights, &slope));
                    }
                }
            }
            count = count.min(3);
        }
        Err(self.stopped(MOST_TRIES, cause))
    }

    /// The slope at the newest point itself. That of a solution is one update of Newton's method back, and near limit points it may be wrong by all
    /// of itself. Where the pace is not quick the point is replaced by what it is solved to: it may have been no equilibrium.
    fn again(&mut self, point: &Solution, weights: &Observables) -> Result<Observables, SolveError> {
        let constraint = PathConstraint { weights: *weights, target: weights.dot(&point.observables) };
        let exact = NewtonOptions { exact_slope: true, ..self.newton() };
        self.ws.set_pace(Pace::Quick);
        let solution = match self.options.pace {
            Pace::Quick => solve(self.problem, point.at.clone(), &constraint, &exact, &mut self.ws)?,
            pace @ (Pace::Wary | Pace::Watchful) => {
                // the next one lies on the mesh that this one asks for itself
                let start = if pace == Pace::Watchful { point.aligned(self.problem) } else { &point.at };
                let mended = solve_warily(self.problem, start, &constraint, &exact, &mut self.ws)
                    .or_else(|_| solve(self.problem, point.at.clone(), &constraint, &exact, &mut self.ws))?;
                self.mend(Arc::new(mended.clone()));
                mended
            }
        };
        self.iterations += solution.iterations;
        Ok(solution.slope)
    }

    /// Puts an equilibrium in the place of the newest point.
    fn mend(&mut self, equilibrium: Arc<Solution>) {
        self.history = self.problem.system.commit(&equilibrium.at);
        if let Some(newest) = self.points.last_mut() {
            *newest = equilibrium;
        }
        self.mended = true;
    }

    /// Weights of the first steps: the displacement in the path's direction.
    fn outset(&self) -> Observables {
        Observables { displacement: self.options.first_displacement.signum(), ..Observables::default() }
    }

    /// Weights of the path parameter: a direction between the tangent's and that of the last points, in which those go
    /// forward although one observable may turn; each observable in units of its recent changes.
    fn weights(&self, slope: &Observables) -> Observables {
        let n = self.points.len();
        let newest = &self.points[n - 1];
        if n <= OUTSET {
            return self.outset();
        }
        let metric = self.metric(None);
        let chord = newest.observables.since(&self.points[n.saturating_sub(1 + CHORD)].observables);
        metric.weights(&metric.unit(slope).plus(&metric.unit(&chord)))
    }

    /// Whether the path turns too much on the step to `next`, from either end to the chord.
    fn turns_sharply(&self, slope: &Observables, next: &Solution) -> bool {
        let newest = &self.points[self.points.len() - 1];
        let metric = self.metric(Some(&next.observables));
        let chord = next.observables.since(&newest.observables);
        metric.cosine(slope, &chord) < LEAST_COSINE || metric.cosine(&next.slope, &chord) < LEAST_COSINE
    }

    /// Whether a point lies on the path that has been followed, which runs back there.
    fn leads_back(&self, next: &Solution) -> bool {
        let metric = self.metric(Some(&next.observables));
        self.points.windows(2).rev().take(LOOKED_BACK).any(|ends| {
            let chord = ends[1].observables.since(&ends[0].observables);
            let off = next.observables.since(&ends[0].observables);
            let length = metric.weights(&chord).dot(&chord);
            let share = metric.weights(&chord).dot(&off) / length;
            let beside = off.plus(&chord.times(-share));
            let on_it = (0.0..=1.0).contains(&share) && metric.weights(&beside).dot(&beside) <= BESIDE * length;
            on_it && metric.cosine(&next.slope, &chord) < 0.0
        })
    }

    /// Error wanted of a prediction.
    fn step_tolerance(&self) -> f64 {
        NearBranch::step_tolerance(self.branch.as_ref(), self.options.step_tolerance)
    }

    /// Where a step has led; where branches nearly meet is remembered.
    fn seen(&mut self, newest: &Solution, next: &Solution, crosses: bool) -> StepSeen {
        let problem = self.problem;
        if self.branch.is_none() && leads_elsewhere(problem, self.options.pace, newest, next) {
            self.branch = Some(NearBranch::ahead(problem, newest, next));
        }
        let before = &self.points[self.points.len().saturating_sub(2)];
        self.branch.map_or(StepSeen::OnPath, |near| near.seen(problem, [before, newest], next, crosses))
    }

    /// The metric of the newest points, and of a further one.
    fn metric(&self, next: Option<&Observables>) -> Metric {
        let from = self.points.len().saturating_sub(if next.is_some() { 3 } else { 4 });
        let newest = &self.points[self.points.len() - 1].observables;
        Metric::of(self.problem, self.notice, newest, self.points[from..].iter().map(|p| &p.observables).chain(next))
    }

    /// The newest points, newest first, and their labels relative to the newest; as many as labels keep their order.
    fn labelled(&self, weights: &Observables) -> (Vec<Arc<Solution>>, Vec<f64>) {
        let newest = &self.points[self.points.len() - 1];
        let (mut points, mut labels) = (vec![newest.clone()], vec![0.0f64]);
        for point in self.points.iter().rev().skip(1).take(self.options.prediction.clamp(1, MOST_POINTS)) {
            let label = weights.dot(&point.observables.since(&newest.observables));
            let gap = labels[labels.len() - 1] - label;
            if gap <= 0.0 || (labels.len() > 1 && gap < 0.02 * -labels[1]) {
                break;
            }
            points.push(point.clone());
            labels.push(label);
        }
        (points, labels)
    }

    /// The steps along the tangent with which a path begins: the second as long as the first was good, whose error is of
    /// second order.
    fn first_step(&self, labels: &[f64]) -> f64 {
        match labels {
            [_, before] => {
                let error = self.points[1].correction.max(f64::MIN_POSITIVE);
                let growth = (0.7 * self.options.step_tolerance / error).sqrt();
                -before * growth.min(OUTSET_GROWTH)
            }
            _ => self.options.first_displacement.abs(),
        }
    }

    /// How many points to predict from, and the step. Of several that allow the same step, fewest points; once a step has been refused, those that
    /// are expected to be wrong by least.
    fn choose(&self, labels: &[f64]) -> (usize, f64) {
        if labels.len() == 1 {
            return (1, 1e-2);
        }
        let stride = self.options.stride;
        let most =
            self.refused.map_or(MOST_GROWTH, |refused| MOST_GROWTH.min(OF_REFUSED * refused)) / stride * -labels[1];
        let tolerance = 0.7 * self.step_tolerance();
        let mut best = (labels.len().min(2), 0.5 / stride * -labels[1], f64::INFINITY);
        for count in 1..labels.len() {
            let Some(&error) = self.errors.get(count - 1) else { break };
            let step = predictor::longest_step(labels, count, error, tolerance, most);
            let expected = predictor::expected_error(labels, count, error, step);
            if count == 1 || step > best.1 || self.careful && step == best.1 && expected < best.2 {
                best = (count, step, expected);
            }
        }
        (best.0, stride * best.1)
    }

    /// The longest step that the first monitor allows.
    fn longest(&self, weights: &Observables, slope: &Observables) -> f64 {
        let PathOptions { stride, longest: Some(longest), .. } = self.options else { return f64::INFINITY };
        let most = stride * longest * self.problem.measure.monitors[0];
        most / (slope.monitors[0] / weights.dot(slope)).abs()
    }

    fn stopped(&self, tries: usize, cause: SolveError) -> PathError {
        let last = self.points.last().map(|p| p.observables).unwrap_or_default();
        PathError { point: self.points.len(), displacement_nm: last.displacement, force: last.force, tries, cause }
    }
}

impl Iterator for Path<'_> {
    type Item = Result<Arc<Solution>, PathError>;

    fn next(&mut self) -> Option<Self::Item> {
        Some(self.advance())
    }
}
