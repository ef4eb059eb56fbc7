//! The branch on which a strip leaves its plane, followed in space.
//!
//!     P |      planar path, unstable           roll |        .---.
//!       |     .-'-.                                 |      .'     '.
//!       |    /*....'-.      branch                  |     /         \
//!       |   /       ''-._                           |    |           |
//!       +------------------ u                       +----*-----------*---- u
//!
//! References: Gauss collocation of the strong form, without finite elements (`verification/out_of_plane_branch.csv`);
//! the theory of bifurcations; paths in space that are pulled beside the plane, extrapolated to it. Parameters: the paper's strip of 100 nm, 1 to
//! 100 nm wide, pulled straight up, and 40 nm wide at 30 degrees. Expected: limit points of the
//! table within their bounds; forces at given displacements; a branch that begins where the planar path loses its
//! stability and ends where that regains it. Why: behind that loss the branch is what a strip that is free to roll does.

use crate::common::{paper_strip, whole_peel};
use peelkit::model::{PeelModel, Pull, Space, StripModel};
use peelkit::study::{
    Accuracy, Bound, LimitPoint, LimitPointKind, OutOfPlaneBranch, OutOfPlaneBranchError, PathEnd, PathPoint,
    StopCriteria, peel,
};

fn wide(width: f64) -> StripModel {
    let mut model = paper_strip(100.0, 1.0);
    model.strip.width = width;
    model
}

fn branch_to(width: f64, relative: f64, displacement: f64) -> OutOfPlaneBranch {
    let stop = StopCriteria { displacement: Some(displacement), ..StopCriteria::default() };
    whole_peel(&wide(width), relative).branch(&stop).unwrap().unwrap()
}

/// A number of the table, by case and quantity.
fn known(case: &str, quantity: &str) -> f64 {
    let table = include_str!("../../../verification/out_of_plane_branch.csv");
    let row = |line: &&str| line.split(',').take(2).eq([case, quantity]);
    table.lines().find(row).unwrap().split(',').nth(2).unwrap().parse().unwrap()
}

/// A number of the branch at a displacement, by the polynomial through the ten points around.
fn at(branch: &OutOfPlaneBranch, displacement: f64, of: impl Fn(&PathPoint) -> f64) -> f64 {
    let points = &branch.peel.points;
    let behind = points.iter().position(|point| point.displacement > displacement).unwrap();
    let near = &points[behind.max(5) - 5..(behind + 5).min(points.len())];
    let weight = |i: usize| -> f64 {
        let others = (0..near.len()).filter(|&j| j != i);
        let factor = |j: usize| (displacement - near[j].displacement) / (near[i].displacement - near[j].displacement);
        others.map(factor).product()
    };
    (0..near.len()).map(|i| weight(i) * of(&near[i])).sum()
}

#[test]
fn limit_points_are_those_of_collocation() {
    for (case, width, relative) in
        [("wide_40", 40.0, 1e-4), ("wide_40", 40.0, 1e-6), ("wide_40", 40.0, 1e-9), ("wide_60", 60.0, 1e-6)]
    {
        let branch = branch_to(width, relative, 48.5).peel;
        let peak = branch.limit_points[0];
        let fold = branch.snap_off.unwrap();
        assert_eq!((peak.kind, fold.kind), (LimitPointKind::Load, LimitPointKind::Displacement));
        assert_eq!(branch.peak.unwrap().force, peak.force);
        for (limit, name) in [(peak, "peak"), (fold, "fold")] {
            let [u, force, roll] =
                ["displacement_nm", "force_nN", "roll_deg"].map(|what| known(case, &format!("{name}_{what}")));
            let off = [(limit.displacement - u).abs(), (limit.force - force).abs()];
            assert!(off[0] <= limit.displacement_error && off[1] <= limit.force_error, "{case} {limit:?} {off:?}");
            let reached = (limit.displacement_error / u).max(limit.force_error / force);
            assert!(reached <= relative.max(1e-8), "{case}: {reached:e} where {relative:e} was asked for");
            let found = limit.in_space.unwrap().roll.to_degrees();
            assert!((found - roll).abs() < 1e-4, "{case} {name}: roll {found} {roll}");
        }
    }
}

