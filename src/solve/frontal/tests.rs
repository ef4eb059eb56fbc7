//! A forest of elements that are no beams: a star of three branches, one of which is reversed, with two unknowns a node.
//!
//! ```text
//!   o--o--o--+--o--o root          each -- an element of order 1 to 4 with a random matrix, symmetric or not
//!            |
//!            o  held in its first unknown
//! ```
//!
//! Reference: the same elements added up to a dense matrix, its LU decomposition and its eigenvalues (nalgebra). Expected: the same solutions of
//! the system and of its transpose, the same functional of the solution, to 1e-10 of their size, and, of a symmetric one, as many negative eigenvalues
//! with the root held. Why: the elimination does without pivoting, by Sylvester's law.

use super::eliminate::{FrontalFactors, Fronts};
use super::forest::{Bundle, Forest, Piece};
use super::frontal_matrix::FrontalMatrix;
use super::nodes::{AnyNumber, Nodes, slot};
use crate::number::F64x4;
use crate::solve::error::Place;
use crate::solve::system::NodalTerms;
use nalgebra::{DMatrix, DVector};
use std::sync::Arc;

const F: usize = 2;
/// Joints: the centre, the root, the held tip, the free tip
const JOINTS: usize = 4;
const OFF: f64 = 0.3;

/// Branches from joint to joint, from left to right, with their elements; which end is near to the root.
const BRANCHES: [([usize; 2], usize, usize); 3] = [([0, 1], 5, 1), ([0, 2], 1, 0), ([3, 0], 2, 1)];

struct Star {
    forest: Forest,
    nodes: usize,
    symmetric: bool,
    /// Matrix, gradient and functional of each element, nodes from left to right
    elements: Vec<(DMatrix<f64>, DVector<f64>, DVector<f64>)>,
}

