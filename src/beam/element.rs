//! The element: integrates a density into its front, the matrix that elimination works on.

use super::{Basis, Density};

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

/// Integrates one element into its front.
///
/// The front is square of size M = F N + border + 1. Rows are equations and columns unknowns, node by node in the
/// elimination order of [`Basis`], F a node; then the border, if the density has one; the last column holds the
/// gradient, the last row `path_weight` times the gradient of the adhesion energy. `values[a][f]` is field f at node a,
/// `length` the element's reference length in nm. Everything in the front is overwritten.
#[allow(clippy::too_many_arguments)]
#[inline(always)]
pub fn integrate<D: Density<F>, const F: usize, const N: usize, const M: usize>(
    density: &D,
    basis: &Basis<N>,
    spread: &Spread<F, N, M>,
    values: &[[f64; F]; N],
    length: f64,
    border: f64,
    path_weight: f64,
    front: &mut [[f64; M]; M],
) -> ElementEnergy {
    let has_border = M == F * N + 2;
    let (edge, last) = (F * N, M - 1);
    let stretch = 2.0 / length;
    let mut energy = ElementEnergy::default();
    // per Gauss point and field: the row that its value weighs, and the row that its slope weighs
    let mut by_value = [[[0.0; M]; F]; N];
    let mut by_slope = [[[0.0; M]; F]; N];
    let mut path_row = [0.0; M];
    let mut border_row = [0.0; M];
    for q in 0..N - 1 {
        let (mut value_at, mut slope_at) = ([0.0; F], [0.0; F]);
        for a in 0..N {
            for f in 0..F {
                value_at[f] += basis.value[q][a] * values[a][f];
                slope_at[f] += basis.slope[q][a] * values[a][f];
            }
        }
        let r = density.response(value_at, slope_at.map(|s| s * stretch), border);
        let weight = basis.weights[q] * (0.5 * length);
        energy.total += weight * r.energy;
        energy.adhesion += weight * r.adhesion;
        // slopes carry the factor 2/length twice: in the column and in the row
        let (weight_s, weight_ss) = (weight * stretch, weight * stretch * stretch);
        let (values, slopes) = (&spread.value[q], &spread.slope[q]);
        for f in 0..F {
            for g in 0..F {
                let (vv, vs) = (weight * r.value_value[f][g], weight_s * r.value_slope[f][g]);
                let (sv, ss) = (weight_s * r.slope_value[f][g], weight_ss * r.slope_slope[f][g]);
                for j in 0..M {
                    by_value[q][f][j] += vv * values[g][j] + vs * slopes[g][j];
                    by_slope[q][f][j] += sv * values[g][j] + ss * slopes[g][j];
                }
            }
            by_value[q][f][last] = weight * r.by_value[f];
            by_slope[q][f][last] = weight_s * r.by_slope[f];
            let path = weight * path_weight * r.adhesion_by_value[f];
            for j in 0..M {
                path_row[j] += path * values[f][j];
            }
            if has_border {
                by_value[q][f][edge] = weight * r.border_value[f];
                by_slope[q][f][edge] = weight_s * r.border_slope[f];
                let (bv, bs) = (weight * r.border_value[f], weight_s * r.border_slope[f]);
                for j in 0..M {
                    border_row[j] += bv * values[f][j] + bs * slopes[f][j];
                }
            }
        }
        border_row[edge.min(last - 1)] += if has_border { weight * r.border_border } else { 0.0 };
        border_row[last] += weight * r.by_border;
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
    energy
}
