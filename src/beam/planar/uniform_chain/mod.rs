//! Elimination along a chain of elements of one order, front by front.
//!
//! Elements come in bundles of four side by side: an operation on one number is the same operation on four, whatever the
//! order. A bundle is integrated and its interior nodes are eliminated; then, element by element, the left node, which nobody
//! else needs any more. What is left on the right node and on the border passes into the next element. The last row of a
//! front carries the path functional and the last column the residual, so that both are reduced along with the rest. The
//! sign of a pivot is the sign of an eigenvalue (Sylvester), so the sweep counts the negative ones as it goes.

mod back;
mod ends;
mod read;
mod sweep;

use super::{
    Basis, Chain, ChainFactors, Configuration, Element, ElementEnergy, Front, Integrand, MOST_FIELDS, NodeState,
    PathRow, Root, SectionState,
};
use crate::number::Four;
use crate::solve::{History, SolveError};
use std::ops::Range;

/// Elements that are treated side by side.
pub const BUNDLE: usize = 4;

/// One front a bundle.
type Fronts<const F: usize, const N: usize> = Vec<Front<Four, F, N>>;

/// The elimination of a chain, with a border or without.
type Sweep<const F: usize, const N: usize> =
    fn(&UniformChain<F, N>, Configuration, &PathRow, &[f64], &mut ChainFactors) -> Result<Root, SolveError>;

/// [`Chain`] of one order: N = p + 1 nodes an element, F fields a node.
pub struct UniformChain<const F: usize, const N: usize> {
    density: Box<dyn Integrand<F>>,
    basis: Basis<N>,
    /// Whether the tangent is symmetric.
    symmetric: bool,
    /// Where the fields of the left end are held, as far as they are.
    pinned_left: [Option<f64>; F],
    sweep: Sweep<F, N>,
}

impl<const F: usize, const N: usize> UniformChain<F, N> {
    const ORDER: usize = N - 1;
    /// Pivots of the interior nodes of an element.
    const PIVOTS: usize = (N - 2) * F;

    /// A chain whose left end is free but for the fields that `pinned_left` holds at a value. Panics unless `BORDER` is what
    /// the density has.
    pub fn new<const BORDER: bool>(density: Box<dyn Integrand<F>>, pinned_left: [Option<f64>; F]) -> Self {
        assert_eq!(density.has_border(), BORDER, "a chain has a border where its density has one");
        let symmetric = density.is_symmetric();
        Self { density, basis: Basis::new(), symmetric, pinned_left, sweep: sweep::sweep::<F, N, BORDER> }
    }

    /// Values of element `e` in elimination order.
    #[inline(always)]
    fn gather(&self, state: &[f64], e: usize) -> [[f64; F]; N] {
        let at = &state[e * Self::ORDER * F..][..N * F];
        let mut values = [[0.0; F]; N];
        for rank in 0..N {
            values[Basis::<N>::slot(rank)].copy_from_slice(&at[rank * F..(rank + 1) * F]);
        }
        values
    }

    /// One element.
    fn element(&self, at: Configuration, e: usize) -> Element<f64, F, N> {
        let (from, to) = (at.ends[e], at.ends[e + 1]);
        let mut slips = [[0.0; 2]; N];
        if let (true, Some(known)) = (self.density.remembers(), at.history) {
            for (slip, point) in slips.iter_mut().zip(self.basis.points) {
                *slip = known.at(from + 0.5 * (1.0 + point) * (to - from));
            }
        }
        Element { values: self.gather(at.state, e), from, length: to - from, slips, border: at.border }
    }

    /// Elements `first` to `first + 3`; behind the last one it is repeated.
    #[inline(always)]
    fn bundle(&self, at: Configuration, first: usize) -> Element<Four, F, N> {
        let zero = Four([0.0; BUNDLE]);
        let mut bundle =
            Element { values: [[zero; F]; N], from: zero, length: zero, slips: [[zero; 2]; N], border: at.border };
        for l in 0..BUNDLE {
            let e = (first + l).min(at.ends.len() - 2);
            bundle.from.0[l] = at.ends[e];
            bundle.length.0[l] = at.ends[e + 1] - at.ends[e];
        }
        if let (true, Some(known)) = (self.density.remembers(), at.history) {
            for (slips, point) in bundle.slips.iter_mut().zip(self.basis.points) {
                for l in 0..BUNDLE {
                    let [place, share] = known.at(bundle.from.0[l] + 0.5 * (1.0 + point) * bundle.length.0[l]);
                    (slips[0].0[l], slips[1].0[l]) = (place, share);
                }
            }
        }
        bundle.values = self.gather_bundle(at.state, first, at.ends.len() - 1);
        bundle
    }

    #[inline(always)]
    fn gather_bundle(&self, state: &[f64], first: usize, elements: usize) -> [[Four; F]; N] {
        let mut values = [[Four([0.0; BUNDLE]); F]; N];
        for l in 0..BUNDLE {
            let one = self.gather(state, (first + l).min(elements - 1));
            for a in 0..N {
                for f in 0..F {
                    values[a][f].0[l] = one[a][f];
                }
            }
        }
        values
    }
}

impl<const F: usize, const N: usize> Chain for UniformChain<F, N> {
    fn fields(&self) -> usize {
        F
    }

    fn order(&self) -> usize {
        Self::ORDER
    }

    fn node_fraction(&self, rank: usize) -> f64 {
        0.5 * (1.0 + self.basis.nodes[Basis::<N>::slot(rank)])
    }

    fn has_border(&self) -> bool {
        self.density.has_border()
    }

    fn eliminate_damped(
        &self,
        at: Configuration,
        path: &PathRow,
        damping: &[f64],
        work: &mut ChainFactors,
    ) -> Result<Root, SolveError> {
        (self.sweep)(self, at, path, damping, work)
    }

    fn recover(&self, work: &ChainFactors, root: &[f64], scale: f64, out: &mut [f64]) {
        back::back(self, work, root, scale, out);
    }

    fn energy(&self, at: Configuration, direction: &[f64]) -> (ElementEnergy, f64) {
        read::energy(self, at, direction)
    }

    fn residual(&self, at: Configuration) -> (Vec<f64>, f64) {
        self.residual_of(at)
    }

    fn adhesion_gradient(&self, at: Configuration) -> Vec<f64> {
        self.adhesion_gradient_of(at)
    }

    fn node_states(&self, at: Configuration, elements: Range<usize>) -> Vec<NodeState> {
        self.states_of(at, elements)
    }

    fn sample(&self, at: Configuration, element: usize, local: f64) -> ([f64; MOST_FIELDS], SectionState) {
        self.sample_at(at, element, local)
    }

    fn slid(&self, at: Configuration) -> Option<History> {
        self.slide(at)
    }

    fn shifted(&self, at: Configuration, ends: &[f64]) -> Vec<f64> {
        read::shifted(self, at, ends)
    }

    fn resampled(&self, at: Configuration, ends: &[f64]) -> Vec<f64> {
        self.resample(at, ends)
    }
}
