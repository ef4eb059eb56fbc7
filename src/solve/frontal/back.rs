//! Any number of right-hand sides through a forest that is eliminated: K = L D U, of a symmetric tangent with L = Uᵀ, but for the rows of what is held
//! of joints, which were replaced behind the elimination of the interior of their element.

use super::eliminate::FrontalFactors;
use super::forest::{Forest, Piece};
use super::interior::{Interior, OfNodes, packed_length};
use super::nodes::MOST_NODES;
use crate::number::{F64x4, Real};

impl<const F: usize> FrontalFactors<F> {
    /// The direction that solves K q = `scale` R with the root known.
    pub(crate) fn recover(&self, root: &[f64; F], scale: f64, out: &mut [f64]) {
        out[self.forest.root[1] * F..][..F].copy_from_slice(root);
        recover(self, scale, out);
    }

    /// Takes a right-hand side down to the root.
    pub(crate) fn reduce(&self, right: &mut [f64], transposed: bool) -> [f64; F] {
        let (order, mut x) = (self.forest.order, [[0.0; F]; MOST_NODES]);
        for (e, b, l) in self.forest.inwards() {
            // plain, the equations of what is held do not take part
            let piece = &self.forest.pieces[e];
            take(piece, order, right, &mut x);
            self.interior(b).forward(l, &mut x, &self.taking_part(piece, !transposed), transposed);
            put_inside(piece, order, &x, right);
            for (end, node) in piece.left_and_right().into_iter().enumerate() {
                right[node * F..][..F].copy_from_slice(&x[order - 1 + end]);
            }
            self.end_forward(e, right, transposed);
        }
        std::array::from_fn(|f| right[self.forest.root[1] * F + f])
    }

    /// From a reduced right-hand side and the solution at the root to the whole.
    pub(crate) fn substitute(&self, root: &[f64; F], right: &mut [f64], transposed: bool) {
        right[self.forest.root[1] * F..][..F].copy_from_slice(root);
        let (order, mut x) = (self.forest.order, [[0.0; F]; MOST_NODES]);
        for (e, b, l) in self.forest.inwards().rev() {
            self.end_backward(e, right, transposed);
            // transposed, what is held does not act on the interior
            let piece = &self.forest.pieces[e];
            take(piece, order, right, &mut x);
            self.interior(b).backward(l, &mut x, &self.taking_part(piece, transposed), transposed);
            put_inside(piece, order, &x, right);
        }
    }

