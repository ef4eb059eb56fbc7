//! The block of an element's two ends, what condensation leaves of it: eliminated from its far end to its near one.

use super::frontal_matrix::FrontalMatrix;
use super::nodes::Nodes;
use crate::number::F64x4;

/// An equation of the block, or its functional.
#[derive(Clone, Copy, Debug)]
pub(crate) struct EndRow<const F: usize> {
    /// Columns of the far end, then of the near one
    pub ends: [[f64; F]; 2],
    /// Column of the residual
    pub residual: f64,
}

/// What stands below the pivots of the far end in the rows of the near one.
pub(crate) type BelowEnd<const F: usize> = [[f64; F]; F];

/// What is left of all that a joint carries: its equations, and the functional.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Carry<const F: usize> {
    /// By the unknowns of the joint
    pub tangent: [[f64; F]; F],
    /// Column of the residual
    pub residual: [f64; F],
    /// The functional
    pub path: [f64; F],
    /// Its value in the column of the residual
    pub path_residual: f64,
}

impl<const F: usize> Carry<F> {
    /// Nothing.
    pub(crate) const ZERO: Self =
        Self { tangent: [[0.0; F]; F], residual: [0.0; F], path: [0.0; F], path_residual: 0.0 };

    /// Adds what another element leaves on the joint.
    pub(super) fn add(&mut self, other: &Self) {
        for i in 0..F {
            (0..F).for_each(|j| self.tangent[i][j] += other.tangent[i][j]);
            self.residual[i] += other.residual[i];
            self.path[i] += other.path[i];
        }
        self.path_residual += other.path_residual;
    }
}

/// The block itself.
pub(super) struct EndBlock<const F: usize> {
    /// Equations of the far end, then of the near one
    pub rows: [[EndRow<F>; F]; 2],
    path: EndRow<F>,
}

impl<const F: usize> EndRow<F> {
    /// All zero.
    pub(super) const ZERO: Self = Self { ends: [[0.0; F]; 2], residual: 0.0 };

    /// Takes off a multiple of a pivot row, in the columns from `from` on.
    #[inline(always)]
    fn reduce(&mut self, pivot_row: &Self, factor: f64, from: usize) {
        let (own, pivot) = (self.ends.as_flattened_mut(), pivot_row.ends.as_flattened());
        for j in from..2 * F {
            own[j] -= factor * pivot[j];
        }
        self.residual -= factor * pivot_row.residual;
    }
}

impl<const F: usize> EndBlock<F> {
    /// All zero.
    #[inline(always)]
    pub(crate) fn zero() -> Self {
        Self { rows: [[EndRow::ZERO; F]; 2], path: EndRow::ZERO }
    }

    /// Takes what condensation left of element `l` of a front; `near` of its ends, 0 at its left or 1, is the near one. Of a `symmetric` one nothing
    /// below its diagonal is looked at.
    #[inline(always)]
    pub(crate) fn take(
        &mut self,
        nodes: impl Nodes,
        front: &FrontalMatrix<F64x4, F>,
        l: usize,
        near: usize,
        symmetric: bool,
    ) {
        let (first, places) = (nodes.count() - 2, [1 - near, near]);
        for a in 0..2 {
            for f in 0..F {
                let (i, row) = (places[a], &front.rows[first + a][f]);
                for b in if symmetric { a } else { 0 }..2 {
                    let j = places[b];
                    for g in if symmetric && b == a { f } else { 0 }..F {
                        let entry = row.fields[first + b][g].0[l];
                        self.rows[i][f].ends[j][g] = entry;
                        if symmetric {
                            self.rows[j][g].ends[i][f] = entry;
                        }
                    }
                }
                self.rows[i][f].residual = row.residual.0[l];
                self.path.ends[i][f] = front.path.fields[first + a][f].0[l];
            }
        }
        self.path.residual = front.path.residual.0[l];
    }

    /// Adds what is carried to the far end.
    #[inline(always)]
    pub(crate) fn unload(&mut self, carry: &Carry<F>) {
        for i in 0..F {
            let row = &mut self.rows[0][i];
            (0..F).for_each(|j| row.ends[0][j] += carry.tangent[i][j]);
            row.residual += carry.residual[i];
            self.path.ends[0][i] += carry.path[i];
        }
        self.path.residual += carry.path_residual;
    }

    /// Puts in place of equations of the far end by how much what is held there is off.
    pub(crate) fn hold(&mut self, off: &[Option<f64>; F]) {
        for f in 0..F {
            let Some(off) = off[f] else { continue };
            self.rows[0][f] = EndRow::ZERO;
            self.rows[0][f].ends[0][f] = 1.0;
            self.rows[0][f].residual = off;
        }
    }

    /// Eliminates the far end; each pivot is replaced by one over it. How many pivots were negative, and the least without its sign.
    #[inline(always)]
    pub(crate) fn eliminate(&mut self) -> (usize, f64) {
        let (mut negative, mut least) = (0, f64::INFINITY);
        for k in 0..F {
            let pivot_row = self.rows[0][k];
            let pivot = pivot_row.ends[0][k];
            negative += usize::from(pivot < 0.0);
            least = least.min(pivot.abs());
            let inverse = 1.0 / pivot;
            for row in &mut self.rows.as_flattened_mut()[k + 1..] {
                row.reduce(&pivot_row, row.ends[0][k] * inverse, k + 1);
            }
            self.path.reduce(&pivot_row, self.path.ends[0][k] * inverse, k + 1);
            self.rows[0][k].ends[0][k] = inverse;
        }
        (negative, least)
    }

    /// What stands below the pivots.
    #[inline(always)]
    pub(crate) fn below(&self) -> BelowEnd<F> {
        std::array::from_fn(|i| self.rows[1][i].ends[0])
    }

    /// What is left on the near end.
    #[inline(always)]
    pub(crate) fn load(&self) -> Carry<F> {
        Carry {
            tangent: std::array::from_fn(|i| self.rows[1][i].ends[1]),
            residual: std::array::from_fn(|i| self.rows[1][i].residual),
            path: self.path.ends[1],
            path_residual: self.path.residual,
        }
    }
}
