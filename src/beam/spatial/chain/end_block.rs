//! The block of an element's two ends, what condensation leaves of it: eliminated from its left end to its right.

use super::projection::SpatialFront;
use crate::beam::element::basis::Nodes;
use crate::beam::spatial::section::kinematics::SPATIAL_UNKNOWNS;

/// Both ends, and the residual or the path.
pub(in crate::beam::spatial) const EDGE: usize = 2 * SPATIAL_UNKNOWNS + 1;
/// The right end, and the residual or the path.
pub(in crate::beam::spatial) const ROOT: usize = SPATIAL_UNKNOWNS + 1;
const KNOWN: usize = 2 * SPATIAL_UNKNOWNS;

/// An equation of the block.
pub(in crate::beam::spatial) type EndRow = [f64; EDGE];
/// What stands below the pivots of the left end in the rows of the right.
pub(in crate::beam::spatial) type BelowEnd = [[f64; SPATIAL_UNKNOWNS]; SPATIAL_UNKNOWNS];
/// What is left on the right end.
pub(in crate::beam::spatial) type Carry = [[f64; ROOT]; ROOT];

/// The block itself.
pub(in crate::beam::spatial) struct EndBlock(pub [EndRow; EDGE]);

impl EndBlock {
    /// All zero.
    #[inline(always)]
    pub fn zero() -> Self {
        Self([[0.0; EDGE]; EDGE])
    }

    /// Takes what condensation left of element `l` of a front, which is symmetric, with its two ends in this order: 0 and 1, or 1 and 0.
    #[inline(always)]
    pub fn take(&mut self, nodes: impl Nodes, front: &SpatialFront, l: usize, places: [usize; 2]) {
        const F: usize = SPATIAL_UNKNOWNS;
        let Self(block) = self;
        let first = nodes.count() - 2;
        for a in 0..2 {
            for f in 0..F {
                let (i, row) = (places[a] * F + f, &front.rows[first + a][f]);
                for b in a..2 {
                    for g in if b == a { f } else { 0 }..F {
                        block[i][places[b] * F + g] = row.fields[first + b][g].0[l];
                        block[places[b] * F + g][i] = row.fields[first + b][g].0[l];
                    }
                }
                block[i][KNOWN] = row.residual.0[l];
                block[KNOWN][i] = front.path.fields[first + a][f].0[l];
            }
        }
        block[KNOWN][KNOWN] = front.path.residual.0[l];
    }

    /// The left end of the chain: its part of the path functional, and by how much what is held is off.
    pub fn start(&mut self, path: &[f64; SPATIAL_UNKNOWNS], off: &[Option<f64>; SPATIAL_UNKNOWNS]) {
        for f in 0..SPATIAL_UNKNOWNS {
            self.0[KNOWN][f] += path[f];
        }
        for f in 0..SPATIAL_UNKNOWNS {
            let Some(off) = off[f] else { continue };
            self.0[f] = [0.0; EDGE];
            self.0[f][f] = 1.0;
            self.0[f][KNOWN] = off;
        }
    }

    /// Eliminates the left end; each pivot is replaced by one over it. How many pivots were negative, and the least without its sign.
    #[inline(always)]
    pub fn eliminate(&mut self) -> (usize, f64) {
        let (mut negative, mut least) = (0, f64::INFINITY);
        for k in 0..SPATIAL_UNKNOWNS {
            let row = self.0[k];
            negative += usize::from(row[k] < 0.0);
            least = least.min(row[k].abs());
            let inverse = 1.0 / row[k];
            for i in k + 1..EDGE {
                let factor = self.0[i][k] * inverse;
                for j in k + 1..EDGE {
                    self.0[i][j] -= factor * row[j];
                }
            }
            self.0[k][k] = inverse;
        }
        (negative, least)
    }

    /// What stands below the pivots.
    #[inline(always)]
    pub fn below(&self) -> BelowEnd {
        std::array::from_fn(|i| std::array::from_fn(|k| self.0[SPATIAL_UNKNOWNS + i][k]))
    }

    /// What is left on the right end and the path.
    #[inline(always)]
    pub fn load(&self) -> Carry {
        std::array::from_fn(|i| std::array::from_fn(|j| self.0[SPATIAL_UNKNOWNS + i][SPATIAL_UNKNOWNS + j]))
    }

    /// Adds what the element before left to the left end.
    #[inline(always)]
    pub fn unload(&mut self, carry: &Carry) {
        let place = |i: usize| if i < SPATIAL_UNKNOWNS { i } else { KNOWN };
        for i in 0..ROOT {
            for j in 0..ROOT {
                self.0[place(i)][place(j)] += carry[i][j];
            }
        }
    }
}
