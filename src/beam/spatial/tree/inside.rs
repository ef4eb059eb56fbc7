//! What the elimination of the interior nodes of four elements side by side leaves, closely packed.
//!
//! Row k of the pivots has one over the pivot, then the entries of the columns behind it, then the residual; unknowns are those of the
//! nodes in elimination order, the interior first.

use crate::beam::element::basis::MOST_NODES;
use crate::beam::spatial::chain::projection::SpatialFront;
use crate::beam::spatial::section::kinematics::SPATIAL_UNKNOWNS;
use crate::number::{F64x4, Real};

/// Most unknowns of an element.
pub(super) const MOST: usize = MOST_NODES * SPATIAL_UNKNOWNS;

/// Unknowns of the interior, and of the whole element.
fn counts(order: usize) -> (usize, usize) {
    ((order - 1) * SPATIAL_UNKNOWNS, (order + 1) * SPATIAL_UNKNOWNS)
}

/// Numbers of an element of an order.
pub(super) fn inside_length(order: usize) -> usize {
    let (pivots, unknowns) = counts(order);
    (0..pivots).map(|k| unknowns - k + 1).sum()
}

/// Writes a front whose interior is eliminated.
#[inline(always)]
pub(super) fn pack(order: usize, front: &SpatialFront, out: &mut [F64x4]) {
    let (pivots, unknowns) = counts(order);
    let mut from = 0;
    for k in 0..pivots {
        let row = &front.rows[k / SPATIAL_UNKNOWNS][k % SPATIAL_UNKNOWNS];
        let (own, length) = (row.fields.as_flattened(), unknowns - k);
        out[from..from + length].copy_from_slice(&own[k..unknowns]);
        out[from + length] = row.residual;
        from += length + 1;
    }
}

/// The packed rows of four elements.
pub(super) struct Inside<'a> {
    rows: &'a [F64x4],
    pivots: usize,
    unknowns: usize,
}

impl<'a> Inside<'a> {
    #[inline(always)]
    pub fn new(order: usize, rows: &'a [F64x4]) -> Self {
        let (pivots, unknowns) = counts(order);
        Self { rows, pivots, unknowns }
    }

    /// One over the pivot, the entries behind it, the residual.
    #[inline(always)]
    fn row(&self, k: usize) -> (F64x4, &'a [F64x4], F64x4) {
        let from = k * (self.unknowns + 1) - k * k.saturating_sub(1) / 2;
        let length = self.unknowns - k;
        let row = &self.rows[from..=from + length];
        (row[0], &row[1..length], row[length])
    }

    /// The interiors of the direction that solves K q = `scale` R, whose ends are known.
    #[inline(always)]
    pub fn recover(&self, scale: f64, x: &mut [F64x4; MOST]) {
        for k in (0..self.pivots).rev() {
            let (inverse, entries, residual) = self.row(k);
            let mut sum = F64x4::splat(0.0);
            for (entry, x) in entries.iter().zip(&x[k + 1..]) {
                sum = sum + *entry * *x;
            }
            x[k] = inverse * (residual * scale - sum);
        }
    }

    /// Of element `l`, takes what the interior is loaded with off the unknowns behind it, up to `until`.
    pub fn forward(&self, l: usize, x: &mut [f64; MOST], until: &Ends) {
        for k in 0..self.pivots {
            let (inverse, entries, _) = self.row(k);
            let share = x[k] * inverse.0[l];
            for (i, entry) in (k + 1..).zip(entries) {
                if i < self.pivots || until.0[i - self.pivots] {
                    x[i] -= entry.0[l] * share;
                }
            }
        }
    }

    /// The interior of element `l` in a solution whose ends are known.
    pub fn backward(&self, l: usize, x: &mut [f64; MOST], from: &Ends) {
        for end in (0..from.0.len()).filter(|&end| !from.0[end]) {
            x[self.pivots + end] = 0.0;
        }
        for k in (0..self.pivots).rev() {
            let (inverse, entries, _) = self.row(k);
            let sum: f64 = entries.iter().zip(&x[k + 1..]).map(|(entry, x)| entry.0[l] * x).sum();
            x[k] = inverse.0[l] * (x[k] - sum);
        }
    }
}

/// Which unknowns of the two ends of an element take part.
pub(super) struct Ends(pub [bool; 2 * SPATIAL_UNKNOWNS]);
