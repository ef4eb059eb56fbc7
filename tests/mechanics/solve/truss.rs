//! The shallow and the steep two-bar truss (von Mises): limit points of load and of displacement, inertia and a branching point, all in
//! closed form.
//!
//! ```text
//!            | P, u
//!            v
//!           /o\         apex at height h above supports that are 2a apart
//!         /     \
//!      /|\       /|\
//! ```
//!
//! Bars of stiffness EA store ½EA l0 (l/l0 - 1)² each. On the symmetric path with the apex at the height y = h + u, l² = a² + y²,
//!   P = 2 EA y (1/l0 - 1/l),  dP/du = 0 at l³ = a² l0;
//! behind a spring k, U = u + P/k turns where dP/du = -k. Sideways the tangent is 2EA (1/l0 - y²/l³): it vanishes at l³ = y² l0, where a
//! steep truss leaves its symmetric path.
//!
//! Expected: limit points to 1e-9 (their own bound is zero, for there is no mesh), inertia 0, 1, 0 along the path, the branching point
//! to 1e-6 of the displacement, which is what the locator aims at. Stations at a displacement and a force, and events of the strain of a bar, at
//! their closed forms to 1e-10: y = h + u at a station, y = ±√(l² - a²) where the bar has the length l.

use super::dense_truss::Truss;
use approx::{assert_abs_diff_eq, assert_relative_eq};
use peelkit::solve::{
    EndConditions, LimitPointKind, Pace, Passing, Path, PathNumber, PathOptions, SoughtValue, State, Workspace,
    locate_branching,
};
use peelkit::study::follow_rod;

const HALF_SPAN: f64 = 1.0;
const STIFFNESS: f64 = 3.0;

/// The apex is node 0; its height is driven.
fn truss(height: f64) -> Truss {
    Truss {
        nodes: vec![[0.0, height], [-HALF_SPAN, 0.0], [HALF_SPAN, 0.0]],
        free: 1,
        bars: vec![(0, 1, STIFFNESS), (0, 2, STIFFNESS)],
        interface: vec![1],
        monitors: [0, 1],
        follower: 0.0,
    }
}

fn options() -> PathOptions {
    PathOptions {
        elements: 0,
        step_tolerance: 1e-3,
        stride: 1.0,
        longest: None,
        tolerance: 1e-12,
        prediction: 8,
        first_displacement: -1e-3,
        pace: Pace::Quick,
    }
}

/// P and dP/du at an apex height.
fn load(height: f64, y: f64) -> (f64, f64) {
    let (rest, length) = (HALF_SPAN.hypot(height), HALF_SPAN.hypot(y));
    let force = 2.0 * STIFFNESS * y * (1.0 / rest - 1.0 / length);
    (force, 2.0 * STIFFNESS * (1.0 / rest - 1.0 / length + y * y / length.powi(3)))
}

#[test]
fn a_shallow_truss_snaps_through_at_its_limit_loads() {
    let height = 0.5;
    let problem = truss(height).problem(EndConditions::drive(0));
    let path = follow_rod(&problem, options(), 500, |point| point.observables.displacement < -2.5 * height).unwrap();
    let rest = HALF_SPAN.hypot(height);
    let y = ((HALF_SPAN * HALF_SPAN * rest).powf(2.0 / 3.0) - HALF_SPAN * HALF_SPAN).sqrt();
    let wanted = [y, -y].map(|y| (y - height, load(height, y).0));
    assert_eq!(path.turns.len(), 2);
    for (turn, (displacement, force)) in path.turns.iter().zip(wanted) {
        assert_eq!(turn.kind, LimitPointKind::Load);
        assert_relative_eq!(turn.located.observables.displacement, displacement, max_relative = 1e-9);
        assert_relative_eq!(turn.located.observables.force, force, max_relative = 1e-9);
    }
    // under load control unstable between the two, under displacement control stable all along: the load limit points are all there is
    for point in &path.points {
        let y = height + point.observables.displacement;
        assert_eq!(point.negative_load, usize::from(load(height, y).1 < 0.0));
        assert_eq!(point.negative, 0);
        assert_abs_diff_eq!(point.observables.force, load(height, y).0, epsilon = 1e-10);
    }
    assert!(path.points.len() < 60 && path.iterations < 300, "{} {}", path.points.len(), path.iterations);
}

