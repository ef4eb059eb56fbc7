//! Trees of beams with mass: a tree that is a chain, a forked tree that flies, and one that vibrates.
//!
//! ```text
//!    o       o      free
//!     \     /       L = 6 each, at 40 degrees
//!      \   /
//!        o
//!        |          L = 10
//!      ==o==        held, or free as well
//! ```
//!
//! References: the planar beam of `in_space.rs`; momentum, angular momentum and energy of a body that nothing acts on; the lowest frequency of a frame of
//! Euler-Bernoulli elements with consistent masses, assembled as a dense matrix. Expected: the same to 1e-10; momenta that stay, with an error that falls
//! with the square of the steps; a frequency to 1e-4. Why: masses of joints, at which branches meet at an angle, are a full matrix, and in the elimination each
//! node must be counted once.

use super::in_space::{MATERIALS, as_tree, assert_same, in_grip, moved, planar};
use crate::beam::trees::setup::four_tips;
use approx::assert_relative_eq;
use nalgebra::{DMatrix, SymmetricEigen};
use peelkit::beam::rotation::{apply, apply_transposed, cross, matrix};
use peelkit::beam::{BeamTree, Branch, BranchRest, BranchingBeam, EndRotation, JointCondition, SpatialStiffness};
use peelkit::solve::time::{Drive, DynamicProblem, DynamicSystem, Motion, StepControl, TimeIntegrator, TimeOptions};
use peelkit::solve::{EndConditions, InitialState, MeasuredBeside, PathMeasure, Problem, State, System, Workspace};
use std::f64::consts::PI;
use std::sync::Arc;

#[test]
fn a_tree_of_one_branch_with_mass_is_the_planar_beam() {
    for viscosity in MATERIALS {
        let planar = planar([1.0, 0.3], viscosity);
        let wanted = moved(&planar.dynamics, planar.statics.initial(14), 150);
        for cuts in [1, 2] {
            let tree = as_tree(viscosity, cuts).with_inertia(|_| [1.0, 0.4, 0.5, 0.3]);
            let at = tree.stress_free(0);
            assert_same(&moved(&in_grip(tree), at, 150), &wanted);
        }
    }
}

/// Mass per length and rotary inertia of a level of the tree of four tips.
const INERTIA: [[f64; 4]; 3] = [[3.0, 6.0, 2.0, 4.0], [2.0, 3.0, 1.0, 2.0], [1.0, 1.0, 0.3, 0.7]];
const END: f64 = 2.0;

/// The tree of four tips, whose root turns freely as well.
fn free_tree() -> BranchingBeam {
    let root = JointCondition { rotation: EndRotation::Free, ..JointCondition::free(0) };
    BranchingBeam { conditions: vec![root], ..four_tips(3, 2) }
}

/// The tree of four tips, one of them bent at rest: it spins about a tilted axis, flies, and swings.
fn flying() -> (BeamTree, State, Vec<f64>) {
    let levels = [0, 1, 1, 2, 2, 2, 2];
    let beam = BranchingBeam { scale: [1.0; 2], ..free_tree() };
    let tree = beam.build().unwrap().with_inertia(|branch| INERTIA[levels[branch]]);
    let at = tree.stress_free(0);
    let (spin, flight) = ([0.3, 0.5, 1.0], [0.2, -0.1, 0.4]);
    let nodes = tree.unknowns(&at) / 6;
    let velocity = at.values[..7 * nodes].chunks_exact(7).flat_map(|node| {
        let place = [node[0], node[1], node[2]];
        let turned = cross(spin, place);
        let swing = 0.05 * (0.4 * node[2]).sin();
        let v: [f64; 3] = std::array::from_fn(|k| flight[k] + turned[k] + swing);
        let turn = apply_transposed(&matrix([node[3], node[4], node[5], node[6]]), &spin);
        [v, turn].concat()
    });
    let velocity = velocity.collect();
    (tree, at, velocity)
}

