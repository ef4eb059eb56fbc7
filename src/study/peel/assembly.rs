//! What is reported of a path that was followed: its numbers and their error bounds.

use super::equilibrium_path::Followed;
use super::plateau::plateau;
use super::work::{work_near, works};
use super::{Effort, Failure, LimitPoint, PathEnd, PathPoint, Peak, Peel};
use crate::beam::FRONT;
use crate::model::{PeelModel, PlanarProblem};
use crate::solve::{LimitPointKind, Located, Solution, Workspace, difference_on_more_elements};
use crate::study::Accuracy;
use crate::study::error_bounds::*;
use std::sync::Arc;

/// A force at rest below this share of its scale is round-off.
const PULL: f64 = 1e-6;

/// The relative differences to more elements of what is reported. Where the material points remember, of the turns of the force
/// alone: at one of the displacement much of the beam that slid sticks at once, a corner of the path, of which bounds tell how well it
/// is known.
pub(super) fn differences(followed: &Followed, problem: &PlanarProblem) -> Vec<f64> {
    let first_load = followed.turns.iter().position(|t| t.0 == LimitPointKind::Load);
    let told = followed.turns.iter().enumerate().filter(|(_, turn)| counts(problem, turn.0));
    let turns = told.flat_map(|(i, (_, _, located))| {
        let (o, d) = (&located.observables, &located.difference);
        let place = if located.flat && Some(i) != first_load { 0.0 } else { (d.displacement / o.displacement).abs() };
        [place, (d.force / o.force).abs()]
    });
    turns.collect()
}

/// What is reported of a path.
pub(super) fn report(model: &PeelModel, problem: &PlanarProblem, followed: &Followed, relative: f64) -> Peel {
    let mut ws = followed.workspace();
    let works = works(problem, &followed.points, &mut ws);
    let largest = followed.points.iter().map(|s| s.observables.force.abs()).fold(0.0, f64::max);
    let section = model.section();
    // strains are known to the machine's epsilon, and a stiff beam makes large forces of them
    let strained = STRAIN_ROUND_OFF * f64::EPSILON * section.axial.max(section.shear);
    let bent = BENDING_ROUND_OFF * f64::EPSILON * section.bending / model.adhesion.equilibrium_distance.powi(2);
    let force_round_off = if problem.beam.chain.has_border() { ROUND_OFF_HELD } else { ROUND_OFF };
    let points = followed.points.iter().zip(&works).map(|(s, &work)| PathPoint {
        displacement: s.observables.displacement,
        force: s.observables.force,
        end_rotation: s.observables.recorded,
        work,
        negative_eigenvalues: s.negative,
        negative_eigenvalues_load: s.negative_load,
        front: problem.beam.fronts.place(s.observables.monitors[FRONT]),
        iterations: s.iterations,
    });
    let force_error = |located: &Located| {
        let floor =
            force_round_off * largest + strained + bound_floor(located, relative) * located.observables.force.abs();
        DIFFERENCE_BOUND_FACTOR * located.difference.force.abs() + floor
    };
    let limit_points: Vec<LimitPoint> = followed
        .turns
        .iter()
        .map(|(kind, after, located)| LimitPoint {
            kind: *kind,
            displacement: located.observables.displacement,
            force: located.observables.force,
            end_rotation: located.observables.recorded,
            work: work_near(problem, &followed.points, &works, *after, located, &mut ws),
            displacement_error: place_error(located, relative, *kind, [strained, bent]).max(level(
                &followed.points,
                *after,
                located,
                force_error(located),
            )),
            force_error: force_error(located),
            flat: located.flat,
            after: *after,
        })
        .collect();
    let mut peel = Peel { points: points.collect(), end: followed.end.clone(), limit_points, ..empty(model) };
    fill_special_points(&mut peel, problem, followed, relative);
    peel
}

/// Bound on the error of a located point's displacement, nm.
fn place_error(located: &Located, relative: f64, turn: LimitPointKind, [strained, bent]: [f64; 2]) -> f64 {
    let o = &located.observables;
    let (round_off, stiff) = match turn {
        LimitPointKind::Load => (ROUND_OFF_PLACE, strained + bent),
        LimitPointKind::Displacement => (ROUND_OFF, strained),
    };
    let stiff = stiff / o.force.abs().max(stiff).max(f64::MIN_POSITIVE);
    DIFFERENCE_BOUND_FACTOR * located.difference.displacement.abs()
        + (round_off + stiff + bound_floor(located, relative)) * o.displacement.abs()
}

/// How far from a flat turn behind the point `after` the force stays within its error, nm, but no further than rest: no nearer is
/// its place known. From its curvature, and from the points around: on a plateau, all of that.
fn level(points: &[Arc<Solution>], after: usize, located: &Located, force_error: f64) -> f64 {
    if !located.flat {
        return 0.0;
    }
    let turn = &located.observables;
    let is_level = |point: &&Arc<Solution>| (point.observables.force - turn.force).abs() <= force_error;
    let (before, behind) = points.split_at(after + 1);
    let around = before.iter().rev().take_while(is_level).chain(behind.iter().take_while(is_level));
    let away = around.map(|point| (point.observables.displacement - turn.displacement).abs()).fold(0.0, f64::max);
    let curved = (2.0 * force_error / located.force_curvature.abs()).sqrt();
    let curved = if located.force_curvature == 0.0 { 0.0 } else { curved };
    away.max(curved).min(turn.displacement.abs())
}

