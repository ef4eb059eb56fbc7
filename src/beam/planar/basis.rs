//! Lagrange polynomials of order p at the Gauss-Lobatto nodes, sampled at p Gauss points.
//!
//! With p Gauss points for every term, adhesion too, an element of order p does not lock and is as accurate at its end
//! nodes as p-stage Gauss collocation, order 2p.

use gauss_quad::{FiniteAboveNegOneF64, GaussJacobi, GaussLegendre};
use std::num::NonZeroUsize;

/// Shape functions of an element with N = p + 1 nodes on [-1, 1]. Nodes come in elimination order: the interior ones
/// from left to right, then the left end, then the right end.
#[derive(Clone, Debug)]
pub struct Basis<const N: usize> {
    /// Local coordinates of the nodes.
    pub nodes: [f64; N],
    /// Local coordinates of the N - 1 Gauss points; here and below the last of N entries is unused.
    pub points: [f64; N],
    /// Gauss weights.
    pub weights: [f64; N],
    /// `value[q][a]`: shape function a at point q.
    pub value: [[f64; N]; N],
    /// `slope[q][a]`: its derivative with respect to the local coordinate.
    pub slope: [[f64; N]; N],
    /// `value_of[a][q]` and `slope_of[a][q]`: the same two tables by node.
    pub value_of: [[f64; N]; N],
    /// See `value_of`.
    pub slope_of: [[f64; N]; N],
    /// `nodal_slope[b][a]`: derivative of shape function a at node b.
    pub nodal_slope: [[f64; N]; N],
}

impl<const N: usize> Basis<N> {
    /// Order p of the element.
    pub const ORDER: usize = N - 1;

    /// The tables. N is at least 2.
    pub fn new() -> Self {
        const { assert!(N >= 2) };
        let ascending = lobatto_nodes(Self::ORDER);
        let mut nodes = [0.0; N];
        for (rank, &node) in ascending.iter().enumerate() {
            nodes[Self::slot(rank)] = node;
        }
        let mut basis = Self {
            nodes,
            points: [0.0; N],
            weights: [0.0; N],
            value: [[0.0; N]; N],
            slope: [[0.0; N]; N],
            value_of: [[0.0; N]; N],
            slope_of: [[0.0; N]; N],
            nodal_slope: [[0.0; N]; N],
        };
        basis.nodal_slope = nodes.map(|node| lagrange(&nodes, node).1);
        for (q, (point, weight)) in gauss_points(Self::ORDER).into_iter().enumerate() {
            basis.points[q] = point;
            basis.weights[q] = weight;
            (basis.value[q], basis.slope[q]) = lagrange(&nodes, point);
        }
        basis.value_of = std::array::from_fn(|a| std::array::from_fn(|q| basis.value[q][a]));
        basis.slope_of = std::array::from_fn(|a| std::array::from_fn(|q| basis.slope[q][a]));
        basis
    }

    /// Place of the node of rank `rank` (from the left, 0 to p) in elimination order.
    #[inline(always)]
    pub fn slot(rank: usize) -> usize {
        match rank {
            0 => Self::ORDER - 1,
            r if r == Self::ORDER => r,
            r => r - 1,
        }
    }

    /// Derivatives at the nodes, with respect to the local coordinate, of fields given at the nodes.
    #[inline(always)]
    pub fn differentiate<const F: usize>(&self, values: &[[f64; F]; N]) -> [[f64; F]; N] {
        let mut slopes = [[0.0; F]; N];
        for b in 0..N {
            for a in 0..N {
                for f in 0..F {
                    slopes[b][f] += self.nodal_slope[b][a] * values[a][f];
                }
            }
        }
        slopes
    }

    /// Values and slopes of all shape functions at the local coordinate `at`.
    pub fn sample(&self, at: f64) -> ([f64; N], [f64; N]) {
        lagrange(&self.nodes, at)
    }
}

impl<const N: usize> Default for Basis<N> {
    fn default() -> Self {
        Self::new()
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

/// The p Gauss points and weights on [-1, 1], ascending.
fn gauss_points(order: usize) -> Vec<(f64, f64)> {
    let Some(degree) = NonZeroUsize::new(order) else { return Vec::new() };
    let mut pairs: Vec<(f64, f64)> = GaussLegendre::new(degree).as_node_weight_pairs().to_vec();
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
    pairs
}

/// All Lagrange polynomials of `nodes` and their derivatives at `at`.
fn lagrange<const N: usize>(nodes: &[f64; N], at: f64) -> ([f64; N], [f64; N]) {
    let mut value = [1.0; N];
    let mut slope = [0.0; N];
    for a in 0..N {
        for b in (0..N).filter(|&b| b != a) {
            let factor = 1.0 / (nodes[a] - nodes[b]);
            slope[a] = (slope[a] * (at - nodes[b]) + value[a]) * factor;
            value[a] *= (at - nodes[b]) * factor;
        }
    }
    (value, slope)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;

    /// Interpolates a polynomial of degree p exactly and integrates one of degree 2p - 1 exactly.
    fn exact<const N: usize>() {
        let basis = Basis::<N>::new();
        let p = N as i32 - 1;
        for at in [-0.93, 0.1, 0.77f64] {
            let (value, slope) = basis.sample(at);
            let sum = |s: &[f64; N], k: i32| (0..N).map(|a| s[a] * basis.nodes[a].powi(k)).sum::<f64>();
            assert_abs_diff_eq!(sum(&value, p), at.powi(p), epsilon = 1e-13);
            assert_abs_diff_eq!(sum(&slope, p), f64::from(p) * at.powi(p - 1), epsilon = 1e-12);
        }
        let even = 2 * p - 2;
        let integral: f64 = (0..N - 1).map(|q| basis.weights[q] * basis.points[q].powi(even)).sum();
        assert_abs_diff_eq!(integral, 2.0 / f64::from(even + 1), epsilon = 1e-13);
    }

    #[test]
    fn every_order_is_exact_to_its_degree() {
        exact::<2>();
        exact::<3>();
        exact::<4>();
        exact::<5>();
        exact::<6>();
        exact::<7>();
        exact::<8>();
        exact::<9>();
    }
}
