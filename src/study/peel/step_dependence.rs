//! Which limit points a path has whatever its steps are, where its material points remember how they have slid.
//!
//! On a stretch of constant force such a path has maxima and minima that the steps and the mesh make. They come in pairs between which the force hardly
//! changes. Two paths with other steps have the same limit points where those that are left of both are the same once the weakest pairs are
//! left out, and they have the same ones up to a place where that holds as far as there.

use super::equilibrium_path::path_end::Followed;
use super::result::Peel;
use super::solution_history::{LimitPoint, PathPoint};
use crate::beam::element::basis::Basis;
use crate::solve::newton::Solution;
use crate::solve::path::predictor::lagrange_weights;
use crate::solve::path::segment::PathSegment;
use crate::solve::points::locate::{Located, ROUGH, step_to};
use crate::solve::points::search::LimitPointKind;
use crate::solve::problem::Problem;
use crate::solve::state::Observables;
use crate::solve::workspace::Workspace;
use crate::study::asked::error_bounds::{DIFFERENCE_BOUND_FACTOR, STRIDE_BOUND_FACTOR};
use std::sync::Arc;

/// Pairs between which the force changes by more than this share of itself are no ripple of the steps.
const MOST_RIPPLE: f64 = 1e-3;
/// Limit points whose forces, or whose displacements at a jump, differ by more than this share are not the same.
const SAME: f64 = 1e-2;

/// A limit point, as far as it is compared.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Mark {
    kind: LimitPointKind,
    displacement: f64,
    force: f64,
}

impl Mark {
    fn of(point: &LimitPoint) -> Self {
        Self { kind: point.kind, displacement: point.displacement, force: point.force }
    }

    fn located((kind, _, located): &(LimitPointKind, usize, Located)) -> Self {
        let at = &located.observables;
        Self { kind: *kind, displacement: at.displacement, force: at.force }
    }

    fn is(&self, other: &Self) -> bool {
        let near = |one: f64, other: f64| (one - other).abs() <= SAME * one.abs();
        self.kind == other.kind
            && near(self.force, other.force)
            && (self.kind == LimitPointKind::Load || near(self.displacement, other.displacement))
    }
}

/// What two paths have in common.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Common {
    /// Which limit points are left of either.
    kept: [Vec<usize>; 2],
    /// How many of these, from the first on, are the same.
    same: usize,
}

/// Which of these limit points are left once neighbouring load limit points between which the force changes by less than `ripple` of itself are left
/// out, the weakest pair first; and the weakest change that is left. The first ones, `stay` of them, are kept: the initiation peak is, but a
/// film that yields may come to its steady force from below.
fn without_ripple(marks: &[Mark], ripple: f64, stay: usize) -> (Vec<usize>, f64) {
    let mut kept: Vec<usize> = (0..marks.len()).collect();
    loop {
        let pairs = (stay..kept.len().saturating_sub(1)).map(|at| {
            let [one, two] = [marks[kept[at]], marks[kept[at + 1]]];
            let loads = [one, two].iter().all(|mark| mark.kind == LimitPointKind::Load);
            (at, if loads { ((two.force - one.force) / one.force).abs() } else { f64::INFINITY })
        });
        match pairs.min_by(|a, b| a.1.total_cmp(&b.1)) {
            Some((at, change)) if change < ripple => drop(kept.drain(at..at + 2)),
            weakest => return (kept, weakest.map_or(f64::INFINITY, |weakest| weakest.1)),
        }
    }
}

/// What two lists of limit points have in common, with as little left out of them as can be beyond what changes the force by less than the share `least`.
fn common(lists: [&[Mark]; 2], least: f64) -> Common {
    let (mut ripple, stay) = (least, usize::from(least == 0.0));
    loop {
        let [one, other] = lists.map(|marks| without_ripple(marks, ripple, stay));
        let pairs = one.0.iter().zip(&other.0);
        let same = pairs.take_while(|(a, b)| lists[0][**a].is(&lists[1][**b])).count();
        let agree = same == one.0.len() && same == other.0.len();
        let weakest = one.1.min(other.1);
        if agree || weakest >= MOST_RIPPLE {
            return Common { kept: [one.0, other.0], same };
        }
        // just above what is left
        ripple = weakest * (1.0 + f64::EPSILON) + f64::MIN_POSITIVE;
    }
}

