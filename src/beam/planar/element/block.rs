//! The tangent of an element by two fields: the sum over the Gauss points of N vv Nᵀ + N vs N'ᵀ + N' sv Nᵀ + N' ss N'ᵀ.

use super::planar_element::Integration;
use crate::beam::{Basis, FrontalMatrix, MOST_NODES, Nodes};
use crate::number::{F64x4, Real};

/// At each Gauss point, shape function `a` times one weight and its slope times another, as far as there are any.
#[inline(always)]
pub(super) fn mixed(
    nodes: impl Nodes,
    basis: &Basis,
    a: usize,
    by_value: Option<&[F64x4; MOST_NODES]>,
    by_slope: Option<&[F64x4; MOST_NODES]>,
) -> [F64x4; MOST_NODES] {
    let mut sum = [F64x4::splat(0.0); MOST_NODES];
    let (points, value, slope) = (nodes.count() - 1, &basis.four_values_of[a], &basis.four_slopes_of[a]);
    // loops and not closures: these are not compiled for the vector units that the rest is compiled for
    match (by_value, by_slope) {
        (Some(v), Some(s)) => {
            for q in 0..points {
                sum[q] = v[q] * value[q] + s[q] * slope[q];
            }
        }
        (Some(v), None) => {
            for q in 0..points {
                sum[q] = v[q] * value[q];
            }
        }
        (None, Some(s)) => {
            for q in 0..points {
                sum[q] = s[q] * slope[q];
            }
        }
        (None, None) => {}
    }
    sum
}

/// What is weighted of the second derivatives by two fields, as far as there are any.
pub(super) struct Block<'a> {
    pub value_value: Option<&'a [F64x4; MOST_NODES]>,
    pub value_slope: Option<&'a [F64x4; MOST_NODES]>,
    pub slope_value: Option<&'a [F64x4; MOST_NODES]>,
    pub slope_slope: Option<&'a [F64x4; MOST_NODES]>,
}

impl Block<'_> {
    /// Writes the columns of field `g` into the rows of field `f`.
    #[inline(always)]
    pub fn assemble<const F: usize>(
        &self,
        by: &Integration<impl Nodes, F>,
        fields: (usize, usize),
        front: &mut FrontalMatrix<F64x4, F>,
    ) {
        let on_value = self.value_value.is_some() || self.slope_value.is_some();
        let on_slope = self.value_slope.is_some() || self.slope_slope.is_some();
        match (on_value, on_slope) {
            (true, true) => self.rows::<true, true, F>(by, fields, front),
            (true, false) => self.rows::<true, false, F>(by, fields, front),
            (false, true) => self.rows::<false, true, F>(by, fields, front),
            (false, false) => self.rows::<false, false, F>(by, fields, front),
        }
    }

    #[inline(always)]
    fn rows<const ON_VALUE: bool, const ON_SLOPE: bool, const F: usize>(
        &self,
        by: &Integration<impl Nodes, F>,
        (f, g): (usize, usize),
        front: &mut FrontalMatrix<F64x4, F>,
    ) {
        let &Integration { nodes, basis, symmetric, .. } = by;
        for a in 0..nodes.count() {
            // what row a puts on the unknown's values and on its slopes
            let on_value = mixed(nodes, basis, a, self.value_value, self.slope_value);
            let on_slope = mixed(nodes, basis, a, self.value_slope, self.slope_slope);
            for b in if symmetric { a } else { 0 }..nodes.count() {
                // two sums, so that one need not wait for the other
                let (mut by_value, mut by_slope) = (F64x4::splat(0.0), F64x4::splat(0.0));
                for q in 0..nodes.count() - 1 {
                    if ON_VALUE {
                        by_value = by_value + on_value[q] * basis.four_values_of[b][q];
                    }
                    if ON_SLOPE {
                        by_slope = by_slope + on_slope[q] * basis.four_slopes_of[b][q];
                    }
                }
                front.rows[a][f].fields[b][g] = by_value + by_slope;
            }
        }
    }
}
