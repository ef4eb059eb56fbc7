//! What the elimination of an element's interior nodes leaves, closely packed.
//!
//! Row k of the pivots has one over the pivot, then the entries of the columns behind it, then the residual; unknowns are those of the
//! nodes in elimination order, the interior first.

use crate::beam::MOST_NODES;
use crate::beam::spatial::chain::SPATIAL_UNKNOWNS;
use crate::beam::spatial::chain::projection::SpatialFront;

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

/// Writes element `l` of a front whose interior is eliminated.
#[inline(always)]
pub(super) fn pack(order: usize, front: &SpatialFront, l: usize, out: &mut [f64]) {
    let (pivots, unknowns) = counts(order);
    let mut from = 0;
    for k in 0..pivots {
        let row = &front.rows[k / SPATIAL_UNKNOWNS][k % SPATIAL_UNKNOWNS];
        let (own, length) = (row.fields.as_flattened(), unknowns - k);
        for (out, entry) in out[from..from + length].iter_mut().zip(&own[k..unknowns]) {
            *out = entry.0[l];
        }
        out[from + length] = row.residual.0[l];
        from += length + 1;
    }
}

/// The packed rows of an element.
pub(super) struct Inside<'a> {
    rows: &'a [f64],
    pivots: usize,
    unknowns: usize,
}

impl<'a> Inside<'a> {
    pub fn new(order: usize, rows: &'a [f64]) -> Self {
        let (pivots, unknowns) = counts(order);
        Self { rows, pivots, unknowns }
    }

    /// One over the pivot, the entries behind it, the residual.
    #[inline(always)]
    fn row(&self, k: usize) -> (f64, &'a [f64], f64) {
        let from = k * (self.unknowns + 1) - k * k.saturating_sub(1) / 2;
        let length = self.unknowns - k;
        let row = &self.rows[from..=from + length];
        (row[0], &row[1..length], row[length])
    }

    /// The interior of the direction that solves K q = `scale` R, whose ends are known.
    #[inline(always)]
    pub fn recover(&self, scale: f64, x: &mut [f64; MOST]) {
        for k in (0..self.pivots).rev() {
            let (inverse, entries, residual) = self.row(k);
            x[k] = inverse * (scale * residual - sum(entries, &x[k + 1..]));
        }
    }

    /// Takes what the interior is loaded with off the unknowns behind it, up to `until`.
    pub fn forward(&self, x: &mut [f64; MOST], until: &Ends) {
        for k in 0..self.pivots {
            let (inverse, entries, _) = self.row(k);
            let share = x[k] * inverse;
            for (i, entry) in (k + 1..).zip(entries) {
                if i < self.pivots || until.0[i - self.pivots] {
                    x[i] -= entry * share;
                }
            }
        }
    }

    /// The interior of a solution whose ends are known.
    pub fn backward(&self, x: &mut [f64; MOST], from: &Ends) {
        for end in (0..from.0.len()).filter(|&end| !from.0[end]) {
            x[self.pivots + end] = 0.0;
        }
        for k in (0..self.pivots).rev() {
            let (inverse, entries, _) = self.row(k);
            x[k] = inverse * (x[k] - sum(entries, &x[k + 1..]));
        }
    }
}

/// Which unknowns of the two ends of an element take part.
pub(super) struct Ends(pub [bool; 2 * SPATIAL_UNKNOWNS]);

#[inline(always)]
fn sum(entries: &[f64], x: &[f64]) -> f64 {
    entries.iter().zip(x).map(|(entry, x)| entry * x).sum()
}
