//! Elimination of the first unknowns of a dense matrix: K = L U, with the pivots on the diagonal of U and ones on that of L.
//!
//! Where K is symmetric only its upper triangle is read and written, and L is Uᵀ over the pivots. There is no exchange of rows: what is
//! eliminated first is a piece of an elastic body, and its pivots are the stiffnesses of that. The number of negative ones is that of
//! negative eigenvalues, by Sylvester's law.

/// Pivots whose rows are taken off the others at once.
const PANEL: usize = 4;

/// The first `eliminated` of `size` unknowns eliminated.
#[derive(Clone, Debug, Default)]
pub(crate) struct Elimination {
    size: usize,
    eliminated: usize,
    /// Rows of U, each from its pivot on, one after the other at its full length.
    upper: Vec<f64>,
    /// L below the pivots, row by row of the unknowns; empty where K is symmetric.
    lower: Vec<f64>,
}

/// What pivots say of a matrix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pivots {
    /// How many are negative.
    pub negative: usize,
    /// The smallest without its sign.
    pub least: f64,
    /// Whether all are finite, and none is zero to rounding.
    pub regular: bool,
}

impl Pivots {
    /// Of no pivot.
    pub(crate) const NONE: Self = Self { negative: 0, least: f64::INFINITY, regular: true };

    /// With those of another matrix.
    pub(crate) fn and(self, other: Self) -> Self {
        Self {
            negative: self.negative + other.negative,
            least: self.least.min(other.least),
            regular: self.regular && other.regular,
        }
    }
}

/// A pivot below this share of the diagonal that it came from is round-off.
const SINGULAR: f64 = 1e-14;

impl Elimination {
    /// Eliminates the first unknowns of `matrix`, `size` by `size`, row by row; what is left of it, the Schur complement, stays there in the
    /// rows and columns behind.
    pub(crate) fn run(&mut self, matrix: &mut [f64], size: usize, eliminated: usize, symmetric: bool) -> Pivots {
        (self.size, self.eliminated) = (size, eliminated);
        let mut pivots = Pivots::NONE;
        self.lower.clear();
        if !symmetric {
            self.lower.resize(size * eliminated, 0.0);
        }
        let diagonal: Vec<f64> = (0..eliminated).map(|k| matrix[k * size + k].abs()).collect();
        eliminate(matrix, (size, eliminated), &mut self.lower);
        for k in 0..eliminated {
            let pivot = matrix[k * size + k];
            pivots.negative += usize::from(pivot < 0.0);
            pivots.least = pivots.least.min(pivot.abs());
            pivots.regular &= pivot.is_finite() && pivot.abs() > SINGULAR * diagonal[k];
        }
        self.upper.clear();
        self.upper.extend_from_slice(&matrix[..size * eliminated]);
        pivots
    }

    /// The factor of row `row` for the pivot `k`, of a matrix that is not symmetric.
    #[inline(always)]
    fn factor(&self, row: usize, k: usize) -> f64 {
        self.lower[row * self.eliminated + k]
    }

    /// A right-hand side taken down: of K, or of Kᵀ.
    pub(crate) fn forward(&self, right: &mut [f64], transposed: bool) {
        let right = &mut right[..self.size];
        for k in 0..self.eliminated {
            let row = &self.upper[k * self.size..][..self.size];
            if transposed {
                right[k] /= row[k];
                let value = right[k];
                right[k + 1..].iter_mut().zip(&row[k + 1..]).for_each(|(right, row)| *right -= row * value);
            } else {
                let value = right[k];
                if self.lower.is_empty() {
                    let value = value / row[k];
                    right[k + 1..].iter_mut().zip(&row[k + 1..]).for_each(|(right, row)| *right -= row * value);
                } else {
                    (k + 1..self.size).for_each(|i| right[i] -= self.factor(i, k) * value);
                }
            }
        }
    }

