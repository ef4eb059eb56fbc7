//! The two-field form of the beam, with x' minimised out, against the three-field form that keeps it.
//!
//! Reference: Reissner's beam as it is, unknowns ξ = x - S, y and θ at each node.
//!
//!      ______________________
//!     |______________________|/ ^ u, P     grip: rotation free or fixed, sliding or held
//!     =========================
//!
//! Parameters: the paper's strip, L = 100 nm, EI × 1 and × 0.01; 40 elements of order 5 and 7, 120 of order 2; u from 0 to 5 nm.
//!
//! Expected: equal forces, rotations, energies, horizontal forces, and numbers of negative eigenvalues. They are equal on any
//! mesh and not only in the limit, because with p Gauss points the x' of an element of order p can take any value at each
//! of them: it is minimised out there, too. Hence 1e-9 on a mesh that may be coarse.
//! Why: the program computes with two fields wherever it can, and nothing else would tell if that were another beam.

use crate::common::{LOADS, paper_strip, with_grip, with_load};
use peelkit::adhesion::LineLoad;
use peelkit::beam::{FRONT, TIP_ROTATION};
use peelkit::model::{BeamProblem, Body, Form, Hold, PeelModel, Spatula, StripModel};
use peelkit::solve::{Mesh, NewtonOptions, Observables, PathConstraint, Solution, Workspace, solve};
use peelkit::study::{Accuracy, Choice, StopCriteria, peel};

const STEPS: [f64; 14] = [0.0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.35, 0.5, 0.75, 1.0, 1.5, 2.2, 3.3, 5.0];

/// Longest step of the displacement, nm.
const LONGEST: f64 = 0.05;

/// Equilibria under displacement control, at every one of [`STEPS`]. The mesh stays: fine where the front is at 5 nm.
fn lift(problem: &BeamProblem, elements: usize) -> Vec<Solution> {
    let weights = Observables::DISPLACEMENT;
    let options = NewtonOptions { tolerance: 1e-12, largest_update: 1.0, most_iterations: 20, exact_slope: false };
    let mut work = Workspace::default();
    let focus = 0.9 * problem.beam.length();
    let mesh = Mesh { boundaries: problem.beam.planar().unwrap().ends(focus, elements), focus, ..Mesh::default() };
    let mut at = problem.beam.resampled(&problem.initial(elements), mesh);
    let (mut solutions, mut u) = (Vec::new(), 0.0);
    for target in STEPS {
        loop {
            let next = (u + LONGEST).min(target);
            let solution = solve(problem, at, &PathConstraint { weights, target: next }, &options, &mut work)
                .unwrap_or_else(|error| panic!("u = {next} nm: {error}"));
            u = next;
            if u == target {
                let ahead = STEPS.iter().find(|&&s| s > target).map_or(0.0, |s| (s - target).min(LONGEST));
                at = solution.moved(problem, ahead);
                solutions.push(solution);
                break;
            }
            at = solution.moved(problem, (target - u).min(LONGEST));
        }
    }
    solutions
}

