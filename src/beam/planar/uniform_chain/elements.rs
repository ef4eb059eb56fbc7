//! The elements of a chain of one order, and their numbers four side by side.

use crate::beam::element::basis::Basis;
use crate::beam::element::energy_density::MEMORY;
use crate::beam::element::integrand::PlanarIntegrand;
use crate::beam::element::integration::{Element, ElementEnergy, Integration, Responses, memory_of};
use crate::beam::planar::chain::{ChainFactors, CondensedChain, Configuration, ConstraintGradient, NodeState};
use crate::number::F64x4;
use crate::solve::error::SolveError;
use crate::solve::frontal::frontal_matrix::FrontalMatrix;
use crate::solve::frontal::nodes::{AnyNumber, BUNDLE, MOST_NODES, Nodes, slot};
use crate::solve::state::{History, Places};
use crate::solve::system::NodalTerms;
use std::ops::Range;

/// What a chain keeps of an elimination, for the way back and for the next.
pub(super) struct Kept<const F: usize> {
    /// One front a bundle.
    pub(super) fronts: Vec<FrontalMatrix<F64x4, F>>,
    pub(super) bundle: Element<F64x4, F>,
    pub(super) room: Responses<F>,
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
pub(super) struct Kernels<const F: usize> {
    pub(super) sweep: Sweep<F>,
    pub(super) back: fn(&UniformChain<F>, &ChainFactors, &[f64], f64, &mut [f64]),
    pub(super) energy: fn(&UniformChain<F>, Configuration, &[f64]) -> (ElementEnergy, f64),
    pub(super) node_states: fn(&UniformChain<F>, Configuration, Range<usize>) -> Vec<NodeState>,
    pub(super) shifted: fn(&UniformChain<F>, Configuration, &[f64]) -> Vec<f64>,
    pub(super) follow_force: FollowForce<F>,
}

/// [`Chain`](crate::beam::Chain) of F fields a node.
pub(crate) struct UniformChain<const F: usize> {
    pub(super) density: Box<dyn PlanarIntegrand<F>>,
    pub(super) basis: Basis,
    /// Whether the tangent is symmetric.
    pub(super) symmetric: bool,
    /// Whether its law has pieces that join inside of elements.
    pub(super) has_knots: bool,
    /// Where the fields of the left end are held, as far as they are.
    pub(super) pinned_left: [Option<f64>; F],
    pub(super) kernels: Kernels<F>,
}

impl<const F: usize> UniformChain<F> {
    /// How its elements are integrated.
    #[inline(always)]
    pub(super) fn integration<'a, N: Nodes>(&'a self, nodes: N, history: Option<&'a History>) -> Integration<'a, N, F> {
        let (density, coupling) = (&*self.density, self.density.coupling());
        Integration {
            nodes,
            basis: &self.basis,
            density,
            coupling,
            symmetric: self.symmetric,
            history: history.filter(|_| density.remembers_face()),
            in_pieces: true,
        }
    }

    /// As many nodes as an element has.
    pub(super) fn nodes(&self) -> AnyNumber {
        AnyNumber::of_order(self.basis.order)
    }

    /// Values of element `e` in elimination order.
    #[inline(always)]
    pub(super) fn gather(&self, nodes: impl Nodes, state: &[f64], e: usize) -> [[f64; F]; MOST_NODES] {
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
    pub(super) fn element(&self, nodes: impl Nodes, at: Configuration, e: usize) -> Element<f64, F> {
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
    pub(super) fn gather_bundle(
        &self,
        nodes: impl Nodes,
        at: Configuration,
        first: usize,
        bundle: &mut Element<F64x4, F>,
    ) {
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
        let Some(known) = at.strains else {
            if let Some(history) = at.history
                && let Places::Gauss(_) = history.places
            {
                return history.of(e * self.basis.order + q);
            }
            let place = at.ends[e] + 0.5 * (1.0 + self.basis.points[q]) * (at.ends[e + 1] - at.ends[e]);
            return memory_of(at.history, place);
        };
        let [stretch, slide, turn, distance] = known.strains[e * self.basis.order + q];
        let mut memory = [0.0; MEMORY];
        memory[..6].copy_from_slice(&[stretch, slide, turn, known.factor, distance, known.per_time]);
        memory
    }

    /// The same of one number a node and field.
    #[inline(always)]
    pub(super) fn gather_values(
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
