//! Splines along one coordinate of a table: the coefficients of B-splines from numbers at nodes, and the B-splines themselves.
//!
//! With values alone, of degree 5 and four times continuously differentiable, their third and fourth derivatives and the fifth continuous at
//! the three outermost nodes ("not a knot"); of fewer than six nodes one polynomial. With values and slopes, of degree 5 and three times
//! continuously differentiable, four times at the outermost nodes but the ends. De Boor, A Practical Guide to Splines, chapters IX to XIII.
#![allow(clippy::suspicious_arithmetic_impl)] // the derivatives of products and quotients are sums

use super::options::TipResponse;
use nalgebra::DMatrix;
use std::ops::{Add, Div, Mul, Sub};

/// Degree, where there are nodes enough.
const DEGREE: usize = 5;
/// B-splines that are not zero at a place, at most.
pub(super) const SUPPORT: usize = DEGREE + 1;

/// Splines through numbers at the nodes of one coordinate.
#[derive(Clone, Debug)]
pub(super) struct SplineAxis {
    degree: usize,
    knots: Vec<f64>,
    /// Between knots that differ, ascending
    pieces: Vec<SplinePiece>,
    /// From the numbers at the nodes to coefficients.
    inverse: DMatrix<f64>,
}

/// The B-splines that are not zero between two knots, as polynomials of (place - middle)/length.
#[derive(Clone, Copy, Debug)]
pub(super) struct SplinePiece {
    /// The first of them
    pub first: usize,
    ends: [f64; 2],
    middle: f64,
    per_length: f64,
    /// By power, then B-spline
    powers: [[f64; SUPPORT]; SUPPORT],
}

/// The B-splines at a place: the first that is not zero, and of each value, first and second derivative.
#[derive(Clone, Copy, Debug)]
pub(super) struct Basis {
    pub first: usize,
    pub count: usize,
    pub derivatives: [[f64; SUPPORT]; 3],
}

/// A spline on a piece; beyond that, its expansion of second order at the end.
#[derive(Clone, Copy, Debug)]
pub(super) struct PiecePolynomial {
    ends: [f64; 2],
    middle: f64,
    per_length: f64,
    powers: [f64; SUPPORT],
}

impl PiecePolynomial {
    /// Whether a place is on the piece.
    pub(crate) fn holds(&self, place: f64) -> bool {
        (self.ends[0]..=self.ends[1]).contains(&place)
    }

    /// Value and slope.
    pub(crate) fn at(&self, place: f64) -> (f64, f64) {
        let inside = place.clamp(self.ends[0], self.ends[1]);
        let (t, away) = ((inside - self.middle) * self.per_length, (place - inside) * self.per_length);
        let [mut value, mut slope, mut half_bend] = [0.0; 3];
        for power in self.powers.iter().rev() {
            half_bend = half_bend * t + slope;
            slope = slope * t + value;
            value = value * t + power;
        }
        (value + away * (slope + away * half_bend), (slope + 2.0 * away * half_bend) * self.per_length)
    }
}

impl SplinePiece {
    /// Of B-splines on knots of which the piece is the one behind the knot of this index.
    fn new(knots: &[f64], degree: usize, index: usize) -> Self {
        let ends = [knots[index], knots[index + 1]];
        let (middle, length) = (0.5 * (ends[0] + ends[1]), ends[1] - ends[0]);
        let mut powers = [[0.0; SUPPORT]; SUPPORT];
        let mut scale = 1.0;
        for (order, power) in powers.iter_mut().enumerate().take(degree + 1) {
            *power = derivatives(knots, degree, index, middle, order).map(|derivative| scale * derivative);
            scale *= length / (order + 1) as f64;
        }
        let per_length = if length > 0.0 { 1.0 / length } else { 0.0 };
        Self { first: index - degree, ends, middle, per_length, powers }
    }

    /// The B-splines at a place between its ends.
    fn basis(&self, place: f64, degree: usize) -> Basis {
        let t = (place - self.middle) * self.per_length;
        let [mut values, mut slopes, mut bends] = [[0.0; SUPPORT]; 3];
        for power in self.powers[..=degree].iter().rev() {
            for i in 0..SUPPORT {
                bends[i] = bends[i] * t + slopes[i];
                slopes[i] = slopes[i] * t + values[i];
                values[i] = values[i] * t + power[i];
            }
        }
        for i in 0..SUPPORT {
            slopes[i] *= self.per_length;
            bends[i] *= 2.0 * self.per_length * self.per_length;
        }
        Basis { first: self.first, count: degree + 1, derivatives: [values, slopes, bends] }
    }

