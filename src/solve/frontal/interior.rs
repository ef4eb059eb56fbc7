//! What the elimination of the interior nodes of four elements side by side leaves, closely packed.
//!
//! Row k of the pivots has one over the pivot, then the entries of the columns behind it, then the residual; unknowns are those of the
//! nodes in elimination order, the interior first. Where the tangent is not symmetric, column k has what stood below the pivot, of as many numbers.

use super::frontal_matrix::FrontalMatrix;
use super::nodes::MOST_NODES;
use crate::number::{F64x4, Real};

/// Numbers of the nodes of an element, in elimination order.
pub(super) type OfNodes<T, const F: usize> = [[T; F]; MOST_NODES];

/// Unknowns of the interior, and of the whole element.
fn counts<const F: usize>(order: usize) -> (usize, usize) {
    ((order - 1) * F, (order + 1) * F)
}

/// Numbers of four elements of an order.
pub(super) fn packed_length<const F: usize>(order: usize) -> usize {
    let (pivots, unknowns) = counts::<F>(order);
    (0..pivots).map(|k| unknowns - k + 1).sum()
}

/// Writes a front whose interior is eliminated.
#[inline(always)]
pub(super) fn pack<const F: usize>(order: usize, front: &FrontalMatrix<F64x4, F>, out: &mut [F64x4]) {
    let (pivots, unknowns) = counts::<F>(order);
    let mut from = 0;
    for k in 0..pivots {
        let row = &front.rows[k / F][k % F];
        let (own, length) = (row.fields.as_flattened(), unknowns - k);
        out[from..from + length].copy_from_slice(&own[k..unknowns]);
        out[from + length] = row.residual;
        from += length + 1;
    }
}

/// Writes what stood below the pivots, where [`pack`] writes what stood behind them.
pub(super) fn pack_columns<const F: usize>(order: usize, front: &FrontalMatrix<F64x4, F>, out: &mut [F64x4]) {
    let (pivots, unknowns) = counts::<F>(order);
    let rows = front.rows.as_flattened();
    let mut from = 0;
    for k in 0..pivots {
        for i in k + 1..unknowns {
            out[from + i - k] = rows[i].fields.as_flattened()[k];
        }
        from += unknowns - k + 1;
    }
}

/// The packed rows of four elements.
pub(super) struct Interior<'a, const F: usize> {
    rows: &'a [F64x4],
    /// Of a symmetric tangent the rows
    columns: &'a [F64x4],
    pivots: usize,
    unknowns: usize,
}

impl<'a, const F: usize> Interior<'a, F> {
    #[inline(always)]
    pub(crate) fn new(order: usize, rows: &'a [F64x4], columns: &'a [F64x4]) -> Self {
        let (pivots, unknowns) = counts::<F>(order);
        Self { rows, columns, pivots, unknowns }
    }

    /// One over the pivot, the entries behind it, the residual.
    #[inline(always)]
    fn row(&self, k: usize) -> (F64x4, &'a [F64x4], F64x4) {
        let (from, length) = self.place(k);
        let row = &self.rows[from..=from + length];
        (row[0], &row[1..length], row[length])
    }

    /// The entries below the pivot.
    fn column(&self, k: usize) -> &'a [F64x4] {
        let (from, length) = self.place(k);
        &self.columns[from + 1..from + length]
    }

    /// Where row k begins, and how many columns it has.
    #[inline(always)]
    fn place(&self, k: usize) -> (usize, usize) {
        (k * (self.unknowns + 1) - k * k.saturating_sub(1) / 2, self.unknowns - k)
    }

    /// The interiors of the direction that solves K q = `scale` R, whose ends are known.
    #[inline(always)]
    pub(crate) fn recover(&self, scale: f64, x: &mut OfNodes<F64x4, F>) {
        let x = x.as_flattened_mut();
        for k in (0..self.pivots).rev() {
            let (inverse, entries, residual) = self.row(k);
            // the rest of its own node, then node by node: a sum a field, so that one need not wait for the other
            let (own, behind) = entries.split_at(F - 1 - k % F);
            let (known, nodes) = x[k + 1..].split_at(own.len());
            let mut sums = [F64x4::splat(0.0); F];
            for (entries, x) in behind.as_chunks::<F>().0.iter().zip(nodes.as_chunks::<F>().0) {
                for g in 0..F {
                    sums[g] = sums[g] + entries[g] * x[g];
                }
            }
            let mut sum = residual * scale;
            for part in sums {
                sum = sum - part;
            }
            for (entry, x) in own.iter().zip(known) {
                sum = sum - *entry * *x;
            }
            x[k] = inverse * sum;
        }
    }

    /// Of element `l`, takes what the interior is loaded with off the unknowns behind it; of the ends, off those that take part.
    pub(crate) fn forward(&self, l: usize, x: &mut OfNodes<f64, F>, taking_part: &[[bool; F]; 2], transposed: bool) {
        let (x, taking_part) = (x.as_flattened_mut(), taking_part.as_flattened());
        for k in 0..self.pivots {
            let (inverse, behind, _) = self.row(k);
            let entries = if transposed { behind } else { self.column(k) };
            let share = x[k] * inverse.0[l];
            for (i, entry) in (k + 1..).zip(entries) {
                if i < self.pivots || taking_part[i - self.pivots] {
                    x[i] -= entry.0[l] * share;
                }
            }
        }
    }

    /// The interior of element `l` in a solution whose ends are known, of which some take part.
    pub(crate) fn backward(&self, l: usize, x: &mut OfNodes<f64, F>, taking_part: &[[bool; F]; 2], transposed: bool) {
        let x = x.as_flattened_mut();
        for (end, takes_part) in taking_part.as_flattened().iter().enumerate() {
            if !takes_part {
                x[self.pivots + end] = 0.0;
            }
        }
        for k in (0..self.pivots).rev() {
            let (inverse, behind, _) = self.row(k);
            let entries = if transposed { self.column(k) } else { behind };
            let sum: f64 = entries.iter().zip(&x[k + 1..]).map(|(entry, x)| entry.0[l] * x).sum();
            x[k] = inverse.0[l] * (x[k] - sum);
        }
    }
}
