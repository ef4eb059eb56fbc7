//! The path of equilibria from rest, point by point, through every turning point.
//!
//! The path parameter is a linear functional of three observables that do not all turn at once: position of the peeling
//! front (adhesion energy), displacement of the grip, rotation of the left end; where nothing adheres the force stands in
//! for the front. Its weights are renewed at every step from the tangent, each observable measured by its own recent
//! changes.

use super::predictor::{self, MOST_POINTS};
use super::{
    Beginning, Condition, Equilibrium, Held, NewtonOptions, Observables, Problem, RelaxOptions, Slips, Solution,
    SolveError, Workspace, relax, settle, solve,
};
use crate::beam::Rest;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::time::Instant;
use std::vec;

/// How a path is stepped. Its points follow from this and the problem alone.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PathOptions {
    /// Elements of the chain.
    pub elements: usize,
    /// Error wanted of a prediction, relative as in [`Problem::relative_size`].
    pub step_tolerance: f64,
    /// Length of a step over that which predictions allow, at most 1.
    pub stride: f64,
    /// Error wanted of a solution, likewise.
    pub tolerance: f64,
    /// Most points that a prediction uses: 2 is the secant
    pub prediction: usize,
    /// First displacement, nm (rad where the rotation is driven); its sign is the direction of the path
    pub first_displacement: f64,
}

/// Where a path stopped and why.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(
    "the path cannot be continued from u = {displacement_nm:.6} nm, P = {force:.6} nN (point {point}): after {tries} shorter and shorter steps: {cause}"
)]
pub struct PathError {
    pub point: usize,
    pub displacement_nm: f64,
    pub force: f64,
    pub tries: usize,
    pub cause: SolveError,
}

/// A point of a path and what the path has learnt there: with the points before, all that it takes to go on.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Waypoint {
    pub point: Arc<Solution>,
    errors: Vec<f64>,
    iterations: usize,
}

/// A path being followed: an iterator over its points, to be driven and stopped at will. All points stay in it.
pub struct Path<'p> {
    problem: &'p Problem,
    options: PathOptions,
    start: Equilibrium,
    /// Points that need not be computed.
    known: vec::IntoIter<Waypoint>,
    points: Vec<Arc<Solution>>,
    /// Errors at the newest point of predictions through 1, 2, … points.
    errors: Vec<f64>,
    work: Workspace,
    iterations: usize,
    /// What the material points remember behind the newest point.
    slips: Option<Arc<Slips>>,
}

/// Most tries of one step, each shorter.
const MOST_TRIES: usize = 14;
/// A step is refused when its prediction was wrong by this multiple of the step tolerance.
const REFUSE: f64 = 12.0;
/// A step is refused when the path turns from its chord by more than the angle of this cosine.
const LEAST_COSINE: f64 = 0.5;
/// Most growth of a step.
const MOST_GROWTH: f64 = 3.5;
/// Points at the beginning of a path that are stepped by the displacement alone: at rest the front does not move yet.
const OUTSET: usize = 3;
/// The same for the second, before anything is known of the force's curvature.
const OUTSET_GROWTH: f64 = 2.0;
/// A beam of which less than this share of the process zone adheres is loose.
const LOOSE: f64 = 0.1;
/// Share of the friction that is all of it.
const ALL: f64 = 1.0 - 1e-9;
/// Friction that is next to nothing, over that of a process zone at rest.
const LET_GO: f64 = 0.5;
/// One step takes a loose beam no nearer to the substrate than this share of its distance.
const NEARER: f64 = 0.6;
/// Points over which the path's direction is taken.
const CHORD: usize = 4;
/// Most that a step of settling down moves, relative as in [`Problem::relative_size`].
const SETTLING: f64 = 0.3;
/// Changes of front, displacement, rotation and force below this share of their scales do not measure a path.
const NOTICED: f64 = 1e-3;

impl<'p> Path<'p> {
    /// A path that starts at rest.
    pub fn new(problem: &'p Problem, options: PathOptions) -> Self {
        Self::from(problem, options, problem.at_rest(options.elements))
    }