/// M⁻¹ of forces: M is a block of six for each node, of which the forces of inertia at rest say the columns.
fn accelerated(tree: &BeamTree, at: &State, forces: &[f64]) -> Vec<f64> {
    let still = vec![0.0; forces.len()];
    let masses = tree.masses(at);
    let columns: Vec<Vec<f64>> = (0..6)
        .map(|f| {
            let unit: Vec<f64> = (0..forces.len()).map(|k| if k % 6 == f { 1.0 } else { 0.0 }).collect();
            tree.inertia_forces(at, &masses, &still, &unit)
        })
        .collect();
    let node = |node: usize| {
        let block = DMatrix::from_fn(6, 6, |i, j| columns[j][6 * node + i]);
        let right = DMatrix::from_fn(6, 1, |i, _| forces[6 * node + i]);
        block.lu().solve(&right).unwrap().as_slice().to_vec()
    };
    (0..forces.len() / 6).flat_map(node).collect()
}

fn free(tree: &Arc<BeamTree>) -> DynamicProblem {
    let measure = PathMeasure { monitors: [f64::INFINITY; 2], force: 1.0, beside: MeasuredBeside::Force };
    let problem =
        Problem { system: tree.clone(), grip: EndConditions::drive(1), measure, start: InitialState::StressFree };
    DynamicProblem::new(problem, tree.clone())
}

/// Errors of the energy and of the angular momentum, over these, and of the momentum, at the end of a flight.
fn errors(h: f64) -> [f64; 3] {
    let (tree, at, velocity) = flying();
    let tree = Arc::new(tree);
    let masses = tree.masses(&at);
    let gyroscopic = tree.inertia_forces(&at, &masses, &velocity, &vec![0.0; velocity.len()]);
    let forces: Vec<f64> = tree.residual(&at).iter().zip(&gyroscopic).map(|(r, g)| -r - g).collect();
    let acceleration = accelerated(&tree, &at, &forces);
    let before = tree.momenta(&at, &velocity);
    let problem = free(&tree);
    let motion = Motion::new(0.0, at, velocity, acceleration, Vec::new());
    let options = TimeOptions::new(StepControl::Fixed(h));
    let nothing = Drive::Force(Arc::new(|_| 0.0));
    let mut run = TimeIntegrator::new(&problem, nothing, motion, options, Workspace::default());
    while run.motion().time < END - 1e-9 {
        run.advance(END).unwrap();
    }
    let after = tree.momenta(&run.motion().at, &run.motion().velocity);
    let apart = |k: usize| (0..3).map(|i| (after[k][i] - before[k][i]).abs()).fold(0.0, f64::max);
    assert!(run.balance().stored > 0.01, "it does not bend: {:?}", run.balance());
    let size = |k: usize| before[k].iter().map(|l| l * l).sum::<f64>().sqrt();
    let found = [run.balance().defect(run.start()).abs() / run.start().total(), apart(1) / size(1), apart(0) / size(0)];
    println!("steps of {h}: energy {:.2e}, angular momentum {:.2e}, momentum {:.2e}", found[0], found[1], found[2]);
    found
}

#[test]
fn a_forked_tree_that_flies_keeps_energy_and_momenta() {
    let [coarse, fine] = [0.004, 0.002].map(errors);
    assert!(fine[0] < 1e-4 && fine[1] < 1e-5 && fine[2] < 1e-10, "{fine:?}");
    let order = (coarse[1] / fine[1]).log2();
    assert!((order - 2.0).abs() < 0.4, "order {order:.2}");
}

