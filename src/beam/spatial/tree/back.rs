//! The way back through a tree that is eliminated, from the root to the tips.

use super::beam_tree::{BeamTree, TreeBranch};
use super::factors::TreeFactors;
use super::inside::{Inside, MOST};
use crate::beam::slot;
use crate::beam::spatial::chain::SPATIAL_UNKNOWNS;

const F: usize = SPATIAL_UNKNOWNS;

impl BeamTree {
    /// The direction that solves K q = `scale` R with the root known.
    pub fn recover(&self, factors: &TreeFactors, root: &[f64; F], scale: f64, out: &mut [f64]) {
        out[self.root() * F..][..F].copy_from_slice(root);
        let mut x = [0.0; MOST];
        for &b in self.outward.iter() {
            let branch = &self.branches[b];
            for k in (0..branch.elements).rev() {
                let e = branch.inwards(k);
                self.recover_end(factors, branch, e, scale, out);
                self.take_local(branch, e, out, &mut x);
                self.inside(factors, branch, e).recover(scale, &mut x);
                self.put_inside(branch, e, &x, out);
            }
        }
    }

    /// The end of an element that is farther from the root, the other being known.
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

    pub(super) fn inside<'a>(&self, factors: &'a TreeFactors, branch: &TreeBranch, e: usize) -> Inside<'a> {
        let from = (branch.first_element + e) * self.inside;
        Inside::new(self.order(), &factors.inside[from..from + self.inside])
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
