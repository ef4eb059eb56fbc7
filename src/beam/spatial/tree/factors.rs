//! The factors of a tree, and any number of right-hand sides through them: K = Lᵀ D L, but for the rows of what is held of tips, which were
//! replaced behind the elimination of the interior of their element.

use super::beam_tree::{BeamTree, TreeBranch};
use super::inside::{Ends, Inside, MOST};
use crate::beam::element::basis::slot;
use crate::beam::element::integration::Responses;
use crate::beam::spatial::chain::end_block::{BelowEnd, Carry, EDGE, EndRow};
use crate::beam::spatial::chain::projection::{FieldFront, SpatialFront};
use crate::beam::spatial::section::kinematics::{SPATIAL_FIELDS, SPATIAL_UNKNOWNS};
use crate::number::{F64x4, Real};

const F: usize = SPATIAL_UNKNOWNS;

/// What an elimination leaves for the way back, element by element but the interiors, and room for it.
pub struct TreeFactors {
    /// Bundle by bundle
    pub(super) inside: Vec<F64x4>,
    pub(super) ends: Vec<[EndRow; F]>,
    pub(super) below: Vec<BelowEnd>,
    pub(super) carries: Vec<Carry>,
    pub(super) front: Box<SpatialFront>,
    pub(super) field_front: Box<FieldFront>,
    pub(super) room: Box<Responses<SPATIAL_FIELDS>>,
}

impl Default for TreeFactors {
    fn default() -> Self {
        Self {
            inside: Vec::new(),
            ends: Vec::new(),
            below: Vec::new(),
            carries: Vec::new(),
            front: Box::new(SpatialFront::zero()),
            field_front: Box::new(FieldFront::zero()),
            room: Box::default(),
        }
    }
}

impl TreeFactors {
    pub(super) fn resize(&mut self, elements: usize, inside: usize) {
        self.inside.resize(inside, F64x4::splat(0.0));
        self.ends.resize(elements, [[0.0; EDGE]; F]);
        self.below.resize(elements, [[0.0; F]; F]);
    }
}

impl BeamTree {
    /// Takes a right-hand side down to the root.
    pub fn reduce(&self, factors: &TreeFactors, right: &mut [f64], transposed: bool) -> [f64; F] {
        let mut x = [0.0; MOST];
        for &b in self.outward.iter().rev() {
            let branch = &self.branches[b];
            for k in 0..branch.elements {
                let e = branch.inwards(k);
                // plain, the equations of what is held do not take part
                self.take_local(branch, e, right, &mut x);
                let (inside, l) = self.inside(factors, branch, e);
                inside.forward(l, &mut x, &self.taking_part(branch, k, !transposed));
                self.put(branch, e, &x, right);
                self.end_forward(factors, branch, e, right, transposed);
            }
        }
        let root = self.root() * F;
        std::array::from_fn(|f| right[root + f])
    }

    /// From a reduced right-hand side and the solution at the root to the whole.
    pub fn substitute(&self, factors: &TreeFactors, root: &[f64; F], right: &mut [f64], transposed: bool) {
        right[self.root() * F..][..F].copy_from_slice(root);
        let mut x = [0.0; MOST];
        for &b in self.outward.iter() {
            let branch = &self.branches[b];
            for k in (0..branch.elements).rev() {
                let e = branch.inwards(k);
                self.end_backward(factors, branch, e, right, transposed);
                // transposed, what is held does not act on the interior
                self.take_local(branch, e, right, &mut x);
                let (inside, l) = self.inside(factors, branch, e);
                inside.backward(l, &mut x, &self.taking_part(branch, k, transposed));
                self.put_inside(branch, e, &x, right);
            }
        }
    }

    /// Which unknowns of the ends of an element, the k-th from the far joint on, take part: all, or all `but_held`.
    fn taking_part(&self, branch: &TreeBranch, k: usize, but_held: bool) -> Ends {
        let mut ends = Ends([true; 2 * F]);
        if let (true, 0, Some(end)) = (but_held, k, self.end_of[branch.far_joint()]) {
            let from = if branch.near == 1 { 0 } else { F };
            (0..F).for_each(|f| ends.0[from + f] = self.ends[end].held[f].is_none());
        }
        ends
    }

    /// Writes the unknowns of an element.
    fn put(&self, branch: &TreeBranch, e: usize, own: &[f64; MOST], all: &mut [f64]) {
        let order = self.order();
        for rank in 0..=order {
            let (from, to) = (slot(order + 1, rank) * F, branch.node(order, e, rank) * F);
            all[to..to + F].copy_from_slice(&own[from..from + F]);
        }
    }

    fn end_forward(&self, factors: &TreeFactors, branch: &TreeBranch, e: usize, right: &mut [f64], transposed: bool) {
        let id = branch.first_element + e;
        let (rows, below, [far, near]) = (&factors.ends[id], &factors.below[id], self.end_places(branch, e));
        for k in 0..F {
            let share = right[far + k] * rows[k][k];
            if transposed {
                right[far + k] = share;
                (k + 1..F).for_each(|i| right[far + i] -= rows[k][i] * share);
                (0..F).for_each(|i| right[near + i] -= rows[k][F + i] * share);
            } else {
                (k + 1..F).for_each(|i| right[far + i] -= rows[i][k] * share);
                (0..F).for_each(|i| right[near + i] -= below[i][k] * share);
            }
        }
    }