#[track_caller]
fn assert_same(model: &StripModel, order: usize) {
    let elements = if order < 5 { 120 } else { 40 };
    let [two, three] = [Form::TwoField, Form::ThreeField].map(|form| model.problem(form, order).unwrap());
    let (reduced, full) = (lift(&two, elements), lift(&three, elements));
    let largest = full.iter().map(|s| s.observables.force).fold(0.0, f64::max);
    let stiffest = full.iter().map(|s| s.slope.force.abs()).fold(0.0, f64::max);
    // energies count from rest
    let energy = |s: &[Solution], i: usize| s[i].energy - s[0].energy;
    let coverage = |p: &BeamProblem, s: &Solution| {
        p.beam
            .planar()
            .unwrap()
            .chain
            .energy(p.beam.planar().unwrap().configuration(&s.at), p.beam.planar().unwrap().nodes(&s.at.values))
            .0
            .coverage
    };
    let whole = energy(&full, STEPS.len() - 1);
    let held = model.grip.horizontal == Hold::Fixed;
    for (i, (a, b)) in reduced.iter().zip(&full).enumerate() {
        let case = format!("{:?} {:?} order {order}, u = {} nm", model.adhesion.line_load, model.grip, STEPS[i]);
        let close = |what: &str, a: f64, b: f64, size: f64| {
            assert!((a - b).abs() <= 1e-9 * size, "{what}, {case}: {a:e} and {b:e}");
        };
        close("force", a.observables.force, b.observables.force, largest);
        close("rotation", a.observables.recorded, b.observables.recorded, 0.1);
        close(
            "rotation of the free end",
            a.observables.monitors[TIP_ROTATION],
            b.observables.monitors[TIP_ROTATION],
            0.1,
        );
        close("front", a.observables.monitors[FRONT], b.observables.monitors[FRONT], two.beam.length());
        close("energy", energy(&reduced, i), energy(&full, i), whole);
        close("coverage", coverage(&two, a), coverage(&three, b), whole);
        // taken one Newton update before the solution, hence coarser
        close("stiffness", a.slope.force, b.slope.force, 1e4 * stiffest);
        assert_eq!((a.negative, a.negative_load), (b.negative, b.negative_load), "negative eigenvalues, {case}");
        if held {
            let states = three
                .beam
                .planar()
                .unwrap()
                .chain
                .node_states(three.beam.planar().unwrap().configuration(&b.at), 0..b.at.mesh.elements());
            let axial_multiplier = two.beam.planar().unwrap().configuration(&a.at).axial_multiplier;
            for state in states {
                close("horizontal force", axial_multiplier, state.section.horizontal_force, largest);
            }
        }
    }
    // these steps cross the initiation peak: stable under the grip, unstable under a weight
    assert_eq!(full.iter().map(|s| s.negative).max(), Some(0));
    let falls = full.iter().any(|s| s.slope.force < 0.0);
    assert_eq!(full.iter().any(|s| s.negative_load == 1), falls, "one negative eigenvalue where the force falls");
}

#[test]
fn sliding_grip() {
    for load in LOADS {
        for rotation in [Hold::Free, Hold::Fixed] {
            for order in [2, 5, 7] {
                assert_same(&with_load(with_grip(paper_strip(100.0, 1.0), rotation, Hold::Free), load), order);
            }
        }
    }
}

#[test]
fn held_grip() {
    for load in LOADS {
        for rotation in [Hold::Free, Hold::Fixed] {
            for order in [2, 5, 7] {
                assert_same(&with_load(with_grip(paper_strip(100.0, 1.0), rotation, Hold::Fixed), load), order);
            }
        }
    }
}

#[test]
fn soft_strip() {
    for horizontal in [Hold::Free, Hold::Fixed] {
        let soft = with_grip(paper_strip(100.0, 0.01), Hold::Free, horizontal);
        assert_same(&with_load(soft, LineLoad::Full), 7);
    }
}

/// A whole peel in either form: section, height and direction vary along the beam. The same path, so within both bounds.
#[test]
fn a_spatula_in_either_form() {
    for horizontal in [Hold::Free, Hold::Fixed] {
        let strip = with_grip(paper_strip(100.0, 1.0), Hold::Fixed, horizontal);
        let spatula = PeelModel { body: Body::Spatula(Spatula::default()), ..PeelModel::from(strip) };
        let [two, three] = [Form::TwoField, Form::ThreeField].map(|form| {
            let accuracy = Accuracy::to(1e-6);
            let choice = Choice { form, ..accuracy.choice };
            let bounds = StopCriteria { points: 5000, displacement: Some(400.0), ..StopCriteria::default() };
            let peel = peel(&spatula, &accuracy.with(choice), &bounds);
            (peel.peak.unwrap(), peel.snap_off.unwrap())
        });
        let ((peak, snap), (same_peak, same_snap)) = (two, three);
        let close = |what: &str, a: f64, b: f64, bounds: f64| {
            assert!(
                (a - b).abs() <= bounds && bounds < 1e-5 * a,
                "{what}, {horizontal:?}: {a} and {b} within {bounds:e}"
            );
        };
        close("peak", peak.force, same_peak.force, peak.force_error + same_peak.force_error);
        let bounds = snap.displacement_error + same_snap.displacement_error;
        close("snap-off", snap.displacement, same_snap.displacement, bounds);
        close("work", snap.work, same_snap.work, 1e-6 * snap.work);
    }
}