/// Momentum and spin of a rigid motion, against sums over the branches: the lumped masses of a straight branch have its momentum exactly.
#[test]
fn momenta_of_a_rigid_motion_are_those_of_its_branches() {
    let mut straight = free_tree();
    let levels = [0, 1, 1, 2, 2, 2, 2];
    if let BranchRest::Curve(rest) = &mut straight.branches[6].rest {
        rest.curvature = [0.0; 3];
    }
    let tree = straight.build().unwrap().with_inertia(|branch| INERTIA[levels[branch]]);
    let at = tree.stress_free(0);
    let (spin, flight) = ([0.3, -0.5, 1.0], [0.2, -0.1, 0.4]);
    let nodes = tree.unknowns(&at) / 6;
    let velocity: Vec<f64> = at.values[..7 * nodes]
        .chunks_exact(7)
        .flat_map(|node| {
            let turned = cross(spin, [node[0], node[1], node[2]]);
            let v: [f64; 3] = std::array::from_fn(|k| flight[k] + turned[k]);
            let turn = apply_transposed(&matrix([node[3], node[4], node[5], node[6]]), &spin);
            [v, turn].concat()
        })
        .collect();
    let mut wanted = [[0.0; 3]; 2];
    let mut kinetic = 0.0;
    for (branch, level) in straight.branches.iter().zip(levels) {
        let [mass, moments @ ..] = INERTIA[level].map(|x| x * branch.length);
        let axes = matrix(branch.rest.at(0.0).1);
        let along: [f64; 3] = std::array::from_fn(|k| axes[k][0]);
        let (start, _) = branch.rest.at(0.0);
        // Simpson's rule is exact of what is quadratic along a branch
        for (share, part) in [(1.0 / 6.0, 0.0), (4.0 / 6.0, 0.5), (1.0 / 6.0, 1.0)] {
            let place: [f64; 3] = std::array::from_fn(|k| start[k] + part * branch.length * along[k]);
            let turned = cross(spin, place);
            let v: [f64; 3] = std::array::from_fn(|k| flight[k] + turned[k]);
            let turn = apply_transposed(&axes, &spin);
            let own = apply(&axes, &std::array::from_fn(|k| moments[k] * turn[k]));
            let about = cross(place, v);
            for k in 0..3 {
                wanted[0][k] += share * mass * v[k];
                wanted[1][k] += share * (mass * about[k] + own[k]);
                kinetic += 0.5 * share * (mass * v[k] * v[k] + moments[k] * turn[k] * turn[k]);
            }
        }
    }
    let found = tree.momenta(&at, &velocity);
    for (found, wanted) in found.iter().flatten().zip(wanted.iter().flatten()) {
        assert_relative_eq!(found, wanted, max_relative = 1e-12, epsilon = 1e-12);
    }
    assert_relative_eq!(tree.kinetic_energy(&at, &[], &velocity), kinetic, max_relative = 1e-12);
}

const STEM: f64 = 10.0;
const TWIG: f64 = 6.0;
const BENDING: [f64; 2] = [400.0, 60.0];
const MASS: [f64; 2] = [3.0, 1.0];
const AXIAL: f64 = 1e5;

/// Ends of the three branches in the plane of x and z.
fn fork() -> [([f64; 2], [f64; 2], usize); 3] {
    let (sin, cos) = 40f64.to_radians().sin_cos();
    let top = |sign: f64| [sign * TWIG * sin, STEM + TWIG * cos];
    [([0.0, 0.0], [0.0, STEM], 0), ([0.0, STEM], top(-1.0), 1), ([0.0, STEM], top(1.0), 1)]
}

