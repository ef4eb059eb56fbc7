//! Any number of right-hand sides through a chain that is eliminated: K = Lᵀ D L, but for the rows of what is held, which were
//! replaced behind the elimination of the interior.

use super::spatial_chain::{SpatialChain, SpatialFactors};
use crate::beam::element::basis::{MOST_NODES, slot};
use crate::beam::element::integration::BUNDLE;
use crate::beam::spatial::section::kinematics::SPATIAL_UNKNOWNS;

/// Most unknowns of an element.
const MOST: usize = MOST_NODES * SPATIAL_UNKNOWNS;
const F: usize = SPATIAL_UNKNOWNS;

/// What the interior of an element is eliminated with: the pivot rows, and where each unknown stands in a right-hand side.
struct Interior<'a> {
    factors: &'a SpatialFactors,
    e: usize,
    pivots: usize,
    unknowns: usize,
    places: [usize; MOST],
}

impl Interior<'_> {
    /// Of a pivot row, the entry of a column; on the diagonal one over the pivot.
    #[inline(always)]
    fn entry(&self, k: usize, j: usize) -> f64 {
        self.factors.fronts[self.e / BUNDLE].rows[k / F][k % F].fields[j / F][j % F].0[self.e % BUNDLE]
    }

    /// Takes what the interior is loaded with off the ends. Plain, the equations of what is held do not take part; transposed they do.
    fn forward(&self, right: &mut [f64], held: impl Fn(usize) -> bool) {
        for k in 0..self.pivots {
            let share = right[self.places[k]] * self.entry(k, k);
            for i in k + 1..self.unknowns {
                if i < self.pivots || !held(i - self.pivots) {
                    right[self.places[i]] -= self.entry(k, i) * share;
                }
            }
        }
    }

    /// The interior, the ends being known; transposed, what is held does not act on the interior.
    fn backward(&self, right: &mut [f64], held: impl Fn(usize) -> bool) {
        for k in (0..self.pivots).rev() {
            let mut sum = right[self.places[k]];
            for i in k + 1..self.unknowns {
                if i < self.pivots || !held(i - self.pivots) {
                    sum -= self.entry(k, i) * right[self.places[i]];
                }
            }
            right[self.places[k]] = sum * self.entry(k, k);
        }
    }
}

impl SpatialChain {
    /// Takes a right-hand side down to the right end.
    pub fn reduce(&self, factors: &SpatialFactors, right: &mut [f64], transposed: bool) -> [f64; F] {
        let elements = factors.below.len();
        for e in 0..elements {
            self.interior(factors, e).forward(right, |i| !transposed && self.is_held(e, i));
            self.end_forward(factors, e, right, transposed);
        }
        let last = elements * self.basis.order * F;
        std::array::from_fn(|f| right[last + f])
    }

    /// From a reduced right-hand side and the solution at the right end to the whole.
    pub fn substitute(&self, factors: &SpatialFactors, root: &[f64; F], right: &mut [f64], transposed: bool) {
        let elements = factors.below.len();
        right[elements * self.basis.order * F..].copy_from_slice(root);
        for e in (0..elements).rev() {
            self.end_backward(factors, e, right, transposed);
            self.interior(factors, e).backward(right, |i| transposed && self.is_held(e, i));
        }
    }

    fn is_held(&self, e: usize, field: usize) -> bool {
        e == 0 && field < F && self.held_left[field].is_some()
    }

    fn interior<'a>(&self, factors: &'a SpatialFactors, e: usize) -> Interior<'a> {
        let (order, count) = (self.basis.order, self.basis.order + 1);
        let mut places = [0; MOST];
        for rank in 0..count {
            for f in 0..F {
                places[slot(count, rank) * F + f] = (e * order + rank) * F + f;
            }
        }
        Interior { factors, e, pivots: (count - 2) * F, unknowns: count * F, places }
    }

    /// Where the two ends of an element stand.
    fn end_places(&self, e: usize) -> [usize; 2] {
        [e * self.basis.order * F, (e + 1) * self.basis.order * F]
    }

    fn end_forward(&self, factors: &SpatialFactors, e: usize, right: &mut [f64], transposed: bool) {
        let (rows, below, [left, next]) = (&factors.ends[e], &factors.below[e], self.end_places(e));
        for k in 0..F {
            let mut pivot = right[left + k];
            if transposed {
                pivot *= rows[k][k];
                right[left + k] = pivot;
                (k + 1..F).for_each(|i| right[left + i] -= rows[k][i] * pivot);
                (0..F).for_each(|i| right[next + i] -= rows[k][F + i] * pivot);
            } else {
                let share = pivot * rows[k][k];
                (k + 1..F).for_each(|i| right[left + i] -= rows[i][k] * share);
                (0..F).for_each(|i| right[next + i] -= below[i][k] * share);
            }
        }
    }

    fn end_backward(&self, factors: &SpatialFactors, e: usize, right: &mut [f64], transposed: bool) {
        let (rows, below, [left, next]) = (&factors.ends[e], &factors.below[e], self.end_places(e));
        for k in (0..F).rev() {
            let mut sum = right[left + k];
            if transposed {
                let mut taken = 0.0;
                (k + 1..F).for_each(|i| taken += rows[i][k] * right[left + i]);
                (0..F).for_each(|i| taken += below[i][k] * right[next + i]);
                sum -= taken * rows[k][k];
                right[left + k] = sum;
            } else {
                (k + 1..F).for_each(|i| sum -= rows[k][i] * right[left + i]);
                (0..F).for_each(|i| sum -= rows[k][F + i] * right[next + i]);
                right[left + k] = sum * rows[k][k];
            }
        }
    }
}
