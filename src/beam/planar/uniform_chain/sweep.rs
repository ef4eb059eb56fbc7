//! The elimination, from the left end of the chain to the right.

use super::ends::Ends;
use super::{BUNDLE, Fronts, UniformChain};
use crate::beam::planar::chain::EndRow;
use crate::beam::{ChainFactors, Configuration, ElementEnergy, Front, PathRow, PointResponse, ROOT, Root};
use crate::number::Four;
use crate::solve::{Place, Quantity, SolveError};

/// Pivots below this are zero to rounding.
const LEAST_PIVOT: f64 = f64::MIN_POSITIVE * 1e20;

/// [`UniformChain::sweep_with`] compiled for the vector units that the machine may have, chosen when it runs.
#[cfg_attr(not(any(feature = "portable", debug_assertions)), multiversion::multiversion(targets("x86_64+avx2+fma")))]
pub(super) fn sweep<const F: usize, const N: usize, const BORDER: bool>(
    chain: &UniformChain<F, N>,
    at: Configuration,
    path: &PathRow,
    damping: &[f64],
    work: &mut ChainFactors,
) -> Result<Root, SolveError> {
    chain.sweep_with::<BORDER>(at, path, damping, work)
}

impl<const F: usize, const N: usize> UniformChain<F, N> {
    #[inline(always)]
    fn sweep_with<const BORDER: bool>(
        &self,
        at: Configuration,
        path: &PathRow,
        damping: &[f64],
        work: &mut ChainFactors,
    ) -> Result<Root, SolveError> {
        // the fronts of the last time, if it was a chain of this kind
        let mut fronts: Box<Fronts<F, N>> =
            work.fronts.take().and_then(|last| last.downcast().ok()).unwrap_or_default();
        let root = self.sweep_into::<BORDER>(at, path, damping, &mut fronts, &mut work.ends);
        work.fronts = Some(fronts);
        root
    }

    #[inline(always)]
    fn sweep_into<const BORDER: bool>(
        &self,
        at: Configuration,
        path: &PathRow,
        damping: &[f64],
        fronts: &mut Fronts<F, N>,
        ends: &mut Vec<EndRow>,
    ) -> Result<Root, SolveError> {
        let elements = at.ends.len() - 1;
        fronts.resize_with(elements.div_ceil(BUNDLE), Front::zero);
        ends.clear();
        let mut responses = [PointResponse::zero(); N];
        let coupling = self.density.coupling();
        let mut energy = ElementEnergy::default();
        let mut negative = 0;
        let mut carry = [[0.0; ROOT]; ROOT];
        for (first, front) in (0..elements).step_by(BUNDLE).zip(fronts) {
            let bundle = self.bundle(at, first);
            let (total, adhesion) = bundle.integrate::<BORDER>(
                (&*self.density, &coupling),
                &self.basis,
                self.symmetric,
                path.adhesion,
                &mut responses,
                front,
            );
            if !damping.is_empty() {
                self.damp_inside(front, damping, first, elements);
            }
            let pivots = front.condense::<BORDER>(self.symmetric);
            for e in first..elements.min(first + BUNDLE) {
                let l = e - first;
                energy.total += total.0[l];
                energy.adhesion += adhesion.0[l];
                let mut block = Ends::<F, BORDER>::block(front, self.symmetric, l);
                if !damping.is_empty() {
                    (0..F).for_each(|f| block[f][f] += damping[e * Self::ORDER * F + f]);
                }
                if e == 0 {
                    Ends::<F, BORDER>::start(&mut block, path, &self.pinned_left, &at.state[..F]);
                } else {
                    Ends::<F, BORDER>::unload(&carry, &mut block);
                }
                let (negative_end, least) = Ends::<F, BORDER>::eliminate(&mut block);
                negative += pivots.negative.0[l] as usize + negative_end;
                let least = least.min(pivots.least.0[l]);
                if least < LEAST_PIVOT {
                    return Err(SolveError::Singular {
                        pivot: least,
                        place: Place { element: e, position: at.ends[e] },
                    });
                }
                ends.extend_from_slice(&block[..F]);
                carry = Ends::<F, BORDER>::load(&block);
                if !carry[0][0].is_finite() || !energy.total.is_finite() {
                    let place = Place { element: e, position: at.ends[e] };
                    return Err(SolveError::NotFinite { quantity: Quantity::Tangent, place });
                }
            }
        }
        if !damping.is_empty() {
            (0..F).for_each(|f| carry[f][f] += damping[elements * Self::ORDER * F + f]);
        }
        Ok(Root { matrix: carry, negative, energy })
    }

    /// Adds to the diagonal of the interior nodes of a bundle; the ends of its elements are left to the chain.
    fn damp_inside(&self, front: &mut Front<Four, F, N>, damping: &[f64], first: usize, elements: usize) {
        let damping = self.gather_bundle(damping, first, elements);
        for (slot, rows) in front.rows[..N - 2].iter_mut().enumerate() {
            for f in 0..F {
                rows[f].fields[slot][f] = rows[f].fields[slot][f] + damping[slot][f];
            }
        }
    }
}
