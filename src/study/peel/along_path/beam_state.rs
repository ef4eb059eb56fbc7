//! Which equilibria of a path are looked at with their fields along the beam: its limit points, and others evenly between.

use crate::solve::newton::Solution;
use crate::solve::path::segment::PathSegment;
use crate::solve::points::locate::{ROUGH, step_to};
use crate::solve::workspace::Workspace;
use crate::study::peel::result::Peel;
use crate::study::peel::solution_history::SolutionHistory;
use crate::study::states::fields::{BeamState, Reader};
use std::sync::Arc;

/// Pieces of a step by which the length of the curve is measured.
const PIECES: usize = 16;

impl Peel {
    /// The beam at every limit point of the path and at `count` places of it: its beginning, its end, and evenly between by the length of the
    /// curve of P over u, each over its range. In path order; empty where the peel was read or its solutions were dropped.
    pub fn states(&self, count: usize) -> Vec<BeamState> {
        let Some(trace) = self.trace.as_ref().filter(|trace| !trace.points.is_empty()) else { return Vec::new() };
        let reader = Reader::new(&self.model, &trace.problem.beam);
        let lengths = Lengths::of(trace);
        let mut found: Vec<BeamState> = lengths
            .places(count)
            .into_iter()
            .map(|place| {
                let at = lengths.found(place);
                reader.read(&solution_at(trace, at), None, lengths.position(at))
            })
            .collect();
        for (limit_point, solution) in self.limit_points.iter().zip(&trace.limit_points) {
            let position = lengths.position(beside(trace, limit_point.after, solution));
            found.push(reader.read(solution, Some(limit_point.kind), position));
        }
        found.sort_by(|a, b| a.path_position.total_cmp(&b.path_position));
        found
    }
}

/// A place of a path: on the step behind a point, this share of the step's label.
#[derive(Clone, Copy, Debug)]
struct Place {
    step: usize,
    share: f64,
}

/// The lengths of a curve from its beginning to places of its steps, [`PIECES`] a step.
struct Lengths {
    /// From the beginning, u and P over their ranges
    sums: Vec<f64>,
}

impl Lengths {
    fn of(trace: &SolutionHistory) -> Self {
        let mut curve: Vec<(f64, f64)> = Vec::new();
        for index in 0..trace.points.len() - 1 {
            let segment = PathSegment::around(&trace.problem, &trace.points, index);
            let middle = 0.5 * segment.end();
            let (displacement, force) =
                (segment.observable(|o| o.displacement, middle), segment.observable(|o| o.force, middle));
            let label = |piece: usize| segment.end() * piece as f64 / PIECES as f64;
            let inner = (1..PIECES).map(|piece| (displacement.at(label(piece)).0, force.at(label(piece)).0));
            curve.push(of(&trace.points[index]));
            curve.extend(inner);
        }
        curve.extend(trace.points.last().map(|last| of(last)));
        let range = |pick: fn(&(f64, f64)) -> f64| {
            let ends = trace.points.iter().map(|point| pick(&of(point)));
            let (low, high) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
            if high > low { high - low } else { 1.0 }
        };
        let ranges = (range(|p| p.0), range(|p| p.1));
        curve.iter_mut().for_each(|(u, p)| (*u, *p) = (*u / ranges.0, *p / ranges.1));
        let mut sums = vec![0.0];
        for pair in curve.windows(2) {
            let piece = (pair[1].0 - pair[0].0).hypot(pair[1].1 - pair[0].1);
            sums.push(sums[sums.len() - 1] + if piece.is_finite() { piece } else { 0.0 });
        }
        Self { sums }
    }

    fn whole(&self) -> f64 {
        self.sums.last().copied().unwrap_or(0.0)
    }

    /// Lengths at which `count` places lie evenly, the two ends among them.
    fn places(&self, count: usize) -> Vec<f64> {
        (0..count).map(|k| self.whole() * k as f64 / count.saturating_sub(1).max(1) as f64).collect()
    }

    /// The place at a length.
    fn found(&self, length: f64) -> Place {
        let last = self.sums.len().saturating_sub(2);
        let piece = self.sums.partition_point(|&sum| sum <= length).saturating_sub(1).min(last);
        let (from, to) = (self.sums[piece], self.sums.get(piece + 1).copied().unwrap_or(self.sums[piece]));
        let part = if to > from { ((length - from) / (to - from)).clamp(0.0, 1.0) } else { 0.0 };
        Place { step: piece / PIECES, share: ((piece % PIECES) as f64 + part) / PIECES as f64 }
    }

    /// How far along the path a place is, 0 to 1.
    fn position(&self, at: Place) -> f64 {
        let (piece, part) = ((at.share * PIECES as f64).floor(), (at.share * PIECES as f64).fract());
        let index = (at.step * PIECES + piece as usize).min(self.sums.len() - 1);
        let next = self.sums.get(index + 1).copied().unwrap_or(self.sums[index]);
        let length = self.sums[index] + part * (next - self.sums[index]);
        if self.whole() > 0.0 { length / self.whole() } else { 0.0 }
    }
}

/// The place of a solution on the step behind a point.
fn beside(trace: &SolutionHistory, step: usize, solution: &Solution) -> Place {
    if step + 1 >= trace.points.len() {
        return Place { step, share: 0.0 };
    }
    let segment = PathSegment::around(&trace.problem, &trace.points, step);
    Place { step, share: (segment.label(&solution.observables) / segment.end()).clamp(0.0, 1.0) }
}

fn of(point: &Solution) -> (f64, f64) {
    (point.observables.displacement, point.observables.force)
}

/// The solution at a place of a path; where none is found between two points, the nearer of these.
fn solution_at(trace: &SolutionHistory, Place { step, share }: Place) -> Arc<Solution> {
    let points = &trace.points;
    let known = if share <= 0.0 { Some(step) } else { (share >= 1.0).then_some(step + 1) };
    if let Some(point) = known.or(points.len().checked_sub(1).filter(|&last| step >= last)) {
        return points[point.min(points.len() - 1)].clone();
    }
    let mut segment = PathSegment::around(&trace.problem, points, step);
    let label = share * segment.end();
    match step_to(&trace.problem, &mut segment, 0.0, label, ROUGH, &mut Workspace::default()) {
        Ok(solution) => solution,
        Err(_) => points[if share < 0.5 { step } else { step + 1 }].clone(),
    }
}
