//! What is reported of a path that was followed: its numbers and their error bounds.

use super::equilibrium_path::followed::Followed;
use super::failure::Failure;
use super::points::{BranchPoint, LimitPoint, PathPoint, Peak};
use super::result::{Effort, PathEnd, Peel};
use super::special_points::{name_special_points, peak_of, pushes_behind_a_fold};
use super::work::{WorkErrors, work_at, work_near};
use crate::beam::planar::planar_beam::FRONT;
use crate::model::peel::PeelModel;
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::newton::Solution;
use crate::solve::points::kind::LimitPointKind;
use crate::solve::points::locate::Located;
use crate::study::accuracy::Accuracy;
use crate::study::error_bounds::{
    BENDING_ROUND_OFF, DIFFERENCE_BOUND_FACTOR, ROUND_OFF, ROUND_OFF_HELD, ROUND_OFF_PLACE, STRAIN_ROUND_OFF,
    bound_floor, counts,
};
use std::sync::Arc;

/// A slope of the force below this share of a later one, before a maximum, is that of another maximum.
const OVERLOOKED: f64 = 0.1;

/// How well what is reported is known, relative: twice the differences to more elements. Where the material points remember, of the turns of the force
/// alone: at one of the displacement much of the beam that slid sticks at once, a corner of the path, of which bounds tell how well it
/// is known. A difference of a force by no more than the `round_off`, nN, is none.
pub(super) fn differences(followed: &Followed, problem: &BeamProblem, round_off: f64) -> Vec<f64> {
    let first_load = followed.turns.iter().position(|t| t.0 == LimitPointKind::Load);
    let told = followed.turns.iter().enumerate().filter(|(_, turn)| counts(problem, turn.0));
    let turns = told.flat_map(|(i, (_, _, located))| {
        let (o, d) = (&located.observables, &located.difference);
        let anywhere = located.flat && (followed.level || Some(i) != first_load);
        let place = if anywhere { 0.0 } else { (d.displacement / o.displacement).abs() };
        let force = if d.force.abs() <= round_off { 0.0 } else { (d.force / o.force).abs() };
        [DIFFERENCE_BOUND_FACTOR * place, DIFFERENCE_BOUND_FACTOR * force]
    });
    turns.collect()
}

/// Round-off of the forces of a path, nN.
pub(super) fn force_round_off(model: &PeelModel, problem: &BeamProblem, followed: &Followed) -> f64 {
    let largest = followed.points.iter().map(|s| s.observables.force.abs()).fold(0.0, f64::max);
    let elements = followed.points.first().map_or(0, |point| point.at.mesh.elements());
    let is_held = problem.beam.planar().is_some_and(|beam| beam.chain.has_border());
    let relative = if is_held { ROUND_OFF_HELD * elements as f64 } else { ROUND_OFF };
    relative * largest + strain_round_off(model)
}

/// Strains are known to the machine's epsilon, and a stiff beam makes large forces of them, nN.
fn strain_round_off(model: &PeelModel) -> f64 {
    let section = model.section();
    STRAIN_ROUND_OFF * f64::EPSILON * section.axial.max(section.shear)
}

/// What is reported of a path.
pub(super) fn report(model: &PeelModel, problem: &BeamProblem, followed: &Followed, relative: f64) -> Peel {
    let mut ws = followed.workspace();
    let (strained, round_off) = (strain_round_off(model), force_round_off(model, problem, followed));
    let bent = BENDING_ROUND_OFF * f64::EPSILON * model.section().bending / model.line_law().gap_scale().powi(2);
    let points = followed.points.iter().map(|s| PathPoint {
        displacement: s.observables.displacement,
        force: s.observables.force,
        end_rotation: s.observables.recorded,
        work: work_at(problem, &followed.points[0], s),
        negative_eigenvalues: s.negative,
        negative_eigenvalues_load: s.negative_load,
        front: problem.beam.front_place(s.observables.monitors[FRONT]),
        iterations: s.iterations,
        in_space: problem.spatial_grip(&s.at),
    });
    let force_error = |turn: LimitPointKind, located: &Located| {
        let left_out = if turn == LimitPointKind::Load { located.left_out } else { 0.0 };
        let floor = round_off + bound_floor(located, relative) * located.observables.force.abs();
        DIFFERENCE_BOUND_FACTOR * located.difference.force.abs() + floor + left_out
    };
    let first = followed.points.first().filter(|_| !followed.turns.is_empty());
    let work_errors = first.map(|first| WorkErrors::new(problem, first, relative, &mut ws));
    let first_load = followed.turns.iter().position(|turn| turn.0 == LimitPointKind::Load);
    let limit_points: Vec<LimitPoint> = followed
        .turns
        .iter()
        .enumerate()
        .map(|(index, (kind, after, located))| {
            let overlooked = if Some(index) == first_load {
                overlooked_before(&followed.points[..=*after], located, relative)
            } else {
                None
            };
            let displacement_error = place_error(located, relative, *kind, [strained, bent]).max(level(
                &followed.points,
                *after,
                located,
                force_error(*kind, located),
            ));
            let [further, lower] = overlooked.unwrap_or_default();
            LimitPoint {
                kind: *kind,
                displacement: located.observables.displacement,
                force: located.observables.force,
                end_rotation: located.observables.recorded,
                work: work_near(problem, &followed.points[0], located),
                displacement_error: displacement_error.max(further),
                force_error: force_error(*kind, located).max(lower),
                work_error: work_errors
                    .as_ref()
                    .and_then(|errors| errors.at(located, *kind, displacement_error, &mut ws)),
                flat: located.flat || overlooked.is_some(),
                after: *after,
                in_space: problem.spatial_grip(&located.solution.at),
            }
        })
        .collect();
    let end = if pushes_behind_a_fold(problem, followed) { PathEnd::Pushing } else { followed.end.clone() };
    let branch_points = branch_points(followed, relative);
    let mut peel = Peel { points: points.collect(), end, limit_points, branch_points, asked: relative, ..empty(model) };
    name_special_points(&mut peel, problem, followed);
    peel.find_detachment(problem, followed);
    peel
}

