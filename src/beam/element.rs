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

/// Adds one element to its front.
///
/// The front is square of size M = F N + border + 1. Rows are equations and columns unknowns, node by node in the
/// elimination order of [`Basis`], F a node; then the border, if the density has one; the last column holds the
/// gradient, the last row `path_weight` times the gradient of the adhesion energy. `values[a][f]` is field f at node a,
/// `length` the element's reference length in nm.
#[inline(always)]
pub fn integrate<D: Density<F>, const F: usize, const N: usize, const M: usize>(
    density: &D,
    basis: &Basis<N>,
    values: &[[f64; F]; N],
    length: f64,
    border: f64,
    path_weight: f64,
    front: &mut [[f64; M]; M],
) -> ElementEnergy {
    let has_border = M == F * N + 2;
    let (edge, last) = (F * N, M - 1);
    let mut energy = ElementEnergy::default();
    for q in 0..N - 1 {
        let shape = &basis.value[q];
        let mut slope = [0.0; N];
        for a in 0..N {
            slope[a] = basis.slope[q][a] * (2.0 / length);
        }
        let (mut value_at, mut slope_at) = ([0.0; F], [0.0; F]);
        for a in 0..N {
            for f in 0..F {
                value_at[f] += shape[a] * values[a][f];
                slope_at[f] += slope[a] * values[a][f];
            }
        }
        let r = density.response(value_at, slope_at, border);
        let weight = basis.weights[q] * (0.5 * length);
        energy.total += weight * r.energy;
        energy.adhesion += weight * r.adhesion;

        let mut by_value = [[0.0; M]; F];
        let mut by_slope = [[0.0; M]; F];
        for f in 0..F {
            for a in 0..N {
                for g in 0..F {
                    by_value[f][a * F + g] = weight * (r.value_value[f][g] * shape[a] + r.value_slope[f][g] * slope[a]);
                    by_slope[f][a * F + g] = weight * (r.slope_value[f][g] * shape[a] + r.slope_slope[f][g] * slope[a]);
                }
            }
            by_value[f][last] = weight * r.by_value[f];
            by_slope[f][last] = weight * r.by_slope[f];
            if has_border {
                by_value[f][edge] = weight * r.border_value[f];
                by_slope[f][edge] = weight * r.border_slope[f];
            }
        }
        for a in 0..N {
            for f in 0..F {
                let row = &mut front[a * F + f];
                for j in 0..M {
                    row[j] += shape[a] * by_value[f][j] + slope[a] * by_slope[f][j];
                }
                front[last][a * F + f] += weight * path_weight * r.adhesion_by_value[f] * shape[a];
            }
        }
        if has_border {
            for a in 0..N {
                for f in 0..F {
                    front[edge][a * F + f] += weight * (r.border_value[f] * shape[a] + r.border_slope[f] * slope[a]);
                }
            }
            front[edge][edge] += weight * r.border_border;
            front[edge][last] += weight * r.by_border;
        }
    }
    energy
}