    /// From a right-hand side that was taken down, with the solution of what was not eliminated, to the whole solution.
    pub(crate) fn backward(&self, right: &mut [f64], transposed: bool) {
        let right = &mut right[..self.size];
        for k in (0..self.eliminated).rev() {
            let row = &self.upper[k * self.size..][..self.size];
            if transposed {
                if self.lower.is_empty() {
                    right[k] -= sum_of_products(&row[k + 1..], &right[k + 1..]) / row[k];
                } else {
                    let taken: f64 = (k + 1..self.size).map(|i| self.factor(i, k) * right[i]).sum();
                    right[k] -= taken;
                }
            } else {
                right[k] = (right[k] - sum_of_products(&row[k + 1..], &right[k + 1..])) / row[k];
            }
        }
    }
}

/// Σ a b, in eight sums side by side.
fn sum_of_products(a: &[f64], b: &[f64]) -> f64 {
    let ((a, a_rest), (b, b_rest)) = (a.as_chunks::<8>(), b.as_chunks::<8>());
    let mut sums = [0.0; 8];
    for (a, b) in a.iter().zip(b) {
        (0..8).for_each(|l| sums[l] += a[l] * b[l]);
    }
    let rest: f64 = a_rest.iter().zip(b_rest).map(|(a, b)| a * b).sum();
    sums.iter().sum::<f64>() + rest
}

/// The elimination itself; of a matrix that is symmetric `lower` is empty.
#[cfg_attr(
    not(any(test, feature = "portable", debug_assertions)),
    multiversion::multiversion(targets("x86_64+avx512f+fma", "x86_64+avx2+fma"))
)]
fn eliminate(matrix: &mut [f64], (size, eliminated): (usize, usize), lower: &mut [f64]) {
    for first in (0..eliminated).step_by(PANEL) {
        let last = (first + PANEL).min(eliminated);
        for row in first + 1..last {
            let (above, own) = matrix.split_at_mut(row * size);
            let own = &mut own[..size];
            let (factors, from) = factors(above, own, (first, row), (row, eliminated), lower);
            let mut rows = [&above[..0]; PANEL];
            (first..row).for_each(|k| rows[k - first] = &above[k * size + from..][..size - from]);
            for (pivot_row, factor) in rows[..row - first].iter().zip(&factors) {
                own[from..].iter_mut().zip(*pivot_row).for_each(|(own, value)| *own -= factor * value);
            }
        }
        for row in (last..size).step_by(2) {
            let (above, own) = matrix.split_at_mut(row * size);
            let (own, next) = own.split_at_mut(size);
            let (of_own, from) = factors(above, own, (first, last), (row, eliminated), lower);
            let mut rows = [&above[..0]; PANEL];
            (first..last).for_each(|k| rows[k - first] = &above[k * size + from..][..size - from]);
            match next.get_mut(..size) {
                Some(next) => {
                    let (of_next, _) = factors(above, next, (first, last), (row + 1, eliminated), lower);
                    take_off([&mut own[from..], &mut next[from..]], &rows[..last - first], [&of_own, &of_next]);
                }
                None => take_off([&mut own[from..], &mut []], &rows[..last - first], [&of_own, &of_own]),
            }
        }
    }
}

/// The factors of a row for the pivots from `first` to `last`, and the column from which on it changes.
#[inline(always)]
fn factors(
    above: &[f64],
    own: &[f64],
    (first, last): (usize, usize),
    (row, eliminated): (usize, usize),
    lower: &mut [f64],
) -> ([f64; PANEL], usize) {
    let (size, symmetric) = (own.len(), lower.is_empty());
    let mut factors = [0.0; PANEL];
    for k in first..last {
        let pivot_row = &above[k * size..][..size];
        let factor = if symmetric {
            pivot_row[row] / pivot_row[k]
        } else {
            let taken: f64 = (first..k).map(|m| factors[m - first] * above[m * size + k]).sum();
            (own[k] - taken) / pivot_row[k]
        };
        factors[k - first] = factor;
        if !symmetric {
            lower[row * eliminated + k] = factor;
        }
    }
    (factors, if symmetric { row } else { last })
}