impl Common {
    /// Of the limit points of a path and of one with shorter steps. Where a path ends counts with them: a force that turned last by less than ripple
    /// has not turned.
    pub(super) fn of(longer: &Peel, shorter: &Followed, least: f64) -> Self {
        let end = |displacement, force| Mark { kind: LimitPointKind::Load, displacement, force };
        let at_end = longer.points.last().map(|at| end(at.displacement, at.force));
        let of_longer: Vec<Mark> = longer.limit_points.iter().map(Mark::of).chain(at_end).collect();
        let at_end = shorter.points.last().map(|at| end(at.observables.displacement, at.observables.force));
        let of_shorter: Vec<Mark> = shorter.turns.iter().map(Mark::located).chain(at_end).collect();
        let mut found = common([&of_longer, &of_shorter], least);
        for (kept, turns) in found.kept.iter_mut().zip([longer.limit_points.len(), shorter.turns.len()]) {
            kept.retain(|&index| index < turns);
            found.same = found.same.min(kept.len());
        }
        found
    }

    /// Those that both have, of the path with longer steps.
    pub(super) fn of_longer(&self, limit_points: &[LimitPoint]) -> Vec<LimitPoint> {
        self.kept[0][..self.same].iter().map(|&index| limit_points[index]).collect()
    }

    /// How many limit points are left of the path with shorter steps and of that with longer ones, where not all of these are the same.
    pub(super) fn differ(&self) -> Option<(usize, usize)> {
        let [longer, shorter] = [0, 1].map(|path| self.kept[path].len());
        (longer.max(shorter) > self.same).then_some((shorter, longer))
    }

    /// Leaves the path with shorter steps with those limit points that both have.
    pub(super) fn leave(&self, shorter: &mut Followed) {
        shorter.keep_turns(&self.kept[1][..self.same]);
    }
}

impl Peel {
    /// Bounds the steady force by what longer steps made of it at its displacement, and by no less than the accuracy asked for. The place is where the
    /// force is that within the bound.
    pub(super) fn bound_plateau_by(&mut self, longer: &Self) {
        let Some(plateau) = &mut self.plateau else { return };
        let curve = longer.points.windows(2).filter(|pair| {
            let [a, b] = [pair[0].displacement, pair[1].displacement];
            (a - plateau.displacement) * (b - plateau.displacement) <= 0.0
        });
        let at = |pair: &[PathPoint]| {
            let [a, b] = [&pair[0], &pair[1]];
            let share = (plateau.displacement - a.displacement) / (b.displacement - a.displacement);
            a.force + share * (b.force - a.force)
        };
        let changes = curve.map(|pair| (at(pair) - plateau.force).abs());
        let Some(change) = changes.filter(|change| change.is_finite()).min_by(f64::total_cmp) else { return };
        let bound = (STRIDE_BOUND_FACTOR * change).max(self.asked * plateau.force);
        let beside = |point: &&PathPoint| (point.force - plateau.force).abs() <= bound;
        let (before, behind) = self.points.split_at((plateau.after + 1).min(self.points.len()));
        let near = before.iter().rev().take_while(beside).chain(behind.iter().take_while(beside));
        let away = near.map(|point| (point.displacement - plateau.displacement).abs()).fold(0.0, f64::max);
        (plateau.force_error, plateau.displacement_error) = (Some(bound), Some(away));
    }
}

impl Followed {
    /// Leaves out the load limit points behind the first that are not known better than the force changes between them.
    pub(super) fn leave_out_unresolved(&mut self) {
        let weak = |pair: &[(LimitPointKind, usize, Located)]| {
            let [one, two] = [&pair[0], &pair[1]];
            let change = (two.2.observables.force - one.2.observables.force).abs();
            let unsure = one.2.difference.force.abs() + two.2.difference.force.abs();
            one.0 == LimitPointKind::Load && two.0 == LimitPointKind::Load && change < DIFFERENCE_BOUND_FACTOR * unsure
        };
        while let Some(at) = (1..self.turns.len().saturating_sub(1)).find(|&at| weak(&self.turns[at..at + 2])) {
            let kept: Vec<usize> = (0..self.turns.len()).filter(|&index| index != at && index != at + 1).collect();
            self.keep_turns(&kept);
        }
    }