/// Numbers between -1 and 1 that are always the same.
fn numbers(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed.wrapping_mul(2_862_933_555_777_941_757).wrapping_add(3_037_000_493);
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

impl Star {
    fn new(order: usize, shift: f64, symmetric: bool) -> Self {
        let (mut pieces, mut numbered, mut nodes) = (Vec::new(), Vec::new(), JOINTS);
        for (joints, elements, near) in BRANCHES {
            let first = pieces.len();
            let node = |k: usize| match k {
                0 => joints[0],
                k if k == elements * order => joints[1],
                k => nodes + k - 1,
            };
            for e in 0..elements {
                let (left, right) = (node(e * order), node((e + 1) * order));
                let is_last = if near == 1 { e + 1 == elements } else { e == 0 };
                pieces.push(Piece {
                    ends: if near == 1 { [left, right] } else { [right, left] },
                    near,
                    inside: nodes + e * order,
                    from: joints[1 - near],
                    onto: if is_last { joints[near] } else { joints[1 - near] },
                    is_first: if near == 1 { e == 0 } else { e + 1 == elements },
                });
            }
            nodes += elements * order - 1;
            let own: Vec<usize> = (first..pieces.len()).collect();
            numbered.push(own);
        }
        // those that are carried first: the two tips, then the way to the root
        let bundles = [2, 1, 0].iter().flat_map(|&b: &usize| numbered[b].chunks(4).map(Bundle::of)).collect();
        let (size, mut next) = ((order + 1) * F, numbers(order as u64));
        let elements = (0..pieces.len()).map(|_| {
            let half = DMatrix::from_fn(size, size, |_, _| next());
            let other = if symmetric { half.transpose() } else { DMatrix::from_fn(size, size, |_, _| next()) };
            let matrix = &half + other + DMatrix::identity(size, size) * shift;
            (matrix, DVector::from_fn(size, |_, _| next()), DVector::from_fn(size, |_, _| next()))
        });
        Self {
            elements: elements.collect(),
            forest: Forest { order, pieces, bundles, joints: JOINTS, root: [1, 1] },
            nodes,
            symmetric,
        }
    }

    fn node(&self, e: usize, rank: usize) -> usize {
        let piece = &self.forest.pieces[e];
        let [left, right] = piece.left_and_right();
        match rank {
            0 => left,
            r if r == self.forest.order => right,
            r => piece.inside + r - 1,
        }
    }

    /// The dense system, its right-hand side, and the functional.
    fn dense(&self, added: &[f64]) -> (DMatrix<f64>, DVector<f64>, DVector<f64>) {
        let n = self.nodes * F;
        let (mut matrix, mut right, mut path) = (DMatrix::zeros(n, n), DVector::zeros(n), DVector::zeros(n));
        for (e, (own, gradient, functional)) in self.elements.iter().enumerate() {
            let place = |i: usize| self.node(e, i / F) * F + i % F;
            for i in 0..own.nrows() {
                right[place(i)] += gradient[i];
                path[place(i)] += functional[i];
                (0..own.ncols()).for_each(|j| matrix[(place(i), place(j))] += own[(i, j)]);
            }
        }
        (JOINTS * F..n).for_each(|i| matrix[(i, i)] += added[i]);
        let held = 2 * F;
        matrix.row_mut(held).fill(0.0);
        (matrix[(held, held)], right[held]) = (1.0, OFF);
        (matrix, right, path)
    }
}

impl Fronts<F> for Star {
    type Room = ();

    fn write(&self, nodes: impl Nodes, bundle: usize, (): &mut (), front: &mut FrontalMatrix<F64x4, F>) -> [F64x4; 2] {
        for (l, &e) in self.forest.bundles[bundle].lanes.iter().enumerate() {
            let (matrix, gradient, path) = &self.elements[e];
            let place = |i: usize| (slot(nodes.count(), i / F), i % F);
            for i in 0..matrix.nrows() {
                let (a, f) = place(i);
                front.rows[a][f].residual.0[l] = gradient[i];
                front.path.fields[a][f].0[l] = path[i];
                for j in 0..matrix.ncols() {
                    let (b, g) = place(j);
                    front.rows[a][f].fields[b][g].0[l] = matrix[(i, j)];
                }
            }
            front.path.residual.0[l] = 0.0;
        }
        [F64x4([1.0; 4]), F64x4([2.0; 4])]
    }

    fn is_symmetric(&self) -> bool {
        self.symmetric
    }

    fn off(&self, joint: usize) -> [Option<f64>; F] {
        [(joint == 2).then_some(OFF), None]
    }

    fn place(&self, element: usize) -> Place {
        Place { element, position: element as f64 }
    }
}

#[test]
fn a_star_is_solved_both_ways_with_its_inertia_and_its_functional() {
    let cases = [(1, 4.0), (2, 0.5), (3, -3.0), (4, 1.0)];
    for ((order, shift), symmetric) in cases.into_iter().flat_map(|case| [(case, true), (case, false)]) {
        let star = Star::new(order, shift, symmetric);
        let added: Vec<f64> = (0..star.nodes * F).map(|k| 0.1 * (k % 7) as f64).collect();
        let (matrix, right, path) = star.dense(&added);
        let mut factors = FrontalFactors::<F>::default();
        assert!(factors.begin(Arc::new(star.forest.clone())).iter().all(|own| own.residual == [0.0; F]));
        let added = NodalTerms { stiffness: &added, force: &[] };
        let found = factors.eliminate::<_, AnyNumber>(&star, added, &mut ()).unwrap();
        let count = star.elements.len() as f64;
        assert_eq!(found.integrals, [count, 2.0 * count]);

        let root = DMatrix::from_fn(F, F, |i, j| found.root.tangent[i][j]);
        let solved = root.clone().lu().solve(&DVector::from_row_slice(&found.root.residual)).unwrap();
        let mut direction = vec![0.0; star.nodes * F];
        factors.recover(&[solved[0], solved[1]], 1.0, &mut direction);
        let wanted = matrix.clone().lu().solve(&right).unwrap();
        let largest = wanted.amax();
        let miss = (DVector::from(direction) - &wanted).amax();
        assert!(miss < 1e-10 * largest, "order {order}: {miss} of {largest}");
        let functional = -found.root.path_residual + DVector::from_row_slice(&found.root.path).dot(&solved);
        let miss = (functional - path.dot(&wanted)).abs();
        assert!(miss < 1e-10 * largest * path.amax(), "order {order}, functional: {miss}");

        let mut next = numbers(99);
        let other = DVector::from_fn(star.nodes * F, |_, _| next());
        for transposed in [false, true] {
            let (dense, own) =
                if transposed { (matrix.transpose(), root.transpose()) } else { (matrix.clone(), root.clone()) };
            let wanted = dense.lu().solve(&other).unwrap();
            let mut found: Vec<f64> = other.iter().copied().collect();
            let reduced = factors.reduce(&mut found, transposed);
            let at_root = own.lu().solve(&DVector::from_row_slice(&reduced)).unwrap();
            factors.substitute(&[at_root[0], at_root[1]], &mut found, transposed);
            let miss = (DVector::from(found) - &wanted).amax();
            assert!(miss < 1e-10 * wanted.amax(), "order {order}, transposed {transposed}: {miss}");
        }

        let free: Vec<usize> = (0..star.nodes * F).filter(|&k| k / F != 1 && k != 2 * F).collect();
        let inside = matrix.select_rows(&free).select_columns(&free);
        if symmetric {
            let negative = inside.symmetric_eigenvalues().iter().filter(|value| **value < 0.0).count();
            assert_eq!(found.negative, negative, "order {order}");
        }
    }
}
