//! What is reported of a path that was followed: its numbers and their error bounds.

use super::equilibrium_path::path_end::Followed;
use super::result::{Effort, Failure, PathEnd, Peel};
use super::solution_history::{BranchPoint, LimitPoint, PathPoint, Peak};
use crate::beam::planar::planar_beam::FRONT;
use crate::model::check::error::ModelError;
use crate::model::peel::PeelModel;
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::newton::Solution;
use crate::solve::points::locate::Located;
use crate::solve::points::search::LimitPointKind;
use crate::study::asked::accuracy::Accuracy;
use crate::study::asked::error_bounds::{
    BENDING_ROUND_OFF, DIFFERENCE_BOUND_FACTOR, ROUND_OFF, ROUND_OFF_HELD, ROUND_OFF_PLACE, STRAIN_ROUND_OFF,
    bound_floor, counts,
};
use crate::study::peel::along_path::special_points::{name_special_points, peak_of, pushes_behind_a_fold};
use crate::study::peel::along_path::work::{WorkErrors, work_at, work_near};
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
        step_ways: Vec::new(),
        step_jumps: Vec::new(),
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

// -- What an analysis gives of a model that it refuses --

/// A peel that was not begun.
pub(in crate::study) fn peel(model: &PeelModel, accuracy: &Accuracy, error: &ModelError) -> Peel {
    let (end, asked) = (PathEnd::Failed(failure(error)), accuracy.relative);
    Peel { end, asked, choice: accuracy.choice, ..empty(model) }
}

/// That a model is refused.
pub(in crate::study) fn failure(error: &ModelError) -> Failure {
    Failure::Refused { key: error.key().into(), found: error.found(), remedy: error.remedy() }
}

// -- Bounds of what cannot be known better --

/// With no bound below a share of its number, where there is one.
pub(super) fn widened(mut peel: Peel, accuracy: &Accuracy, least: Option<f64>) -> Peel {
    peel.asked = accuracy.relative;
    // with friction a path depends on its steps: where a maximum lies may change by little from some steps to others by luck
    let of_place = if peel.model.friction.strength.is_some() { Some(accuracy.relative) } else { least };
    let [share, of_place] = [least, of_place].map(|least| least.unwrap_or(0.0));
    // one that is no number stays none
    let widen = |error: &mut f64, least: f64| {
        if *error < least {
            *error = least;
        }
    };
    let Peel { limit_points, initiation_peak, peak, snap_off, pad_detachment, detachment, plateau, .. } = &mut peel;
    for point in limit_points.iter_mut().chain(snap_off).chain(pad_detachment).chain(detachment) {
        widen(&mut point.force_error, share * point.force.abs());
        widen(&mut point.displacement_error, of_place * point.displacement.abs());
        point.work_error.iter_mut().for_each(|error| widen(error, share * point.work.abs()));
    }
    if let Some(plateau) = plateau {
        plateau.force_error.iter_mut().for_each(|error| widen(error, share * plateau.force));
    }
    for peak in initiation_peak.iter_mut().chain(peak) {
        widen(&mut peak.force_error, share * peak.force.abs());
        widen(&mut peak.displacement_error, of_place * peak.displacement.abs());
    }
    peel
}

// -- The limit points of a path that is whole, beside those that it has on another mesh --

/// Limit points that differ by more than this, relative, are not the same, and an error above it is no accuracy, whatever it comes from. It is no
/// measured number: a user can ask for no less (`Accuracy::RELATIVE`), so that a bound below it is one with which somebody could have been content.
pub(super) const NO_ACCURACY: f64 = 1e-2;

/// The limit points of a path that could be used, and its elements.
pub(super) struct Whole {
    pub(super) elements: usize,
    pub(super) limit_points: Vec<LimitPoint>,
}

impl Whole {
    /// Whether these are the same limit points, as far as there is an accuracy. Those around which the force is flat do not count: on a plateau each
    /// mesh has its own.
    pub(super) fn agrees_with(&self, limit_points: &[LimitPoint]) -> bool {
        let found = |these: &[LimitPoint], others: &[LimitPoint]| {
            these.iter().all(|point| point.flat || twin(point, others).is_some())
        };
        let folds = |these: &[LimitPoint]| these.iter().filter(|p| p.kind == LimitPointKind::Displacement).count();
        let same = folds(&self.limit_points) == folds(limit_points);
        same && found(&self.limit_points, limit_points) && found(limit_points, &self.limit_points)
    }

