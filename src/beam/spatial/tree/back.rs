//! The way back through a tree that is eliminated, from the root to the tips.

use super::beam_tree::{BeamTree, TreeBranch};
use super::factors::TreeFactors;
use super::inside::{Inside, MOST};
use crate::beam::element::basis::slot;
use crate::beam::spatial::section::kinematics::SPATIAL_UNKNOWNS;
use crate::number::{F64x4, Real};

const F: usize = SPATIAL_UNKNOWNS;

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
