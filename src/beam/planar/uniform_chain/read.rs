//! What is read off a configuration: energies, section forces, and its fields in other places.

use super::elements::UniformChain;
use crate::beam::element::basis::PerNode;
use crate::beam::element::energy_density::{Point, SectionState, StepEnd};
use crate::beam::element::integration::{Element, ElementEnergy, memory_of};
use crate::beam::planar::chain::{Configuration, MOST_FIELDS, NodeState};
use crate::solve::frontal::nodes::{BUNDLE, MOST_NODES, Nodes, slot};
use crate::solve::state::History;
use std::ops::Range;

/// [`UniformChain::shift`] compiled for the vector units that the machine may have, chosen when it runs.
#[cfg_attr(
    not(any(test, feature = "portable", debug_assertions)),
    multiversion::multiversion(targets("x86_64+avx2+fma"))
)]
pub(super) fn shifted<N: Nodes, const F: usize>(chain: &UniformChain<F>, at: Configuration, ends: &[f64]) -> Vec<f64> {
    chain.shift(N::of_order(chain.basis.order), at, ends)
}

/// [`UniformChain::states_of`] for a number of nodes.
pub(super) fn node_states<N: Nodes, const F: usize>(
    chain: &UniformChain<F>,
    at: Configuration,
    elements: Range<usize>,
) -> Vec<NodeState> {
    chain.states_of(N::of_order(chain.basis.order), at, elements)
}

/// [`UniformChain::sum_energy`], likewise.
#[cfg_attr(
    not(any(test, feature = "portable", debug_assertions)),
    multiversion::multiversion(targets("x86_64+avx2+fma"))
)]
pub(super) fn energy<N: Nodes, const F: usize>(
    chain: &UniformChain<F>,
    at: Configuration,
    direction: &[f64],
) -> (ElementEnergy, f64) {
    chain.sum_energy(N::of_order(chain.basis.order), at, direction)
}

/// The fields of a section at S with x in place of ξ, where that is one of them.
fn in_place<const F: usize>(place: f64, fields: [f64; F]) -> [f64; MOST_FIELDS] {
    let mut all = [0.0; MOST_FIELDS];
    all[..F].copy_from_slice(&fields);
    if F == MOST_FIELDS {
        all[0] += place;
    }
    all
}

impl<const F: usize> UniformChain<F> {
    #[inline(always)]
    fn sum_energy(&self, nodes: impl Nodes, at: Configuration, direction: &[f64]) -> (ElementEnergy, f64) {
        let elements = at.ends.len() - 1;
        let mut sums = [0.0; 3];
        let (by, mut bundle) = (self.integration(nodes, at.history), Element::zero());
        for first in (0..elements).step_by(BUNDLE) {
            let changes = self.gather_values(nodes, direction, first, elements);
            self.gather_bundle(nodes, at, first, &mut bundle);
            let parts = bundle.energy(&by, &changes);
            for (sum, part) in sums.iter_mut().zip(parts) {
                *sum += part.0[..BUNDLE.min(elements - first)].iter().sum::<f64>();
            }
        }
        for e in if self.has_knots { 0..elements } else { 0..0 } {
            let changes = self.gather(nodes, direction, e);
            self.element(nodes, at, e).piecewise(&by, |point| {
                let change = combine(nodes, &changes, &point.shape);
                let turned: f64 = (0..F).map(|f| point.response.coverage_by_value[f] * change[f]).sum();
                let parts = [point.response.energy, point.response.coverage, turned];
                sums.iter_mut().zip(parts).for_each(|(sum, part)| *sum += point.weight * part);
            });
        }
        (ElementEnergy { total: sums[0], coverage: sums[1] }, sums[2])
    }

    #[inline(always)]
    fn shift(&self, nodes: impl Nodes, at: Configuration, ends: &[f64]) -> Vec<f64> {
        let mut state = at.state.to_vec();
        for e in 0..ends.len() - 1 {
            let values = self.gather(nodes, at.state, e);
            let (from, length) = (at.ends[e], at.ends[e + 1] - at.ends[e]);
            let (new_from, new_length) = (ends[e], ends[e + 1] - ends[e]);
            let first = self.basis.differentiate(nodes, &values);
            let second = self.basis.differentiate(nodes, &first);
            for rank in usize::from(e > 0)..nodes.count() {
                let a = slot(nodes.count(), rank);
                let place = 0.5 * (1.0 + self.basis.nodes[a]);
                let shift = 2.0 / length * (new_from - from + place * (new_length - length));
                for f in 0..F {
                    state[(e * (nodes.count() - 1) + rank) * F + f] +=
                        shift * (first[a][f] + 0.5 * shift * second[a][f]);
                }
            }
        }
        state
    }

    /// [`super::Chain::residual`]
    pub(super) fn residual_of(&self, at: Configuration) -> (Vec<f64>, f64) {
        let (nodes, mut residual, mut by_border) = (self.nodes(), vec![0.0; at.state.len()], 0.0);
        let by = self.integration(nodes, at.history);
        for e in 0..at.ends.len() - 1 {
            let element = self.element(nodes, at, e);
            self.scatter(e, &element.forces(&by), &mut residual);
            by_border += element.border_force(nodes, &*self.density, &self.basis);
        }
        for (f, held) in self.pinned_left.iter().enumerate() {
            residual[f] = held.map_or(residual[f], |held| at.state[f] - held);
        }
        (residual, by_border)
    }

