//! The points of a path that have a name: peaks are located limit points, or there are none.

use super::equilibrium_path::followed::Followed;
use super::failure::PathFailure;
use super::plateau::steady_force;
use super::points::{LimitPoint, PathPoint, Peak};
use super::result::{LargestComputedForce, PathEnd, Peel};
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::newton::Solution;
use crate::solve::observables::Observables;
use crate::solve::points::kind::LimitPointKind;
use crate::solve::points::locate::difference_on_more_elements;
use crate::solve::workspace::Workspace;
use crate::study::error_bounds::{DIFFERENCE_BOUND_FACTOR, ROUND_OFF, least};
use std::sync::Arc;

/// A force below this share of its scale is round-off.
const PULL: f64 = 1e-6;

/// Names the points of a path with points and limit points.
pub(super) fn name_special_points(peel: &mut Peel, problem: &BeamProblem, followed: &Followed) {
    let known = steps_known(followed);
    let rises = |at: &LimitPoint, of: fn(&Solution) -> f64| of(&followed.points[at.after]) > 0.0;
    let located: Vec<LimitPoint> = peel.limit_points.iter().filter(|at| at.after < known).copied().collect();
    let maximum = |at: &&LimitPoint| at.kind == LimitPointKind::Load && rises(at, |s| s.slope.force) && at.force > 0.0;
    let turns_back = |at: &&LimitPoint| at.kind == LimitPointKind::Displacement && rises(at, |s| s.slope.displacement);
    let first_maximum = located.iter().filter(maximum).find(|at| stands_out(&peel.points, at, peel.asked)).copied();
    peel.initiation_peak = first_maximum.as_ref().map(peak_of);
    let first_jump = located.iter().position(|at| turns_back(&at));
    peel.snap_off = first_jump.map(|index| located[index]);
    let before = &located[..first_jump.map_or(located.len(), |index| index + 1)];
    // where a path failed before it jumped, the force may go further up; beyond a section that stands upright the model has no force
    let ended = matches!(followed.trouble, None | Some(PathFailure::NearUpright(_)));
    let whole = peel.snap_off.is_some() || (ended && followed.late().is_none());
    let steps = peel.snap_off.map_or(peel.points.len(), |at| at.after + 1);
    let computed = largest(&peel.points[..steps.min(peel.points.len())]);
    peel.peak = if whole { highest(before, computed, peel.asked) } else { None };
    let pulls = |at: &LargestComputedForce| at.force > PULL * problem.measure.force;
    // rest alone is no curve
    peel.largest_computed_force = computed.filter(pulls).filter(|_| peel.peak.is_none() && peel.points.len() > 1);
    let last = followed.points.len().saturating_sub(2);
    let snap = peel.snap_off.map_or(last, |at| at.after);
    let before_jump = first_maximum.map(|first| first.after + 1..snap);
    peel.plateau = steady_force(problem, followed, before_jump, known.min(last), peel.asked);
}

/// Whether the force rises to a maximum, and falls behind it, by more than its error and than was asked: where it does not, as beside the beginning of
/// a path that begins with a level force, another mesh may have the maximum somewhere else or have none.
fn stands_out(points: &[PathPoint], maximum: &LimitPoint, asked: f64) -> bool {
    let known = maximum.force_error + asked * maximum.force;
    let (before, behind) = points.split_at(points.len().min(maximum.after + 1));
    let differs = |point: &&PathPoint| (point.force - maximum.force).abs() > known;
    let is_below = |point: &PathPoint| point.force < maximum.force;
    let rises = before.iter().rev().find(differs).is_some_and(is_below);
    // what the force does beyond the end of a path is not known
    rises && behind.iter().find(differs).is_none_or(is_below)
}

/// How many steps of a path are behind one another: beyond one on which a limit point is missing, or on which it may have gone to another
/// part of itself, a limit point is not the first of anything.
fn steps_known(followed: &Followed) -> usize {
    followed.trouble.as_ref().and_then(PathFailure::after).unwrap_or(followed.points.len())
}

/// The located point with the largest force, where the computed curve goes no higher than that is known: else the largest force is
/// somewhere else, at an end of the curve or where nothing was located.
fn highest(located: &[LimitPoint], computed: Option<LargestComputedForce>, asked: f64) -> Option<Peak> {
    let highest = located.iter().max_by(|a, b| a.force.total_cmp(&b.force)).filter(|at| at.force > 0.0)?;
    let above = computed.map_or(0.0, |computed| computed.force - highest.force);
    // turns between which the force changes by less than was asked are left out
    let known = highest.force_error + asked * highest.force;
    (above <= known).then(|| Peak { force_error: highest.force_error.max(above), ..peak_of(highest) })
}

/// The point with the largest force.
fn largest(points: &[PathPoint]) -> Option<LargestComputedForce> {
    let at = points.iter().max_by(|a, b| a.force.total_cmp(&b.force))?;
    Some(LargestComputedForce { displacement: at.displacement, force: at.force })
}