fn branch_points(followed: &Followed, relative: f64) -> Vec<BranchPoint> {
    let located = |(after, located): &(usize, Located)| {
        let (at, difference) = (&located.observables, &located.difference);
        let [before, behind] = [*after, after + 1].map(|index| followed.points[index].negative);
        let bound = |value: f64, difference: f64| {
            DIFFERENCE_BOUND_FACTOR * difference.abs() + bound_floor(located, relative) * value.abs()
        };
        BranchPoint {
            displacement: at.displacement,
            force: at.force,
            displacement_error: bound(at.displacement, difference.displacement),
            force_error: bound(at.force, difference.force),
            negative_eigenvalues: [before, behind],
            after: *after,
        }
    };
    followed.branch_points.iter().map(located).collect()
}

/// Bound on the error of a located point's displacement, nm.
fn place_error(located: &Located, relative: f64, turn: LimitPointKind, [strained, bent]: [f64; 2]) -> f64 {
    let o = &located.observables;
    let (round_off, stiff) = match turn {
        LimitPointKind::Load => (ROUND_OFF_PLACE, strained + bent),
        LimitPointKind::Displacement => (ROUND_OFF, strained),
    };
    let stiff = stiff / o.force.abs().max(stiff).max(f64::MIN_POSITIVE);
    let left_out = if turn == LimitPointKind::Displacement { located.left_out } else { 0.0 };
    DIFFERENCE_BOUND_FACTOR * located.difference.displacement.abs()
        + left_out
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

/// How far before the first maximum of the force (nm), and by how much below it (nN), an earlier one may be that was overlooked or left out:
/// as far as the force differs by less than `relative`, if its slope does not fall all the way from there, as it does before a single maximum.
/// `points` end with the one before the maximum.
fn overlooked_before(points: &[Arc<Solution>], maximum: &Located, relative: f64) -> Option<[f64; 2]> {
    let top = &maximum.observables;
    let near = |point: &&Arc<Solution>| (point.observables.force - top.force).abs() < relative * top.force.abs();
    let slope = |point: &Arc<Solution>| point.slope.force / point.slope.displacement;
    let level: Vec<&Arc<Solution>> = points.iter().rev().take_while(near).collect();
    let steepest = level.iter().scan(0.0f64, |steepest, point| {
        let behind = *steepest;
        *steepest = steepest.max(slope(point));
        Some(behind)
    });
    let rises_again = level.iter().zip(steepest).any(|(point, steepest)| slope(point) < OVERLOOKED * steepest);
    let first = level.last().filter(|_| rises_again)?.observables;
    Some([(top.displacement - first.displacement).abs(), (top.force - first.force).abs()])
}

impl Peel {
    /// The largest relative error bound of the forces and displacements of the limit points; `None` where there are none. A limit point around which the force is flat counts with its force alone.
    pub fn reached_accuracy(&self) -> Option<f64> {
        // zero has no relative error
        let relative = |error: f64, value: f64| if value == 0.0 { 0.0 } else { (error / value).abs() };
        let turns = self.limit_points.iter().flat_map(|at| {
            let place = if at.flat { 0.0 } else { relative(at.displacement_error, at.displacement) };
            [place, relative(at.force_error, at.force)]
        });
        turns.reduce(f64::max)
    }

    /// Gives the special points the bounds that their limit points have.
    pub(in crate::study) fn tell_bounds(&mut self) {
        let Self { limit_points, initiation_peak, peak, snap_off, pad_detachment, detachment, .. } = self;
        for point in limit_points.iter() {
            for peak in [&mut *initiation_peak, &mut *peak].into_iter().flatten() {
                if peak.displacement == point.displacement {
                    *peak = Peak { force_error: peak.force_error.max(point.force_error), ..peak_of(point) };
                }
            }
            for fold in [&mut *snap_off, &mut *pad_detachment, &mut *detachment].into_iter().flatten() {
                if fold.displacement == point.displacement {
                    *fold = *point;
                }
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
        branch_points: Vec::new(),
        initiation_peak: None,
        peak: None,
        largest_computed_force: None,
        plateau: None,
        snap_off: None,
        pad_detachment: None,
        detachment: None,
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
