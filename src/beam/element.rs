//! The element: integrates a density into its front, the matrix that elimination works on.

use super::{Basis, Density};
use crate::number::Lanes;

/// Energy of one element, nN·nm.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ElementEnergy {
    /// Stored and adhesion energy.
    pub total: f64,
    /// Adhesion alone.
    pub adhesion: f64,
}

/// Shape functions of one element spread over its front: entry `[q][f][a F + f]` belongs to field f at node a, all others
/// are zero, so that a row of the front is a sum of whole vectors.
#[derive(Clone, Debug)]
pub struct Spread<const F: usize, const N: usize, const M: usize> {
    value: [[[f64; M]; F]; N],
    slope: [[[f64; M]; F]; N],
}

impl<const F: usize, const N: usize, const M: usize> Spread<F, N, M> {
    /// Spreads the tables of a basis.
    pub fn new(basis: &Basis<N>) -> Self {
        let spread = |table: &[[f64; N]; N]| {
            let mut out = [[[0.0; M]; F]; N];
            for q in 0..N - 1 {
                for f in 0..F {
                    for a in 0..N {
                        out[q][f][a * F + f] = table[q][a];
                    }
                }
            }
            out
        };
        Self { value: spread(&basis.value), slope: spread(&basis.slope) }
    }
}

/// Fields and their slopes along S at all Gauss points side by side, from nodal values.
#[inline(always)]
pub fn side_by_side<const F: usize, const N: usize>(
    basis: &Basis<N>,
    values: &[[f64; F]; N],
    length: f64,
) -> ([Lanes<N>; F], [Lanes<N>; F]) {
    let (mut value_at, mut slope_at) = ([Lanes([0.0; N]); F], [Lanes([0.0; N]); F]);
    for a in 0..N {
        for f in 0..F {
            value_at[f] = value_at[f] + Lanes(basis.value_of[a]) * values[a][f];
            slope_at[f] = slope_at[f] + Lanes(basis.slope_of[a]) * (values[a][f] * (2.0 / length));
        }
    }
    (value_at, slope_at)
}

/// S at all Gauss points of an element side by side, nm.
#[inline(always)]
pub fn places<const N: usize>(basis: &Basis<N>, from: f64, length: f64) -> Lanes<N> {
    (Lanes(basis.points) + 1.0) * (0.5 * length) + from
}

/// Integrates one element into its front.
///
/// The front is square of size M = F N + border + 1. Rows are equations and columns unknowns, node by node in the
/// elimination order of [`Basis`], F a node; then the border, if the density has one; the last column holds the
/// gradient, the last row `path_weight` times the gradient of the adhesion energy. `values[a][f]` is field f at node a;
/// the element reaches from S = `from` over the reference length `length`, nm. Everything in the front is overwritten.
#[allow(clippy::too_many_arguments)]
#[inline(always)]
pub fn integrate<D: Density<F>, const F: usize, const N: usize, const M: usize>(
    density: &D,
    basis: &Basis<N>,
    spread: &Spread<F, N, M>,
    values: &[[f64; F]; N],
    (from, length): (f64, f64),
    border: f64,
    path_weight: f64,
    front: &mut [[f64; M]; M],
) -> ElementEnergy {
    let has_border = M == F * N + 2;
    let (edge, last) = (F * N, M - 1);
    let stretch = 2.0 / length;
    let (value_at, slope_at) = side_by_side(basis, values, length);
    let r = density.response(places(basis, from, length), value_at, slope_at, border);
    let weights = Lanes(basis.weights) * (0.5 * length);

    // per Gauss point and field: the row that its value weighs, and the row that its slope weighs; a slope carries the
    // factor 2/length once as a column and once as a row
    let mut by_value = [[[0.0; M]; F]; N];
    let mut by_slope = [[[0.0; M]; F]; N];
    for q in 0..N - 1 {
        let weight = weights.0[q];
        let (values, slopes) = (&spread.value[q], &spread.slope[q]);
        for f in 0..F {
            for g in 0..F {
                let (vv, vs) = (weight * r.value_value[f][g].0[q], weight * stretch * r.value_slope[f][g].0[q]);
                let (sv, ss) = (r.slope_value[f][g].0[q], stretch * r.slope_slope[f][g].0[q]);
                let (sv, ss) = (weight * stretch * sv, weight * stretch * ss);
                for j in 0..M {
                    by_value[q][f][j] += vv * values[g][j] + vs * slopes[g][j];
                    by_slope[q][f][j] += sv * values[g][j] + ss * slopes[g][j];
                }
            }
        }
    }
    let mut path_row = [0.0; M];
    let mut border_row = [0.0; M];
    for q in 0..N - 1 {
        let (weight, weight_s) = (weights.0[q], weights.0[q] * stretch);
        for f in 0..F {
            by_value[q][f][last] = weight * r.by_value[f].0[q];
            by_slope[q][f][last] = weight_s * r.by_slope[f].0[q];
            let path = weight * path_weight * r.adhesion_by_value[f].0[q];
            for j in 0..M {
                path_row[j] += path * spread.value[q][f][j];
            }
            if has_border {
                let (on_value, on_slope) = (weight * r.border_value[f].0[q], weight_s * r.border_slope[f].0[q]);
                by_value[q][f][edge] = on_value;
                by_slope[q][f][edge] = on_slope;
                for j in 0..M {
                    border_row[j] += on_value * spread.value[q][f][j] + on_slope * spread.slope[q][f][j];
                }
            }
        }
        if has_border {
            border_row[edge] += weight * r.border_border.0[q];
            border_row[last] += weight * r.by_border.0[q];
        }
    }
    for a in 0..N {
        for f in 0..F {
            let mut row = [0.0; M];
            for q in 0..N - 1 {
                let (v, s) = (basis.value[q][a], basis.slope[q][a]);
                for j in 0..M {
                    row[j] += v * by_value[q][f][j] + s * by_slope[q][f][j];
                }
            }
            front[a * F + f] = row;
        }
    }
    if has_border {
        front[edge] = border_row;
    }
    front[last] = path_row;
    ElementEnergy { total: (weights * r.energy).0.iter().sum(), adhesion: (weights * r.adhesion).0.iter().sum() }
}
