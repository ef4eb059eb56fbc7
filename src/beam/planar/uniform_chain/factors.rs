//! Any number of right-hand sides through a chain that is eliminated, plain and transposed.
//!
//! Elimination writes the tangent as K = L U, the unit lower triangle L holding the multipliers. With p for what is eliminated
//! and r for the root,
//!
//!   K x = b:   b_r := b_r - L_rp L_pp⁻¹ b_p,   x_p = U_pp⁻¹ (L_pp⁻¹ b_p - U_pr x_r)
//!   Kᵀ x = b:  b_r := b_r - U_prᵀ U_pp⁻ᵀ b_p,  x_p = L_pp⁻ᵀ (U_pp⁻ᵀ b_p - L_rpᵀ x_r)
//!
//! and the root's own matrix, or its transpose, stands between the two. U is what elimination leaves in its pivot rows. L is
//! found again from what it leaves below the pivots, and in the fronts of a symmetric tangent from U.

use super::elements::{Kept, UniformChain};
use crate::beam::planar::chain::{BelowEnd, ChainFactors, EndRow, MOST_FIELDS, RootVector};
use crate::number::F64x4;
use crate::solve::frontal::frontal_matrix::{FrontalMatrix, FrontalRow};
use crate::solve::frontal::nodes::{BUNDLE, MOST_NODES, slot};

/// Most unknowns of an element: its fields and the border.
const MOST: usize = MOST_NODES * MOST_FIELDS + 1;

/// Some unknowns of which the first are eliminated: L below the diagonal, U above it, one over the pivots on it.
struct Factors {
    pivots: usize,
    unknowns: usize,
    entries: [[f64; MOST]; MOST],
    /// Where each unknown stands in a right-hand side.
    places: [usize; MOST],
}

impl Factors {
    fn new(pivots: usize, unknowns: usize) -> Self {
        Self { pivots, unknowns, entries: [[0.0; MOST]; MOST], places: [0; MOST] }
    }

    /// L⁻¹ b, or U⁻ᵀ b.
    fn forward(&self, right: &mut [f64], transposed: bool) {
        for k in 0..self.pivots {
            let mut pivot = right[self.places[k]];
            if transposed {
                pivot *= self.entries[k][k];
                right[self.places[k]] = pivot;
            }
            for i in k + 1..self.unknowns {
                let entry = if transposed { self.entries[k][i] } else { self.entries[i][k] };
                right[self.places[i]] -= entry * pivot;
            }
        }
    }

    /// U⁻¹ of what [`Factors::forward`] made, or L⁻ᵀ of it.
    fn backward(&self, right: &mut [f64], transposed: bool) {
        for k in (0..self.pivots).rev() {
            let mut sum = right[self.places[k]];
            for i in k + 1..self.unknowns {
                let entry = if transposed { self.entries[i][k] } else { self.entries[k][i] };
                sum -= entry * right[self.places[i]];
            }
            right[self.places[k]] = if transposed { sum } else { sum * self.entries[k][k] };
        }
    }
}

impl<const F: usize> UniformChain<F> {
    /// [`super::Chain::reduce`]
    pub(super) fn reduce_right(&self, eliminated: &ChainFactors, right: &mut [f64], transposed: bool) -> RootVector {
        let (elements, last) = self.measure(eliminated, right);
        for e in 0..elements {
            self.inside(eliminated, e, right.len()).forward(right, transposed);
            self.ends(eliminated, e, right.len()).forward(right, transposed);
        }
        let mut root = [0.0; MOST_FIELDS + 1];
        root[..right.len() - last].copy_from_slice(&right[last..]);
        root
    }

    /// [`super::Chain::substitute`]
    pub(super) fn substitute_right(
        &self,
        eliminated: &ChainFactors,
        root: &[f64],
        right: &mut [f64],
        transposed: bool,
    ) {
        let (elements, last) = self.measure(eliminated, right);
        let left = right.len() - last;
        right[last..].copy_from_slice(&root[..left]);
        for e in (0..elements).rev() {
            self.ends(eliminated, e, right.len()).backward(right, transposed);
            self.inside(eliminated, e, right.len()).backward(right, transposed);
        }
    }

