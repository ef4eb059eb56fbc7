//! The front of an element: its tangent with all that elimination takes along.

use super::nodes::{MOST_NODES, Nodes};
use crate::number::Real;

/// One row: an equation, with a column for each unknown.
#[derive(Clone, Copy, Debug)]
pub struct FrontalRow<T, const F: usize> {
    /// Columns of the fields, node by node in the order of elimination.
    pub fields: [[T; F]; MOST_NODES],
    /// Column of the border.
    pub border: T,
    /// Column of the gradient.
    pub residual: T,
}

/// The tangent of one element of N nodes and F fields, or of four side by side, with the gradient, the border's row and column,
/// and one more row that carries a functional along.
#[derive(Clone, Copy, Debug)]
pub struct FrontalMatrix<T, const F: usize> {
    /// `rows[a][f]`: the equation of field f at node a.
    pub rows: [[FrontalRow<T, F>; F]; MOST_NODES],
    /// The equation of the border; unused where there is none.
    pub border: FrontalRow<T, F>,
    /// The functional, and its value in the column of the gradient.
    pub path: FrontalRow<T, F>,
}

/// What elimination reports of its pivots.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pivots<T> {
    /// The smallest, without its sign.
    pub least: T,
    /// How many were negative.
    pub negative: T,
}

impl<T: Real, const F: usize> FrontalRow<T, F> {
    #[inline(always)]
    fn zero() -> Self {
        let zero = T::splat(0.0);
        Self { fields: [[zero; F]; MOST_NODES], border: zero, residual: zero }
    }

    #[inline(always)]
    fn clear(&mut self, nodes: impl Nodes) {
        let zero = T::splat(0.0);
        for fields in &mut self.fields[..nodes.count()] {
            *fields = [zero; F];
        }
        (self.border, self.residual) = (zero, zero);
    }

    #[inline(always)]
    fn column(&self, k: usize) -> T {
        self.fields.as_flattened()[k]
    }

    /// Takes off multiples of pivot rows, in the columns from `from` on.
    #[inline(always)]
    fn reduce<const BORDER: bool, const ROWS: usize>(
        &mut self,
        nodes: impl Nodes,
        rows: [&Self; ROWS],
        factors: [T; ROWS],
        from: usize,
    ) {
        let columns = self.fields.as_flattened_mut();
        for j in from..F * nodes.count() {
            let mut sum = columns[j];
            for r in 0..ROWS {
                sum = sum - rows[r].column(j) * factors[r];
            }
            columns[j] = sum;
        }
        for (row, factor) in rows.into_iter().zip(factors) {
            if BORDER {
                self.border = self.border - row.border * factor;
            }
            self.residual = self.residual - row.residual * factor;
        }
    }
}

impl<T: Real, const F: usize> FrontalRow<T, F> {
    /// Takes off the pivot rows of node `a`, one over whose pivots is `inverse`. In the columns of that node stays what stood below each pivot.
    #[inline(always)]
    fn reduce_by_node(&mut self, nodes: impl Nodes, pivot_rows: [&Self; F], inverse: &[T; F], a: usize) {
        let mut factors = [T::splat(0.0); F];
        for k in 0..F {
            let mut entry = self.fields[a][k];
            for r in 0..k {
                entry = entry - pivot_rows[r].fields[a][k] * factors[r];
            }
            self.fields[a][k] = entry;
            factors[k] = entry * inverse[k];
        }
        self.reduce::<false, F>(nodes, pivot_rows, factors, F * (a + 1));
    }