#[test]
fn forces_and_rolls_between_limit_points_are_those_of_collocation() {
    for (case, width, places) in [("wide_40", 40.0, &[0.5, 1.0, 2.0][..]), ("narrow_1", 1.0, &[0.6, 0.8])] {
        let branch = branch_to(width, 1e-9, places[places.len() - 1] + 0.2);
        assert!(matches!(branch.peel.end, PathEnd::Bound(Bound::Displacement(_))), "{:?}", branch.peel.end);
        for &u in places {
            let table = |what: &str| known(case, &format!("u_{u}_{what}"));
            let force = at(&branch, u, |point| point.force) / table("force_nN");
            assert!((force - 1.0).abs() < 1e-8, "{case} u = {u}: force {:e}", force - 1.0);
            let angles = [
                (at(&branch, u, |point| point.in_space.unwrap().roll.to_degrees()), table("roll_deg")),
                (at(&branch, u, |point| point.in_space.unwrap().yaw.to_degrees()), table("yaw_deg")),
                (at(&branch, u, |point| point.end_rotation.to_degrees()), table("rotation_deg")),
            ];
            for (found, expected) in angles {
                assert!((found - expected).abs() < 1e-6, "{case} u = {u}: {found} {expected}");
            }
        }
    }
}

/// On the branch of the strip 1 nm wide its end leans by 5 degrees at u = 0.554922612 nm, P = 0.27663077 nN.
#[test]
fn a_narrow_strip_leans_by_five_degrees() {
    let branch = branch_to(1.0, 1e-8, 0.6);
    let lean = |point: &PathPoint| {
        let grip = point.in_space.unwrap();
        let ((s, c), (sr, cr)) = (point.end_rotation.sin_cos(), grip.roll.sin_cos());
        (c * sr - s * grip.yaw.sin() * cr).atan2(c * cr + s * grip.yaw.sin() * sr).to_degrees()
    };
    assert!((at(&branch, 0.554922612, lean) - 5.0).abs() < 2e-6);
    assert!((at(&branch, 0.554922612, |point| point.force) - 0.27663077).abs() < 1e-8);
}

#[test]
fn a_branch_begins_where_stability_is_lost_and_ends_where_it_is_regained() {
    for (width, relative) in [(4.929, 1e-6), (4.92, 1e-6), (4.5, 1e-5), (25.3, 1e-6), (30.0, 1e-6), (40.0, 1e-5)] {
        let branch = whole_peel(&wide(width), relative).branch(&StopCriteria::default()).unwrap().unwrap();
        let OutOfPlaneBranch { loss, start, peel, rejoins } = &branch;
        assert_eq!(peel.end, PathEnd::BackInPlane, "b = {width}");
        let off = (start.displacement / loss.displacement - 1.0).abs();
        assert!(off < 1e-4, "b = {width}: {start:?} {loss:?}");
        let first = &peel.points[0];
        let second_order = start.displacement + start.displacement_by_roll * first.in_space.unwrap().roll.powi(2);
        let of_second = (first.displacement - start.displacement).abs();
        assert!((first.displacement - second_order).abs() < 0.21 * of_second, "b = {width}");
        assert!(peel.points.iter().all(|point| point.in_space.unwrap().roll > 0.0), "b = {width}: one of two sides");
        // the square of the roll falls to zero, linearly in u
        let rejoins = rejoins.unwrap();
        let [before, last] = [2, 1].map(|from_end| peel.points[peel.points.len() - from_end]);
        let [a, b] = [before, last].map(|point| point.in_space.unwrap().roll.powi(2));
        let end = last.displacement + b * (last.displacement - before.displacement) / (a - b);
        let most = 0.2 * (last.displacement - before.displacement).abs() + 10.0 * rejoins.displacement_error;
        assert!((end - rejoins.displacement).abs() < most, "b = {width}: {end} {rejoins:?}");
    }
}

