//! The block of an element's two ends, what condensation leaves of it: eliminated from its left end to its right.
use crate::beam::planar::chain::{BelowEnd, ConstraintGradient, EDGE, EndRow, ROOT};
use crate::number::F64x4;
use crate::solve::frontal::frontal_matrix::FrontalMatrix;
use crate::solve::frontal::nodes::Nodes;

/// The block of F fields at each end, and of the border where there is one.
pub(super) struct Ends<const F: usize, const BORDER: bool>;

impl<const F: usize, const BORDER: bool> Ends<F, BORDER> {
    /// Places in the block: of the border, and of residual and path behind all unknowns.
    const BORDER: usize = 2 * F;
    const KNOWN: usize = 2 * F + BORDER as usize;

    /// What condensation left of element `l` of a bundle: rows and columns of the left end, the right end and the border, then
    /// the residual and the path.
    #[inline(always)]
    pub(crate) fn block(
        nodes: impl Nodes,
        front: &FrontalMatrix<F64x4, F>,
        symmetric: bool,
        l: usize,
    ) -> [EndRow; EDGE] {
        let mut block = [[0.0; EDGE]; EDGE];
        let ends = [nodes.count() - 2, nodes.count() - 1];
        for i in 0..2 * F {
            let row = &front.rows[ends[i / F]][i % F];
            for j in 0..2 * F {
                let below = symmetric && j < i;
                let (row, node, field) = if below {
                    (&front.rows[ends[j / F]][j % F], ends[i / F], i % F)
                } else {
                    (row, ends[j / F], j % F)
                };
                block[i][j] = row.fields[node][field].0[l];
            }
            if BORDER {
                block[i][Self::BORDER] = row.border.0[l];
                block[Self::BORDER][i] = front.border.fields[ends[i / F]][i % F].0[l];
            }
            block[i][Self::KNOWN] = row.residual.0[l];
            block[Self::KNOWN][i] = front.path.fields[ends[i / F]][i % F].0[l];
        }
        if BORDER {
            block[Self::BORDER][Self::BORDER] = front.border.border.0[l];
            block[Self::BORDER][Self::KNOWN] = front.border.residual.0[l];
            block[Self::KNOWN][Self::BORDER] = front.path.border.0[l];
        }
        block[Self::KNOWN][Self::KNOWN] = front.path.residual.0[l];
        block
    }

    /// The left end of the chain: its part of the path functional, and the fields that are held.
    #[inline(always)]
    pub(crate) fn start(
        block: &mut [EndRow; EDGE],
        path: &ConstraintGradient,
        pinned: &[Option<f64>; F],
        left_values: &[f64],
    ) {
        for f in 0..F {
            block[Self::KNOWN][f] += path.left[f];
        }
        for f in 0..F {
            let Some(held) = pinned[f] else { continue };
            block[f] = [0.0; EDGE];
            block[f][f] = 1.0;
            block[f][Self::KNOWN] = left_values[f] - held;
        }
    }

    /// Eliminates the left end; each pivot is replaced by one over it. Returns how many pivots were negative, and the least
    /// without its sign.
    #[inline(always)]
    pub(crate) fn eliminate(block: &mut [EndRow; EDGE]) -> (usize, f64) {
        let (mut negative, mut least) = (0, f64::INFINITY);
        for k in 0..F {
            let row = block[k];
            negative += usize::from(row[k] < 0.0);
            least = least.min(row[k].abs());
            let inverse = 1.0 / row[k];
            for i in k + 1..=Self::KNOWN {
                let factor = block[i][k] * inverse;
                for j in k + 1..=Self::KNOWN {
                    block[i][j] -= factor * row[j];
                }
            }
            block[k][k] = inverse;
        }
        (negative, least)
    }

    /// Keeps what stands below the pivots in the rows of the right end and of the border.
    #[inline(always)]
    pub(crate) fn keep_below(block: &[EndRow; EDGE], below: &mut BelowEnd) {
        for i in F..Self::KNOWN {
            for k in 0..F {
                below[i - F][k] = block[i][k];
            }
        }
    }

    /// What is left on the right end, the border and the path.
    #[inline(always)]
    pub(crate) fn load(block: &[EndRow; EDGE]) -> [[f64; ROOT]; ROOT] {
        let mut carry = [[0.0; ROOT]; ROOT];
        for i in 0..=Self::KNOWN - F {
            for j in 0..=Self::KNOWN - F {
                carry[i][j] = block[F + i][F + j];
            }
        }
        carry
    }

    /// Adds what the element before left to the left end.
    #[inline(always)]
    pub(crate) fn unload(carry: &[[f64; ROOT]; ROOT], block: &mut [EndRow; EDGE]) {
        let place = |i: usize| if i < F { i } else { F + i };
        for i in 0..=Self::KNOWN - F {
            for j in 0..=Self::KNOWN - F {
                block[place(i)][place(j)] += carry[i][j];
            }
        }
    }
}
