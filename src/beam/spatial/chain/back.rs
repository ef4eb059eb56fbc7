//! The way back through a chain that is eliminated, from the right end to the left.

use super::projection::SpatialFront;
use super::spatial_chain::{SpatialChain, SpatialFactors, USUAL_ORDER, Usual, gather_nodes, no_values};
use crate::beam::element::basis::{AnyNumber, Nodes, slot};
use crate::beam::element::integration::BUNDLE;
use crate::beam::spatial::section::kinematics::SPATIAL_UNKNOWNS;
use crate::number::{F64x4, Real};

const F: usize = SPATIAL_UNKNOWNS;

impl SpatialChain {
    /// The direction that solves K q = scale R with the right end known.
    pub fn recover(&self, factors: &SpatialFactors, root: &[f64; F], scale: f64, out: &mut [f64]) {
        if self.basis.order == USUAL_ORDER {
            back::<Usual>(self, factors, root, scale, out);
        } else {
            back::<AnyNumber>(self, factors, root, scale, out);
        }
    }

    #[inline(always)]
    fn go_back(&self, nodes: impl Nodes, factors: &SpatialFactors, root: &[f64; F], scale: f64, out: &mut [f64]) {
        let (elements, order) = (factors.ends.len(), nodes.count() - 1);
        // the ends of the elements from right to left
        let mut next = *root;
        out[elements * order * F..].copy_from_slice(root);
        for (e, rows) in factors.ends.iter().enumerate().rev() {
            let mut own = [0.0; F];
            for k in (0..F).rev() {
                let mut sum = scale * rows[k][2 * F];
                for j in 0..F {
                    sum -= rows[k][F + j] * next[j];
                }
                for j in k + 1..F {
                    sum -= rows[k][j] * own[j];
                }
                own[k] = sum * rows[k][k];
            }
            out[e * order * F..][..F].copy_from_slice(&own);
            next = own;
        }
        for (bundle, front) in factors.fronts.iter().enumerate() {
            back_inside(nodes, front, (bundle * BUNDLE, elements), scale, out);
        }
    }
}

/// [`SpatialChain::go_back`] compiled for the vector units that the machine may have, chosen when it runs.
#[cfg_attr(
    not(any(test, feature = "portable", debug_assertions)),
    multiversion::multiversion(targets("x86_64+avx2+fma"))
)]
fn back<N: Nodes>(chain: &SpatialChain, factors: &SpatialFactors, root: &[f64; F], scale: f64, out: &mut [f64]) {
    chain.go_back(N::of_order(chain.basis.order), factors, root, scale, out);
}

/// The interior nodes of four elements, whose ends are known.
#[inline(always)]
fn back_inside(
    nodes: impl Nodes,
    front: &SpatialFront,
    (first, elements): (usize, usize),
    scale: f64,
    out: &mut [f64],
) {
    let (count, order) = (nodes.count(), nodes.count() - 1);
    let mut x = no_values::<F>();
    gather_nodes(nodes, out, (first, elements), &mut x);
    for a in (0..count - 2).rev() {
        for f in (0..F).rev() {
            let row = &front.rows[a][f];
            // a sum a field, so that one need not wait for the other
            let mut sums = [F64x4::splat(0.0); F];
            for b in a + 1..count {
                for g in 0..F {
                    sums[g] = sums[g] + row.fields[b][g] * x[b][g];
                }
            }
            let mut sum = row.residual * scale;
            for g in 0..F {
                sum = sum - sums[g];
            }
            for g in f + 1..F {
                sum = sum - row.fields[a][g] * x[a][g];
            }
            x[a][f] = sum * row.fields[a][f];
        }
    }
    for l in 0..BUNDLE.min(elements - first) {
        for rank in 1..order {
            for f in 0..F {
                out[((first + l) * order + rank) * F + f] = x[slot(count, rank)][f].0[l];
            }
        }
    }
}
