//! Splines along one coordinate of a table: the coefficients of B-splines from numbers at nodes, and the B-splines themselves.
//!
//! With values alone, of degree 5 and four times continuously differentiable, their third and fourth derivatives and the fifth continuous at
//! the three outermost nodes ("not a knot"); of fewer than six nodes one polynomial. With values and slopes, of degree 5 and three times
//! continuously differentiable, four times at the outermost nodes but the ends. De Boor, A Practical Guide to Splines, chapters IX to XIII.

use nalgebra::DMatrix;

/// Degree, where there are nodes enough.
const DEGREE: usize = 5;
/// B-splines that are not zero at a place, at most.
pub(super) const SUPPORT: usize = DEGREE + 1;

/// Splines through numbers at the nodes of one coordinate.
#[derive(Clone, Debug)]
pub(super) struct SplineAxis {
    degree: usize,
    knots: Vec<f64>,
    /// From the numbers at the nodes to coefficients.
    inverse: DMatrix<f64>,
}

/// The B-splines at a place: the first that is not zero, and of each value, first and second derivative.
#[derive(Clone, Copy, Debug)]
pub(super) struct Basis {
    pub first: usize,
    pub count: usize,
    pub derivatives: [[f64; SUPPORT]; 3],
}

impl SplineAxis {
    /// Through values at ascending nodes, one at least. None where they do not ascend.
    pub fn of_values(nodes: &[f64]) -> Option<Self> {
        let degree = DEGREE.min(nodes.len().checked_sub(1)?);
        let inner = if nodes.len() > SUPPORT { &nodes[3..nodes.len() - 3] } else { &[] };
        Self::of(nodes, degree, inner.to_vec(), 1)
    }

    /// Through values and slopes at ascending nodes, three at least; the numbers are value, slope, value, slope, …
    pub fn of_slopes(nodes: &[f64]) -> Option<Self> {
        let last = nodes.len().checked_sub(1).filter(|&last| last >= 2)?;
        let twice = |k: usize| if last == 2 { 0 } else { 2 - usize::from(k == 1) - usize::from(k == last - 1) };
        let inner = (1..last).flat_map(|k| std::iter::repeat_n(nodes[k], twice(k))).collect();
        Self::of(nodes, DEGREE, inner, 2)
    }

    /// Of a degree, with these inner knots, through so many derivatives at each node.
    fn of(nodes: &[f64], degree: usize, inner: Vec<f64>, derivatives: usize) -> Option<Self> {
        if !nodes.windows(2).all(|pair| pair[0] < pair[1]) {
            return None;
        }
        let ends = |place: f64| std::iter::repeat_n(place, degree + 1);
        let knots = ends(nodes[0]).chain(inner).chain(ends(nodes[nodes.len() - 1])).collect();
        let count = derivatives * nodes.len();
        let mut axis = Self { degree, knots, inverse: DMatrix::identity(count, count) };
        let mut matrix = DMatrix::zeros(count, count);
        for (k, &node) in nodes.iter().enumerate() {
            let basis = axis.basis(node);
            for derivative in 0..derivatives {
                for i in 0..basis.count {
                    matrix[(derivatives * k + derivative, basis.first + i)] = basis.derivatives[derivative][i];
                }
            }
        }
        axis.inverse = matrix.try_inverse()?;
        Some(axis)
    }

    /// How many coefficients there are.
    pub fn len(&self) -> usize {
        self.inverse.nrows()
    }

    /// The coefficients of the spline through these numbers.
    pub fn coefficients(&self, numbers: &[f64]) -> Vec<f64> {
        (&self.inverse * nalgebra::DVector::from_column_slice(numbers)).as_slice().to_vec()
    }

    /// The B-splines at a place; beyond the ends, their expansions of second order there.
    pub fn basis(&self, place: f64) -> Basis {
        let inside = place.clamp(self.knots[0], self.knots[self.knots.len() - 1]);
        let away = place - inside;
        let mut basis = self.basis_within(inside);
        if away != 0.0 {
            let [values, slopes, bends] = &mut basis.derivatives;
            for i in 0..SUPPORT {
                values[i] += away * (slopes[i] + 0.5 * away * bends[i]);
                slopes[i] += away * bends[i];
            }
        }
        basis
    }

