//! The way back through an eliminated chain, from the right end to the left.

use super::elements::{Kept, UniformChain};
use crate::beam::planar::chain::{ChainFactors, EDGE};
use crate::number::F64x4;
use crate::solve::frontal::frontal_matrix::FrontalMatrix;
use crate::solve::frontal::nodes::{BUNDLE, Nodes, slot};

/// [`UniformChain::go_back`] compiled for the vector units that the machine may have, chosen when it runs.
#[cfg_attr(
    not(any(test, feature = "portable", debug_assertions)),
    multiversion::multiversion(targets("x86_64+avx2+fma"))
)]
pub(super) fn back<N: Nodes, const F: usize>(
    chain: &UniformChain<F>,
    eliminated: &ChainFactors,
    root: &[f64],
    scale: f64,
    out: &mut [f64],
) {
    chain.go_back(N::of_order(chain.basis.order), eliminated, root, scale, out);
}

impl<const F: usize> UniformChain<F> {
    #[inline(always)]
    fn go_back(&self, nodes: impl Nodes, eliminated: &ChainFactors, root: &[f64], scale: f64, out: &mut [f64]) {
        let (elements, order) = (eliminated.ends.len() / F, nodes.count() - 1);
        let has_border = self.density.has_border();
        let border = if has_border { root[F] } else { 0.0 };
        // places of the border, and of the residual behind all unknowns, in the block of the ends
        let (border_at, known) = (2 * F, 2 * F + usize::from(has_border));
        // the ends of the elements from right to left
        let mut x = [0.0; EDGE];
        x[F..F + F].copy_from_slice(&root[..F]);
        x[border_at] = border;
        out[elements * order * F..].copy_from_slice(&root[..F]);
        for e in (0..elements).rev() {
            for k in (0..F).rev() {
                let row = &eliminated.ends[e * F + k];
                let mut sum = scale * row[known];
                for j in k + 1..known {
                    sum -= row[j] * x[j];
                }
                x[k] = sum * row[k];
            }
            out[e * order * F..][..F].copy_from_slice(&x[..F]);
            for f in 0..F {
                x[F + f] = x[f];
            }
        }
        let kept = eliminated.fronts.as_ref().and_then(|kept| kept.downcast_ref::<Kept<F>>());
        for (bundle, front) in
            kept.expect("eliminated comes from an elimination of this chain").fronts.iter().enumerate()
        {
            self.back_inside(nodes, front, (bundle * BUNDLE, elements), border, scale, out);
        }
    }

    /// The interior nodes of a bundle, whose ends are known.
    // a struct of what it needs would be made for this one call
    #[allow(clippy::too_many_arguments)]
    #[inline(always)]
    fn back_inside(
        &self,
        nodes: impl Nodes,
        front: &FrontalMatrix<F64x4, F>,
        (first, elements): (usize, usize),
        border: f64,
        scale: f64,
        out: &mut [f64],
    ) {
        let (count, order) = (nodes.count(), nodes.count() - 1);
        let inside = (count - 2) * F;
        let mut values = self.gather_values(nodes, out, first, elements);
        let x = values.as_flattened_mut();
        // what is known first; then each unknown, as soon as it is found, is taken off all those above it
        let rows = front.rows.as_flattened();
        for k in 0..inside {
            let columns = rows[k].fields.as_flattened();
            let mut sum = rows[k].residual * scale - rows[k].border * border;
            for j in inside..count * F {
                sum = sum - columns[j] * x[j];
            }
            x[k] = sum;
        }
        for k in (0..inside).rev() {
            let found = x[k] * rows[k].fields.as_flattened()[k];
            x[k] = found;
            for i in 0..k {
                x[i] = x[i] - rows[i].fields.as_flattened()[k] * found;
            }
        }
        for l in 0..BUNDLE.min(elements - first) {
            for rank in 1..order {
                for f in 0..F {
                    let at = ((first + l) * order + rank) * F + f;
                    out[at] = values[slot(count, rank)][f].0[l];
                }
            }
        }
    }
}
