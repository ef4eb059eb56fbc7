//! The elimination, from the left end of the chain to the right.

use super::elements::{Kept, UniformChain};
use super::ends::Ends;
use crate::beam::element::integration::ElementEnergy;
use crate::beam::planar::chain::{
    BelowEnd, ChainFactors, CondensedChain, Configuration, ConstraintGradient, EDGE, EndRow, LeastPivot, MOST_FIELDS,
    ROOT,
};
use crate::number::F64x4;
use crate::solve::error::{Place, Quantity, SolveError};
use crate::solve::frontal::frontal_matrix::FrontalMatrix;
use crate::solve::frontal::nodes::{BUNDLE, Nodes};
use crate::solve::system::NodalTerms;

/// Pivots below this are zero to rounding.
const LEAST_PIVOT: f64 = f64::MIN_POSITIVE * 1e20;

/// [`UniformChain::sweep_with`] compiled for the vector units that the machine may have, chosen when it runs.
#[cfg_attr(
    not(any(test, feature = "portable", debug_assertions)),
    multiversion::multiversion(targets("x86_64+avx2+fma"))
)]
pub(super) fn sweep<N: Nodes, const F: usize, const BORDER: bool>(
    chain: &UniformChain<F>,
    at: Configuration,
    path: &ConstraintGradient,
    added: NodalTerms,
    eliminated: &mut ChainFactors,
) -> Result<CondensedChain, SolveError> {
    chain.sweep_with::<BORDER>(N::of_order(chain.basis.order), at, path, added, eliminated)
}

impl<const F: usize> UniformChain<F> {
    #[inline(always)]
    fn sweep_with<const BORDER: bool>(
        &self,
        nodes: impl Nodes,
        at: Configuration,
        path: &ConstraintGradient,
        added: NodalTerms,
        eliminated: &mut ChainFactors,
    ) -> Result<CondensedChain, SolveError> {
        // what the last time left, if it was a chain of this kind
        let mut kept: Box<Kept<F>> = eliminated.fronts.take().and_then(|last| last.downcast().ok()).unwrap_or_default();
        let root =
            self.sweep_into::<BORDER>(nodes, at, path, added, &mut kept, (&mut eliminated.ends, &mut eliminated.below));
        eliminated.fronts = Some(kept);
        root
    }

    #[inline(always)]
    fn sweep_into<const BORDER: bool>(
        &self,
        nodes: impl Nodes,
        at: Configuration,
        path: &ConstraintGradient,
        added: NodalTerms,
        Kept { fronts, bundle, room }: &mut Kept<F>,
        (ends, below): (&mut Vec<EndRow>, &mut Vec<BelowEnd>),
    ) -> Result<CondensedChain, SolveError> {
        let (elements, order) = (at.ends.len() - 1, nodes.count() - 1);
        fronts.resize_with(elements.div_ceil(BUNDLE), FrontalMatrix::zero);
        ends.resize(elements * F, [0.0; EDGE]);
        below.resize(elements, [[0.0; MOST_FIELDS]; MOST_FIELDS + 1]);
        let by = self.integration(nodes, at.history);
        let mut energy = ElementEnergy::default();
        let mut negative = 0;
        let mut least_pivot = LeastPivot { size: f64::INFINITY, element: 0 };
        let mut carry = [[0.0; ROOT]; ROOT];
        for (first, front) in (0..elements).step_by(BUNDLE).zip(fronts) {
            self.gather_bundle(nodes, at, first, bundle);
            let (total, coverage) = bundle.integrate::<BORDER>(&by, path.coverage, room, front);
            let pieces = self.add_pieces(nodes, at, first, path.coverage, front);
            self.add_inside(nodes, front, added, first, elements);
            let pivots = front.condense::<BORDER>(nodes, self.symmetric);
            for e in first..elements.min(first + BUNDLE) {
                let l = e - first;
                energy.total += total.0[l] + pieces[l].total;
                energy.coverage += coverage.0[l] + pieces[l].coverage;
                let mut block = Ends::<F, BORDER>::block(nodes, front, self.symmetric, l);
                for f in 0..F {
                    let (stiffness, force) = added.at(e * order * F + f);
                    block[f][f] += stiffness;
                    block[f][2 * F + usize::from(BORDER)] += force;
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
                if least < least_pivot.size {
                    least_pivot = LeastPivot { size: least, element: e };
                }
                ends[e * F..][..F].copy_from_slice(&block[..F]);
                Ends::<F, BORDER>::keep_below(&block, &mut below[e]);
                carry = Ends::<F, BORDER>::load(&block);
                if !carry[0][0].is_finite() || !energy.total.is_finite() {
                    let place = Place { element: e, position: at.ends[e] };
                    return Err(SolveError::NotFinite { quantity: Quantity::Tangent, place });
                }
            }
        }
        for f in 0..F {
            let (stiffness, force) = added.at(elements * order * F + f);
            carry[f][f] += stiffness;
            carry[f][F + usize::from(BORDER)] += force;
        }
        Ok(CondensedChain { matrix: carry, negative, energy, least_pivot })
    }

    /// Adds what the pieces of a law with knots make of the elements of a bundle; returns their energies.
    #[inline(always)]
    fn add_pieces(
        &self,
        nodes: impl Nodes,
        at: Configuration,
        first: usize,
        path_weight: f64,
        front: &mut FrontalMatrix<F64x4, F>,
    ) -> [ElementEnergy; BUNDLE] {
        let mut energies = [ElementEnergy::default(); BUNDLE];
        if self.has_knots {
            let by = self.integration(nodes, at.history);
            for e in first..(at.ends.len() - 1).min(first + BUNDLE) {
                let l = e - first;
                self.element(nodes, at, e).piecewise(&by, |point| {
                    energies[l].total += point.weight * point.response.energy;
                    energies[l].coverage += point.weight * point.response.coverage;
                    front.add_piece(nodes, l, point, path_weight, self.symmetric);
                });
            }
        }
        energies
    }

    /// Adds to the interior nodes of a bundle; the ends of its elements are left to the chain.
    #[inline(always)]
    fn add_inside(
        &self,
        nodes: impl Nodes,
        front: &mut FrontalMatrix<F64x4, F>,
        added: NodalTerms,
        first: usize,
        elements: usize,
    ) {
        if !added.stiffness.is_empty() {
            let stiffness = self.gather_values(nodes, added.stiffness, first, elements);
            for (slot, rows) in front.rows[..nodes.count() - 2].iter_mut().enumerate() {
                for f in 0..F {
                    rows[f].fields[slot][f] = rows[f].fields[slot][f] + stiffness[slot][f];
                }
            }
        }
        if !added.force.is_empty() {
            let force = self.gather_values(nodes, added.force, first, elements);
            for (slot, rows) in front.rows[..nodes.count() - 2].iter_mut().enumerate() {
                for f in 0..F {
                    rows[f].residual = rows[f].residual + force[slot][f];
                }
            }
        }
    }
}