    /// A path that starts at the equilibrium next to `start`, on its elements, with its displacement. A beam that is curved when
    /// free of stress bends towards the substrate. It must not turn there.
    pub fn from(problem: &'p Problem, options: PathOptions, start: Equilibrium) -> Self {
        let (known, points, errors) = (Vec::new().into_iter(), Vec::new(), Vec::new());
        Self { problem, options, start, known, points, errors, work: Workspace::default(), iterations: 0, slips: None }
    }

    /// The same path where its first points are known, from another run of the same problem with the same options: they
    /// are not computed again, and all behind them is as if they had been.
    pub fn knowing(self, first: Vec<Waypoint>) -> Self {
        Self { known: first.into_iter(), ..self }
    }

    /// The same, with nothing begun after `deadline`.
    pub fn until(self, deadline: Option<Instant>) -> Self {
        Self { work: Workspace::until(deadline), ..self }
    }

    /// The points so far.
    pub fn points(&self) -> &[Arc<Solution>] {
        &self.points
    }

    /// Whether no part of the beam is nearer to the substrate than `far`, nm, at the newest point.
    pub fn is_clear(&self, far: f64) -> bool {
        self.points.last().is_none_or(|p| self.problem.is_clear(&p.at, far))
    }

    /// Whether all that is in contact slides one way, or next to nothing is left of the friction that alone holds the beam along the
    /// substrate.
    pub fn slides(&self) -> bool {
        let (Some(now), Some(rest)) = (&self.slips, &self.problem.slips) else { return false };
        let (capacity, little) = (now.capacity(), LET_GO * self.problem.process_length / self.problem.length);
        capacity < little * rest.capacity() || now.carried().abs() > ALL * capacity
    }

    /// Newton iterations so far, of refused steps too.
    pub fn iterations(&self) -> usize {
        self.iterations
    }

    fn newton(&self) -> NewtonOptions {
        NewtonOptions { tolerance: self.options.tolerance, largest_update: 0.5, most_iterations: 9, exact_slope: false }
    }

    /// The newest point, for a path that is to go on from there.
    pub fn waypoint(&self) -> Option<Waypoint> {
        let point = self.points.last()?.clone();
        Some(Waypoint { point, errors: self.errors.clone(), iterations: self.iterations })
    }

    /// Computes the next point, where it is not known.
    pub fn advance(&mut self) -> Result<Arc<Solution>, PathError> {
        let point = match self.known.next() {
            Some(Waypoint { point, errors, iterations }) => {
                (self.errors, self.iterations) = (errors, iterations);
                point
            }
            None if self.points.is_empty() => Arc::new(self.first()?),
            None => Arc::new(self.step()?),
        };
        self.slips = self.problem.chain.slid(point.at.configuration()).map(Arc::new);
        self.points.push(point.clone());
        Ok(point)
    }

    fn first(&mut self) -> Result<Solution, PathError> {
        if let Beginning::Nowhere(why) = &self.problem.beginning {
            return Err(self.stopped(1, SolveError::NoBeginning(why.clone())));
        }
        let start = self.start.clone();
        let weights = self.outset();
        let target = weights.displacement * self.problem.displacement(&start);
        let condition = Condition { weights, target };
        let solved = match self.problem.rest {
            Rest::Curve(_) => solve(self.problem, start, &condition, &self.newton(), &mut self.work),
            Rest::Varying(_) => self.settled(start, &condition),
        };
        solved.inspect(|s| self.iterations += s.iterations).map_err(|cause| self.stopped(1, cause))
    }

    /// The equilibrium of a beam that is none where it is free of stress, on a mesh whose focus is at its front.
    fn settled(&mut self, start: Equilibrium, condition: &Condition) -> Result<Solution, SolveError> {
        let found = self.settled_near(start, condition)?;
        let center = self.problem.centered(found.observables.front);
        let elements = found.at.ends.len() - 1;
        let at = self.problem.on_elements(&Equilibrium { center, ..found.at }, elements);
        settle(self.problem, at, condition, &self.newton(), &mut self.work)
    }

