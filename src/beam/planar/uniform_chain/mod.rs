//! Elimination along a chain of elements of one order, front by front.
//!
//! Elements come in bundles of four side by side: an operation on one number is the same operation on four, whatever the
//! order. A bundle is integrated and its interior nodes are eliminated; then, element by element, the left node, which nobody
//! else needs any more. What is left on the right node and on the border passes into the next element. The last row of a
//! front carries the path functional and the last column the residual, so that both are reduced along with the rest. The
//! sign of a pivot is the sign of an eigenvalue (Sylvester), so the sweep counts the negative ones as it goes.

mod back;
pub(crate) mod elements;
mod ends;
mod factors;
mod finite_step;
#[cfg(test)]
mod piece_tests;
mod read;
mod sweep;
#[cfg(test)]
mod tests;

use super::chain::{
    Chain, ChainFactors, CondensedChain, Configuration, ConstraintGradient, MOST_FIELDS, NodeState, RootVector,
};
use crate::beam::element::basis::{Basis, MOST_ORDER};
use crate::beam::element::energy_density::SectionState;
use crate::beam::element::integrand::PlanarIntegrand;
use crate::beam::element::integration::ElementEnergy;
use crate::solve::error::SolveError;
use crate::solve::frontal::nodes::{AnyNumber, Fixed, Nodes, slot};
use crate::solve::state::History;
use crate::solve::system::NodalTerms;
use elements::{Kernels, UniformChain};
use std::ops::Range;

/// The order that is used where none is asked for: its loops are compiled for it alone, those of the others for any.
const USUAL: usize = 7;

impl<const F: usize> Kernels<F> {
    fn of<N: Nodes, const BORDER: bool>() -> Self {
        Self {
            sweep: sweep::sweep::<N, F, BORDER>,
            back: back::back::<N, F>,
            energy: read::energy::<N, F>,
            node_states: read::node_states::<N, F>,
            shifted: read::shifted::<N, F>,
            follow_force: finite_step::follow_force::<N, F>,
        }
    }
}

impl<const F: usize> UniformChain<F> {
    /// A chain of elements of an order, 1 to 8, whose left end is free but for the fields that `pinned_left` holds at a value.
    /// Panics unless `BORDER` is what the density has.
    pub(crate) fn new<const BORDER: bool>(
        density: Box<dyn PlanarIntegrand<F>>,
        order: usize,
        pinned_left: [Option<f64>; F],
    ) -> Self {
        assert_eq!(density.has_border(), BORDER, "a chain has a border where its density has one");
        let order = order.clamp(1, MOST_ORDER);
        let kernels = match order {
            USUAL => Kernels::of::<Fixed<{ USUAL + 1 }>, BORDER>(),
            _ => Kernels::of::<AnyNumber, BORDER>(),
        };
        let (symmetric, has_knots) = (density.is_symmetric(), !density.knots().is_empty());
        Self { symmetric, has_knots, density, basis: Basis::new(order), pinned_left, kernels }
    }
}

impl<const F: usize> Chain for UniformChain<F> {
    fn fields(&self) -> usize {
        F
    }

    fn order(&self) -> usize {
        self.basis.order
    }

    fn node_fraction(&self, rank: usize) -> f64 {
        0.5 * (1.0 + self.basis.nodes[slot(self.basis.order + 1, rank)])
    }

    fn has_border(&self) -> bool {
        self.density.has_border()
    }

    fn node_weight(&self, rank: usize) -> f64 {
        self.basis.lobatto_weight(slot(self.basis.order + 1, rank))
    }

    fn eliminate_with(
        &self,
        at: Configuration,
        path: &ConstraintGradient,
        added: NodalTerms,
        eliminated: &mut ChainFactors,
    ) -> Result<CondensedChain, SolveError> {
        (self.kernels.sweep)(self, at, path, added, eliminated)
    }

    fn recover(&self, eliminated: &ChainFactors, root: &[f64], scale: f64, out: &mut [f64]) {
        (self.kernels.back)(self, eliminated, root, scale, out);
    }

    fn reduce(&self, eliminated: &ChainFactors, right: &mut [f64], transposed: bool) -> RootVector {
        self.reduce_right(eliminated, right, transposed)
    }

    fn substitute(&self, eliminated: &ChainFactors, root: &[f64], right: &mut [f64], transposed: bool) {
        self.substitute_right(eliminated, root, right, transposed);
    }

    fn follow_force(&self, ends: &[f64], state: &mut [f64], direction: &[f64], axial: [f64; 2]) {
        if self.density.follows_force() {
            (self.kernels.follow_force)(self, ends, state, direction, axial);
        }
    }

    fn energy(&self, at: Configuration, direction: &[f64]) -> (ElementEnergy, f64) {
        (self.kernels.energy)(self, at, direction)
    }

    fn residual(&self, at: Configuration) -> (Vec<f64>, f64) {
        self.residual_of(at)
    }

    fn coverage_gradient(&self, at: Configuration) -> Vec<f64> {
        self.coverage_gradient_of(at)
    }

    fn node_states(&self, at: Configuration, elements: Range<usize>) -> Vec<NodeState> {
        (self.kernels.node_states)(self, at, elements)
    }

    fn sample(&self, at: Configuration, element: usize, local: f64) -> ([f64; MOST_FIELDS], SectionState) {
        self.sample_at(at, element, local)
    }

    fn gauss_points(&self, ends: &[f64]) -> Vec<[f64; 2]> {
        let of_element = |pair: &[f64]| {
            let (from, half) = (pair[0], 0.5 * (pair[1] - pair[0]));
            let at = move |q: usize| [from + half * (1.0 + self.basis.points[q]), half * self.basis.weights[q]];
            (0..self.basis.order).map(at)
        };
        ends.windows(2).flat_map(of_element).collect()
    }

    fn updated_history(&self, at: Configuration, before: f64) -> Option<(History, f64)> {
        self.updated(at, before)
    }

    fn shifted(&self, at: Configuration, ends: &[f64]) -> Vec<f64> {
        (self.kernels.shifted)(self, at, ends)
    }

    fn resampled(&self, at: Configuration, ends: &[f64]) -> Vec<f64> {
        self.resample(at, ends)
    }
}