    /// [`super::Chain::coverage_gradient`]
    pub(super) fn coverage_gradient_of(&self, at: Configuration) -> Vec<f64> {
        let (nodes, mut gradient) = (self.nodes(), vec![0.0; at.state.len()]);
        for e in 0..at.ends.len() - 1 {
            let element = self.element(nodes, at, e);
            self.scatter(e, &element.coverage_forces(&self.integration(nodes, at.history)), &mut gradient);
        }
        gradient
    }

    /// Adds numbers of the nodes of an element, in elimination order, to those of the chain.
    fn scatter(&self, e: usize, own: &[[f64; F]], all: &mut [f64]) {
        let order = self.basis.order;
        for rank in 0..=order {
            for f in 0..F {
                all[(e * order + rank) * F + f] += own[slot(order + 1, rank)][f];
            }
        }
    }

    /// [`super::Chain::node_states`]
    #[inline(always)]
    fn states_of(&self, nodes: impl Nodes, at: Configuration, elements: Range<usize>) -> Vec<NodeState> {
        let (order, by) = (nodes.count() - 1, self.integration(nodes, at.history));
        let mut states = Vec::with_capacity(elements.len() + 1);
        for e in elements.clone() {
            let element = self.element(nodes, at, e);
            let (values, forces) = (element.values, element.forces(&by));
            let slopes = self.basis.differentiate(nodes, &values);
            let mut node = |slot: usize, position: f64, sign: f64| {
                let forces = forces[slot].map(|force| sign * force);
                let mut section =
                    self.density.section_state_from_forces(position, values[slot], forces, at.axial_multiplier);
                if self.density.yields() {
                    let mut slopes = slopes[slot].map(|slope| slope * element.stretch());
                    slopes[0] += 1.0;
                    (section.horizontal_slope, section.vertical_slope) = (slopes[0], slopes[1]);
                    section.curvature = slopes[F - 1];
                }
                let memory = memory_of(at.history, position);
                let adhesion = self.density.adhesion_at(position, values[slot], memory, at.axial_multiplier);
                states.push(NodeState { position, values: in_place(position, values[slot]), section, adhesion });
            };
            if e == elements.start {
                node(order - 1, at.ends[e], -1.0);
            }
            node(order, at.ends[e + 1], 1.0);
        }
        states
    }

    /// [`super::Chain::sample`]
    pub(super) fn sample_at(
        &self,
        at: Configuration,
        element: usize,
        local: f64,
    ) -> ([f64; MOST_FIELDS], SectionState) {
        let length = at.ends[element + 1] - at.ends[element];
        let (shape, shape_slope) = self.basis.sample(local);
        let values = self.gather(self.nodes(), at.state, element);
        let value = combine(self.nodes(), &values, &shape);
        let slope = combine(self.nodes(), &values, &shape_slope.map(|slope| slope * (2.0 / length)));
        let place = at.ends[element] + 0.5 * (1.0 + local) * length;
        let memory = memory_of(at.history, place);
        (
            in_place(place, value),
            self.density.section_state(&Point { place, value, slope, memory }, at.axial_multiplier),
        )
    }

    /// [`super::Chain::updated_history`]
    pub(super) fn updated(&self, at: Configuration, before: f64) -> Option<(History, f64)> {
        let known = at.history.filter(|_| self.density.remembers())?;
        let (mut e, mut values) = (0, self.gather(self.nodes(), at.state, 0));
        Some(known.updated(|s, row| {
            while e + 2 < at.ends.len() && s > at.ends[e + 1] {
                e += 1;
                values = self.gather(self.nodes(), at.state, e);
            }
            let local = 2.0 * (s - at.ends[e]) / (at.ends[e + 1] - at.ends[e]) - 1.0;
            let (shape, shape_slope) = self.basis.sample(local);
            let per_length = 2.0 / (at.ends[e + 1] - at.ends[e]);
            let value = combine(self.nodes(), &values, &shape);
            let slope = combine(self.nodes(), &values, &shape_slope.map(|slope| slope * per_length));
            self.density.remember(&StepEnd { place: s, value, slope, before }, row)
        }))
    }

    /// [`super::Chain::resampled`]
    pub(super) fn resample(&self, at: Configuration, ends: &[f64]) -> Vec<f64> {
        let order = self.basis.order;
        let mut state = Vec::with_capacity(((ends.len() - 1) * order + 1) * F);
        let mut old = 0;
        for e in 0..ends.len() - 1 {
            let last = usize::from(e + 2 == ends.len());
            for rank in 0..order + last {
                let place = 0.5 * (1.0 + self.basis.nodes[slot(order + 1, rank)]);
                let s = ends[e] + place * (ends[e + 1] - ends[e]);
                while old + 2 < at.ends.len() && s > at.ends[old + 1] {
                    old += 1;
                }
                let local = 2.0 * (s - at.ends[old]) / (at.ends[old + 1] - at.ends[old]) - 1.0;
                let values = self.gather(self.nodes(), at.state, old);
                state.extend_from_slice(&combine(self.nodes(), &values, &self.basis.sample_values(local)));
            }
        }
        state
    }
}

/// Σ shape·values over the nodes.
#[inline(always)]
fn combine<const F: usize>(nodes: impl Nodes, values: &[[f64; F]; MOST_NODES], shape: &PerNode) -> [f64; F] {
    let mut sum = [0.0; F];
    for a in 0..nodes.count() {
        for f in 0..F {
            sum[f] += shape[a] * values[a][f];
        }
    }
    sum
}
