//! Lagrange polynomials of order p at the Gauss-Lobatto nodes, sampled at p Gauss points.
//!
//! With p Gauss points for every term, adhesion too, an element of order p does not lock and is as accurate at its end
//! nodes as p-stage Gauss collocation, order 2p.

use crate::number::gauss::gauss_legendre;
use crate::number::{F64x4, Real};
use crate::solve::frontal::nodes::{MOST_NODES, Nodes, slot};
use gauss_quad::{FiniteAboveNegOneF64, GaussJacobi};
use std::num::NonZeroUsize;

/// The highest order of an element.
pub const MOST_ORDER: usize = MOST_NODES - 1;

/// Points of the rule for a part of an element.
const FINE: NonZeroUsize = NonZeroUsize::MIN.saturating_add(9);

/// Shape functions of an element with N = p + 1 nodes on [-1, 1]. Nodes come in elimination order: the interior ones
/// from left to right, then the left end, then the right end. Behind the last node and the last point the tables are zero.
#[derive(Clone, Debug)]
pub struct Basis {
    /// p
    pub order: usize,
    /// Local coordinates of the nodes.
    pub nodes: PerNode,
    /// Local coordinates of the p Gauss points.
    pub points: PerNode,
    /// Gauss weights.
    pub weights: PerNode,
    /// Points and weights of a finer rule, for a part of an element.
    pub fine: Vec<(f64, f64)>,
    /// `value[q][a]`: shape function a at point q.
    pub value: [PerNode; MOST_NODES],
    /// `slope[q][a]`: its derivative with respect to the local coordinate.
    pub slope: [PerNode; MOST_NODES],
    /// `four_values_of[a][q]`: shape function a at point q, four times side by side.
    pub four_values_of: [[F64x4; MOST_NODES]; MOST_NODES],
    /// Its derivative, likewise.
    pub four_slopes_of: [[F64x4; MOST_NODES]; MOST_NODES],
    /// `nodal_slope[b][a]`: derivative of shape function a at node b.
    pub nodal_slope: [PerNode; MOST_NODES],
    /// `primitive[a][q]`: the integral from the left end to node a of the polynomial of degree p - 1 that is one at Gauss point q and zero at
    /// the others, over the local coordinate.
    pub primitive: [PerNode; MOST_NODES],
    /// `apart[a][b]`: one over how far node a is behind node b; zero of a node from itself.
    apart: [PerNode; MOST_NODES],
}

/// A number for each node or each point.
pub(crate) type PerNode = [f64; MOST_NODES];

impl Basis {
    /// The tables of an order from 1 to [`MOST_ORDER`].
    pub(crate) fn new(order: usize) -> Self {
        let count = order + 1;
        let zero = [[0.0; MOST_NODES]; MOST_NODES];
        let mut nodes = [0.0; MOST_NODES];
        for (rank, node) in lobatto_nodes(order).into_iter().enumerate() {
            nodes[slot(count, rank)] = node;
        }
        let [points, weights] = [[0.0; MOST_NODES]; 2];
        let [value, slope, nodal_slope, mut apart] = [zero; 4];
        for a in 0..count {
            for b in (0..count).filter(|&b| b != a) {
                apart[a][b] = 1.0 / (nodes[a] - nodes[b]);
            }
        }
        let [four_values_of, four_slopes_of] = [[[F64x4::splat(0.0); MOST_NODES]; MOST_NODES]; 2];
        let mut basis = Self {
            order,
            nodes,
            points,
            weights,
            fine: gauss_legendre(FINE),
            value,
            slope,
            four_values_of,
            four_slopes_of,
            nodal_slope,
            primitive: zero,
            apart,
        };
        for b in 0..count {
            basis.nodal_slope[b] = basis.sample(nodes[b]).1;
        }
        let gauss = NonZeroUsize::new(order).map_or_else(Vec::new, gauss_legendre);
        for (q, (point, weight)) in gauss.into_iter().enumerate() {
            basis.points[q] = point;
            basis.weights[q] = weight;
            (basis.value[q], basis.slope[q]) = basis.sample(point);
        }
        basis.primitive = std::array::from_fn(|a| std::array::from_fn(|q| basis.integral(a, q)));
        let by_node =
            |table: &[PerNode; MOST_NODES]| std::array::from_fn(|a| std::array::from_fn(|q| F64x4::splat(table[q][a])));
        basis.four_values_of = by_node(&basis.value);
        basis.four_slopes_of = by_node(&basis.slope);
        basis
    }