    /// Keeps these limit points alone. What is left on the level of one that is left out is known no better than that differs from it.
    fn keep_turns(&mut self, kept: &[usize]) {
        let all = std::mem::take(&mut self.turns);
        let left_out: Vec<f64> = (0..all.len())
            .filter(|index| !kept.contains(index) && all[*index].0 == LimitPointKind::Load)
            .map(|index| all[index].2.observables.force)
            .collect();
        self.ripple += all.len() - kept.len();
        self.turns = kept.iter().map(|&index| all[index].clone()).collect();
        for (kind, _, located) in &mut self.turns {
            let force = located.observables.force;
            let beside = left_out.iter().map(|other| (other - force).abs());
            let beside = beside.filter(|away| *kind == LimitPointKind::Load && *away < MOST_RIPPLE * force.abs());
            located.left_out = beside.fold(located.left_out, f64::max);
        }
    }
}

// -- Displacement and force inside one step of a path, from solutions there --
//
// Slopes of the path belong to the mesh of a point; between points whose meshes differ they are good to few digits. Here
// only values count: u and P are polynomials through solutions at Gauss-Lobatto labels.

/// Solutions on a step, its ends among them.
const NODES: usize = 7;
/// Most times a step is halved.
const MOST_HALVINGS: usize = 5;
/// A middle that is missed by this share of what changes on the step is missed in earnest.
const ROUGHLY: f64 = 1e-3;
/// Work that counts, over the adhesion of the whole beam.
const COUNTS: f64 = 1e-8;

/// u (nm) and P (nN) on a step, as polynomials of a local coordinate on [-1, 1].
pub(in crate::study) struct StepCurve {
    basis: Basis,
    displacements: [f64; NODES],
    forces: [f64; NODES],
}

impl StepCurve {
    /// The step behind `points[index]`; by what the path has by itself where its points are as close as its curvature asks for.
    pub(crate) fn behind(problem: &Problem, points: &[Arc<Solution>], index: usize, ws: &mut Workspace) -> Self {
        let segment = PathSegment::around(problem, points, index);
        if problem.system.step_dependence().is_yielding() {
            return Self::interpolated(&segment, segment.end(), &points[index + 1]);
        }
        Self::until(problem, &segment, segment.end(), &points[index + 1], ws)
    }

    /// From the first point of a segment to a solution at the label `to` of it.
    pub(crate) fn until(problem: &Problem, segment: &PathSegment, to: f64, end: &Solution, ws: &mut Workspace) -> Self {
        Self::between(problem, &mut segment.clone(), [(0.0, &segment.first()), (to, end)], ws)
    }

    /// The same in pieces, halved where one curve would not be certain of its work, by a scale of works, aJ.
    pub(crate) fn pieces(
        (problem, scale): (&Problem, f64),
        segment: &PathSegment,
        to: f64,
        end: &Solution,
        ws: &mut Workspace,
    ) -> Vec<Self> {
        let mut known = segment.clone();
        Self::halved((problem, scale), &mut known, [(0.0, &segment.first()), (to, end)], MOST_HALVINGS, ws)
    }

    fn halved(
        (problem, scale): (&Problem, f64),
        known: &mut PathSegment,
        [from, to]: [(f64, &Solution); 2],
        halvings: usize,
        ws: &mut Workspace,
    ) -> Vec<Self> {
        let curve = Self::between(problem, known, [from, to], ws);
        if halvings == 0 || !curve.is_uncertain(scale) {
            return vec![curve];
        }
        let label = 0.5 * (from.0 + to.0);
        let Ok(middle) = step_to(problem, known, from.0, label, ROUGH, ws) else { return vec![curve] };
        let mut pieces = Self::halved((problem, scale), known, [from, (label, &middle)], halvings - 1, ws);
        pieces.extend(Self::halved((problem, scale), known, [(label, &middle), to], halvings - 1, ws));
        pieces
    }

