//! The residual of a tree is the gradient of its energy, its tangent that of the residual, and what is eliminated solves the dense system.
//!
//! Parameters: the tree of four tips, one of them clamped, one pinned, one with a force and a moment and one with an energy of its place and
//! rotation; a force at the fork; orders 1 and 3; moved by up to 0.2 nm and rad at every node. Reference: central differences along each
//! unknown; dense solutions and dense eigenvalues of nalgebra. Expected: differences agree to their own error, solutions to 1e-9 of their
//! size, and inertia exactly, in a stable state and in unstable ones.

use super::setup::{four_tips, moved, pseudo_random};
use approx::assert_abs_diff_eq;
use nalgebra::{DMatrix, DVector, Matrix6, Vector6};
use peelkit::beam::rotation::{Quaternion, apply_transposed, cross, matrix};
use peelkit::beam::{BeamTree, EndEnergy, EndResponse, JointCondition, JointUnknown, SpatialFactors, TreeMonitor};
use peelkit::solve::{State, System};
use std::sync::Arc;

/// A spring to a place, and the projection of the axis on a direction: E = ½ k |r - c|² - t d1·e. With d1 turned by exp(φ) to second order,
/// R (e1 + φ × e1 + ½ φ × (φ × e1)).
#[derive(Debug)]
struct Spring {
    stiffness: f64,
    center: [f64; 3],
    pull: f64,
    towards: [f64; 3],
}

impl EndEnergy for Spring {
    fn response(&self, place: [f64; 3], directors: Quaternion) -> EndResponse {
        let r = matrix(directors);
        let [g0, g1, g2] = apply_transposed(&r, &self.towards);
        let mut out = EndResponse::default();
        for i in 0..3 {
            let off = place[i] - self.center[i];
            out.energy += 0.5 * self.stiffness * off * off;
            out.gradient[i] = self.stiffness * off;
            out.hessian[i][i] = self.stiffness;
        }
        out.energy -= self.pull * g0;
        // e1·(φ × ·): g·(φ × e1) = φ·(e1 × g)
        let by_turn = cross([1.0, 0.0, 0.0], [g0, g1, g2]);
        // g·½(φ (φ·e1) - e1 φ²)
        let e = [1.0, 0.0, 0.0];
        for i in 0..3 {
            out.gradient[3 + i] = -self.pull * by_turn[i];
            for j in 0..3 {
                let g = [g0, g1, g2];
                let same = if i == j { g0 } else { 0.0 };
                out.hessian[3 + i][3 + j] = -self.pull * (0.5 * (g[i] * e[j] + e[i] * g[j]) - same);
            }
        }
        out
    }
}

fn tree(order: usize, moment: f64) -> BeamTree {
    let mut beam = four_tips(order, 2);
    let spring = Spring { stiffness: 3.0, center: [5.0, 0.5, 20.0], pull: 4.0, towards: [0.4, 0.2, -1.0] };
    let mut axes = JointCondition::pinned(3, [-5.0, -2.0, 17.0]);
    axes.axes = [[0.6, -0.8, 0.0], [0.8, 0.6, 0.0], [0.0, 0.0, 1.0]];
    let mut turning = JointCondition::loaded(7, [0.3, 0.2, -0.5], [0.0; 3]);
    turning.rotation = peelkit::beam::EndRotation::Angles;
    beam.conditions = vec![
        JointCondition::clamped(4, [-4.0, 2.0, 18.0]),
        axes,
        JointCondition::loaded(5, [1.0, -2.0, 3.0], [0.5 * moment, moment, -moment]),
        JointCondition::with_energy(6, Arc::new(spring)),
        turning,
    ];
    beam.monitors = [(3, 1), (7, 4)].map(|(joint, slot)| Some(TreeMonitor::Joint(JointUnknown { joint, slot })));
    beam.build().unwrap()
}

pub(super) fn dense(tree: &BeamTree, at: &State) -> DMatrix<f64> {
    let n = tree.unknowns(at);
    let mut all = DMatrix::zeros(n, n);
    tree.tangent_entries(at).into_iter().for_each(|(row, column, value)| all[(row, column)] += value);
    all
}

/// What a step ahead and a step back along an unknown give.
pub(super) fn difference<T>(
    tree: &BeamTree,
    at: &State,
    (unknown, step): (usize, f64),
    of: impl Fn(&State) -> T,
    less: impl Fn(T, T) -> T,
) -> T {
    let mut direction = vec![0.0; tree.unknowns(at)];
    direction[unknown] = 1.0;
    let go = |factor: f64| {
        let mut next = at.clone();
        tree.retract(&mut next, &direction, factor);
        of(&next)
    };
    less(go(step), go(-step))
}

/// Joints of this tree whose rotation is counted by angles.
const WITH_ANGLES: [usize; 4] = [0, 3, 4, 7];

/// The residual by a turn is that in the directors as they are, which turn along: exp(φ) exp(ε) is the turn by φ + ε + ½ φ × ε. So the difference
/// of residuals has ½ g·(e_j × e_i) beside the second derivative by φ_i and φ_j, for the gradient g by the turn; it is taken off.
pub(super) fn add_turn(column: &mut DVector<f64>, reactions: &[f64], unknown: usize, with_angles: &[usize]) {
    let (node, j) = (unknown / 6, unknown % 6);
    if j < 3 || with_angles.contains(&node) {
        return;
    }
    let g = [3, 4, 5].map(|k| reactions[6 * node + k]);
    let mut axis = [0.0; 3];
    axis[j - 3] = 1.0;
    // g·(e_j × e_i) = e_i·(g × e_j)
    let across = cross(g, axis);
    (0..3).for_each(|i| column[6 * node + 3 + i] -= 0.5 * across[i]);
}