/// The lowest frequency, rad per unit of time, of a frame of so many Euler-Bernoulli elements a branch, held at its root.
fn frame(elements: usize) -> f64 {
    // nodes: the root, the fork, then those inside of the branches and their ends
    let (mut nodes, mut all) = (2, Vec::new());
    for (b, (from, to, level)) in fork().into_iter().enumerate() {
        let length = (to[0] - from[0]).hypot(to[1] - from[1]) / elements as f64;
        let (c, s) = ((to[0] - from[0]) / length / elements as f64, (to[1] - from[1]) / length / elements as f64);
        let mut last = if b == 0 { 0 } else { 1 };
        for k in 0..elements {
            let next = if b == 0 && k + 1 == elements {
                1
            } else {
                nodes += 1;
                nodes - 1
            };
            all.push((last, next, length, c, s, level));
            last = next;
        }
    }
    let (mut k, mut m) = (DMatrix::<f64>::zeros(3 * nodes, 3 * nodes), DMatrix::<f64>::zeros(3 * nodes, 3 * nodes));
    for (from, to, l, c, s, level) in all {
        let (ei, mass) = (BENDING[level], MASS[level] * l / 420.0);
        let (a, b) = (AXIAL / l, ei / l.powi(3));
        #[rustfmt::skip]
        let stiffness = DMatrix::from_row_slice(6, 6, &[
            a, 0.0, 0.0, -a, 0.0, 0.0,
            0.0, 12.0 * b, 6.0 * b * l, 0.0, -12.0 * b, 6.0 * b * l,
            0.0, 6.0 * b * l, 4.0 * b * l * l, 0.0, -6.0 * b * l, 2.0 * b * l * l,
            -a, 0.0, 0.0, a, 0.0, 0.0,
            0.0, -12.0 * b, -6.0 * b * l, 0.0, 12.0 * b, -6.0 * b * l,
            0.0, 6.0 * b * l, 2.0 * b * l * l, 0.0, -6.0 * b * l, 4.0 * b * l * l,
        ]);
        #[rustfmt::skip]
        let masses = mass * DMatrix::from_row_slice(6, 6, &[
            140.0, 0.0, 0.0, 70.0, 0.0, 0.0,
            0.0, 156.0, 22.0 * l, 0.0, 54.0, -13.0 * l,
            0.0, 22.0 * l, 4.0 * l * l, 0.0, 13.0 * l, -3.0 * l * l,
            70.0, 0.0, 0.0, 140.0, 0.0, 0.0,
            0.0, 54.0, 13.0 * l, 0.0, 156.0, -22.0 * l,
            0.0, -13.0 * l, -3.0 * l * l, 0.0, -22.0 * l, 4.0 * l * l,
        ]);
        let mut turn = DMatrix::zeros(6, 6);
        for end in [0, 3] {
            (turn[(end, end)], turn[(end, end + 1)]) = (c, s);
            (turn[(end + 1, end)], turn[(end + 1, end + 1)]) = (-s, c);
            turn[(end + 2, end + 2)] = 1.0;
        }
        let (stiffness, masses) = (turn.transpose() * stiffness * &turn, turn.transpose() * masses * &turn);
        let place = |i: usize| if i < 3 { 3 * from + i } else { 3 * to + i - 3 };
        for i in 0..6 {
            for j in 0..6 {
                k[(place(i), place(j))] += stiffness[(i, j)];
                m[(place(i), place(j))] += masses[(i, j)];
            }
        }
    }
    let (k, m) = (k.remove_rows(0, 3).remove_columns(0, 3), m.remove_rows(0, 3).remove_columns(0, 3));
    let lower = m.cholesky().unwrap().l();
    let half = lower.solve_lower_triangular(&k).unwrap();
    let whole = lower.solve_lower_triangular(&half.transpose()).unwrap();
    let lowest: f64 = SymmetricEigen::new(0.5 * (&whole + whole.transpose())).eigenvalues.min();
    lowest.sqrt()
}