    /// The B-splines at a place between the ends.
    fn basis_within(&self, place: f64) -> Basis {
        let (degree, knots) = (self.degree, &self.knots);
        let last = knots.len() - degree - 2;
        let piece = (knots.partition_point(|&knot| knot <= place).saturating_sub(1)).clamp(degree, last);
        // values of the degrees up to this one: those of degree q stand from piece - q on
        let mut values = [[0.0; SUPPORT]; SUPPORT];
        values[0][0] = 1.0;
        for q in 1..=degree {
            for i in 0..=q {
                let first = piece + i - q;
                let rising = if i > 0 { (place - knots[first]) / (knots[first + q] - knots[first]) } else { 0.0 };
                let falling = if i < q {
                    (knots[first + q + 1] - place) / (knots[first + q + 1] - knots[first + 1])
                } else {
                    0.0
                };
                values[q][i] = if i > 0 { rising * values[q - 1][i - 1] } else { 0.0 }
                    + if i < q { falling * values[q - 1][i] } else { 0.0 };
            }
        }
        let differentiated = |lower: &[f64; SUPPORT], q: usize| {
            let mut slopes = [0.0; SUPPORT];
            for i in 0..=q {
                let first = piece + i - q;
                let before = if i > 0 { lower[i - 1] / (knots[first + q] - knots[first]) } else { 0.0 };
                let behind = if i < q { lower[i] / (knots[first + q + 1] - knots[first + 1]) } else { 0.0 };
                slopes[i] = q as f64 * (before - behind);
            }
            slopes
        };
        let zero = [0.0; SUPPORT];
        let first = if degree > 0 { differentiated(&values[degree - 1], degree) } else { zero };
        let second =
            if degree > 1 { differentiated(&differentiated(&values[degree - 2], degree - 1), degree) } else { zero };
        Basis { first: piece - degree, count: degree + 1, derivatives: [values[degree], first, second] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;

    fn at(axis: &SplineAxis, coefficients: &[f64], place: f64) -> [f64; 3] {
        let basis = axis.basis(place);
        std::array::from_fn(|d| (0..basis.count).map(|i| basis.derivatives[d][i] * coefficients[basis.first + i]).sum())
    }

    /// A polynomial of degree five is its own spline, with its derivatives, on even and uneven nodes and between them.
    #[test]
    fn polynomials_are_reproduced() {
        let f = |x: f64| [x.powi(5) - 2.0 * x * x + 1.0, 5.0 * x.powi(4) - 4.0 * x, 20.0 * x.powi(3) - 4.0];
        for nodes in [vec![-1.0, -0.7, -0.2, 0.1, 0.5, 0.8, 0.9, 1.3], (0..6).map(f64::from).collect()] {
            let values = SplineAxis::of_values(&nodes).unwrap();
            let slopes = SplineAxis::of_slopes(&nodes).unwrap();
            let by_value = values.coefficients(&nodes.iter().map(|&x| f(x)[0]).collect::<Vec<_>>());
            let by_slope = slopes.coefficients(&nodes.iter().flat_map(|&x| [f(x)[0], f(x)[1]]).collect::<Vec<_>>());
            assert_eq!(by_slope.len(), slopes.len());
            for k in 0..21 {
                let place = nodes[0] + (nodes[nodes.len() - 1] - nodes[0]) * f64::from(k) / 20.0;
                for (one, other) in at(&values, &by_value, place).iter().zip(f(place)) {
                    assert_abs_diff_eq!(*one, other, epsilon = 1e-7);
                }
                for (one, other) in at(&slopes, &by_slope, place).iter().zip(f(place)) {
                    assert_abs_diff_eq!(*one, other, epsilon = 1e-7);
                }
            }
        }
    }

    /// One node is a constant, three a parabola; nodes that do not ascend are none.
    #[test]
    fn few_nodes_are_a_polynomial() {
        let one = SplineAxis::of_values(&[2.0]).unwrap();
        assert_eq!(at(&one, &one.coefficients(&[7.0]), 5.0), [7.0, 0.0, 0.0]);
        let three = SplineAxis::of_values(&[0.0, 1.0, 2.0]).unwrap();
        let found = at(&three, &three.coefficients(&[0.0, 1.0, 4.0]), 1.5);
        for (one, other) in found.iter().zip([2.25, 3.0, 2.0]) {
            assert_abs_diff_eq!(*one, other, epsilon = 1e-12);
        }
        assert!(SplineAxis::of_values(&[0.0, 0.0]).is_none());
        assert!(SplineAxis::of_slopes(&[0.0, 1.0]).is_none());
    }
}