    /// An entry of [`Basis::primitive`], by the Gauss rule between the left end and the node.
    fn integral(&self, node: usize, point: usize) -> f64 {
        let (points, half) = (&self.points[..self.order], 0.5 * (self.nodes[node] + 1.0));
        if node > self.order || point >= self.order {
            return 0.0;
        }
        let cardinal = |at: f64| {
            let others = points.iter().enumerate().filter(|&(q, _)| q != point);
            others.map(|(_, other)| (at - other) / (points[point] - other)).product::<f64>()
        };
        points.iter().zip(self.weights).map(|(at, weight)| half * weight * cardinal(half * (at + 1.0) - 1.0)).sum()
    }

    /// Derivatives at the nodes, with respect to the local coordinate, of fields given at the nodes.
    #[inline(always)]
    pub(crate) fn differentiate<const F: usize>(
        &self,
        nodes: impl Nodes,
        values: &[[f64; F]; MOST_NODES],
    ) -> [[f64; F]; MOST_NODES] {
        let mut slopes = [[0.0; F]; MOST_NODES];
        for b in 0..nodes.count() {
            for a in 0..nodes.count() {
                for f in 0..F {
                    slopes[b][f] += self.nodal_slope[b][a] * values[a][f];
                }
            }
        }
        slopes
    }

    /// Weight of node `a` in the Gauss-Lobatto rule of the nodes, over the length of the element: ½ ∫ Nₐ dξ.
    pub(crate) fn lobatto_weight(&self, a: usize) -> f64 {
        0.5 * (0..self.order).map(|q| self.weights[q] * self.value[q][a]).sum::<f64>()
    }

    /// Values and slopes of all shape functions at the local coordinate `at`.
    pub(crate) fn sample(&self, at: f64) -> (PerNode, PerNode) {
        let nodes = &self.nodes[..self.order + 1];
        let (mut values, mut slopes) = ([0.0; MOST_NODES], [0.0; MOST_NODES]);
        for a in 0..nodes.len() {
            let (mut value, mut slope) = (1.0, 0.0);
            for b in (0..nodes.len()).filter(|&b| b != a) {
                let factor = self.apart[a][b];
                slope = (slope * (at - nodes[b]) + value) * factor;
                value *= (at - nodes[b]) * factor;
            }
            (values[a], slopes[a]) = (value, slope);
        }
        (values, slopes)
    }

    /// The values alone, likewise.
    pub(crate) fn sample_values(&self, at: f64) -> PerNode {
        let count = self.order + 1;
        let mut values = [0.0; MOST_NODES];
        for a in 0..count {
            let mut value = 1.0;
            for b in (0..count).filter(|&b| b != a) {
                value *= (at - self.nodes[b]) * self.apart[a][b];
            }
            values[a] = value;
        }
        values
    }
}

/// The p + 1 Gauss-Lobatto nodes on [-1, 1], ascending: the ends and the zeros of the Jacobi polynomial P^(1,1)_{p-1}.
fn lobatto_nodes(order: usize) -> Vec<f64> {
    let mut nodes = vec![-1.0, 1.0];
    if let (Some(interior), Some(one)) = (NonZeroUsize::new(order - 1), FiniteAboveNegOneF64::new(1.0)) {
        nodes.extend(GaussJacobi::new(interior, one, one).nodes().copied());
    }
    nodes.sort_by(f64::total_cmp);
    nodes
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;

    /// Interpolates a polynomial of degree p exactly and integrates one of degree 2p - 1 exactly.
    fn exact(order: usize) {
        let basis = Basis::new(order);
        let p = order as i32;
        for at in [-0.93, 0.1, 0.77f64] {
            let (value, slope) = basis.sample(at);
            let sum = |s: &PerNode, k: i32| (0..=order).map(|a| s[a] * basis.nodes[a].powi(k)).sum::<f64>();
            assert_abs_diff_eq!(sum(&value, p), at.powi(p), epsilon = 1e-13);
            assert_abs_diff_eq!(sum(&slope, p), f64::from(p) * at.powi(p - 1), epsilon = 1e-12);
        }
        let even = 2 * p - 2;
        let integral: f64 = (0..order).map(|q| basis.weights[q] * basis.points[q].powi(even)).sum();
        assert_abs_diff_eq!(integral, 2.0 / f64::from(even + 1), epsilon = 1e-13);
    }

    #[test]
    fn every_order_is_exact_to_its_degree() {
        (1..=MOST_ORDER).for_each(exact);
    }
}
