//! The front of an element: its tangent with all that elimination takes along.

use super::{Basis, Density, PointResponse};
use crate::number::Real;

/// One row: an equation, with a column for each unknown.
#[derive(Clone, Copy, Debug)]
pub struct FrontRow<T, const F: usize, const N: usize> {
    /// Columns of the fields, node by node in the elimination order of [`Basis`].
    pub fields: [[T; F]; N],
    /// Column of the border.
    pub border: T,
    /// Column of the gradient.
    pub residual: T,
}

/// The tangent of one element of N nodes and F fields, or of four side by side, with the gradient, the border's row and column,
/// and one more row that carries a functional along.
#[derive(Clone, Copy, Debug)]
pub struct Front<T, const F: usize, const N: usize> {
    /// `rows[a][f]`: the equation of field f at node a.
    pub rows: [[FrontRow<T, F, N>; F]; N],
    /// The equation of the border; unused where there is none.
    pub border: FrontRow<T, F, N>,
    /// The functional, and its value in the column of the gradient.
    pub path: FrontRow<T, F, N>,
}

/// What elimination tells of its pivots.
#[derive(Clone, Copy, Debug)]
pub struct Pivots<T> {
    /// The smallest, without its sign.
    pub least: T,
    /// How many were negative.
    pub negative: T,
}

impl<T: Real, const F: usize, const N: usize> FrontRow<T, F, N> {
    #[inline(always)]
    fn zero() -> Self {
        let zero = T::splat(0.0);
        Self { fields: [[zero; F]; N], border: zero, residual: zero }
    }

    /// Takes off a multiple of a pivot row, in the columns from `from` on.
    #[inline(always)]
    fn reduce<const BORDER: bool>(&mut self, pivot_row: &Self, factor: T, from: usize) {
        let (columns, pivot_columns) = (self.fields.as_flattened_mut(), pivot_row.fields.as_flattened());
        for j in from..F * N {
            columns[j] = columns[j] - pivot_columns[j] * factor;
        }
        if BORDER {
            self.border = self.border - pivot_row.border * factor;
        }
        self.residual = self.residual - pivot_row.residual * factor;
    }
}

impl<T: Real, const F: usize, const N: usize> Front<T, F, N> {
    /// All zero.
    #[inline(always)]
    pub fn zero() -> Self {
        let row = FrontRow::zero();
        Self { rows: [[row; F]; N], border: row, path: row }
    }

    /// Clears what [`Self::add_gradient`] adds to.
    #[inline(always)]
    pub(super) fn clear_gradient(&mut self) {
        let zero = T::splat(0.0);
        for row in self.rows.as_flattened_mut() {
            (row.border, row.residual) = (zero, zero);
        }
        (self.border, self.path) = (FrontRow::zero(), FrontRow::zero());
    }

    /// Adds what Gauss point `q` gives to gradient, border and path; `once` weighs values and `twice` slopes.
    #[inline(always)]
    pub(super) fn add_gradient<D: Density<F>>(
        &mut self,
        r: &PointResponse<T, F>,
        basis: &Basis<N>,
        q: usize,
        (once, twice): (T, T),
        path_weight: f64,
    ) {
        for f in 0..F {
            let (on_value, on_slope) = (r.by_value[f] * once, r.by_slope[f] * twice);
            let on_path = r.adhesion_by_value[f] * once * path_weight;
            for a in 0..N {
                let (value, slope) = (basis.value[q][a], basis.slope[q][a]);
                let row = &mut self.rows[a][f];
                row.residual = row.residual + on_value * value + on_slope * slope;
                self.path.fields[a][f] = self.path.fields[a][f] + on_path * value;
                if D::BORDER {
                    let mixed = r.border_value[f] * once * value + r.border_slope[f] * twice * slope;
                    row.border = row.border + mixed;
                    self.border.fields[a][f] = self.border.fields[a][f] + mixed;
                }
            }
        }
        if D::BORDER {
            self.border.border = self.border.border + r.border_border * once;
            self.border.residual = self.border.residual + r.by_border * once;
        }
    }

    /// Eliminates the interior nodes, without pivoting; each pivot is replaced by one over it. Where the tangent is
    /// `symmetric`, nothing below its diagonal is looked at.
    #[inline(always)]
    pub fn condense<const BORDER: bool>(&mut self, symmetric: bool) -> Pivots<T> {
        let (zero, one) = (T::splat(0.0), T::splat(1.0));
        let mut pivots = Pivots { least: T::splat(f64::INFINITY), negative: zero };
        let rows = self.rows.as_flattened_mut();
        for k in 0..F * (N - 2) {
            let (done, rest) = rows.split_at_mut(k + 1);
            let pivot_row = &mut done[k];
            let pivot = pivot_row.fields.as_flattened()[k];
            let size = pivot.choose(pivot, -pivot);
            pivots.least = (pivots.least - size).choose(size, pivots.least);
            pivots.negative = pivots.negative + pivot.choose(zero, one);
            let inverse = pivot.recip();
            for (i, row) in (k + 1..).zip(rest) {
                let (entry, from) = if symmetric {
                    (pivot_row.fields.as_flattened()[i], i)
                } else {
                    (row.fields.as_flattened()[k], k + 1)
                };
                row.reduce::<BORDER>(pivot_row, entry * inverse, from);
            }
            if BORDER {
                let entry = self.border.fields.as_flattened()[k];
                self.border.reduce::<BORDER>(pivot_row, entry * inverse, k + 1);
            }
            let entry = self.path.fields.as_flattened()[k];
            self.path.reduce::<BORDER>(pivot_row, entry * inverse, k + 1);
            pivot_row.fields.as_flattened_mut()[k] = inverse;
        }
        pivots
    }
}
