//! What is read off a configuration: energies, gradients, and its fields in other places.

use super::projection::{projected, turn_to_quaternion};
use super::spatial_chain::{SpatialChain, SpatialConfiguration, gather_nodes, no_values, quaternion_of};
use crate::beam::element::basis::PerNode;
use crate::beam::element::integration::{Element, ElementEnergy};
use crate::beam::spatial::rotation::{apply, normalised};
use crate::beam::spatial::section::kinematics::{SPATIAL_FIELDS, SPATIAL_UNKNOWNS};
use crate::solve::frontal::nodes::{BUNDLE, MOST_NODES, slot};
use std::ops::Range;

const F: usize = SPATIAL_UNKNOWNS;
const N: usize = SPATIAL_FIELDS;

impl SpatialChain {
    /// Energy and coverage, and how the coverage changes along a direction.
    pub fn energy(&self, at: SpatialConfiguration, direction: &[f64]) -> (ElementEnergy, f64) {
        let elements = at.boundaries.len() - 1;
        let (nodes, mut sums, mut bundle) = (self.nodes(), [0.0; 3], Element::zero());
        let (by, change) = (self.integration(nodes), self.change_of_fields(at, direction));
        for first in (0..elements).step_by(BUNDLE) {
            self.gather(nodes, at, first, &mut bundle);
            let mut changes = no_values::<N>();
            gather_nodes(nodes, &change, (first, elements), &mut changes);
            for (sum, part) in sums.iter_mut().zip(bundle.energy_in_pieces(&by, &changes)) {
                *sum += part.0[..BUNDLE.min(elements - first)].iter().sum::<f64>();
            }
        }
        (ElementEnergy { total: sums[0], coverage: sums[1] }, sums[2])
    }

    /// A direction as one of the nodes alone, without ends of their own.
    pub(crate) fn direction_of_nodes(&self, at: SpatialConfiguration, direction: &[f64]) -> Vec<f64> {
        let mut own = direction.to_vec();
        let last = own.len() - F;
        for (end, from) in [(0, 0), (1, last)] {
            own[from..from + F].copy_from_slice(&self.end_map(at, end).forward(&direction[from..from + F]));
        }
        own
    }

    /// The change of the fields along a direction.
    fn change_of_fields(&self, at: SpatialConfiguration, direction: &[f64]) -> Vec<f64> {
        let own = self.direction_of_nodes(at, direction);
        let mut change = Vec::with_capacity(at.fields.len());
        for (node, own) in at.fields.chunks_exact(N).zip(own.chunks_exact(F)) {
            change.extend_from_slice(&own[..3]);
            change.extend(apply(&turn_to_quaternion(quaternion_of(node)), &[own[3], own[4], own[5]]));
        }
        change
    }

    /// A gradient by the fields of the nodes as one by the unknowns.
    fn by_unknowns(&self, at: SpatialConfiguration, by_fields: &[f64]) -> Vec<f64> {
        let mut out = Vec::with_capacity(by_fields.len() / N * F);
        for (node, by) in at.fields.chunks_exact(N).zip(by_fields.as_chunks::<N>().0) {
            out.extend(projected(by, &turn_to_quaternion(quaternion_of(node))));
        }
        let last = out.len() - F;
        for (end, from) in [(0, 0), (1, last)] {
            let taken = self.end_map(at, end).back(&out[from..from + F]);
            out[from..from + F].copy_from_slice(&taken);
        }
        out
    }

    /// The residual: the gradient of the energy less the dead load, and by how much what is held of the left end is off.
    pub fn residual(&self, at: SpatialConfiguration) -> Vec<f64> {
        let by = self.integration(self.nodes());
        let fields = self.summed(at, |element| element.forces(&by));
        let mut residual = self.by_unknowns(at, &fields);
        let (load, _) = self.dead_load(at);
        let last = residual.len() - F;
        (0..F).for_each(|f| residual[last + f] -= load[f]);
        for (f, off) in self.off(at).into_iter().enumerate() {
            residual[f] = off.unwrap_or(residual[f]);
        }
        residual
    }

    /// The residual of the unknowns of the right end alone, to which one element contributes.
    pub(crate) fn residual_of_right_end(&self, at: SpatialConfiguration) -> [f64; F] {
        let (by, last) = (self.integration(self.nodes()), slot(self.basis.order + 1, self.basis.order));
        let element = self.element(at, at.boundaries.len() - 2);
        let turned = turn_to_quaternion(quaternion_of(&element.values[last]));
        let taken = self.end_map(at, 1).back(&projected(&element.forces(&by)[last], &turned));
        let (load, _) = self.dead_load(at);
        std::array::from_fn(|f| taken[f] - load[f])
    }

    /// The gradient of the coverage.
    pub(crate) fn coverage_gradient(&self, at: SpatialConfiguration) -> Vec<f64> {
        let by = self.integration(self.nodes());
        let fields = self.summed(at, |element| element.coverage_forces(&by));
        self.by_unknowns(at, &fields)
    }

    /// Numbers of the nodes of each element, summed.
    fn summed(&self, at: SpatialConfiguration, of: impl Fn(&Element<f64, N>) -> [[f64; N]; MOST_NODES]) -> Vec<f64> {
        let (order, mut all) = (self.basis.order, vec![0.0; at.fields.len()]);
        for e in 0..at.boundaries.len() - 1 {
            let own = of(&self.element(at, e));
            for rank in 0..=order {
                for f in 0..N {
                    all[(e * order + rank) * N + f] += own[slot(order + 1, rank)][f];
                }
            }
        }
        all
    }

    /// Section force (along x, y, z, nN) and moment (about the directors, nN·nm) at the ends of the elements of a range, from nodal forces:
    /// as accurate as the energy. From the left end of the first element on.
    pub(crate) fn end_forces(&self, at: SpatialConfiguration, elements: Range<usize>) -> Vec<[f64; F]> {
        let (order, by) = (self.basis.order, self.integration(self.nodes()));
        let mut ends = Vec::with_capacity(elements.len() + 1);
        for e in elements.clone() {
            let element = self.element(at, e);
            let forces = element.forces(&by);
            let at_node = |rank: usize| {
                let node = slot(order + 1, rank);
                projected(&forces[node], &turn_to_quaternion(quaternion_of(&element.values[node])))
            };
            if e == elements.start {
                ends.push(at_node(0).map(|force| -force));
            }
            ends.push(at_node(order));
        }
        ends
    }

    /// Fields at the local coordinate `local` in [-1, 1] of an element, and their slopes along S; the quaternion as it is interpolated.
    pub fn sample(&self, at: SpatialConfiguration, element: usize, local: f64) -> ([f64; N], [f64; N]) {
        let (shape, slopes) = self.basis.sample(local);
        let own = self.element(at, element);
        let value = combine(&own.values, &shape);
        let stretch = 2.0 / own.length;
        (value, combine(&own.values, &slopes).map(|slope| slope * stretch))
    }
}

/// Makes the quaternion of a node one of length one.
pub(crate) fn normalise(node: &mut [f64]) {
    let unit = normalised(quaternion_of(node));
    node[3..].copy_from_slice(&unit);
}

/// Σ shape·values over the nodes.
pub(super) fn combine(values: &[[f64; N]; MOST_NODES], shape: &PerNode) -> [f64; N] {
    let mut sum = [0.0; N];
    for a in 0..MOST_NODES {
        for f in 0..N {
            sum[f] += shape[a] * values[a][f];
        }
    }
    sum
}
