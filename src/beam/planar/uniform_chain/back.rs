//! The way back through an eliminated chain, from the right end to the left.

use super::{BUNDLE, Fronts, UniformChain};
use crate::beam::planar::chain::EDGE;
use crate::beam::{Basis, ChainFactors, Front};
use crate::number::Four;

/// [`UniformChain::go_back`] compiled for the vector units that the machine may have, chosen when it runs.
#[cfg_attr(not(any(feature = "portable", debug_assertions)), multiversion::multiversion(targets("x86_64+avx2+fma")))]
pub(super) fn back<const F: usize, const N: usize>(
    chain: &UniformChain<F, N>,
    work: &ChainFactors,
    root: &[f64],
    scale: f64,
    out: &mut [f64],
) {
    chain.go_back(work, root, scale, out);
}

impl<const F: usize, const N: usize> UniformChain<F, N> {
    #[inline(always)]
    fn go_back(&self, work: &ChainFactors, root: &[f64], scale: f64, out: &mut [f64]) {
        let elements = work.ends.len() / F;
        let has_border = self.density.has_border();
        let border = if has_border { root[F] } else { 0.0 };
        // places of the border, and of the residual behind all unknowns, in the block of the ends
        let (border_at, known) = (2 * F, 2 * F + usize::from(has_border));
        // the ends of the elements from right to left
        let mut x = [0.0; EDGE];
        x[F..F + F].copy_from_slice(&root[..F]);
        x[border_at] = border;
        out[elements * Self::ORDER * F..].copy_from_slice(&root[..F]);
        for e in (0..elements).rev() {
            for k in (0..F).rev() {
                let row = &work.ends[e * F + k];
                let mut sum = scale * row[known];
                for j in k + 1..known {
                    sum -= row[j] * x[j];
                }
                x[k] = sum * row[k];
            }
            out[e * Self::ORDER * F..][..F].copy_from_slice(&x[..F]);
            for f in 0..F {
                x[F + f] = x[f];
            }
        }
        let fronts = work.fronts.as_ref().and_then(|fronts| fronts.downcast_ref::<Fronts<F, N>>());
        for (bundle, front) in fronts.expect("work comes from an elimination of this chain").iter().enumerate() {
            self.back_inside(front, bundle * BUNDLE, elements, border, scale, out);
        }
    }

    /// The interior nodes of a bundle, whose ends are known.
    #[inline(always)]
    fn back_inside(
        &self,
        front: &Front<Four, F, N>,
        first: usize,
        elements: usize,
        border: f64,
        scale: f64,
        out: &mut [f64],
    ) {
        let mut values = self.gather_bundle(out, first, elements);
        let x = values.as_flattened_mut();
        // what is known first; then each unknown, as soon as it is found, is taken off all those above it
        let rows = front.rows.as_flattened();
        for k in 0..Self::PIVOTS {
            let columns = rows[k].fields.as_flattened();
            let mut sum = rows[k].residual * scale - rows[k].border * border;
            for j in Self::PIVOTS..N * F {
                sum = sum - columns[j] * x[j];
            }
            x[k] = sum;
        }
        for k in (0..Self::PIVOTS).rev() {
            let found = x[k] * rows[k].fields.as_flattened()[k];
            x[k] = found;
            for i in 0..k {
                x[i] = x[i] - rows[i].fields.as_flattened()[k] * found;
            }
        }
        for l in 0..BUNDLE.min(elements - first) {
            for rank in 1..Self::ORDER {
                for f in 0..F {
                    let at = ((first + l) * Self::ORDER + rank) * F + f;
                    out[at] = values[Basis::<N>::slot(rank)][f].0[l];
                }
            }
        }
    }
}