    /// Widens the bounds of the same limit points on another mesh, where these are further away than both bounds together: to twice that distance.
    pub(super) fn widen_unexplained(&self, limit_points: &mut [LimitPoint]) {
        let widened = |[own, other]: [f64; 2], difference: f64| {
            if difference.abs() <= own + other { own } else { DIFFERENCE_BOUND_FACTOR * difference.abs() }
        };
        for point in limit_points {
            let Some(twin) = twin(point, &self.limit_points) else { continue };
            point.force_error = widened([point.force_error, twin.force_error], point.force - twin.force);
            if !point.flat && !twin.flat {
                let apart = point.displacement - twin.displacement;
                point.displacement_error = widened([point.displacement_error, twin.displacement_error], apart);
                let works = [point.work_error, twin.work_error];
                if let [Some(own), Some(other)] = works {
                    point.work_error = Some(widened([own, other], point.work - twin.work));
                }
            }
        }
    }
}

/// The same limit point among others: of its kind, and no further away than there is an accuracy; of several the nearest.
fn twin<'o>(point: &LimitPoint, others: &'o [LimitPoint]) -> Option<&'o LimitPoint> {
    let apart = |other: &LimitPoint| {
        let relative = |one: f64, other: f64| (one - other).abs() / one.abs().max(f64::MIN_POSITIVE);
        let place = if point.flat || other.flat { 0.0 } else { relative(point.displacement, other.displacement) };
        relative(point.force, other.force).max(place)
    };
    let near = others.iter().filter(|other| other.kind == point.kind).map(|other| (apart(other), other));
    near.filter(|near| near.0 <= NO_ACCURACY).min_by(|a, b| a.0.total_cmp(&b.0)).map(|near| near.1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Range;
    use crate::study::Accuracy;

    fn turn(kind: LimitPointKind, displacement: f64, force: f64, flat: bool) -> LimitPoint {
        LimitPoint {
            kind,
            displacement,
            force,
            end_rotation: 0.0,
            work: 0.0,
            displacement_error: 0.0,
            force_error: 1e-9,
            work_error: None,
            flat,
            after: 0,
            in_space: None,
        }
    }

    /// Another mesh confirms limit points where it has the same ones within a hundredth; neither the place of a flat one counts nor whether it is there.
    #[test]
    fn limit_points_of_two_meshes_agree() {
        let level = turn(LimitPointKind::Load, 0.3, 2.0, true);
        let points = |kind, displacement, force| vec![level, turn(kind, displacement, force, false)];
        let found = points(LimitPointKind::Displacement, 50.0, 1e-6);
        let agrees = |limit_points| Whole { elements: 8, limit_points }.agrees_with(&found);
        assert!(agrees(points(LimitPointKind::Displacement, 50.0, 1.005e-6)));
        assert!(agrees(vec![turn(LimitPointKind::Load, 0.6, 2.0, true), found[1]]));
        assert!(agrees(vec![level, level, found[1]]));
        assert!(agrees(vec![found[1]]));
        assert!(!agrees(points(LimitPointKind::Displacement, 50.0, 1.02e-6)));
        assert!(!agrees(points(LimitPointKind::Displacement, 51.0, 1e-6)));
        assert!(!agrees(points(LimitPointKind::Load, 50.0, 1e-6)));
        assert!(!agrees(found[..1].to_vec()));
        assert!(!agrees(vec![level, found[1], found[1]]));
        assert!(Accuracy::RELATIVE == Range::From(1e-11, NO_ACCURACY));
    }

    /// Two numbers that are further apart than both bounds get one that holds the other twice over; where the bounds explain it, nothing changes.
    #[test]
    fn a_bound_holds_what_another_mesh_gave() {
        let folds =
            |forces: [f64; 2]| forces.map(|force| turn(LimitPointKind::Displacement, 9.0 * force, force, false));
        let (mut points, before) = (folds([1.0, 3.0]), folds([1.0, 3.0]));
        let mut limit_points = folds([1.0 + 1.5e-9, 3.0 - 1e-6]).to_vec();
        limit_points.iter_mut().for_each(|point| point.displacement_error = 1.0);
        Whole { elements: 8, limit_points }.widen_unexplained(&mut points);
        assert_eq!(points[0], before[0]);
        assert!((points[1].force_error - 2e-6).abs() < 1e-12, "{}", points[1].force_error);
        assert_eq!(points[1].displacement_error, before[1].displacement_error);
    }
}
