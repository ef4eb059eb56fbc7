//! The element: integrates a density into its front, the matrix that elimination works on.

use super::{Basis, Density, Front, PointResponse};
use crate::number::Real;
use serde::{Deserialize, Serialize};

/// Energy of one element, nN·nm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ElementEnergy {
    /// Stored and adhesion energy.
    pub total: f64,
    /// Adhesion alone.
    pub adhesion: f64,
}

/// One element, or four side by side.
#[derive(Clone, Copy, Debug)]
pub struct Element<T, const F: usize, const N: usize> {
    /// `values[a][f]`: field f at node a, nodes in the elimination order of [`Basis`].
    pub values: [[T; F]; N],
    /// S of the left end, nm
    pub from: T,
    /// Reference length, nm
    pub length: T,
    /// Where the face was (nm) and what share of its limit it carried at the end of the last step, at each Gauss point, of a
    /// density that remembers.
    pub slips: [[T; 2]; N],
    /// The number that the whole chain shares.
    pub border: f64,
}

impl<T: Real, const F: usize, const N: usize> Element<T, F, N> {
    /// The density's response at Gauss point `q`.
    #[inline(always)]
    pub fn response<D: Density<F>>(&self, density: &D, basis: &Basis<N>, q: usize) -> PointResponse<T, F> {
        let stretch = self.stretch();
        let (value, slope) = (at_point(&self.values, &basis.value[q]), at_point(&self.values, &basis.slope[q]));
        let place = self.from + self.length * (0.5 * (1.0 + basis.points[q]));
        let mut response = density.response(place, value, slope.map(|s| s * stretch), self.border);
        if D::REMEMBERS {
            density.hold(place, value, self.slips[q], &mut response);
        }
        response
    }

    /// Factor of a derivative with respect to S over one with respect to the local coordinate.
    #[inline(always)]
    fn stretch(&self) -> T {
        self.length.recip() * 2.0
    }

    /// Weight of Gauss point `q`.
    #[inline(always)]
    fn weight(&self, basis: &Basis<N>, q: usize) -> T {
        self.length * (0.5 * basis.weights[q])
    }

    /// Integrates into a front; returns the energy and its share from adhesion.
    ///
    /// The path row becomes `path_weight` times the gradient of the adhesion energy. Everything in the front is overwritten,
    /// but where the tangent is `symmetric` not what lies below its diagonal.
    #[inline(always)]
    pub fn integrate<D: Density<F>>(
        &self,
        density: &D,
        basis: &Basis<N>,
        symmetric: bool,
        path_weight: f64,
        points: &mut WeightedPoints<T, F, N>,
        front: &mut Front<T, F, N>,
    ) -> (T, T) {
        let zero = T::splat(0.0);
        let stretch = self.stretch();
        let (mut energy, mut adhesion) = (zero, zero);
        front.clear_gradient();
        for q in 0..N - 1 {
            let r = self.response(density, basis, q);
            let once = self.weight(basis, q);
            // a slope carries the factor 2/length once as a column and once as a row
            let twice = once * stretch;
            energy = energy + r.energy * once;
            adhesion = adhesion + r.adhesion * once;
            for f in 0..F {
                for g in 0..F {
                    points.value_value[f][g][q] = r.value_value[f][g] * once;
                    points.value_slope[f][g][q] = r.value_slope[f][g] * twice;
                    points.slope_value[f][g][q] = r.slope_value[f][g] * twice;
                    points.slope_slope[f][g][q] = r.slope_slope[f][g] * twice * stretch;
                }
            }
            front.add_gradient::<D>(&r, basis, q, (once, twice), path_weight);
        }
        points.assemble::<D>(basis, symmetric, front);
        (energy, adhesion)
    }

    /// Energy, its share from adhesion, and how that changes along `direction`, a change of the fields.
    #[inline(always)]
    pub fn energy<D: Density<F>>(&self, density: &D, basis: &Basis<N>, direction: &[[T; F]; N]) -> [T; 3] {
        let mut sums = [T::splat(0.0); 3];
        for q in 0..N - 1 {
            let (r, weight) = (self.response(density, basis, q), self.weight(basis, q));
            let change = at_point(direction, &basis.value[q]);
            sums[0] = sums[0] + r.energy * weight;
            sums[1] = sums[1] + r.adhesion * weight;
            for f in 0..F {
                sums[2] = sums[2] + r.adhesion_by_value[f] * change[f] * weight;
            }
        }
        sums
    }