    /// [`Self::reduce`] of two rows at once, which read every pivot row once for both; the first of them from the column before `from` on.
    #[inline(always)]
    fn reduce_two<const ROWS: usize>(
        [first, second]: [&mut Self; 2],
        nodes: impl Nodes,
        rows: [&Self; ROWS],
        factors: [[T; ROWS]; 2],
        from: usize,
    ) {
        let columns = [first.fields.as_flattened_mut(), second.fields.as_flattened_mut()];
        for r in 0..ROWS {
            columns[0][from - 1] = columns[0][from - 1] - rows[r].column(from - 1) * factors[0][r];
        }
        for j in from..F * nodes.count() {
            let mut sums = [columns[0][j], columns[1][j]];
            for r in 0..ROWS {
                let entry = rows[r].column(j);
                sums = [sums[0] - entry * factors[0][r], sums[1] - entry * factors[1][r]];
            }
            (columns[0][j], columns[1][j]) = (sums[0], sums[1]);
        }
        for r in 0..ROWS {
            first.residual = first.residual - rows[r].residual * factors[0][r];
            second.residual = second.residual - rows[r].residual * factors[1][r];
        }
    }
}

impl<T: Real> Pivots<T> {
    /// Counts a pivot and returns one over it.
    #[inline(always)]
    fn invert(&mut self, pivot: T) -> T {
        let size = pivot.select(pivot, -pivot);
        self.least = (self.least - size).select(size, self.least);
        self.negative = self.negative + pivot.select(T::splat(0.0), T::splat(1.0));
        pivot.recip()
    }
}

impl<T: Real, const F: usize> FrontalMatrix<T, F> {
    /// All zero.
    #[inline(always)]
    pub fn zero() -> Self {
        let row = FrontalRow::zero();
        Self { rows: [[row; F]; MOST_NODES], border: row, path: row }
    }

    /// Clears the gradient, the border and the path.
    #[inline(always)]
    pub(crate) fn clear_gradient<const BORDER: bool>(&mut self, nodes: impl Nodes) {
        let zero = T::splat(0.0);
        for row in &mut self.rows.as_flattened_mut()[..F * nodes.count()] {
            (row.border, row.residual) = (zero, zero);
        }
        self.path.clear(nodes);
        if BORDER {
            self.border.clear(nodes);
        }
    }

    /// Eliminates the interior nodes, without pivoting; each pivot is replaced by one over it. Where the tangent is
    /// `symmetric`, nothing below its diagonal is looked at.
    #[inline(always)]
    pub(crate) fn condense<const BORDER: bool>(&mut self, nodes: impl Nodes, symmetric: bool) -> Pivots<T> {
        let mut pivots = Pivots { least: T::splat(f64::INFINITY), negative: T::splat(0.0) };
        let inside = F * (nodes.count() - 2);
        // two at a time: half as often every number below is read and written
        for k in (0..inside - inside % 2).step_by(2) {
            self.eliminate_two::<BORDER>(nodes, k, symmetric, &mut pivots);
        }
        if inside % 2 == 1 {
            self.eliminate_one::<BORDER>(nodes, inside - 1, symmetric, &mut pivots);
        }
        pivots
    }

