//! The solutions behind a peel: the curve between its points and the deformed strip.

use super::{LimitPoint, Shape};
use crate::solve::{Equilibrium, NodeState, Problem, Solution, Stretch, Turn};
use std::sync::Arc;

/// Path points with the problem that they solve.
#[derive(Clone)]
pub(super) struct Trace {
    pub problem: Arc<Problem>,
    pub points: Vec<Arc<Solution>>,
    /// The solution next to the initiation peak, if there is one.
    pub peak: Option<Arc<Solution>>,
}

impl std::fmt::Debug for Trace {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Trace({} points)", self.points.len())
    }
}

/// Samples of the axis an element gets.
const SAMPLES: usize = 6;

impl Trace {
    /// (u, P, negative eigenvalues under displacement control) with `per_step` intervals a step. A displacement limit
    /// point is put where it splits its step into a stable and an unstable part.
    pub fn dense_curve(&self, limit_points: &[LimitPoint], per_step: usize) -> Vec<(f64, f64, usize)> {
        let mut curve = Vec::new();
        for (index, point) in self.points.iter().enumerate() {
            curve.push((point.observables.displacement, point.observables.force, point.negative));
            let Some(next) = self.points.get(index + 1) else { break };
            let turn = limit_points.iter().find(|p| p.after == index && p.kind == Turn::Displacement);
            let inner = self.step(index, per_step);
            match turn {
                Some(turn) => curve.extend(split(inner, turn, point.negative, next.negative)),
                None => curve.extend(inner.into_iter().map(|(u, p)| (u, p, point.negative))),
            }
        }
        curve
    }

    /// Displacement and force inside one step.
    fn step(&self, index: usize, per_step: usize) -> Vec<(f64, f64)> {
        let stretch = Stretch::around(&self.problem, &self.points, index);
        let middle = 0.5 * stretch.end();
        let displacement = stretch.observable(|o| o.displacement, middle);
        let force = stretch.observable(|o| o.force, middle);
        let label = |k: usize| stretch.end() * k as f64 / per_step as f64;
        (1..per_step).map(|k| (displacement.at(label(k)).0, force.at(label(k)).0)).collect()
    }

    /// Section states at the ends of the elements.
    pub fn sections(&self, index: usize) -> Vec<NodeState> {
        let at = self.points.get(index).map(|p| &p.at);
        at.map(|at| self.problem.chain.node_states(at.configuration(), 0..at.ends.len() - 1)).unwrap_or_default()
    }

    /// Axis and rotation at one point, with x from the section's x' by Simpson's rule between samples.
    pub fn shape(&self, index: usize) -> Shape {
        self.points.get(index).map(|point| Shape::of(&self.problem, &point.at)).unwrap_or_default()
    }
}

impl Shape {
    /// Axis and rotation of an equilibrium.
    pub(super) fn of(problem: &Problem, at: &Equilibrium) -> Self {
        let mut shape = Self::default();
        let sample = |e: usize, fraction: f64| {
            let (values, section) = problem.chain.sample(at.configuration(), e, 2.0 * fraction - 1.0);
            let height = problem.height_at(at.ends[e] + fraction * (at.ends[e + 1] - at.ends[e]));
            let rotation = values[problem.rotation];
            ([values[problem.driven] + 0.5 * height, rotation, height], section.horizontal_slope)
        };
        // the free end is held there, unless friction alone holds it
        let mut x = if problem.slips.is_some() { at.state[0] } else { 0.0 };
        for e in 0..at.ends.len() - 1 {
            let step = (at.ends[e + 1] - at.ends[e]) / SAMPLES as f64;
            for k in 0..SAMPLES {
                let fraction = |part: f64| (k as f64 + part) / SAMPLES as f64;
                let (here, slope) = sample(e, fraction(0.0));
                shape.push(x, here);
                x += step * (slope + 4.0 * sample(e, fraction(0.5)).1 + sample(e, fraction(1.0)).1) / 6.0;
            }
        }
        shape.push(x, sample(at.ends.len() - 2, 1.0).0);
        shape
    }

    fn push(&mut self, x: f64, [y, rotation, height]: [f64; 3]) {
        self.x.push(x);
        self.y.push(y);
        self.rotation.push(rotation);
        self.height.push(height);
    }
}

/// The inner points of a step with the one nearest to the turn replaced by it; before it the count of the step's first
/// point holds, behind it that of its last, and the turn itself belongs to the stable side.
fn split(inner: Vec<(f64, f64)>, turn: &LimitPoint, before: usize, after: usize) -> Vec<(f64, f64, usize)> {
    let away = |&(u, p): &(f64, f64)| (u / turn.displacement - 1.0).hypot(p / turn.force - 1.0);
    let nearest = (0..inner.len()).min_by(|&a, &b| away(&inner[a]).total_cmp(&away(&inner[b])));
    let count = |k: usize| match nearest {
        Some(n) if k == n => before.min(after),
        Some(n) if k > n => after,
        _ => before,
    };
    let place = |k: usize, (u, p)| if Some(k) == nearest { (turn.displacement, turn.force) } else { (u, p) };
    inner
        .into_iter()
        .enumerate()
        .map(|(k, point)| {
            let (u, p) = place(k, point);
            (u, p, count(k))
        })
        .collect()
}
