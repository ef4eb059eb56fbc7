//! The element: integrates a density into its front, the matrix that elimination works on.

use super::integrand::{Integrand, Point, PointEnergy};
use super::{Basis, Coupling, Front, PointResponse};
use crate::number::{Four, Real};
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
    /// What its density is asked at Gauss point `q`.
    #[inline(always)]
    fn point(&self, basis: &Basis<N>, q: usize) -> Point<T, F> {
        let stretch = self.stretch();
        Point {
            place: self.from + self.length * (0.5 * (1.0 + basis.points[q])),
            value: at_point(&self.values, &basis.value[q]),
            slope: at_point(&self.values, &basis.slope[q]).map(|s| s * stretch),
            slip: self.slips[q],
        }
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
}

/// What the density answered at each Gauss point: room for [`Element::integrate`].
pub type Responses<const F: usize, const N: usize> = [PointResponse<Four, F>; N];

impl<const F: usize, const N: usize> Element<Four, F, N> {
    /// All its Gauss points; the last of N is a repetition.
    #[inline(always)]
    fn points(&self, basis: &Basis<N>) -> [Point<Four, F>; N] {
        let mut points = [self.point(basis, 0); N];
        for q in 1..N - 1 {
            points[q] = self.point(basis, q);
        }
        points
    }

    /// Integrates into a front; returns the energy and its share from adhesion.
    ///
    /// The path row becomes `path_weight` times the gradient of the adhesion energy. Everything in the front is overwritten,
    /// but where the tangent is `symmetric` not what lies below its diagonal.
    #[inline(always)]
    pub fn integrate<const BORDER: bool>(
        &self,
        (density, coupling): (&dyn Integrand<F>, &Coupling<F>),
        basis: &Basis<N>,
        symmetric: bool,
        path_weight: f64,
        responses: &mut Responses<F, N>,
        front: &mut Front<Four, F, N>,
    ) -> (Four, Four) {
        let zero = Four::splat(0.0);
        let stretch = self.stretch();
        let (mut energy, mut adhesion) = (zero, zero);
        density.respond(&self.points(basis)[..N - 1], self.border, responses);
        front.clear_gradient();
        for q in 0..N - 1 {
            let (r, once) = (&responses[q], self.weight(basis, q));
            // a slope carries the factor 2/length once as a column and once as a row
            let twice = once * stretch;
            energy = energy + r.energy * once;
            adhesion = adhesion + r.adhesion * once;
            front.add_gradient::<BORDER>(r, basis, q, (once, twice), path_weight);
        }
        self.assemble(coupling, basis, symmetric, responses, front);
        (energy, adhesion)
    }

    /// The tangent: sums over the points of  N vv Nᵀ + N vs N'ᵀ + N' sv Nᵀ + N' ss N'ᵀ  with the shape functions N and their
    /// slopes N', of what the responses are times their weights.
    #[inline(always)]
    fn assemble(
        &self,
        coupling: &Coupling<F>,
        basis: &Basis<N>,
        symmetric: bool,
        responses: &Responses<F, N>,
        front: &mut Front<Four, F, N>,
    ) {
        let stretch = self.stretch();
        for f in 0..F {
            for g in 0..F {
                let (vv, vs) = (coupling.value_value[f][g], coupling.value_slope[f][g]);
                let (sv, ss) = (coupling.value_slope[g][f], coupling.slope_slope[f][g]);
                let zero = [Four::splat(0.0); N];
                let [mut value_value, mut value_slope, mut slope_value, mut slope_slope] = [zero; 4];
                for q in 0..N - 1 {
                    let (r, once) = (&responses[q], self.weight(basis, q));
                    let twice = once * stretch;
                    value_value[q] = r.value_value[f][g] * once;
                    value_slope[q] = r.value_slope[f][g] * twice;
                    slope_value[q] = r.slope_value[f][g] * twice;
                    slope_slope[q] = r.slope_slope[f][g] * twice * stretch;
                }
                for a in 0..N {
                    // what row a puts on the unknown's values and on its slopes
                    let on_value = mixed(basis, a, vv.then_some(&value_value), sv.then_some(&slope_value));
                    let on_slope = mixed(basis, a, vs.then_some(&value_slope), ss.then_some(&slope_slope));
                    for b in if symmetric { a } else { 0 }..N {
                        // two sums, so that one need not wait for the other
                        let (mut by_value, mut by_slope) = (Four::splat(0.0), Four::splat(0.0));
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

    /// Energy, its share from adhesion, and how that changes along `direction`, a change of the fields.
    #[inline(always)]
    pub fn energy(&self, density: &dyn Integrand<F>, basis: &Basis<N>, direction: &[[Four; F]; N]) -> [Four; 3] {
        let zero = Four::splat(0.0);
        let mut energies = [PointEnergy { energy: zero, adhesion: zero, adhesion_by_value: [zero; F] }; N];
        density.sum_up(&self.points(basis)[..N - 1], self.border, &mut energies);
        let mut sums = [zero; 3];
        for q in 0..N - 1 {
            let (r, weight) = (&energies[q], self.weight(basis, q));
            let change = at_point(direction, &basis.value[q]);
            sums[0] = sums[0] + r.energy * weight;
            sums[1] = sums[1] + r.adhesion * weight;
            for f in 0..F {
                sums[2] = sums[2] + r.adhesion_by_value[f] * change[f] * weight;
            }
        }
        sums
    }
}

impl<const F: usize, const N: usize> Element<f64, F, N> {
    /// The gradient of the energy, node by node: the forces that hold the element in place.
    pub fn forces(&self, density: &dyn Integrand<F>, basis: &Basis<N>) -> [[f64; F]; N] {
        let mut forces = [[0.0; F]; N];
        for q in 0..N - 1 {
            let (r, weight) = (density.respond_at(&self.point(basis, q), self.border), self.weight(basis, q));
            for f in 0..F {
                let (on_value, on_slope) = (r.by_value[f] * weight, r.by_slope[f] * weight * self.stretch());
                for a in 0..N {
                    forces[a][f] = forces[a][f] + on_value * basis.value[q][a] + on_slope * basis.slope[q][a];
                }
            }
        }
        forces
    }

    /// The gradient of the adhesion energy, node by node.
    pub fn adhesion_forces(&self, density: &dyn Integrand<F>, basis: &Basis<N>) -> [[f64; F]; N] {
        let mut forces = [[0.0; F]; N];
        for q in 0..N - 1 {
            let (r, weight) = (density.respond_at(&self.point(basis, q), self.border), self.weight(basis, q));
            for f in 0..F {
                for a in 0..N {
                    forces[a][f] += r.adhesion_by_value[f] * weight * basis.value[q][a];
                }
            }
        }
        forces
    }

    /// The derivative of the energy by the border.
    pub fn border_force(&self, density: &dyn Integrand<F>, basis: &Basis<N>) -> f64 {
        let force = |q: usize| density.respond_at(&self.point(basis, q), self.border).by_border * self.weight(basis, q);
        (0..N - 1).map(force).sum()
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