/// own -= Σ factors · rows, of two rows at once, so that the pivots' rows are read once; the second may be empty.
#[inline(always)]
fn take_off([own, next]: [&mut [f64]; 2], rows: &[&[f64]], [of_own, of_next]: [&[f64; PANEL]; 2]) {
    let n = own.len();
    if let ([a, b, c, d], true) = (rows, next.len() == n) {
        let (a, b, c, d) = (&a[..n], &b[..n], &c[..n], &d[..n]);
        for j in 0..n {
            own[j] -= of_own[0] * a[j] + of_own[1] * b[j] + of_own[2] * c[j] + of_own[3] * d[j];
            next[j] -= of_next[0] * a[j] + of_next[1] * b[j] + of_next[2] * c[j] + of_next[3] * d[j];
        }
    } else {
        for (k, row) in rows.iter().enumerate() {
            own.iter_mut().zip(*row).for_each(|(own, value)| *own -= of_own[k] * value);
            next.iter_mut().zip(*row).for_each(|(next, value)| *next -= of_next[k] * value);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;
    use nalgebra::{DMatrix, DVector};

    const SIZE: usize = 11;

    fn matrix(symmetric: bool) -> DMatrix<f64> {
        let entry = |i: usize, j: usize| ((7 * i + 3 * j * j) % 13) as f64 / 13.0 - 0.4;
        let any = DMatrix::from_fn(SIZE, SIZE, entry) + DMatrix::from_diagonal_element(SIZE, SIZE, -3.0);
        let signs = DMatrix::from_diagonal(&DVector::from_fn(SIZE, |k, _| if k == 2 { 9.0 } else { 0.0 }));
        if symmetric { &any + any.transpose() + signs } else { any + signs }
    }

    #[test]
    fn solves_as_the_whole_matrix_does() {
        for (symmetric, transposed, eliminated) in
            [(true, false, 8), (true, true, 7), (false, false, 8), (false, true, 5), (false, false, 11)]
        {
            let whole = matrix(symmetric);
            let mut rows: Vec<f64> = whole.transpose().as_slice().to_vec();
            let mut elimination = Elimination::default();
            let pivots = elimination.run(&mut rows, SIZE, eliminated, symmetric);
            assert!(pivots.regular);
            let right = DVector::from_fn(SIZE, |k, _| (k as f64).cos());
            let asked = if transposed { whole.transpose() } else { whole.clone() };
            let expected = asked.lu().solve(&right).unwrap();
            let mut found = right.as_slice().to_vec();
            elimination.forward(&mut found, transposed);
            let left = SIZE - eliminated;
            let schur = DMatrix::from_fn(left, left, |i, j| {
                let (i, j) = if symmetric { (i.min(j), i.max(j)) } else { (i, j) };
                rows[(eliminated + i) * SIZE + eliminated + j]
            });
            let schur = if transposed { schur.transpose() } else { schur };
            let rest = DVector::from_column_slice(&found[eliminated..]);
            if left > 0 {
                found[eliminated..].copy_from_slice(schur.lu().solve(&rest).unwrap().as_slice());
            }
            elimination.backward(&mut found, transposed);
            (0..SIZE).for_each(|k| assert_abs_diff_eq!(found[k], expected[k], epsilon = 1e-12));
        }
    }

    #[test]
    fn negative_pivots_are_negative_eigenvalues() {
        let whole = matrix(true);
        let mut rows: Vec<f64> = whole.as_slice().to_vec();
        let pivots = Elimination::default().run(&mut rows, SIZE, SIZE, true);
        let expected = whole.symmetric_eigenvalues().iter().filter(|value| **value < 0.0).count();
        assert_eq!(pivots.negative, expected);
        let mut zero = vec![1.0, 1.0, 1.0, 1.0];
        assert!(!Elimination::default().run(&mut zero, 2, 2, true).regular);
    }
}
