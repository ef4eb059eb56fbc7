//! Elimination along a chain of elements of one order, front by front.
//!
//! Elements come in bundles of four side by side: an operation on one number is the same operation on four, whatever the
//! order. A bundle is integrated and its interior nodes are eliminated; then, element by element, the left node, which nobody
//! else needs any more. What is left on the right node and on the border passes into the next element. The last row of a
//! front carries the path functional and the last column the residual, so that both are reduced along with the rest. The
//! sign of a pivot is the sign of an eigenvalue (Sylvester), so the sweep counts the negative ones as it goes.

mod back;
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
use crate::beam::element::basis::{AnyNumber, Basis, Fixed, MOST_NODES, MOST_ORDER, Nodes, slot};
use crate::beam::element::energy_density::{MEMORY, SectionState};
use crate::beam::element::frontal_matrix::FrontalMatrix;
use crate::beam::element::integrand::PlanarIntegrand;
use crate::beam::element::integration::{BUNDLE, Element, ElementEnergy, Integration, Responses};
use crate::number::F64x4;
use crate::solve::error::SolveError;
use crate::solve::state::History;
use crate::solve::system::NodalTerms;
use std::ops::Range;

/// What a chain keeps of an elimination, for the way back and for the next.
struct Kept<const F: usize> {
    /// One front a bundle.
    fronts: Vec<FrontalMatrix<F64x4, F>>,
    bundle: Element<F64x4, F>,
    room: Responses<F>,
}

impl<const F: usize> Default for Kept<F> {
    fn default() -> Self {
        Self { fronts: Vec::new(), bundle: Element::zero(), room: Responses::default() }
    }
}

/// The elimination of a chain.
type Sweep<const F: usize> = fn(
    &UniformChain<F>,
    Configuration,
    &ConstraintGradient,
    NodalTerms,
    &mut ChainFactors,
) -> Result<CondensedChain, SolveError>;
/// What makes the height follow the section force.
type FollowForce<const F: usize> = fn(&UniformChain<F>, &[f64], &mut [f64], &[f64], [f64; 2]);

/// The loops that take time, compiled for a number of nodes that is known then or for any.
struct Kernels<const F: usize> {
    sweep: Sweep<F>,
    back: fn(&UniformChain<F>, &ChainFactors, &[f64], f64, &mut [f64]),
    energy: fn(&UniformChain<F>, Configuration, &[f64]) -> (ElementEnergy, f64),
    node_states: fn(&UniformChain<F>, Configuration, Range<usize>) -> Vec<NodeState>,
    shifted: fn(&UniformChain<F>, Configuration, &[f64]) -> Vec<f64>,
    follow_force: FollowForce<F>,
}

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

/// The order that is used where none is asked for: its loops are compiled for it alone, those of the others for any.
const USUAL: usize = 7;

/// [`Chain`] of F fields a node.
pub struct UniformChain<const F: usize> {
    density: Box<dyn PlanarIntegrand<F>>,
    basis: Basis,
    /// Whether the tangent is symmetric.
    symmetric: bool,
    /// Whether its law has pieces that join inside of elements.
    has_knots: bool,
    /// Where the fields of the left end are held, as far as they are.
    pinned_left: [Option<f64>; F],
    kernels: Kernels<F>,
}

impl<const F: usize> UniformChain<F> {
    /// A chain of elements of an order, 1 to 8, whose left end is free but for the fields that `pinned_left` holds at a value.
    /// Panics unless `BORDER` is what the density has.
    pub fn new<const BORDER: bool>(
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

    /// How its elements are integrated.
    #[inline(always)]
    fn integration<N: Nodes>(&self, nodes: N) -> Integration<'_, N, F> {
        let (density, coupling) = (&*self.density, self.density.coupling());
        Integration { nodes, basis: &self.basis, density, coupling, symmetric: self.symmetric }
    }

    /// As many nodes as an element has.
    fn nodes(&self) -> AnyNumber {
        AnyNumber::of_order(self.basis.order)
    }