/// Slender branches, hardly sheared and with next to no rotary inertia. First the lowest frequency of its stiffness, by differences of the residual, and its
/// masses; then the same mode followed in time over a period of the frame: what is left of its place says by how much the phase is off.
#[test]
fn the_lowest_frequency_of_a_fork_is_that_of_a_frame() {
    let [coarse, fine] = [8, 16].map(frame);
    assert_relative_eq!(coarse, fine, max_relative = 1e-5);
    let stiffness = |level: usize| {
        let ei = BENDING[level];
        SpatialStiffness::diagonal(AXIAL, [1e7; 2], 100.0 * ei, [ei, ei])
    };
    let branch = |joints: [usize; 2], (from, to, level): ([f64; 2], [f64; 2], usize)| {
        let ends = [from, to].map(|[x, z]| [x, 0.0, z]);
        Branch::straight(joints, ends, [0.0, 1.0, 0.0], stiffness(level), 4)
    };
    let [stem, left, right] = fork();
    let branches = vec![branch([0, 1], stem), branch([1, 2], left), branch([1, 3], right)];
    let beam = BranchingBeam { order: 4, scale: [1e-2, 1e-2], ..BranchingBeam::new(branches, 0) };
    let rotary = 1e-6;
    let tree = beam.build().unwrap().with_inertia(|b| [MASS[usize::from(b > 0)], rotary, rotary, rotary]);
    let tree = Arc::new(tree);
    let at = tree.stress_free(0);
    // the mode, by inverse iteration with dense matrices of differences
    let n = tree.unknowns(&at);
    let masses = tree.masses(&at);
    let step = 1e-5;
    let column = |k: usize| {
        let ahead = |sign: f64| {
            let mut unit = vec![0.0; n];
            unit[k] = sign;
            let mut moved = at.clone();
            tree.retract(&mut moved, &unit, step);
            tree.residual(&moved)
        };
        let (up, down) = (ahead(1.0), ahead(-1.0));
        (0..n).map(|i| (up[i] - down[i]) / (2.0 * step)).collect::<Vec<f64>>()
    };
    let mut stiffness = DMatrix::from_fn(n, n, |_, _| 0.0);
    for k in 0..n {
        stiffness.set_column(k, &nalgebra::DVector::from_vec(column(k)));
    }
    for k in 0..6 {
        stiffness.row_mut(k).fill(0.0);
        stiffness.column_mut(k).fill(0.0);
        stiffness[(k, k)] = 1.0;
    }
    let factors = stiffness.lu();
    // in the plane
    let mut mode = nalgebra::DVector::from_fn(n, |k, _| if k >= 6 && k % 6 == 0 { 1.0 } else { 0.0 });
    let mut frequency = 0.0;
    for _ in 0..60 {
        let loaded = nalgebra::DVector::from_fn(n, |k, _| if k < 6 { 0.0 } else { masses[k] * mode[k] });
        let next = factors.solve(&loaded).unwrap();
        frequency = (loaded.dot(&mode) / loaded.dot(&next)).sqrt();
        mode = &next / next.amax();
    }
    println!("frame {fine:.9}, tree {frequency:.9}");
    assert_relative_eq!(frequency, fine, max_relative = 1e-4);
    // a period of it in time
    let (period, amplitude) = (2.0 * PI / fine, 1e-4);
    let velocity: Vec<f64> = mode.iter().enumerate().map(|(k, x)| if k < 6 { 0.0 } else { amplitude * x }).collect();
    let measure = PathMeasure { monitors: [f64::INFINITY; 2], force: 1.0, beside: MeasuredBeside::Force };
    let grip = EndConditions { held: [true, false, true, true, true, true], ..EndConditions::drive(1) };
    let problem = Problem { system: tree.clone(), grip, measure, start: InitialState::StressFree };
    let problem = DynamicProblem::new(problem, tree.clone());
    let motion = Motion::new(0.0, at.clone(), velocity.clone(), vec![0.0; n], Vec::new());
    let options =
        TimeOptions { spectral_radius: 1.0, newton: 1e-13, ..TimeOptions::new(StepControl::Fixed(period / 400.0)) };
    let still = Drive::Displacement(Arc::new(|_| Default::default()));
    let mut run = TimeIntegrator::new(&problem, still, motion, options, Workspace::default());
    while run.motion().time < period * (1.0 - 1e-9) {
        run.advance(period).unwrap();
    }
    // what is left of the place says by how much the phase is off
    let left = tree.difference(&at.values, &run.motion().at.values);
    let k = (6..n).max_by(|&a, &b| velocity[a].abs().total_cmp(&velocity[b].abs())).unwrap();
    let off = left[k] * fine / velocity[k] / (2.0 * PI);
    println!("phase off by {off:.2e} of a period");
    assert!(off.abs() < 1e-4, "{off:.2e}");
    assert_relative_eq!(run.motion().velocity[k], velocity[k], max_relative = 1e-4);
}