fn fill_special_points(peel: &mut Peel, problem: &PlanarProblem, followed: &Followed, relative: f64) {
    let maximum =
        |p: &&LimitPoint| p.kind == LimitPointKind::Load && followed.points[p.after].slope.force > 0.0 && p.force > 0.0;
    let turns_back =
        |p: &&LimitPoint| p.kind == LimitPointKind::Displacement && followed.points[p.after].slope.displacement > 0.0;
    let first_maximum = peel.limit_points.iter().find(maximum).copied();
    peel.initiation_peak = first_maximum.as_ref().map(peak_of);
    peel.snap_off = peel.limit_points.iter().find(turns_back).copied();
    let order = |p: &LimitPoint| peel.limit_points.iter().position(|q| q == p).unwrap_or(0);
    let until = peel.snap_off.as_ref().map_or(peel.limit_points.len(), |s| order(s) + 1);
    let at_turns = peel.limit_points[..until].iter().map(peak_of);
    let at_end = match (&peel.snap_off, followed.points.last()) {
        // rest alone is no path
        (None, Some(last)) if followed.points.len() > 1 => peak_at(problem, last, relative),
        _ => None,
    };
    peel.peak = at_turns.chain(at_end).max_by(|a, b| a.force.total_cmp(&b.force));
    // a beam that is curved in its stress-free configuration is pulled where it begins
    let least = peel.peak.map_or(0.0, |peak| peak.force).max(PULL * problem.measure.force);
    if let Some(first) = followed.points.first().filter(|first| first.observables.force > least) {
        peel.peak = peak_at(problem, first, relative).or(peel.peak);
    }
    // a grip that turns may push all the way
    peel.peak = peel.peak.filter(|peak| peak.force > 0.0);
    if let Some(first) = first_maximum {
        let last = followed.points.len().saturating_sub(2);
        let snap = peel.snap_off.map_or(last, |s| s.after);
        peel.plateau = plateau(problem, followed, first.after, snap);
    }
}

fn peak_of(p: &LimitPoint) -> Peak {
    Peak {
        displacement: p.displacement,
        force: p.force,
        end_rotation: p.end_rotation,
        force_error: p.force_error,
        displacement_error: p.displacement_error,
    }
}

/// An end of a path as its peak, with the error of its force at that displacement.
fn peak_at(problem: &PlanarProblem, last: &Arc<Solution>, relative: f64) -> Option<Peak> {
    let difference = difference_on_more_elements(problem, last, &mut Workspace::default()).ok()?;
    let o = last.observables;
    Some(Peak {
        displacement: o.displacement,
        force: o.force,
        end_rotation: o.recorded,
        // a path may end with a force of zero, or come back to u = 0: to the round-off of their scales
        force_error: DIFFERENCE_BOUND_FACTOR * difference.force.abs()
            + ROUND_OFF * o.force.abs().max(problem.measure.force)
            + least(relative) * o.force.abs(),
        displacement_error: ROUND_OFF * o.displacement.abs().max(problem.grip.displacement_scale()),
    })
}

impl Peel {
    /// The largest relative error bound of the forces and displacements of the limit points and the peaks; `None` where there
    /// are none. A limit point around which the force is flat counts with its force alone.
    pub fn reached_accuracy(&self) -> Option<f64> {
        // zero has no relative error
        let relative = |error: f64, value: f64| if value == 0.0 { 0.0 } else { (error / value).abs() };
        let turns = self.limit_points.iter().flat_map(|at| {
            let place = if at.flat { 0.0 } else { relative(at.displacement_error, at.displacement) };
            [place, relative(at.force_error, at.force)]
        });
        let end = self.peak_at_end().into_iter().flat_map(|peak| {
            [relative(peak.displacement_error, peak.displacement), relative(peak.force_error, peak.force)]
        });
        turns.chain(end).reduce(f64::max)
    }

    /// The peak where it is no limit point but an end of the path.
    pub(in crate::study) fn peak_at_end(&self) -> Option<&Peak> {
        let at_turn =
            |peak: &Peak| self.limit_points.iter().any(|at| at.kind == LimitPointKind::Load && at.force == peak.force);
        self.peak.as_ref().filter(|peak| !at_turn(peak))
    }

    /// Gives the special points the bounds that their limit points have.
    pub(in crate::study) fn tell_bounds(&mut self) {
        let Self { limit_points, initiation_peak, peak, snap_off, .. } = self;
        for point in limit_points.iter() {
            for peak in [&mut *initiation_peak, &mut *peak].into_iter().flatten() {
                if peak.displacement == point.displacement {
                    *peak = peak_of(point);
                }
            }
            if snap_off.is_some_and(|snap_off| snap_off.displacement == point.displacement) {
                *snap_off = Some(*point);
            }
        }
    }
}

/// A path of which there is nothing.
pub(in crate::study) fn empty(model: &PeelModel) -> Peel {
    Peel {
        model: model.clone(),
        steps: Vec::new(),
        relaxed_start: None,
        points: Vec::new(),
        limit_points: Vec::new(),
        initiation_peak: None,
        peak: None,
        plateau: None,
        snap_off: None,
        end: PathEnd::Failed(Failure::NothingComputed),
        effort: Effort::default(),
        asked: 0.0,
        choice: Accuracy::to(0.0).choice,
        ripple: 0,
        considered: None,
        unfinished: false,
        trace: None,
    }
}
