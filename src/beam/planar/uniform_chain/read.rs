//! What is read off a configuration: energies, section forces, and its fields in other places.

use super::{BUNDLE, UniformChain};
use crate::adhesion::Slip;
use crate::beam::{Basis, Configuration, ElementEnergy, MOST_FIELDS, NodeState, Point, SectionState};
use crate::solve::History;
use std::ops::Range;

/// [`UniformChain::shift`] compiled for the vector units that the machine may have, chosen when it runs.
#[cfg_attr(not(any(feature = "portable", debug_assertions)), multiversion::multiversion(targets("x86_64+avx2+fma")))]
pub(super) fn shifted<const F: usize, const N: usize>(
    chain: &UniformChain<F, N>,
    at: Configuration,
    ends: &[f64],
) -> Vec<f64> {
    chain.shift(at, ends)
}

/// [`UniformChain::sum_energy`], likewise.
#[cfg_attr(not(any(feature = "portable", debug_assertions)), multiversion::multiversion(targets("x86_64+avx2+fma")))]
pub(super) fn energy<const F: usize, const N: usize>(
    chain: &UniformChain<F, N>,
    at: Configuration,
    direction: &[f64],
) -> (ElementEnergy, f64) {
    chain.sum_energy(at, direction)
}

impl<const F: usize, const N: usize> UniformChain<F, N> {
    #[inline(always)]
    fn sum_energy(&self, at: Configuration, direction: &[f64]) -> (ElementEnergy, f64) {
        let elements = at.ends.len() - 1;
        let mut sums = [0.0; 3];
        for first in (0..elements).step_by(BUNDLE) {
            let changes = self.gather_bundle(direction, first, elements);
            let parts = self.bundle(at, first).energy(&*self.density, &self.basis, &changes);
            for (sum, part) in sums.iter_mut().zip(parts) {
                *sum += part.0[..BUNDLE.min(elements - first)].iter().sum::<f64>();
            }
        }
        (ElementEnergy { total: sums[0], adhesion: sums[1] }, sums[2])
    }

    #[inline(always)]
    fn shift(&self, at: Configuration, ends: &[f64]) -> Vec<f64> {
        let mut state = at.state.to_vec();
        for e in 0..ends.len() - 1 {
            let values = self.gather(at.state, e);
            let (from, length) = (at.ends[e], at.ends[e + 1] - at.ends[e]);
            let (new_from, new_length) = (ends[e], ends[e + 1] - ends[e]);
            let first = self.basis.differentiate(&values);
            let second = self.basis.differentiate(&first);
            for rank in usize::from(e > 0)..N {
                let a = Basis::<N>::slot(rank);
                let place = 0.5 * (1.0 + self.basis.nodes[a]);
                let shift = 2.0 / length * (new_from - from + place * (new_length - length));
                for f in 0..F {
                    state[(e * Self::ORDER + rank) * F + f] += shift * (first[a][f] + 0.5 * shift * second[a][f]);
                }
            }
        }
        state
    }

    /// [`super::Chain::residual`]
    pub(super) fn residual_of(&self, at: Configuration) -> (Vec<f64>, f64) {
        let (mut residual, mut by_border) = (vec![0.0; at.state.len()], 0.0);
        for e in 0..at.ends.len() - 1 {
            let element = self.element(at, e);
            self.scatter(e, &element.forces(&*self.density, &self.basis), &mut residual);
            by_border += element.border_force(&*self.density, &self.basis);
        }
        for (f, held) in self.pinned_left.iter().enumerate() {
            residual[f] = held.map_or(residual[f], |held| at.state[f] - held);
        }
        (residual, by_border)
    }

    /// [`super::Chain::adhesion_gradient`]
    pub(super) fn adhesion_gradient_of(&self, at: Configuration) -> Vec<f64> {
        let mut gradient = vec![0.0; at.state.len()];
        for e in 0..at.ends.len() - 1 {
            self.scatter(e, &self.element(at, e).adhesion_forces(&*self.density, &self.basis), &mut gradient);
        }
        gradient
    }

