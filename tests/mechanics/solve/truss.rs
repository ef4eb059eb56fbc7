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
//! to 1e-6 of the displacement, which is what the locator aims at.

use super::dense_truss::Truss;
use approx::{assert_abs_diff_eq, assert_relative_eq};
use peelkit::solve::{EndConditions, LimitPointKind, Pace, Path, PathOptions, Workspace, locate_branching};
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