    /// How many elements were eliminated, and where the unknowns of the root begin in a right-hand side.
    fn measure(&self, eliminated: &ChainFactors, right: &[f64]) -> (usize, usize) {
        let elements = eliminated.below.len();
        let last = elements * self.basis.order * F;
        let unknowns = last + F + usize::from(self.density.has_border());
        assert_eq!(right.len(), unknowns, "a right-hand side has a number for each unknown");
        (elements, last)
    }

    /// The interior nodes of element `e`, eliminated from all its unknowns.
    fn inside(&self, eliminated: &ChainFactors, e: usize, all: usize) -> Factors {
        let kept = eliminated.fronts.as_ref().and_then(|kept| kept.downcast_ref::<Kept<F>>());
        let front = &kept.expect("eliminated comes from an elimination of this chain").fronts[e / BUNDLE];
        let (order, count) = (self.basis.order, self.basis.order + 1);
        let (pivots, fields, border) = ((count - 2) * F, count * F, usize::from(self.density.has_border()));
        let mut factors = Factors::new(pivots, fields + border);
        for rank in 0..count {
            for f in 0..F {
                factors.places[slot(count, rank) * F + f] = (e * order + rank) * F + f;
            }
        }
        factors.places[fields] = all - 1;
        let lane = Lane { front, l: e % BUNDLE };
        for k in 0..pivots {
            for j in k..fields {
                factors.entries[k][j] = lane.entry(k, j);
            }
            factors.entries[k][fields] = lane.row(k).border.0[lane.l];
        }
        for i in 0..fields {
            for k in 0..pivots.min(i) {
                factors.entries[i][k] = if self.symmetric {
                    factors.entries[k][i] * factors.entries[k][k]
                } else {
                    lane.multiplier(lane.row(i), k)
                };
            }
        }
        for k in 0..pivots * border {
            factors.entries[fields][k] = lane.multiplier(&front.border, k);
        }
        // the equation of a field that is held was replaced behind the elimination of the interior
        for f in (0..F).filter(|&f| e == 0 && self.pinned_left[f].is_some()) {
            factors.entries[pivots + f][..pivots].fill(0.0);
        }
        factors
    }

    /// The left end of element `e`, eliminated from both ends and the border.
    fn ends(&self, eliminated: &ChainFactors, e: usize, all: usize) -> Factors {
        let (rows, below): (&[EndRow], &BelowEnd) = (&eliminated.ends[e * F..][..F], &eliminated.below[e]);
        let unknowns = 2 * F + usize::from(self.density.has_border());
        let mut factors = Factors::new(F, unknowns);
        for f in 0..F {
            factors.places[f] = e * self.basis.order * F + f;
            factors.places[F + f] = (e + 1) * self.basis.order * F + f;
        }
        factors.places[2 * F] = all - 1;
        for k in 0..F {
            let inverse = rows[k][k];
            factors.entries[k][k..unknowns].copy_from_slice(&rows[k][k..unknowns]);
            for i in k + 1..unknowns {
                let entry = if i < F { rows[i][k] } else { below[i - F][k] };
                factors.entries[i][k] = entry * inverse;
            }
        }
        factors
    }
}

/// One element of an eliminated front.
struct Lane<'a, const F: usize> {
    front: &'a FrontalMatrix<F64x4, F>,
    l: usize,
}

impl<const F: usize> Lane<'_, F> {
    fn row(&self, i: usize) -> &FrontalRow<F64x4, F> {
        &self.front.rows[i / F][i % F]
    }

    fn entry(&self, i: usize, j: usize) -> f64 {
        self.of(self.row(i), j)
    }

    fn of(&self, row: &FrontalRow<F64x4, F>, j: usize) -> f64 {
        row.fields[j / F][j % F].0[self.l]
    }

    /// By what pivot row `k` was multiplied before it was taken off a row below. Pivots go in pairs: in its second column a row is
    /// left as it was before the first was taken off.
    fn multiplier(&self, row: &FrontalRow<F64x4, F>, k: usize) -> f64 {
        let is_second = k % 2 == 1;
        let entry = if is_second {
            self.of(row, k) - self.entry(k - 1, k) * self.multiplier(row, k - 1)
        } else {
            self.of(row, k)
        };
        entry * self.entry(k, k)
    }
}
