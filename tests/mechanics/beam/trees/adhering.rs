//! Branches that adhere to flat ground.
//!
//! ```text
//!            0 root, moved up, never turned                0 root
//!           /                                              |
//!   1 =====/   a spatula, S from its free end      1 ======+====== 2   two strips, joined
//!   ----------------------------------             -----------------
//! ```
//!
//! Reference: the beam in space, which is another implementation of chain, mesh and solver interface; central differences; for two strips that
//! are joined twice the peak of one, because by symmetry each is pulled along the normal with its end held upright. Parameters: the default spatula
//! and the paper's strip, elements of orders 3 and 7. Expected: energy, residual and the length that adheres are the same to round-off;
//! derivatives agree with differences to their own error, on branches that are turned too, and where the adhesive holds them along the ground; the first limit point of the force is the same to 1e-6.

use super::tangents::{add_turn, dense, difference};
use approx::assert_relative_eq;
use nalgebra::DVector;
use peelkit::adhesion::CohesiveShape;
use peelkit::beam::rotation::{Quaternion, apply, exponential, matrix};
use peelkit::beam::{
    BeamTree, Branch, BranchMesh, BranchRest, BranchSections, BranchingBeam, JointCondition, PlacedRest, TreeMonitor,
};
use peelkit::model::{Attraction, Body, BodyBranch, Form, Grip, Hold, PeelModel, Space, Spatula, StripModel};
use peelkit::solve::{
    EndConditions, Held, InitialState, LimitPointKind, MeasuredBeside, Path, PathEvent, PathMeasure, PathOptions,
    PathTracer, Problem, RelaxOptions, State, System, TraceOptions, Workspace, relax,
};
use peelkit::study::{Accuracy, StopCriteria, peel};
use std::sync::Arc;

const AS_IT_IS: Quaternion = [1.0, 0.0, 0.0, 0.0];
/// Along the drive, which goes up, and across it
const UP: [[f64; 3]; 3] = [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];

fn spatula() -> PeelModel {
    Spatula::default().model()
}

/// Under a cohesive law that holds it along the ground as well.
fn held_spatula() -> PeelModel {
    let mut model = spatula();
    model.adhesion.attraction = Attraction::Cohesive(CohesiveShape::Exponential);
    model.adhesion.shear_strength = Some(0.02);
    model
}

/// A body from a joint at its free end to joint 0, turned, with that end at the origin of the ground.
fn placed(body: &BodyBranch, free: usize, turn: Quaternion, elements: usize) -> Branch {
    let (end, _) = body.rest.at(body.length);
    let [x, _, z] = apply(&matrix(turn), &end);
    Branch {
        joints: [free, 0],
        rest: BranchRest::Placed(PlacedRest { rest: body.rest.clone(), turn, origin: [-x, 0.0, -z] }),
        length: body.length,
        sections: BranchSections::Adhering(body.sections.clone()),
        mesh: BranchMesh::Following { policy: body.mesh.clone(), elements },
    }
}

fn tree(branches: Vec<Branch>, order: usize) -> BeamTree {
    let conditions = vec![JointCondition::free(0)];
    BranchingBeam { order, scale: [100.0, 0.3], conditions, ..BranchingBeam::new(branches, 0) }.build().unwrap()
}

/// Numbers between -1 and 1.
fn spread(k: usize) -> f64 {
    2.0 * (0.618_033_988_749_895 * (k + 1) as f64).fract() - 1.0
}

#[test]
fn a_spatula_as_a_branch_is_the_beam_in_space() {
    is_the_beam_in_space(spatula(), 0.0);
}

#[test]
fn one_that_is_held_is_too() {
    // open all over: where a face closes a chain is cut, and a tree is not
    is_the_beam_in_space(held_spatula(), 0.4);
}