    /// The same on the mesh of the start: by Newton's method, or, where that wanders, down the gradient of the energy.
    fn settled_near(&mut self, start: Equilibrium, condition: &Condition) -> Result<Solution, SolveError> {
        let displacement = self.problem.displacement(&start);
        let settled = settle(self.problem, start.clone(), condition, &self.newton(), &mut self.work);
        // long steps may have gone through the surface
        let above = settled.and_then(|solution| {
            let inside = SolveError::NotConverged { update: solution.correction, iterations: solution.iterations };
            if self.problem.nearest(&solution.at) > 0.0 { Ok(solution) } else { Err(inside) }
        });
        above.or_else(|error| {
            let options = RelaxOptions::by(SETTLING);
            let relaxed = relax(self.problem, start, Held::Displacement(displacement), &options, &mut self.work);
            relaxed.map(|relaxed| relaxed.solution).map_err(|_| error)
        })
    }

    fn step(&mut self) -> Result<Solution, PathError> {
        let newest = self.points[self.points.len() - 1].clone();
        let weights = self.weights();
        let (points, labels) = self.labelled(&weights);
        let outset = self.points.len() <= 2;
        let (mut count, mut step) = if outset { (1, self.first_step(&labels)) } else { self.choose(&labels) };
        let mut cause = SolveError::SingularGrip;
        for _ in 0..MOST_TRIES {
            let mut start = if outset {
                newest.moved(step / weights.dot(&newest.slope))
            } else {
                let combination = predictor::lagrange_weights(&labels[..count], step);
                predictor::combine(self.problem, &points[..count], &combination)
            };
            start.slips.clone_from(&self.slips);
            if self.falls_onto(&newest, &start) {
                step *= 0.4;
                continue;
            }
            let condition = Condition { weights, target: weights.dot(&newest.observables) + step };
            match solve(self.problem, start, &condition, &self.newton(), &mut self.work) {
                Ok(next) => {
                    self.iterations += next.iterations;
                    let turned = points.len() > 1 && self.turns_sharply(&next);
                    if turned || next.correction > REFUSE * self.options.step_tolerance && points.len() > 1 {
                        cause = SolveError::NotConverged { update: next.correction, iterations: next.iterations };
                        step *= 0.4;
                    } else {
                        self.errors = predictor::errors(self.problem, &points, &labels, &next, step);
                        return Ok(next);
                    }
                }
                Err(error) => {
                    self.iterations += 3;
                    cause = error;
                    step *= 0.25;
                }
            }
            count = count.min(3);
        }
        Err(self.stopped(MOST_TRIES, cause))
    }

    /// Whether a prediction brings a beam to which nothing adheres nearer to the substrate than a share of its distance: far
    /// away predictions are good, whatever the step, and know nothing of the substrate.
    fn falls_onto(&self, newest: &Solution, next: &Equilibrium) -> bool {
        let loose = self.problem.adheres() && newest.observables.front < LOOSE * self.problem.process_length;
        loose && self.problem.nearest(next) < NEARER * self.problem.nearest(&newest.at)
    }

    /// Weights of the first steps: the displacement in the path's direction.
    fn outset(&self) -> Observables {
        Observables { displacement: self.options.first_displacement.signum(), ..Observables::default() }
    }

    /// Weights of the path parameter: a direction between the tangent's and that of the last points, in which those go
    /// forward although one observable may turn; each observable in units of its recent changes.
    fn weights(&self) -> Observables {
        let n = self.points.len();
        let newest = &self.points[n - 1];
        if n <= OUTSET {
            return self.outset();
        }
        let metric = self.metric(None);
        let chord = newest.observables.since(&self.points[n.saturating_sub(1 + CHORD)].observables);
        metric.weights(&metric.unit(&newest.slope).plus(&metric.unit(&chord)))
    }