    /// The spline with these coefficients of the B-splines that are not zero here.
    pub(crate) fn polynomial(&self, coefficients: &[f64; SUPPORT]) -> PiecePolynomial {
        let power = |own: &[f64; SUPPORT]| own.iter().zip(coefficients).map(|(a, b)| a * b).sum();
        let Self { ends, middle, per_length, .. } = *self;
        PiecePolynomial { ends, middle, per_length, powers: std::array::from_fn(|k| power(&self.powers[k])) }
    }
}

impl SplineAxis {
    /// Through values at ascending nodes, one at least. None where they do not ascend.
    pub(crate) fn of_values(nodes: &[f64]) -> Option<Self> {
        let degree = DEGREE.min(nodes.len().checked_sub(1)?);
        let inner = if nodes.len() > SUPPORT { &nodes[3..nodes.len() - 3] } else { &[] };
        Self::of(nodes, degree, inner.to_vec(), 1)
    }

    /// Through values and slopes at ascending nodes, three at least; the numbers are value, slope, value, slope, …
    pub(crate) fn of_slopes(nodes: &[f64]) -> Option<Self> {
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
        let knots: Vec<f64> = ends(nodes[0]).chain(inner).chain(ends(nodes[nodes.len() - 1])).collect();
        let count = derivatives * nodes.len();
        // one node is a constant, which no knots hold between them
        let own = |index: &usize| nodes.len() == 1 || knots[*index] < knots[*index + 1];
        let pieces = (degree..=knots.len() - degree - 2).filter(own).map(|k| SplinePiece::new(&knots, degree, k));
        let pieces = pieces.collect();
        let mut axis = Self { degree, knots, pieces, inverse: DMatrix::identity(count, count) };
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
    pub(crate) fn len(&self) -> usize {
        self.inverse.nrows()
    }

    /// The coefficients of the spline through these numbers.
    pub(crate) fn coefficients(&self, numbers: &[f64]) -> Vec<f64> {
        (&self.inverse * nalgebra::DVector::from_column_slice(numbers)).as_slice().to_vec()
    }

    /// The piece that a place is on; the outermost one beyond the ends.
    pub(crate) fn piece(&self, place: f64) -> &SplinePiece {
        let behind = self.pieces.partition_point(|piece| piece.ends[0] <= place);
        &self.pieces[behind.saturating_sub(1)]
    }

    /// The B-splines at a place; beyond the ends, their expansions of second order there.
    pub(crate) fn basis(&self, place: f64) -> Basis {
        let inside = place.clamp(self.knots[0], self.knots[self.knots.len() - 1]);
        let away = place - inside;
        let mut basis = self.piece(inside).basis(inside, self.degree);
        if away != 0.0 {
            let [values, slopes, bends] = &mut basis.derivatives;
            for i in 0..SUPPORT {
                values[i] += away * (slopes[i] + 0.5 * away * bends[i]);
                slopes[i] += away * bends[i];
            }
        }
        basis
    }
}

/// The derivative of an order of the B-splines of a degree at a place behind the knot of an index.
fn derivatives(knots: &[f64], degree: usize, index: usize, place: f64, order: usize) -> [f64; SUPPORT] {
    // those of degree q stand from index - q on; the last degrees are those that are differentiated
    let mut values = [0.0; SUPPORT];
    values[0] = 1.0;
    let is_derived = |q: usize| q + order > degree;
    for q in 1..=degree {
        let mut next = [0.0; SUPPORT];
        for i in 0..=q {
            let first = index + i - q;
            if i > 0 {
                let rising = if is_derived(q) { q as f64 } else { place - knots[first] };
                next[i] += rising / (knots[first + q] - knots[first]) * values[i - 1];
            }
            if i < q {
                let last = knots[first + q + 1];
                let falling = if is_derived(q) { -(q as f64) } else { last - place };
                next[i] += falling / (last - knots[first + 1]) * values[i];
            }
        }
        values = next;
    }
    values
}

// -- Numbers that depend on three coordinates, with their first and second derivatives: sums, products and quotients --

/// A value with its derivatives by three coordinates.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Jet {
    pub value: f64,
    pub gradient: [f64; 3],
    pub hessian: [[f64; 3]; 3],
}

impl Jet {
    /// One of the coordinates themselves.
    pub(crate) fn coordinate(value: f64, index: usize) -> Self {
        let mut jet = Self { value, ..Self::default() };
        jet.gradient[index] = 1.0;
        jet
    }

    /// A number that depends on nothing.
    pub(crate) fn constant(value: f64) -> Self {
        Self { value, ..Self::default() }
    }