    /// Values of element `e` in elimination order.
    #[inline(always)]
    fn gather(&self, nodes: impl Nodes, state: &[f64], e: usize) -> [[f64; F]; MOST_NODES] {
        let count = nodes.count();
        let at = &state[e * (count - 1) * F..][..count * F];
        let mut values = [[0.0; F]; MOST_NODES];
        for rank in 0..count {
            values[slot(count, rank)].copy_from_slice(&at[rank * F..(rank + 1) * F]);
        }
        values
    }

    /// One element.
    #[inline(always)]
    fn element(&self, nodes: impl Nodes, at: Configuration, e: usize) -> Element<f64, F> {
        let (from, to) = (at.ends[e], at.ends[e + 1]);
        let mut memories = [[0.0; MEMORY]; MOST_NODES];
        if self.density.remembers() {
            for q in 0..nodes.count() - 1 {
                memories[q] = self.memory(at, e, q);
            }
        }
        Element {
            values: self.gather(nodes, at.state, e),
            from,
            length: to - from,
            memories,
            axial_multiplier: at.axial_multiplier,
        }
    }

    /// Elements `first` to `first + 3`; behind the last one it is repeated.
    #[inline(always)]
    fn gather_bundle(&self, nodes: impl Nodes, at: Configuration, first: usize, bundle: &mut Element<F64x4, F>) {
        let elements = at.ends.len() - 1;
        for l in 0..BUNDLE {
            let e = (first + l).min(elements - 1);
            bundle.from.0[l] = at.ends[e];
            bundle.length.0[l] = at.ends[e + 1] - at.ends[e];
            self.gather_lane(nodes, at.state, e, l, &mut bundle.values);
        }
        bundle.axial_multiplier = at.axial_multiplier;
        if self.density.remembers() {
            for q in 0..nodes.count() - 1 {
                for l in 0..BUNDLE {
                    let memory = self.memory(at, (first + l).min(elements - 1), q);
                    (0..MEMORY).for_each(|k| bundle.memories[q][k].0[l] = memory[k]);
                }
            }
        }
    }

    /// What the material remembers at Gauss point `q` of element `e`.
    fn memory(&self, at: Configuration, e: usize, q: usize) -> [f64; MEMORY] {
        let [a, b, c, d] = match (at.history, at.strains) {
            (Some(known), _) => {
                let [place, carried] =
                    known.at(at.ends[e] + 0.5 * (1.0 + self.basis.points[q]) * (at.ends[e + 1] - at.ends[e]));
                [place, carried, 0.0, 0.0]
            }
            (None, Some(known)) => {
                let [stretch, slide, turn] = known.strains[e * self.basis.order + q];
                [stretch, slide, turn, known.factor]
            }
            (None, None) => [0.0; 4],
        };
        [a, b, c, d, 0.0, 0.0, 0.0]
    }

    /// The same of one number a node and field.
    #[inline(always)]
    fn gather_values(
        &self,
        nodes: impl Nodes,
        state: &[f64],
        first: usize,
        elements: usize,
    ) -> [[F64x4; F]; MOST_NODES] {
        let mut values = [[F64x4([0.0; BUNDLE]); F]; MOST_NODES];
        for l in 0..BUNDLE {
            self.gather_lane(nodes, state, (first + l).min(elements - 1), l, &mut values);
        }
        values
    }

    /// Values of element `e` in elimination order, as the numbers `l` of a bundle.
    #[inline(always)]
    fn gather_lane(&self, nodes: impl Nodes, state: &[f64], e: usize, l: usize, values: &mut [[F64x4; F]; MOST_NODES]) {
        let count = nodes.count();
        let at = &state[e * (count - 1) * F..][..count * F];
        for rank in 0..count {
            for f in 0..F {
                values[slot(count, rank)][f].0[l] = at[rank * F + f];
            }
        }
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

    fn updated_history(&self, at: Configuration) -> Option<History> {
        self.updated(at)
    }

    fn shifted(&self, at: Configuration, ends: &[f64]) -> Vec<f64> {
        (self.kernels.shifted)(self, at, ends)
    }

    fn resampled(&self, at: Configuration, ends: &[f64]) -> Vec<f64> {
        self.resample(at, ends)
    }
}
