//! Displacement and force inside one step of a path, from solutions there.
//!
//! Slopes of the path belong to the mesh of a point; between points whose meshes differ they are good to few digits. Here
//! only values count: u and P are polynomials through solutions at Gauss-Lobatto labels.

use super::result::Peel;
use crate::beam::element::basis::Basis;
use crate::model::problem::beam_problem::BeamProblem;
use crate::number::root::Bracket;
use crate::solve::newton::Solution;
use crate::solve::observables::Observables;
use crate::solve::path::predictor::lagrange_weights;
use crate::solve::path::segment::PathSegment;
use crate::solve::points::locate::{ROUGH, step_to};
use crate::solve::workspace::Workspace;
use std::sync::Arc;

/// Solutions on a step, its ends among them.
const NODES: usize = 7;
/// Most times a step is halved.
const MOST_HALVINGS: usize = 5;
/// A middle that is missed by this share of what changes on the step is missed in earnest.
const ROUGHLY: f64 = 1e-3;
/// How sharp a place on a step is looked for: sixty halvings of [-1, 1].
const SHARP: f64 = 2.6e-18;
/// Work that counts, over the adhesion of the whole beam.
const COUNTS: f64 = 1e-8;

/// u (nm) and P (nN) on a step, as polynomials of a local coordinate on [-1, 1].
pub(in crate::study) struct StepCurve {
    basis: Basis,
    displacements: [f64; NODES],
    forces: [f64; NODES],
}

impl StepCurve {
    /// The step behind `points[index]`.
    pub fn behind(problem: &BeamProblem, points: &[Arc<Solution>], index: usize, ws: &mut Workspace) -> Self {
        let segment = PathSegment::around(problem, points, index);
        Self::until(problem, &segment, segment.end(), &points[index + 1], ws)
    }

    /// From the first point of a segment to a solution at the label `to` of it.
    pub fn until(problem: &BeamProblem, segment: &PathSegment, to: f64, end: &Solution, ws: &mut Workspace) -> Self {
        Self::between(problem, &mut segment.clone(), [(0.0, &segment.first()), (to, end)], ws)
    }

    /// The same in pieces, halved where one curve would not be certain of its work.
    pub fn pieces(
        problem: &BeamProblem,
        segment: &PathSegment,
        to: f64,
        end: &Solution,
        ws: &mut Workspace,
    ) -> Vec<Self> {
        let mut known = segment.clone();
        Self::halved(problem, &mut known, [(0.0, &segment.first()), (to, end)], MOST_HALVINGS, ws)
    }

    fn halved(
        problem: &BeamProblem,
        known: &mut PathSegment,
        [from, to]: [(f64, &Solution); 2],
        halvings: usize,
        ws: &mut Workspace,
    ) -> Vec<Self> {
        let curve = Self::between(problem, known, [from, to], ws);
        let scale = problem.measure.force * problem.beam.length();
        if halvings == 0 || !curve.is_uncertain(scale) {
            return vec![curve];
        }
        let label = 0.5 * (from.0 + to.0);
        let Ok(middle) = step_to(problem, known, from.0, label, ROUGH, ws) else { return vec![curve] };
        let mut pieces = Self::halved(problem, known, [from, (label, &middle)], halvings - 1, ws);
        pieces.extend(Self::halved(problem, known, [(label, &middle), to], halvings - 1, ws));
        pieces
    }

    /// Between two solutions at labels of a segment, which takes in those that are found between them: where the force has a corner, each half
    /// of a step begins from them. Where one cannot be found, the interpolants stand in that the segment has by itself.
    fn between(
        problem: &BeamProblem,
        known: &mut PathSegment,
        [(from, start), (to, end)]: [(f64, &Solution); 2],
        ws: &mut Workspace,
    ) -> Self {
        let basis = Basis::new(NODES - 1);
        let (left, right) = (NODES - 2, NODES - 1);
        let mut at = [(0.0, 0.0); NODES];
        let of = |o: &Observables| (o.displacement, o.force);
        (at[left], at[right]) = (of(&start.observables), of(&end.observables));
        let middle = 0.5 * (from + to);
        let [displacement, force] = [|o: &Observables| o.displacement, |o: &Observables| o.force]
            .map(|pick: fn(&Observables) -> f64| known.observable(pick, middle));
        let mut last = from;
        for (at, node) in at[..left].iter_mut().zip(basis.nodes) {
            let label = from + 0.5 * (1.0 + node) * (to - from);
            *at = match step_to(problem, known, last, label, ROUGH, ws) {
                Ok(solution) => of(&solution.observables),
                Err(_) => (displacement.at(label).0, force.at(label).0),
            };
            last = label;
        }
        Self { basis, displacements: at.map(|pair| pair.0), forces: at.map(|pair| pair.1) }
    }

    /// Whether the polynomials through all nodes but the middle one miss that, by a share of what changes on the step and by more
    /// than work counts, in units of `scale`, aJ.
    fn is_uncertain(&self, scale: f64) -> bool {
        let places = &self.basis.nodes;
        let middle = (0..NODES).min_by(|&a, &b| places[a].abs().total_cmp(&places[b].abs())).unwrap_or(0);
        let others: Vec<usize> = (0..NODES).filter(|&node| node != middle).collect();
        let weights = lagrange_weights(&others.iter().map(|&node| places[node]).collect::<Vec<_>>(), places[middle]);
        let of = |values: &[f64; NODES]| {
            let mixed: f64 = weights.iter().zip(&others).map(|(weight, &node)| weight * values[node]).sum();
            let (low, high) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), &v| (a.min(v), b.max(v)));
            ((mixed - values[middle]).abs(), high - low)
        };
        let ((miss_u, range_u), (miss_p, range_p)) = (of(&self.displacements), of(&self.forces));
        let largest = self.forces.iter().fold(0.0f64, |sum, force| sum.max(force.abs()));
        let rough = miss_u > ROUGHLY * range_u || miss_p > ROUGHLY * range_p;
        rough && miss_p * range_u + miss_u * largest > COUNTS * scale
    }

    /// (u, u', P, P') at a local coordinate.
    pub fn at(&self, place: f64) -> (f64, f64, f64, f64) {
        let (value, slope) = self.basis.sample(place);
        let mixed = |weights: &[f64], values: &[f64; NODES]| -> f64 {
            weights.iter().zip(values).map(|(weight, value)| weight * value).sum()
        };
        let (u, p) = (&self.displacements, &self.forces);
        (mixed(&value, u), mixed(&slope, u), mixed(&value, p), mixed(&slope, p))
    }

    /// ∫ P du over the step, aJ: exact for the polynomials.
    pub fn work(&self) -> f64 {
        let power = |q: usize| {
            let (_, rise, force, _) = self.at(self.basis.points[q]);
            self.basis.weights[q] * force * rise
        };
        (0..NODES - 1).map(power).sum()
    }
}

impl Peel {
    /// The force where the path first has a displacement (nm), nN, by interpolation between solutions around it; nothing where the
    /// path does not go there or was not kept.
    pub fn force_at(&self, displacement: f64) -> Option<f64> {
        let trace = self.trace.as_ref()?;
        let after = trace.points.iter().position(|s| s.observables.displacement >= displacement)?;
        if after == 0 {
            return Some(trace.points[0].observables.force);
        }
        let curve = StepCurve::behind(&trace.problem, &trace.points, after - 1, &mut Workspace::default());
        let is_before = |place: f64| curve.at(place).0 < displacement;
        Some(curve.at(Bracket { low: -1.0, high: 1.0 }.bisected(is_before, |left| left.width() <= SHARP).low).2)
    }
}
