//! What does not matter: where space's axes lie, and on what way an equilibrium was reached.
//!
//! Reference: no number but the solution itself, turned.
//!
//!     ///o==.            rest curve, supports and loads turned as a whole: so is the solution
//!            '==o ->      P first and then Q, Q first and then P, both at once: one solution
//!
//! Parameters: a rod that is curved and twisted at rest, with a stiffness that couples all strains; a force and a
//! moment that bend it by more than a radian; turns at random (a fixed seed).
//!
//! Expected: places, directors and energy to 1e-10, in as many iterations. Why: a beam whose rotations are
//! interpolated as vectors fails both (M. A. Crisfield, G. Jelenić, Proc. R. Soc. Lond. A 455 (1999)).

use super::setup::{Numbers, Rod, assert_close, tip, tip_directors};
use peelkit::beam::rotation::{apply, exponential, inner, matrix, product, times};
use peelkit::beam::{EndRotation, SpatialRestCurve};
use peelkit::solve::{InitialState, Observables, Problem, Solution, State, System, controlled};
use std::sync::Arc;

const CURVATURE: [f64; 3] = [0.8, -0.5, 0.9];
const FORCE: [f64; 3] = [0.9, -1.4, 1.1];
const MOMENT: [f64; 3] = [0.5, 0.8, -0.6];

fn rod() -> Rod {
    let rest =
        SpatialRestCurve { start: [0.2, 0.5, -0.3], directors: exponential([0.4, 0.1, -0.7]), curvature: CURVATURE };
    Rod::clamped(Numbers(5).stiffness(), rest, 2.0)
}

#[test]
fn a_turn_of_the_whole_turns_the_solution() {
    let rod = rod();
    let under = |rod: &Rod, force: [f64; 3], moment: [f64; 3]| {
        let load = |share: f64| [force.map(|f| share * f), moment.map(|m| share * m)];
        let (at, iterations) = rod.under(6, load, 0.25, &[1.0]).remove(0);
        let energy = rod.beam().evaluate(&at, &vec![0.0; rod.beam().unknowns(&at)]).0.energy;
        (at, iterations, energy)
    };
    let (at, iterations, energy) = under(&rod, FORCE, MOMENT);
    let bent = inner(tip_directors(&at), rod.rest.at(rod.length).1).abs().acos() * 2.0;
    assert!(bent > 1.0, "bent by {bent} rad only");
    let mut numbers = Numbers(19);
    for case in 0..6 {
        let turn = exponential(std::array::from_fn(|_| 3.0 * numbers.next()));
        let r = matrix(turn);
        let rest = SpatialRestCurve {
            start: apply(&r, &rod.rest.start),
            directors: product(turn, rod.rest.directors),
            ..rod.rest
        };
        let turned = Rod { rest, ..rod.clone() };
        let (there, as_many, as_much) = under(&turned, apply(&r, &FORCE), apply(&r, &MOMENT));
        assert_close(&tip(&there), &apply(&r, &tip(&at)), 1e-10, "tip");
        let wanted = product(turn, tip_directors(&at));
        let found = tip_directors(&there);
        assert_close(&times(found, inner(found, wanted).signum()), &wanted, 1e-10, "directors");
        assert!((as_much - energy).abs() < 1e-10 * energy, "case {case}: energy {as_much} and {energy}");
        assert_eq!(as_many, iterations, "case {case}");
    }
}

/// The rod's right end in a grip with angles: some numbers of it driven to where they are told, in this order.
fn driven(order: &[(usize, f64)]) -> (State, [f64; 6]) {
    let rod = Rod { rotation: EndRotation::Angles, ..rod() };
    let (problem, beam) = rod.problem(0, &[1, 2, 3, 4, 5]);
    let mut at = problem.initial(6);
    for &(slot, by) in order {
        let mut grip = problem.grip;
        grip.driven = slot;
        grip.held = std::array::from_fn(|f| f != slot);
        grip.origin = beam.interface_values(&at);
        at.force = 0.0;
        let next = Problem {
            grip,
            start: InitialState::Known { at: Arc::new(at.clone()), settling: false },
            ..problem.clone()
        };
        let found: Solution = controlled(&next, at, Observables::DISPLACEMENT, &[by], 1e-12).unwrap().remove(0);
        at = found.at;
    }
    // what the end is held by
    let residual = beam.residual(&at);
    let reactions = std::array::from_fn(|f| residual[residual.len() - 6 + f]);
    (at, reactions)
}

#[test]
fn the_way_to_an_equilibrium_does_not_matter() {
    let moves = [(0, -0.4), (1, 0.5), (2, 0.3), (5, 0.9), (3, 0.6), (4, -0.5)];
    let (at, reactions) = driven(&moves);
    let mut middle = 0;
    for order in [[5, 4, 3, 2, 1, 0], [2, 0, 4, 1, 5, 3], [3, 5, 1, 0, 2, 4]] {
        let (there, others) = driven(&order.map(|k| moves[k]));
        middle = at.values.len() / 14 * 7;
        assert_close(&others, &reactions, 1e-9, "reactions");
        assert_close(&there.values, &at.values, 1e-10, "everything");
    }
    // it did move: the node in the middle
    let rest = rod().beam().stress_free(6);
    assert!((0..3).any(|i| (rest.values[middle + i] - at.values[middle + i]).abs() > 0.05));
}

/// Forces that keep their directions, one after the other.
#[test]
fn the_order_of_loads_does_not_matter() {
    let rod = rod();
    let first = |share: f64| [FORCE.map(|f| share.min(1.0) * f), MOMENT.map(|m| (share - 1.0).max(0.0) * m)];
    let second = |share: f64| [FORCE.map(|f| (share - 1.0).max(0.0) * f), MOMENT.map(|m| share.min(1.0) * m)];
    let both = |share: f64| [FORCE.map(|f| 0.5 * share * f), MOMENT.map(|m| 0.5 * share * m)];
    let at = rod.under(6, first, 0.25, &[2.0]).remove(0).0;
    for other in [rod.under(6, second, 0.25, &[2.0]), rod.under(6, both, 0.5, &[2.0])] {
        assert_close(&other[0].0.values, &at.values, 1e-10, "everything");
    }
}