#[test]
fn the_residual_is_the_gradient_of_the_energy() {
    for order in [1, 3] {
        let tree = tree(order, 0.0);
        let at = moved(&tree, 0.2);
        let reactions = tree.reactions(&at);
        let largest = reactions.iter().fold(0.0f64, |most, r| most.max(r.abs()));
        for unknown in 0..tree.unknowns(&at) {
            let slope = difference(&tree, &at, (unknown, 1e-5), |at| tree.energy(at), |a, b| (a - b) / 2e-5);
            assert_abs_diff_eq!(slope, reactions[unknown], epsilon = 3e-8 * largest);
        }
    }
}

#[test]
fn the_tangent_is_the_derivative_of_the_residual() {
    for (order, moment) in [(1, 0.7), (3, 0.0), (3, 0.7)] {
        let tree = tree(order, moment);
        let at = moved(&tree, 0.2);
        let tangent = dense(&tree, &at);
        let (largest, reactions) = (tangent.abs().max(), tree.reactions(&at));
        for unknown in 0..tree.unknowns(&at) {
            let mut column =
                difference(&tree, &at, (unknown, 1e-5), |at| DVector::from(tree.residual(at)), |a, b| (a - b) / 2e-5);
            add_turn(&mut column, &reactions, unknown, &WITH_ANGLES);
            let miss = (column - tangent.column(unknown)).abs().max();
            assert!(miss < 1e-7 * largest, "order {order}, unknown {unknown}: {miss} of {largest}");
        }
    }
}

#[test]
fn elimination_solves_the_dense_system_and_its_transpose() {
    for (order, moment) in [(1, 0.7), (3, 0.0), (4, 0.7)] {
        let tree = tree(order, moment);
        let at = moved(&tree, 0.2);
        let (n, mut factors) = (tree.unknowns(&at), SpatialFactors::default());
        let condensed = tree.eliminate(&at, [0.3, -0.2], 0.0, &mut factors).unwrap();
        let root = Matrix6::from_fn(|i, j| condensed.root.tangent[i][j]);
        let tangent = dense(&tree, &at);
        // a right-hand side, both ways
        for transposed in [false, true] {
            let right = pseudo_random(n);
            let (dense, own) =
                if transposed { (tangent.transpose(), root.transpose()) } else { (tangent.clone(), root) };
            let wanted = dense.lu().solve(&DVector::from(right.clone())).unwrap();
            let mut found = right;
            let reduced = factors.reduce(&mut found, transposed);
            let at_root = own.lu().solve(&Vector6::from(reduced)).unwrap();
            factors.substitute(&at_root.into(), &mut found, transposed);
            let miss = (DVector::from(found) - &wanted).abs().max() / wanted.abs().max();
            assert!(miss < 1e-9, "order {order}, transposed {transposed}: {miss}");
        }
        // the residual and the monitors carried along
        let residual = DVector::from(tree.residual(&at));
        let inverse = tangent.lu();
        let wanted = inverse.solve(&residual).unwrap();
        let column = Vector6::from_fn(|i, _| condensed.root.residual[i]);
        let mut found = vec![0.0; n];
        factors.recover(&root.lu().solve(&column).unwrap().into(), 1.0, &mut found);
        assert!((DVector::from(found) - &wanted).abs().max() < 1e-9 * wanted.abs().max());
        let gradient = DVector::from(tree.gradient(&at, [0.3, -0.2]));
        let row = nalgebra::RowVector6::from_fn(|_, j| condensed.root.path[j]);
        // g·K⁻¹R from what is left of the path row
        let left = -condensed.root.path_residual + (row * root.lu().solve(&column).unwrap())[0];
        assert_abs_diff_eq!(left, gradient.dot(&wanted), epsilon = 1e-9 * wanted.abs().max());
    }
}

#[test]
fn inertia_is_that_of_the_dense_matrix() {
    for order in [1, 3] {
        let tree = tree(order, 0.0);
        let mut seen = Vec::new();
        for by in [0.0, 0.1, 0.3, 0.6, 1.0] {
            let at = moved(&tree, by);
            let found = tree.eliminate(&at, [0.0; 2], 0.0, &mut SpatialFactors::default()).unwrap();
            let tangent = dense(&tree, &at);
            let is_held = |unknown: usize| {
                let row = tangent.row(unknown);
                unknown / 6 == tree.root() || row.iter().filter(|entry| **entry != 0.0).count() == 1
            };
            let free: Vec<usize> = (0..tree.unknowns(&at)).filter(|&unknown| !is_held(unknown)).collect();
            let inside = tangent.select_rows(&free).select_columns(&free);
            let wanted = inside.symmetric_eigenvalues().iter().filter(|value| **value < 0.0).count();
            assert_eq!(found.negative, wanted, "order {order}, moved by {by}");
            seen.push(wanted);
        }
        assert!(seen[0] == 0 && seen.iter().any(|&count| count > 3), "{seen:?}");
    }
}
