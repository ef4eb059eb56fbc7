//! The limit points of a path that is whole, beside those that it has on another mesh.

use super::points::LimitPoint;
use crate::solve::points::kind::LimitPointKind;
use crate::study::error_bounds::DIFFERENCE_BOUND_FACTOR;

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