#[test]
fn stations_and_events_of_the_user_are_where_the_closed_forms_have_them() {
    let height = 0.5;
    let truss = truss(height);
    let rest = HALF_SPAN.hypot(height);
    let strain = |at: &State| HALF_SPAN.hypot(height + at.values[1]) / rest - 1.0;
    let problem = truss.problem(EndConditions::drive(0));
    let path = follow_rod(&problem, options(), 500, |point| point.observables.displacement < -2.5 * height).unwrap();
    let apexes = |number, value, passing| -> Vec<f64> {
        let found = SoughtValue::new(number, value, passing, &path.points).on_path().unwrap();
        found.iter().map(|found| height + found.solution.observables.displacement).collect()
    };
    let displacement = || PathNumber::observable(&problem, |o| o.displacement);
    let force = || PathNumber::observable(&problem, |o| o.force);
    let bar = || PathNumber::of_state(&problem, strain);
    let agree = |found: Vec<f64>, expected: &[f64]| {
        assert_eq!(found.len(), expected.len(), "{found:?} {expected:?}");
        for (found, expected) in found.iter().zip(expected) {
            assert_abs_diff_eq!(found, expected, epsilon = 1e-10);
        }
    };
    // a station at a displacement, and at the force that the closed form has there, which the path passes three times
    agree(apexes(displacement(), -0.3, Passing::Either), &[height - 0.3]);
    let level = load(height, 0.4).0;
    let at_level = apexes(force(), level, Passing::Either);
    assert_eq!(at_level.len(), 3);
    for &y in &at_level {
        assert_abs_diff_eq!(load(height, y).0, level, epsilon = 1e-10);
    }
    assert_abs_diff_eq!(at_level[0], 0.4, epsilon = 1e-10);
    // an event: the bars are so much shorter on the way down and again behind the middle
    let y = ((0.95 * rest).powi(2) - HALF_SPAN * HALF_SPAN).sqrt();
    agree(apexes(bar(), -0.05, Passing::Either), &[y, -y]);
    agree(apexes(bar(), -0.05, Passing::Falling), &[y]);
    agree(apexes(bar(), -0.05, Passing::Rising), &[-y]);
    agree(apexes(bar(), -0.2, Passing::Either), &[]);
    // what is no number is said, and not passed over
    let none = PathNumber::of_state(&problem, |_| f64::NAN);
    assert!(SoughtValue::new(none, 0.0, Passing::Either, &path.points).on_path().is_err());
}

#[test]
fn behind_a_soft_spring_the_displacement_turns_back() {
    let (height, stiffness) = (0.5, 0.2);
    let problem = truss(height).problem(EndConditions { compliance: 1.0 / stiffness, ..EndConditions::drive(0) });
    let path = follow_rod(&problem, options(), 500, |point| point.observables.monitors[1] < -2.2 * height).unwrap();
    let slope = |y: f64| load(height, y).1 + stiffness;
    let root = |mut low: f64, mut high: f64| {
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if (slope(middle) < 0.0) == (slope(low) < 0.0) { low = middle } else { high = middle }
        }
        low
    };
    let turns: Vec<_> = path.turns.iter().filter(|turn| turn.kind == LimitPointKind::Displacement).collect();
    let wanted = [root(0.0, height), -root(0.0, height)];
    assert_eq!(turns.len(), 2);
    for (turn, y) in turns.iter().zip(wanted) {
        let force = load(height, y).0;
        assert_relative_eq!(turn.located.observables.displacement, y - height + force / stiffness, max_relative = 1e-9);
        assert_relative_eq!(turn.located.observables.force, force, max_relative = 1e-9);
    }
    let unstable = path.points.iter().filter(|point| point.negative == 1).count();
    assert!(unstable > 0, "the snap-back has one negative eigenvalue under displacement control");
    assert!(path.points.iter().all(|point| point.negative <= 1));
}

#[test]
fn a_steep_truss_branches_before_its_limit_load() {
    let height = 3.0;
    let problem = truss(height).problem(EndConditions::drive(0));
    let mut path = Path::new(&problem, options());
    while path.advance().unwrap().negative == 0 {}
    let [.., stable, beyond] = path.points() else { unreachable!() };
    assert_eq!((stable.negative, beyond.negative), (0, 1));
    let located =
        locate_branching(&problem, stable, beyond.observables.displacement, &mut Workspace::default()).unwrap();
    let rest = HALF_SPAN.hypot(height);
    // l³ = y² l0 with l² = a² + y²
    let sideways = |y: f64| HALF_SPAN.hypot(y).powi(3) - y * y * rest;
    let (mut low, mut high) = (1.5, height);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if sideways(middle) < 0.0 { low = middle } else { high = middle }
    }
    assert_relative_eq!(located.observables.displacement, low - height, max_relative = 1e-6);
    assert_relative_eq!(located.observables.force, load(height, low).0, max_relative = 1e-6);
}