    fn interior(&self, bundle: usize) -> Interior<'_, F> {
        let length = packed_length::<F>(self.forest.order);
        let own = bundle * length..(bundle + 1) * length;
        let rows = &self.inside[own.clone()];
        let columns = if self.columns.is_empty() { rows } else { &self.columns[own] };
        Interior::new(self.forest.order, rows, columns)
    }

    /// Which unknowns of the left and the right end of an element take part: all, or all `but_held`.
    fn taking_part(&self, piece: &Piece, but_held: bool) -> [[bool; F]; 2] {
        let mut all = [[true; F]; 2];
        if but_held && piece.is_first {
            all[1 - piece.near] = self.held[piece.from].map(|held| !held);
        }
        all
    }

    fn end_forward(&self, e: usize, right: &mut [f64], transposed: bool) {
        let (rows, below, [far, near]) = (&self.ends[e], &self.below[e], places::<F>(&self.forest, e));
        for k in 0..F {
            let [own, other] = &rows[k].ends;
            let share = right[far + k] * own[k];
            if transposed {
                right[far + k] = share;
                (k + 1..F).for_each(|i| right[far + i] -= own[i] * share);
                (0..F).for_each(|i| right[near + i] -= other[i] * share);
            } else {
                (k + 1..F).for_each(|i| right[far + i] -= rows[i].ends[0][k] * share);
                (0..F).for_each(|i| right[near + i] -= below[i][k] * share);
            }
        }
    }

    fn end_backward(&self, e: usize, right: &mut [f64], transposed: bool) {
        let (rows, below, [far, near]) = (&self.ends[e], &self.below[e], places::<F>(&self.forest, e));
        for k in (0..F).rev() {
            let ([own, other], mut taken) = (&rows[k].ends, 0.0);
            if transposed {
                (k + 1..F).for_each(|i| taken += rows[i].ends[0][k] * right[far + i]);
                (0..F).for_each(|i| taken += below[i][k] * right[near + i]);
                right[far + k] -= taken * own[k];
            } else {
                (k + 1..F).for_each(|i| taken += own[i] * right[far + i]);
                (0..F).for_each(|i| taken += other[i] * right[near + i]);
                right[far + k] = (right[far + k] - taken) * own[k];
            }
        }
    }

    #[inline(always)]
    fn recover_bundles(&self, scale: f64, out: &mut [f64]) {
        let (order, mut x) = (self.forest.order, [[F64x4::splat(0.0); F]; MOST_NODES]);
        for (b, own) in self.forest.bundles.iter().enumerate().rev() {
            // behind one another in a branch, the first is the farthest from the root
            for &e in own.lanes[..own.count].iter().rev() {
                self.recover_end(e, scale, out);
            }
            for (l, &e) in own.lanes.iter().enumerate().take(own.count) {
                for (end, node) in self.forest.pieces[e].left_and_right().into_iter().enumerate() {
                    (0..F).for_each(|f| x[order - 1 + end][f].0[l] = out[node * F + f]);
                }
            }
            self.interior(b).recover(scale, &mut x);
            for (l, &e) in own.lanes.iter().enumerate().take(own.count) {
                let inside = self.forest.pieces[e].inside * F;
                for (node, out) in out[inside..][..(order - 1) * F].as_chunks_mut::<F>().0.iter_mut().enumerate() {
                    (0..F).for_each(|f| out[f] = x[node][f].0[l]);
                }
            }
        }
    }

    /// The far end of an element, the near one being known.
    #[inline(always)]
    fn recover_end(&self, e: usize, scale: f64, out: &mut [f64]) {
        let (rows, [far, near]) = (&self.ends[e], places::<F>(&self.forest, e));
        for k in (0..F).rev() {
            let mut sum = scale * rows[k].residual;
            for j in 0..F {
                sum -= rows[k].ends[1][j] * out[near + j];
            }
            for j in k + 1..F {
                sum -= rows[k].ends[0][j] * out[far + j];
            }
            out[far + k] = sum * rows[k].ends[0][k];
        }
    }
}

/// [`FrontalFactors::recover_bundles`] compiled for the vector units that the machine may have, chosen when it runs.
#[cfg_attr(
    not(any(test, feature = "portable", debug_assertions)),
    multiversion::multiversion(targets("x86_64+avx2+fma"))
)]
fn recover<const F: usize>(factors: &FrontalFactors<F>, scale: f64, out: &mut [f64]) {
    factors.recover_bundles(scale, out);
}

/// Where the far and the near end of an element stand in a direction.
#[inline(always)]
fn places<const F: usize>(forest: &Forest, e: usize) -> [usize; 2] {
    forest.pieces[e].ends.map(|node| node * F)
}

/// Takes the unknowns of an element, in elimination order.
fn take<const F: usize>(piece: &Piece, order: usize, all: &[f64], own: &mut OfNodes<f64, F>) {
    own[..order - 1].as_flattened_mut().copy_from_slice(&all[piece.inside * F..][..(order - 1) * F]);
    for (end, node) in piece.left_and_right().into_iter().enumerate() {
        own[order - 1 + end].copy_from_slice(&all[node * F..][..F]);
    }
}

/// Writes the unknowns of the interior of an element.
fn put_inside<const F: usize>(piece: &Piece, order: usize, own: &OfNodes<f64, F>, all: &mut [f64]) {
    all[piece.inside * F..][..(order - 1) * F].copy_from_slice(own[..order - 1].as_flattened());
}