/// Lifted by so much, nm, and bent.
fn is_the_beam_in_space(spatula: PeelModel, lift: f64) {
    let model = PeelModel { space: Some(Space::default()), ..spatula };
    let problem = model.problem(Form::TwoField, 7).unwrap();
    let tree = tree(vec![placed(&model.branch().unwrap(), 1, AS_IT_IS, 32)], 7);
    let tree = tree.with_monitors([Some(TreeMonitor::AdheringLength), None]);
    let (mut chain, mut own) = (problem.system.stress_free(32), tree.stress_free(0));
    assert_eq!(chain.mesh.boundaries, own.mesh.boundaries);
    let nodes = (chain.values.len() - 6) / 7;
    // both ends, which are the joints of the tree
    [1, 7 * (nodes - 1) + 1].into_iter().for_each(|height| chain.values[height] += lift);
    [1, 8].into_iter().for_each(|height| own.values[height] += lift);
    for node in 1..nodes - 1 {
        let fields = &mut chain.values[7 * node..7 * (node + 1)];
        (0..7).for_each(|f| fields[f] += 1e-3 * spread(7 * node + f));
        fields[1] += lift;
        // the free end stands at the origin of the chain, the held one above that of the tree
        let inside = &mut own.values[14 + 7 * (node - 1)..][..7];
        let shift = inside[0] - (fields[0] - 1e-3 * spread(7 * node));
        inside.copy_from_slice(fields);
        inside[0] += shift;
    }
    let still = |system: &dyn System, at: &State| system.evaluate(at, &vec![0.0; system.unknowns(at)]).0;
    let (wanted, found) = (still(&*problem.system, &chain), still(&tree, &own));
    assert_relative_eq!(found.energy, wanted.energy, max_relative = 1e-11);
    assert_relative_eq!(found.monitors[0], wanted.monitors[0], max_relative = 1e-11);
    let (wanted, found) = (problem.system.residual(&chain), tree.residual(&own));
    let largest = wanted.iter().fold(0.0f64, |most, force| most.max(force.abs()));
    for k in 0..6 * (nodes - 2) {
        assert!((found[12 + k] - wanted[6 + k]).abs() < 1e-8 * largest, "{k}: {} {}", found[12 + k], wanted[6 + k]);
    }
}

#[test]
fn derivatives_are_those_of_the_energy() {
    have_the_derivatives_of_the_energy(&spatula(), [0.0; 3]);
}

#[test]
fn those_of_what_is_held_are_too() {
    // open all over: where a face closes the law has a corner, which coarse elements do not resolve
    have_the_derivatives_of_the_energy(&held_spatula(), [0.6, 0.4, -0.5]);
}

/// Of two spatulae that are moved by so much, nm, and bent.
fn have_the_derivatives_of_the_energy(spatula: &PeelModel, moved: [f64; 3]) {
    let body = spatula.branch().unwrap();
    let turned = |angle: f64| exponential([0.0, angle, 0.0]);
    let branches = vec![placed(&body, 1, turned(0.4), 6), placed(&body, 2, turned(-2.0), 6)];
    let monitors = [TreeMonitor::AdheringLength, TreeMonitor::PadsAside].map(Some);
    let tree = tree(branches, 3).with_monitors(monitors);
    let mut at = tree.stress_free(0);
    let way: Vec<f64> = (0..tree.unknowns(&at)).map(spread).collect();
    tree.retract(&mut at, &way, 1e-3);
    let nodes = tree.unknowns(&at) / 6;
    at.values[..7 * nodes].chunks_exact_mut(7).for_each(|node| (0..3).for_each(|i| node[i] += moved[i]));
    let (residual, tangent, reactions) = (tree.residual(&at), dense(&tree, &at), tree.reactions(&at));
    let largest = residual.iter().fold(0.0f64, |most, force| most.max(force.abs()));
    let gradients = [[1.0, 0.0], [0.0, 1.0]].map(|weights| tree.gradient(&at, weights));
    let monitors = |at: &State| tree.evaluate(at, &way).0.monitors;
    for unknown in 0..tree.unknowns(&at) {
        // an edge of a pad is 100 nm from the axis: a turn moves it a hundred times as far
        let step = if unknown % 6 < 3 { 1e-5 } else { 1e-7 };
        let slope = difference(&tree, &at, (unknown, step), |at| tree.energy(at), |a, b| a - b) / (2.0 * step);
        assert!((slope - residual[unknown]).abs() < 1e-6 * largest, "{unknown}: {slope} {}", residual[unknown]);
        let mut column =
            difference(&tree, &at, (unknown, step), |at| DVector::from(tree.residual(at)), |a, b| a - b) / (2.0 * step);
        add_turn(&mut column, &reactions, unknown, &[0]);
        let miss = (column - tangent.column(unknown)).abs().max();
        assert!(miss < 1e-6 * tangent.abs().max(), "{unknown}: {miss} of {}", tangent.abs().max());
        let rates =
            difference(&tree, &at, (unknown, step), monitors, |a, b| [0, 1].map(|k| (a[k] - b[k]) / (2.0 * step)));
        for (rate, gradient) in rates.iter().zip(&gradients) {
            let most = gradient.iter().fold(0.0f64, |most, by| most.max(by.abs()));
            assert!((rate - gradient[unknown]).abs() < 1e-6 * most, "{unknown}: {rate} {}", gradient[unknown]);
        }
    }
    let rates = tree.evaluate(&at, &way).1.monitors;
    for (rate, gradient) in rates.iter().zip(&gradients) {
        let along: f64 = gradient.iter().zip(&way).map(|(by, way)| by * way).sum();
        assert_relative_eq!(*rate, along, max_relative = 1e-12);
    }
}