    /// The same without a border, a node at a time: every number below is read and written F times less often. Where the tangent is not
    /// `SYMMETRIC`, what stood below each pivot stays there.
    #[inline(always)]
    pub(crate) fn condense_by_nodes<const SYMMETRIC: bool>(&mut self, nodes: impl Nodes) -> Pivots<T> {
        let mut pivots = Pivots { least: T::splat(f64::INFINITY), negative: T::splat(0.0) };
        for a in 0..nodes.count() - 2 {
            let (done, below) = self.rows[..nodes.count()].split_at_mut(a + 1);
            let own = &mut done[a];
            let mut inverse = [T::splat(0.0); F];
            for k in 0..F {
                let (first, rest) = own.split_at_mut(k + 1);
                let pivot_row = &first[k];
                inverse[k] = pivots.invert(pivot_row.fields[a][k]);
                for (i, row) in (k + 1..).zip(rest) {
                    let (entry, from) = if SYMMETRIC { (pivot_row.fields[a][i], i) } else { (row.fields[a][k], k + 1) };
                    row.reduce::<false, 1>(nodes, [pivot_row], [entry * inverse[k]], F * a + from);
                }
            }
            let pivot_rows: [&FrontalRow<T, F>; F] = own.each_ref();
            for (b, rows) in (a + 1..).zip(below) {
                if !SYMMETRIC {
                    for row in rows {
                        row.reduce_by_node(nodes, pivot_rows, &inverse, a);
                    }
                    continue;
                }
                let mut two = rows.chunks_exact_mut(2);
                for (i, pair) in (0..).step_by(2).zip(&mut two) {
                    let [first, second] = pair else { continue };
                    let mut factors = [inverse; 2];
                    for k in 0..F {
                        factors[0][k] = factors[0][k] * pivot_rows[k].fields[b][i];
                        factors[1][k] = factors[1][k] * pivot_rows[k].fields[b][i + 1];
                    }
                    FrontalRow::reduce_two([first, second], nodes, pivot_rows, factors, F * b + i + 1);
                }
                for row in two.into_remainder() {
                    let mut factors = inverse;
                    for k in 0..F {
                        factors[k] = factors[k] * pivot_rows[k].fields[b][F - 1];
                    }
                    row.reduce::<false, F>(nodes, pivot_rows, factors, F * b + F - 1);
                }
            }
            self.path.reduce_by_node(nodes, pivot_rows, &inverse, a);
            for k in 0..F {
                own[k].fields[a][k] = inverse[k];
            }
        }
        pivots
    }

    #[inline(always)]
    fn eliminate_one<const BORDER: bool>(
        &mut self,
        nodes: impl Nodes,
        k: usize,
        symmetric: bool,
        pivots: &mut Pivots<T>,
    ) {
        let (done, rest) = self.rows.as_flattened_mut()[..F * nodes.count()].split_at_mut(k + 1);
        let pivot_row = &mut done[k];
        let inverse = pivots.invert(pivot_row.column(k));
        for (i, row) in (k + 1..).zip(rest) {
            let (entry, from) = if symmetric { (pivot_row.column(i), i) } else { (row.column(k), k + 1) };
            row.reduce::<BORDER, 1>(nodes, [pivot_row], [entry * inverse], from);
        }
        for row in [BORDER.then_some(&mut self.border), Some(&mut self.path)].into_iter().flatten() {
            row.reduce::<BORDER, 1>(nodes, [pivot_row], [row.column(k) * inverse], k + 1);
        }
        pivot_row.fields.as_flattened_mut()[k] = inverse;
    }

    #[inline(always)]
    fn eliminate_two<const BORDER: bool>(
        &mut self,
        nodes: impl Nodes,
        k: usize,
        symmetric: bool,
        pivots: &mut Pivots<T>,
    ) {
        let (done, rest) = self.rows.as_flattened_mut()[..F * nodes.count()].split_at_mut(k + 2);
        let (first, second) = done.split_at_mut(k + 1);
        let (first, second) = (&mut first[k], &mut second[0]);
        let inverse = pivots.invert(first.column(k));
        let coupling = first.column(k + 1);
        let entry = if symmetric { coupling } else { second.column(k) };
        second.reduce::<BORDER, 1>(nodes, [first], [entry * inverse], k + 1);
        let next = pivots.invert(second.column(k + 1));
        let factors = |row: &FrontalRow<T, F>| {
            let factor = row.column(k) * inverse;
            [factor, (row.column(k + 1) - coupling * factor) * next]
        };
        for (i, row) in (k + 2..).zip(rest) {
            let (factors, from) = if symmetric {
                ([first.column(i) * inverse, second.column(i) * next], i)
            } else {
                (factors(row), k + 2)
            };
            row.reduce::<BORDER, 2>(nodes, [first, second], factors, from);
        }
        for row in [BORDER.then_some(&mut self.border), Some(&mut self.path)].into_iter().flatten() {
            row.reduce::<BORDER, 2>(nodes, [first, second], factors(row), k + 2);
        }
        first.fields.as_flattened_mut()[k] = inverse;
        second.fields.as_flattened_mut()[k + 1] = next;
    }
}
