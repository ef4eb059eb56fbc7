//! The fields of elements one behind the other, read off on elements that end elsewhere.

use super::read::{combine, normalise};
use super::spatial_chain::{SpatialChain, SpatialConfiguration};
use crate::beam::element::basis::Basis;
use crate::beam::spatial::section::kinematics::SPATIAL_FIELDS;
use crate::solve::frontal::nodes::{AnyNumber, MOST_NODES, Nodes, slot};

const N: usize = SPATIAL_FIELDS;

/// Fields node by node, from S = 0 on, and where their elements end.
#[derive(Clone, Copy)]
pub(crate) struct FieldsAlong<'a> {
    /// Of the elements
    pub basis: &'a Basis,
    /// S of their ends, nm
    pub boundaries: &'a [f64],
    /// Of each node
    pub fields: &'a [f64],
}

impl<'a> FieldsAlong<'a> {
    /// Of a chain.
    pub(crate) fn of(chain: &'a SpatialChain, at: SpatialConfiguration<'a>) -> Self {
        Self { basis: &chain.basis, boundaries: at.boundaries, fields: at.fields }
    }

    /// The fields of the nodes of an element, in elimination order.
    fn element(&self, e: usize) -> [[f64; N]; MOST_NODES] {
        let (order, mut values) = (self.basis.order, [[0.0; N]; MOST_NODES]);
        for rank in 0..=order {
            let from = (e * order + rank) * N;
            values[slot(order + 1, rank)].copy_from_slice(&self.fields[from..from + N]);
        }
        values
    }

    /// The fields on boundaries of elements that lie a little beside: each node moved along the polynomial of its element, to second order in the
    /// move.
    pub(crate) fn shifted(&self, boundaries: &[f64]) -> Vec<f64> {
        let (basis, order) = (self.basis, self.basis.order);
        let (nodes, count) = (AnyNumber::of_order(order), order + 1);
        let mut fields = self.fields.to_vec();
        for e in 0..boundaries.len() - 1 {
            let values = self.element(e);
            let (was, length_before) = (self.boundaries[e], self.boundaries[e + 1] - self.boundaries[e]);
            let (from, length) = (boundaries[e], boundaries[e + 1] - boundaries[e]);
            let first = basis.differentiate(nodes, &values);
            let second = basis.differentiate(nodes, &first);
            for rank in usize::from(e > 0)..count {
                let a = slot(count, rank);
                let place = 0.5 * (1.0 + basis.nodes[a]);
                let shift = 2.0 / length_before * (from - was + place * (length - length_before));
                let node = &mut fields[(e * order + rank) * N..][..N];
                for f in 0..N {
                    node[f] += shift * (first[a][f] + 0.5 * shift * second[a][f]);
                }
                normalise(node);
            }
        }
        fields
    }

    /// The fields on other boundaries of elements, each new node read off the element it falls in.
    pub(crate) fn resampled(&self, boundaries: &[f64]) -> Vec<f64> {
        let (order, mut old) = (self.basis.order, 0);
        let mut fields = Vec::with_capacity(((boundaries.len() - 1) * order + 1) * N);
        for (e, pair) in boundaries.windows(2).enumerate() {
            let last = usize::from(e + 2 == boundaries.len());
            for rank in 0..order + last {
                let place = 0.5 * (1.0 + self.basis.nodes[slot(order + 1, rank)]);
                let s = pair[0] + place * (pair[1] - pair[0]);
                while old + 2 < self.boundaries.len() && s > self.boundaries[old + 1] {
                    old += 1;
                }
                let (from, to) = (self.boundaries[old], self.boundaries[old + 1]);
                let shape = self.basis.sample_values(2.0 * (s - from) / (to - from) - 1.0);
                let mut node = combine(&self.element(old), &shape);
                normalise(&mut node);
                fields.extend_from_slice(&node);
            }
        }
        fields
    }
}