    /// Adds numbers of the nodes of an element, in elimination order, to those of the chain.
    fn scatter(&self, e: usize, own: &[[f64; F]; N], all: &mut [f64]) {
        for rank in 0..N {
            for f in 0..F {
                all[(e * Self::ORDER + rank) * F + f] += own[Basis::<N>::slot(rank)][f];
            }
        }
    }

    /// [`super::Chain::node_states`]
    pub(super) fn states_of(&self, at: Configuration, elements: Range<usize>) -> Vec<NodeState> {
        let mut states = Vec::with_capacity(elements.len() + 1);
        for e in elements.clone() {
            let element = self.element(at, e);
            let (values, forces) = (element.values, element.forces(&*self.density, &self.basis));
            let mut node = |slot: usize, position: f64, sign: f64| {
                let forces = forces[slot].map(|force| sign * force);
                let section = self.density.section_state_from_forces(position, values[slot], forces, at.border);
                let point = Point { place: position, value: values[slot], slope: [0.0; F], slip: [0.0; 2] };
                let adhesion = self.density.respond_at(&point, at.border).adhesion;
                let mut all = [0.0; MOST_FIELDS];
                all[..F].copy_from_slice(&values[slot]);
                states.push(NodeState { position, values: all, section, adhesion });
            };
            if e == elements.start {
                node(N - 2, at.ends[e], -1.0);
            }
            node(N - 1, at.ends[e + 1], 1.0);
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
        let (value, slope) = combine(&self.gather(at.state, element), &shape, &shape_slope, length);
        let mut all = [0.0; MOST_FIELDS];
        all[..F].copy_from_slice(&value);
        let place = at.ends[element] + 0.5 * (1.0 + local) * length;
        (all, self.density.section_state(place, value, slope, at.border))
    }

    /// [`super::Chain::slid`]
    pub(super) fn slide(&self, at: Configuration) -> Option<History> {
        let known = at.history.filter(|_| self.density.remembers())?;
        let (mut e, mut values) = (0, self.gather(at.state, 0));
        Some(known.updated(|s, [place, share, limit]| {
            while e + 2 < at.ends.len() && s > at.ends[e + 1] {
                e += 1;
                values = self.gather(at.state, e);
            }
            let local = 2.0 * (s - at.ends[e]) / (at.ends[e + 1] - at.ends[e]) - 1.0;
            let (shape, slope) = self.basis.sample(local);
            let before = Slip { place, share, limit };
            let (slip, lost) = self.density.remembered(s, combine(&values, &shape, &slope, 2.0).0, before);
            ([slip.place, slip.share, slip.limit], lost)
        }))
    }

    /// [`super::Chain::resampled`]
    pub(super) fn resample(&self, at: Configuration, ends: &[f64]) -> Vec<f64> {
        let mut state = Vec::with_capacity(((ends.len() - 1) * Self::ORDER + 1) * F);
        let mut old = 0;
        for e in 0..ends.len() - 1 {
            let last = usize::from(e + 2 == ends.len());
            for rank in 0..Self::ORDER + last {
                let place = 0.5 * (1.0 + self.basis.nodes[Basis::<N>::slot(rank)]);
                let s = ends[e] + place * (ends[e + 1] - ends[e]);
                while old + 2 < at.ends.len() && s > at.ends[old + 1] {
                    old += 1;
                }
                let local = 2.0 * (s - at.ends[old]) / (at.ends[old + 1] - at.ends[old]) - 1.0;
                let (shape, slope) = self.basis.sample(local);
                state.extend_from_slice(&combine(&self.gather(at.state, old), &shape, &slope, 2.0).0);
            }
        }
        state
    }
}

/// Fields and slopes from nodal values.
#[inline(always)]
fn combine<const F: usize, const N: usize>(
    values: &[[f64; F]; N],
    shape: &[f64; N],
    shape_slope: &[f64; N],
    length: f64,
) -> ([f64; F], [f64; F]) {
    let (mut value, mut slope) = ([0.0; F], [0.0; F]);
    for a in 0..N {
        for f in 0..F {
            value[f] += shape[a] * values[a][f];
            slope[f] += shape_slope[a] * (2.0 / length) * values[a][f];
        }
    }
    (value, slope)
}