    fn end_backward(&self, factors: &TreeFactors, branch: &TreeBranch, e: usize, right: &mut [f64], transposed: bool) {
        let id = branch.first_element + e;
        let (rows, below, [far, near]) = (&factors.ends[id], &factors.below[id], self.end_places(branch, e));
        for k in (0..F).rev() {
            let mut taken = 0.0;
            if transposed {
                (k + 1..F).for_each(|i| taken += rows[i][k] * right[far + i]);
                (0..F).for_each(|i| taken += below[i][k] * right[near + i]);
                right[far + k] -= taken * rows[k][k];
            } else {
                (k + 1..F).for_each(|i| taken += rows[k][i] * right[far + i]);
                (0..F).for_each(|i| taken += rows[k][F + i] * right[near + i]);
                right[far + k] = (right[far + k] - taken) * rows[k][k];
            }
        }
    }
}

// -- The way back through a tree that is eliminated, from the root to the tips --

impl BeamTree {
    /// The direction that solves K q = `scale` R with the root known.
    pub fn recover(&self, factors: &TreeFactors, root: &[f64; F], scale: f64, out: &mut [f64]) {
        out[self.root() * F..][..F].copy_from_slice(root);
        recover(self, factors, scale, out);
    }

    #[inline(always)]
    fn recover_bundles(&self, factors: &TreeFactors, scale: f64, out: &mut [f64]) {
        let order = self.order();
        let mut x = [F64x4::splat(0.0); MOST];
        for (b, own) in self.bundles.iter().enumerate().rev() {
            let lanes = self.lanes(own);
            // behind one another in a branch, the first is the farthest from the root
            for &(branch, e) in lanes[..own.count].iter().rev() {
                self.recover_end(factors, branch, e, scale, out);
            }
            for (l, &(branch, e)) in lanes.iter().enumerate().take(own.count) {
                for rank in [0, order] {
                    let (from, to) = (branch.node(order, e, rank) * F, slot(order + 1, rank) * F);
                    for f in 0..F {
                        x[to + f].0[l] = out[from + f];
                    }
                }
            }
            Inside::new(order, &factors.inside[b * self.inside..][..self.inside]).recover(scale, &mut x);
            for (l, &(branch, e)) in lanes.iter().enumerate().take(own.count) {
                for rank in 1..order {
                    let (from, to) = (slot(order + 1, rank) * F, branch.node(order, e, rank) * F);
                    for f in 0..F {
                        out[to + f] = x[from + f].0[l];
                    }
                }
            }
        }
    }

    /// The end of an element that is farther from the root, the other being known.
    #[inline(always)]
    fn recover_end(&self, factors: &TreeFactors, branch: &TreeBranch, e: usize, scale: f64, out: &mut [f64]) {
        let rows = &factors.ends[branch.first_element + e];
        let [far, near] = self.end_places(branch, e);
        for k in (0..F).rev() {
            let mut sum = scale * rows[k][2 * F];
            for j in 0..F {
                sum -= rows[k][F + j] * out[near + j];
            }
            for j in k + 1..F {
                sum -= rows[k][j] * out[far + j];
            }
            out[far + k] = sum * rows[k][k];
        }
    }

    /// The interior of an element, which is one of four.
    pub(super) fn inside<'a>(&self, factors: &'a TreeFactors, branch: &TreeBranch, e: usize) -> (Inside<'a>, usize) {
        let [bundle, lane] = self.lane_of[branch.first_element + e];
        (Inside::new(self.order(), &factors.inside[bundle * self.inside..][..self.inside]), lane)
    }

    /// Where the far and the near end of an element stand in a direction.
    pub(super) fn end_places(&self, branch: &TreeBranch, e: usize) -> [usize; 2] {
        let order = self.order();
        let ranks = if branch.near == 1 { [0, order] } else { [order, 0] };
        ranks.map(|rank| branch.node(order, e, rank) * F)
    }

    /// Takes the unknowns of an element, in elimination order.
    pub(super) fn take_local(&self, branch: &TreeBranch, e: usize, all: &[f64], own: &mut [f64; MOST]) {
        let order = self.order();
        for rank in 0..=order {
            let from = branch.node(order, e, rank) * F;
            own[slot(order + 1, rank) * F..][..F].copy_from_slice(&all[from..from + F]);
        }
    }

    /// Writes the unknowns of the interior of an element.
    pub(super) fn put_inside(&self, branch: &TreeBranch, e: usize, own: &[f64; MOST], all: &mut [f64]) {
        let order = self.order();
        for rank in 1..order {
            let (from, to) = (slot(order + 1, rank) * F, branch.node(order, e, rank) * F);
            all[to..to + F].copy_from_slice(&own[from..from + F]);
        }
    }
}

/// [`BeamTree::recover_bundles`] compiled for the vector units that the machine may have, chosen when it runs.
#[cfg_attr(
    not(any(test, feature = "portable", debug_assertions)),
    multiversion::multiversion(targets("x86_64+avx2+fma"))
)]
fn recover(tree: &BeamTree, factors: &TreeFactors, scale: f64, out: &mut [f64]) {
    tree.recover_bundles(factors, scale, out);
}