/// All of them go on to larger displacements, and take over the stability of the planar path under displacement control.
#[test]
fn the_inertia_is_that_of_a_pitchfork() {
    for width in [1.0, 2.0, 4.0, 26.0, 40.0, 100.0] {
        let branch = branch_to(width, 1e-5, 1e-3);
        let first = branch.peel.points[0];
        assert!(branch.start.displacement_by_roll > 0.0, "b = {width}");
        let falls = branch.start.slope() < 0.0;
        assert_eq!(
            (first.negative_eigenvalues, first.negative_eigenvalues_load),
            (0, usize::from(falls)),
            "b = {width}"
        );
    }
}

/// Against ∫ P du along the planar path to where it is left, and along the branch.
/// Beside the plane the peak of the path is that of the branch up to terms in the azimuth: the parabola through three azimuths takes off the first two.
#[test]
fn the_peak_of_an_inclined_pull_is_what_is_left_where_the_azimuth_goes_to_zero() {
    let inclined = |azimuth: f64| PeelModel {
        pull: Pull { angle: 30f64.to_radians(), ..Pull::UP },
        space: Some(Space { azimuth: azimuth.to_radians(), ..Space::default() }),
        ..wide(40.0).into()
    };
    let stop = StopCriteria { displacement: Some(2.8), ..StopCriteria::default() };
    let of = |azimuth: f64| peel(&inclined(azimuth), &Accuracy::to(1e-7), &stop);
    let branch = of(0.0).branch(&stop).unwrap().unwrap().peel.limit_points[0];
    let beside = [0.01, 0.02, 0.03].map(|azimuth| of(azimuth).limit_points[0]);
    let sum = |weights: [f64; 3], of: fn(&LimitPoint) -> f64| -> f64 {
        weights.iter().zip(&beside).map(|(weight, point)| weight * of(point)).sum()
    };
    let (there, sizes) = ([3.0, -3.0, 1.0], [3.0, 3.0, 1.0]);
    let place = (branch.displacement - sum(there, |point| point.displacement)).abs();
    let force = (branch.force - sum(there, |point| point.force)).abs();
    assert!(place <= branch.displacement_error + sum(sizes, |point| point.displacement_error), "{place:e}");
    assert!(force <= branch.force_error + sum(sizes, |point| point.force_error), "{force:e}");
    // what was taken off is more than that
    assert!((branch.force - beside[2].force).abs() > 1e3 * force);
}

#[test]
fn work_counts_from_rest() {
    let branch = branch_to(40.0, 1e-7, 5.0);
    let planar = whole_peel(&wide(40.0), 1e-7);
    let to_loss = at_planar(&planar.points, branch.loss.displacement);
    let points = &branch.peel.points;
    let start = (branch.loss.displacement, branch.loss.force);
    let dense = branch.peel.dense_curve(8).into_iter().map(|(u, force, _)| (u, force));
    let curve = std::iter::once(start).chain(dense);
    let curve: Vec<(f64, f64)> = curve.collect();
    let work: f64 = curve.windows(2).map(|p| 0.5 * (p[1].0 - p[0].0) * (p[0].1 + p[1].1)).sum();
    let last = points[points.len() - 1];
    assert!((last.work / (to_loss + work) - 1.0).abs() < 1e-4, "{} {}", last.work, to_loss + work);
}

/// The work at a displacement of a planar path, to second order from the point before.
fn at_planar(points: &[PathPoint], displacement: f64) -> f64 {
    let behind = points.iter().position(|point| point.displacement > displacement).unwrap();
    let [a, b] = [points[behind - 1], points[behind]];
    let ahead = displacement - a.displacement;
    a.work + ahead * (a.force + 0.5 * ahead * (b.force - a.force) / (b.displacement - a.displacement))
}

#[test]
fn what_has_no_branch_has_none() {
    let stop = StopCriteria::default();
    assert!(whole_peel(&wide(10.0), 1e-6).branch(&stop).unwrap().is_none());
    let upright = whole_peel(&wide(0.15), 1e-6).branch(&stop).unwrap_err();
    assert_eq!(upright, OutOfPlaneBranchError::FromTheBeginning);
}