/// u (nm) and P (nN) at the first maximum of the force on a path from rest on, and the iterations to there. `scale` is about that force.
fn first_maximum(problem: &Problem, rest: State, scale: f64) -> ([f64; 2], usize) {
    let mut ws = Workspace::default();
    let rest = relax(problem, rest, Held::Displacement(0.0), &RelaxOptions::default(), &mut ws).unwrap();
    let options = PathOptions { first_displacement: 0.1, ..PathOptions::default() };
    let path = Path::from(problem, options, rest.solution.at);
    let kinds = &[LimitPointKind::Load];
    let mut tracer = PathTracer::new(problem, path, TraceOptions { kinds, relative: 1e-6, ..TraceOptions::default() });
    loop {
        match tracer.advance().unwrap() {
            // where the pad begins to be lifted ripples are no peak
            PathEvent::LimitPoint { located, .. } if located.observables.force > 0.1 * scale => {
                let o = located.observables;
                return ([o.displacement, o.force], tracer.iterations());
            }
            _ => {}
        }
    }
}

/// The same of a tree whose root is pulled up.
fn of_tree(tree: BeamTree, scale: f64) -> ([f64; 2], usize) {
    let tree = tree.with_root_axes(UP).with_monitors([Some(TreeMonitor::AdheringLength), None]);
    let rest = tree.stress_free(0);
    let held = [false, true, true, true, true, true];
    let problem = Problem {
        grip: EndConditions { held, origin: tree.interface_at_rest(), ..EndConditions::drive(0) },
        measure: PathMeasure { monitors: [1.0, f64::INFINITY], force: scale, beside: MeasuredBeside::Force },
        start: InitialState::StressFree,
        system: Arc::new(tree),
    };
    first_maximum(&problem, rest, scale)
}

/// The largest force of a body in the plane that is pulled up with its end upright and free to move along the ground.
fn in_the_plane(model: &PeelModel) -> [f64; 2] {
    let grip = Grip { rotation: Hold::Fixed, horizontal: Hold::Free, ..Grip::FREE };
    let found = peel(&PeelModel { grip, ..model.clone() }, &Accuracy::to(1e-7), &StopCriteria::default());
    let peak = found.peak.unwrap();
    [peak.displacement, peak.force]
}

#[test]
fn a_spatula_peels_as_a_branch_as_it_does_as_a_beam() {
    let grip = Grip { rotation: Hold::Fixed, horizontal: Hold::Free, ..Grip::FREE };
    let space = Space { yaw: Hold::Fixed, roll: Hold::Fixed, ..Space::default() };
    let model = PeelModel { grip, space: Some(space), ..spatula() };
    let turn = exponential([0.0, 0.7, 0.0]);
    let ([displacement, force], iterations) =
        of_tree(tree(vec![placed(&model.branch().unwrap(), 1, turn, 48)], 7), 6.0);
    let problem = model.problem(Form::TwoField, 7).unwrap();
    let (wanted, of_beam) = first_maximum(&problem, problem.initial(48), 6.0);
    println!("u {displacement} {} P {force} {} iterations {iterations} {of_beam}", wanted[0], wanted[1]);
    assert_relative_eq!(displacement, wanted[0], max_relative = 1e-6);
    assert_relative_eq!(force, wanted[1], max_relative = 1e-6);
    assert!(iterations < 500, "{iterations}");
}

#[test]
fn two_strips_that_are_joined_hold_twice_what_one_does() {
    let model = PeelModel::from(&StripModel::of_the_paper(100.0, 1.0));
    let body = model.branch().unwrap();
    let half_turn = exponential([0.0, std::f64::consts::PI, 0.0]);
    let branches = vec![placed(&body, 1, AS_IT_IS, 24), placed(&body, 2, half_turn, 24)];
    let [_, wanted] = in_the_plane(&model);
    let ([_, force], iterations) = of_tree(tree(branches, 7), 2.0 * wanted);
    println!("P {force} {wanted} iterations {iterations}");
    assert_relative_eq!(force, 2.0 * wanted, max_relative = 1e-6);
    assert!(matches!(model.body, Body::Strip(_)));
}