    /// Between two solutions at labels of a segment, which takes in those that are found between them: where the force has a corner, each half
    /// of a step begins from them. Where one cannot be found, the interpolants stand in that the segment has by itself.
    fn between(
        problem: &Problem,
        known: &mut PathSegment,
        [(from, start), (to, end)]: [(f64, &Solution); 2],
        ws: &mut Workspace,
    ) -> Self {
        let mut curve = Self::through(known, [(from, start), (to, end)]);
        let (places, mut last) = (curve.basis.nodes, from);
        for (k, place) in places.into_iter().enumerate().take(NODES - 2) {
            let label = from + 0.5 * (1.0 + place) * (to - from);
            if let Ok(solution) = step_to(problem, known, last, label, ROUGH, ws) {
                let Observables { displacement, force, .. } = solution.observables;
                (curve.displacements[k], curve.forces[k]) = (displacement, force);
            }
            last = label;
        }
        curve
    }

    /// From the first point of a segment to a solution at the label `to` of it, without a solve.
    pub(crate) fn interpolated(segment: &PathSegment, to: f64, end: &Solution) -> Self {
        Self::through(segment, [(0.0, &segment.first()), (to, end)])
    }

    /// Between two solutions at labels of a segment, by the interpolants that it has by itself.
    fn through(segment: &PathSegment, [(from, start), (to, end)]: [(f64, &Solution); 2]) -> Self {
        let basis = Basis::new(NODES - 1);
        let (left, right) = (NODES - 2, NODES - 1);
        let of = |o: &Observables| (o.displacement, o.force);
        let middle = 0.5 * (from + to);
        let [displacement, force] = [|o: &Observables| o.displacement, |o: &Observables| o.force]
            .map(|pick: fn(&Observables) -> f64| segment.observable(pick, middle));
        let mut at = [(0.0, 0.0); NODES];
        for (at, node) in at[..left].iter_mut().zip(basis.nodes) {
            let label = from + 0.5 * (1.0 + node) * (to - from);
            *at = (displacement.at(label).0, force.at(label).0);
        }
        (at[left], at[right]) = (of(&start.observables), of(&end.observables));
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
    pub(crate) fn at(&self, place: f64) -> (f64, f64, f64, f64) {
        let (value, slope) = self.basis.sample(place);
        let mixed = |weights: &[f64], values: &[f64; NODES]| -> f64 {
            weights.iter().zip(values).map(|(weight, value)| weight * value).sum()
        };
        let (u, p) = (&self.displacements, &self.forces);
        (mixed(&value, u), mixed(&slope, u), mixed(&value, p), mixed(&slope, p))
    }

    /// ∫ P du over the step, aJ: exact for the polynomials.
    pub(crate) fn work(&self) -> f64 {
        let power = |q: usize| {
            let (_, rise, force, _) = self.at(self.basis.points[q]);
            self.basis.weights[q] * force * rise
        };
        (0..NODES - 1).map(power).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use LimitPointKind::{Displacement, Load};

    fn marks(points: &[(LimitPointKind, f64, f64)]) -> Vec<Mark> {
        points.iter().map(|&(kind, displacement, force)| Mark { kind, displacement, force }).collect()
    }

    /// Ripple on a level force that one path has and the other has not, or has elsewhere, is no difference between them.
    #[test]
    fn ripple_is_no_difference() {
        let plain = marks(&[(Load, 0.4, 0.58), (Displacement, 141.5, 0.107)]);
        let level = [
            (Load, 62.0, 0.129_077_0),
            (Load, 64.0, 0.129_076_6),
            (Load, 70.0, 0.129_076_8),
            (Load, 71.0, 0.129_076_1),
        ];
        let rippled = marks(&[&[(Load, 0.4, 0.58)], &level[..], &[(Displacement, 141.6, 0.107)]].concat());
        let found = common([&plain, &rippled], 0.0);
        assert_eq!(found, Common { kept: [vec![0, 1], vec![0, 5]], same: 2 });
        assert_eq!(found.differ(), None);
        // where both have the same, nothing is left out
        assert_eq!(common([&rippled, &rippled], 0.0).kept, [(0..6).collect::<Vec<_>>(), (0..6).collect()]);
    }

    /// Where two paths have other limit points behind some place, those before it are common to both.
    #[test]
    fn what_lies_before_a_difference_is_common() {
        let one = marks(&[(Load, 0.4, 0.58), (Load, 3.0, 0.2), (Load, 9.0, 0.4), (Displacement, 12.0, 0.3)]);
        let other = marks(&[(Load, 0.4, 0.58), (Displacement, 2.0, 0.25)]);
        let found = common([&one, &other], 0.0);
        assert_eq!((found.same, found.differ()), (1, Some((2, 4))));
    }
}