    /// Whether the path turns too much on the step to `next`, from either end to the chord.
    fn turns_sharply(&self, next: &Solution) -> bool {
        let newest = &self.points[self.points.len() - 1];
        let metric = self.metric(Some(&next.observables));
        let chord = next.observables.since(&newest.observables);
        metric.cosine(&newest.slope, &chord) < LEAST_COSINE || metric.cosine(&next.slope, &chord) < LEAST_COSINE
    }

    /// The metric of the newest points, and of a further one.
    fn metric(&self, next: Option<&Observables>) -> Metric {
        let from = self.points.len().saturating_sub(if next.is_some() { 3 } else { 4 });
        Metric::of(self.problem, self.points[from..].iter().map(|p| &p.observables).chain(next))
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

    /// How many points to predict from, and the step.
    fn choose(&self, labels: &[f64]) -> (usize, f64) {
        if labels.len() == 1 {
            return (1, 1e-2);
        }
        let stride = self.options.stride;
        let most = MOST_GROWTH / stride * -labels[1];
        let mut best = (labels.len().min(2), 0.5 / stride * -labels[1]);
        for count in 1..labels.len() {
            let Some(&error) = self.errors.get(count - 1) else { break };
            let step = predictor::longest_step(labels, count, error, 0.7 * self.options.step_tolerance, most);
            if step > best.1 || count == 1 {
                best = (count, step);
            }
        }
        (best.0, stride * best.1)
    }

    fn stopped(&self, tries: usize, cause: SolveError) -> PathError {
        let last = self.points.last().map(|p| p.observables).unwrap_or_default();
        PathError { point: self.points.len(), displacement_nm: last.displacement, force: last.force, tries, cause }
    }
}

/// Units of the three observables that measure the path, from how they change along a stretch of it. What does not
/// measure it, the force where something adheres and else the front, has an infinite unit.
#[derive(Clone, Copy, Debug)]
pub struct Metric {
    front: f64,
    displacement: f64,
    tip_rotation: f64,
    force: f64,
}

impl Metric {
    /// The largest change of each from point to point.
    pub fn of<'a>(problem: &Problem, stretch: impl Iterator<Item = &'a Observables>) -> Self {
        let adheres = problem.adheres();
        let mut metric = Self {
            front: if adheres { NOTICED * problem.process_length } else { f64::INFINITY },
            force: if adheres { f64::INFINITY } else { NOTICED * problem.force_scale },
            displacement: NOTICED * problem.scale[problem.driven],
            tip_rotation: NOTICED * problem.scale[problem.rotation],
        };
        let mut before: Option<&Observables> = None;
        for here in stretch {
            if let Some(before) = before {
                let change = here.since(before);
                metric.front = metric.front.max(change.front.abs());
                metric.displacement = metric.displacement.max(change.displacement.abs());
                metric.tip_rotation = metric.tip_rotation.max(change.tip_rotation.abs());
                metric.force = metric.force.max(change.force.abs());
            }
            before = Some(here);
        }
        metric
    }

    /// Weights of the path parameter that is the length along `direction`.
    pub fn weights(&self, direction: &Observables) -> Observables {
        let dual = Observables {
            front: direction.front / self.front.powi(2),
            displacement: direction.displacement / self.displacement.powi(2),
            tip_rotation: direction.tip_rotation / self.tip_rotation.powi(2),
            force: direction.force / self.force.powi(2),
            grip_rotation: 0.0,
        };
        dual.times(1.0 / dual.dot(direction).sqrt())
    }

    /// A direction with the length one.
    pub fn unit(&self, direction: &Observables) -> Observables {
        direction.times(1.0 / self.weights(direction).dot(direction))
    }

    /// Cosine of the angle between two directions.
    pub fn cosine(&self, a: &Observables, b: &Observables) -> f64 {
        let length = self.weights(b).dot(b);
        self.weights(a).dot(b) / length
    }
}

impl Iterator for Path<'_> {
    type Item = Result<Arc<Solution>, PathError>;

    fn next(&mut self) -> Option<Self::Item> {
        Some(self.advance())
    }
}