/// A limit point as a peak.
pub(super) fn peak_of(at: &LimitPoint) -> Peak {
    Peak {
        displacement: at.displacement,
        force: at.force,
        end_rotation: at.end_rotation,
        force_error: at.force_error,
        displacement_error: at.displacement_error,
    }
}

/// Whether a path that ended because its force was not above zero never came back to zero: it jumps where the grip pushes, and goes on
/// there.
pub(super) fn pushes_behind_a_fold(problem: &BeamProblem, followed: &Followed) -> bool {
    let pushes = |point: &Arc<Solution>| point.observables.force < 0.0;
    problem.grip.gear != 0.0
        && followed.end == PathEnd::Pivoting
        && !followed.upright
        && followed.points.iter().rev().take(2).all(pushes)
}

impl Peel {
    /// The largest force of the path up to its first displacement limit point, nN: that of the peak, or where there is none of the computed
    /// curve.
    pub fn largest_force_before_jump(&self) -> Option<f64> {
        self.peak.map(|peak| peak.force).or_else(|| self.largest_computed_force.map(|largest| largest.force))
    }
}

/// What more elements change of the force where a path begins, at that displacement: where it is the largest, and behind steps in space. A mesh has to
/// show that force too.
pub(super) fn difference_at_start<'p>(
    peel: &Peel,
    problem: &BeamProblem,
    points: &'p [Arc<Solution>],
) -> Option<(&'p Solution, Observables)> {
    let first = points.first().filter(|first| is_largest(peel, first) || begins_turned(peel))?;
    let difference = difference_on_more_elements(problem, first, &mut Workspace::default()).ok()?;
    Some((first, difference))
}

/// Bound on the relative error of that force, in space behind steps over the peak: 0 where there is none to compare it with.
pub(super) fn error_at_start(peel: &Peel, problem: &BeamProblem, first: &Solution, difference: &Observables) -> f64 {
    let force = match peel.peak {
        _ if is_largest(peel, first) => first.observables.force,
        Some(peak) => peak.force,
        None => return 0.0,
    };
    (DIFFERENCE_BOUND_FACTOR * difference.force.abs() + ROUND_OFF * force.max(problem.measure.force)) / force
        + least(peel.asked)
}

/// Whether the force where a path begins is the largest that was computed.
fn is_largest(peel: &Peel, first: &Solution) -> bool {
    let here = first.observables.displacement;
    peel.largest_computed_force.is_some_and(|at| at.displacement == here && at.force > 0.0)
}

/// Whether the pull begins behind steps in space, which turn the strip about where it is fixed.
fn begins_turned(peel: &Peel) -> bool {
    peel.model.space.is_some() && !peel.model.steps.is_empty()
}

impl Peel {
    /// Behind steps in space displacements count from where the grip was let go, and that is known as well as its force is: the bounds of all places
    /// hold that too.
    pub(super) fn allow_for_start(&mut self, first: &Solution, difference: &Observables) {
        let off = DIFFERENCE_BOUND_FACTOR * (difference.force * first.slope.displacement / first.slope.force).abs();
        if begins_turned(self) && off.is_finite() {
            self.limit_points.iter_mut().for_each(|point| point.displacement_error += off);
            self.tell_bounds();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A load limit point with this force between the first two of points with these forces, and whether it is a maximum that stands out.
    fn stands(forces: &[f64], maximum: f64, force_error: f64) -> bool {
        let point = |(k, &force): (usize, &f64)| PathPoint {
            displacement: k as f64,
            force,
            end_rotation: 0.0,
            work: 0.0,
            negative_eigenvalues: 0,
            negative_eigenvalues_load: 0,
            front: 0.0,
            iterations: 0,
            in_space: None,
        };
        let points: Vec<PathPoint> = forces.iter().enumerate().map(point).collect();
        let at = LimitPoint {
            kind: LimitPointKind::Load,
            displacement: 0.5,
            force: maximum,
            end_rotation: 0.0,
            work: 0.0,
            displacement_error: 0.0,
            force_error,
            work_error: None,
            flat: false,
            after: 0,
            in_space: None,
        };
        stands_out(&points, &at, 1e-6)
    }

    /// The spatula of which one accuracy in five had its first maximum, 3.844904 nN ± 4e-6, on the level force with which its path begins.
    #[test]
    fn a_maximum_within_its_error_of_a_level_force_is_none() {
        assert!(!stands(&[3.844902, 3.844903, 3.844901, 3.83], 3.844904, 4e-6));
        // it rises from below its error and falls behind it
        assert!(stands(&[3.80, 3.844903, 3.83], 3.844904, 4e-6));
        assert!(!stands(&[3.80, 3.844903, 3.85], 3.844904, 4e-6));
        // what comes behind the end of a path is not known
        assert!(stands(&[3.80, 3.844903], 3.844904, 4e-6));
    }
}