    /// The gradient of the energy, node by node: the forces that hold the element in place.
    #[inline(always)]
    pub fn forces<D: Density<F>>(&self, density: &D, basis: &Basis<N>) -> [[T; F]; N] {
        let mut forces = [[T::splat(0.0); F]; N];
        for q in 0..N - 1 {
            let (r, weight) = (self.response(density, basis, q), self.weight(basis, q));
            for f in 0..F {
                let (on_value, on_slope) = (r.by_value[f] * weight, r.by_slope[f] * weight * self.stretch());
                for a in 0..N {
                    forces[a][f] = forces[a][f] + on_value * basis.value[q][a] + on_slope * basis.slope[q][a];
                }
            }
        }
        forces
    }
}

/// Fields at a point, from nodal values and the shape functions there.
#[inline(always)]
fn at_point<T: Real, const F: usize, const N: usize>(values: &[[T; F]; N], shape: &[f64; N]) -> [T; F] {
    let mut sum = [T::splat(0.0); F];
    for a in 0..N {
        for f in 0..F {
            sum[f] = sum[f] + values[a][f] * shape[a];
        }
    }
    sum
}

/// Second derivatives at the Gauss points times their weights, `[f][g][q]`: room for [`Element::integrate`].
#[derive(Clone, Copy, Debug)]
pub struct WeightedPoints<T, const F: usize, const N: usize> {
    value_value: [[[T; N]; F]; F],
    value_slope: [[[T; N]; F]; F],
    slope_value: [[[T; N]; F]; F],
    slope_slope: [[[T; N]; F]; F],
}

impl<T: Real, const F: usize, const N: usize> WeightedPoints<T, F, N> {
    /// All zero.
    pub fn zero() -> Self {
        let zero = [[[T::splat(0.0); N]; F]; F];
        Self { value_value: zero, value_slope: zero, slope_value: zero, slope_slope: zero }
    }

    /// The tangent: sums over the points of  N vv Nᵀ + N vs N'ᵀ + N' sv Nᵀ + N' ss N'ᵀ  with the shape functions N and their
    /// slopes N'.
    #[inline(always)]
    fn assemble<D: Density<F>>(&self, basis: &Basis<N>, symmetric: bool, front: &mut Front<T, F, N>) {
        for f in 0..F {
            for g in 0..F {
                let (vv, vs) = (D::COUPLING.value_value[f][g], D::COUPLING.value_slope[f][g]);
                let (sv, ss) = (D::COUPLING.value_slope[g][f], D::COUPLING.slope_slope[f][g]);
                for a in 0..N {
                    // what row a puts on the unknown's values and on its slopes
                    let on_value =
                        mixed(basis, a, vv.then_some(&self.value_value[f][g]), sv.then_some(&self.slope_value[f][g]));
                    let on_slope =
                        mixed(basis, a, vs.then_some(&self.value_slope[f][g]), ss.then_some(&self.slope_slope[f][g]));
                    for b in if symmetric { a } else { 0 }..N {
                        // two sums, so that one need not wait for the other
                        let (mut by_value, mut by_slope) = (T::splat(0.0), T::splat(0.0));
                        for q in 0..N - 1 {
                            if vv || sv {
                                by_value = by_value + on_value[q] * basis.value_of[b][q];
                            }
                            if vs || ss {
                                by_slope = by_slope + on_slope[q] * basis.slope_of[b][q];
                            }
                        }
                        front.rows[a][f].fields[b][g] = by_value + by_slope;
                    }
                }
            }
        }
    }
}

/// At each Gauss point, shape function `a` times one weight and its slope times another, as far as there are any.
#[inline(always)]
fn mixed<T: Real, const N: usize>(
    basis: &Basis<N>,
    a: usize,
    by_value: Option<&[T; N]>,
    by_slope: Option<&[T; N]>,
) -> [T; N] {
    let mut sum = [T::splat(0.0); N];
    for q in 0..N - 1 {
        let (value, slope) = (basis.value_of[a][q], basis.slope_of[a][q]);
        match (by_value, by_slope) {
            (Some(v), Some(s)) => sum[q] = v[q] * value + s[q] * slope,
            (Some(v), None) => sum[q] = v[q] * value,
            (None, Some(s)) => sum[q] = s[q] * slope,
            (None, None) => {}
        }
    }
    sum
}
