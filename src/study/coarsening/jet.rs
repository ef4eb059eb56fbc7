//! Numbers that depend on three coordinates, with their first and second derivatives: sums, products and quotients.

#![allow(clippy::suspicious_arithmetic_impl)] // the derivatives of products and quotients are sums

use super::place::TipResponse;
use std::ops::{Add, Div, Mul, Sub};

/// A value with its derivatives by three coordinates.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Jet {
    pub value: f64,
    pub gradient: [f64; 3],
    pub hessian: [[f64; 3]; 3],
}

impl Jet {
    /// One of the coordinates themselves.
    pub fn coordinate(value: f64, index: usize) -> Self {
        let mut jet = Self { value, ..Self::default() };
        jet.gradient[index] = 1.0;
        jet
    }

    /// A number that depends on nothing.
    pub fn constant(value: f64) -> Self {
        Self { value, ..Self::default() }
    }

    /// It where its first coordinate is a number that depends on all three.
    pub fn at_first(self, first: Self) -> Self {
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
    pub fn through(self, [value, slope, bend]: [f64; 3]) -> Self {
        let hessian = |i: usize, j: usize| slope * self.hessian[i][j] + bend * self.gradient[i] * self.gradient[j];
        Self {
            value,
            gradient: self.gradient.map(|x| slope * x),
            hessian: std::array::from_fn(|i| std::array::from_fn(|j| hessian(i, j))),
        }
    }

    /// Its third power.
    pub fn cube(self) -> Self {
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
mod tests {
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