    /// It where its first coordinate is a number that depends on all three.
    pub(crate) fn at_first(self, first: Self) -> Self {
        let own = |i: usize| if i == 0 { 0.0 } else { 1.0 };
        let [along, p] = [self.gradient[0], 1.0].map(|x| first.gradient.map(|g| x * g));
        let hessian = |i: usize, j: usize| {
            self.hessian[0][0] * p[i] * p[j]
                + self.hessian[0][j] * p[i] * own(j)
                + self.hessian[i][0] * p[j] * own(i)
                + self.hessian[i][j] * own(i) * own(j)
                + self.gradient[0] * first.hessian[i][j]
        };
        Self {
            value: self.value,
            gradient: std::array::from_fn(|i| along[i] + self.gradient[i] * own(i)),
            hessian: std::array::from_fn(|i| std::array::from_fn(|j| hessian(i, j))),
        }
    }

    /// f of it, from f, f' and f'' at its value.
    pub(crate) fn through(self, [value, slope, bend]: [f64; 3]) -> Self {
        let hessian = |i: usize, j: usize| slope * self.hessian[i][j] + bend * self.gradient[i] * self.gradient[j];
        Self {
            value,
            gradient: self.gradient.map(|x| slope * x),
            hessian: std::array::from_fn(|i| std::array::from_fn(|j| hessian(i, j))),
        }
    }

    /// Its third power.
    pub(crate) fn cube(self) -> Self {
        let x = self.value;
        self.through([x * x * x, 3.0 * x * x, 6.0 * x])
    }

    fn combined(self, other: Self, of: impl Fn(f64, f64) -> f64) -> Self {
        Self {
            value: of(self.value, other.value),
            gradient: std::array::from_fn(|i| of(self.gradient[i], other.gradient[i])),
            hessian: std::array::from_fn(|i| std::array::from_fn(|j| of(self.hessian[i][j], other.hessian[i][j]))),
        }
    }
}

impl From<TipResponse> for Jet {
    fn from(TipResponse { energy, force, stiffness }: TipResponse) -> Self {
        Self { value: energy, gradient: force, hessian: stiffness }
    }
}

impl From<Jet> for TipResponse {
    fn from(Jet { value, gradient, hessian }: Jet) -> Self {
        Self { energy: value, force: gradient, stiffness: hessian }
    }
}

impl Add for Jet {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.combined(other, |a, b| a + b)
    }
}

impl Sub for Jet {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.combined(other, |a, b| a - b)
    }
}

impl Mul for Jet {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (a, b) = (&self, &other);
        let hessian = |i: usize, j: usize| {
            a.hessian[i][j] * b.value
                + a.gradient[i] * b.gradient[j]
                + a.gradient[j] * b.gradient[i]
                + a.value * b.hessian[i][j]
        };
        Self {
            value: a.value * b.value,
            gradient: std::array::from_fn(|i| a.gradient[i] * b.value + a.value * b.gradient[i]),
            hessian: std::array::from_fn(|i| std::array::from_fn(|j| hessian(i, j))),
        }
    }
}

impl Mul<f64> for Jet {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        self.through([factor * self.value, factor, 0.0])
    }
}

impl Div for Jet {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let x = other.value;
        self * other.through([1.0 / x, -1.0 / (x * x), 2.0 / (x * x * x)])
    }
}

#[cfg(test)]
mod jet_tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Reference: x³ y/z by hand.
    #[test]
    fn derivatives_are_those_by_hand() {
        let [x, y, z] = [1.3, -0.7, 2.1];
        let [a, b, c] = [Jet::coordinate(x, 0), Jet::coordinate(y, 1), Jet::coordinate(z, 2)];
        let f = a.cube() * b / c;
        assert_relative_eq!(f.value, x * x * x * y / z, max_relative = 1e-14);
        let gradient = [3.0 * x * x * y / z, x * x * x / z, -x * x * x * y / (z * z)];
        let hessian = [
            [6.0 * x * y / z, 3.0 * x * x / z, -3.0 * x * x * y / (z * z)],
            [3.0 * x * x / z, 0.0, -x * x * x / (z * z)],
            [-3.0 * x * x * y / (z * z), -x * x * x / (z * z), 2.0 * x * x * x * y / (z * z * z)],
        ];
        for i in 0..3 {
            assert_relative_eq!(f.gradient[i], gradient[i], max_relative = 1e-14);
            (0..3).for_each(|j| {
                assert_relative_eq!(f.hessian[i][j], hessian[i][j], max_relative = 1e-13, epsilon = 1e-15)
            });
        }
        let g = (f - f * 0.5) + f;
        assert_relative_eq!(g.hessian[0][2], 1.5 * hessian[0][2], max_relative = 1e-13);
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
