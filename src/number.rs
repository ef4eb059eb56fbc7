//! Numbers, one or four side by side, so that one text of a law and of an element serves one element and four.

use std::ops::{Add, Div, Mul, Neg, Sub};
use wide::f64x4;

/// What a law may do with its arguments.
pub trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Mul<f64, Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
{
    /// The same number everywhere.
    fn splat(value: f64) -> Self;
    /// Sine and cosine.
    fn sin_cos(self) -> (Self, Self);
    /// `positive` where the number is above zero, else `other`.
    fn choose(self, positive: Self, other: Self) -> Self;
    /// One over it.
    #[inline(always)]
    fn recip(self) -> Self {
        Self::splat(1.0) / self
    }
}

impl Real for f64 {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        f64::sin_cos(self)
    }
    #[inline(always)]
    fn choose(self, positive: Self, other: Self) -> Self {
        if self > 0.0 { positive } else { other }
    }
}

/// Four numbers side by side.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(32))]
pub struct Four(pub [f64; 4]);

macro_rules! side_by_side {
    ($trait:ident, $method:ident, $assign:tt) => {
        impl $trait for Four {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let mut out = self.0;
                for l in 0..4 {
                    out[l] $assign other.0[l];
                }
                Self(out)
            }
        }
        impl $trait<f64> for Four {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: f64) -> Self {
                let mut out = self.0;
                for l in 0..4 {
                    out[l] $assign other;
                }
                Self(out)
            }
        }
    };
}
side_by_side!(Add, add, +=);
side_by_side!(Sub, sub, -=);
side_by_side!(Mul, mul, *=);
side_by_side!(Div, div, /=);

impl Neg for Four {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self * -1.0
    }
}

impl Real for Four {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self([value; 4])
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = f64x4::new(self.0).sin_cos();
        (Self(sin.to_array()), Self(cos.to_array()))
    }
    #[inline(always)]
    fn choose(self, positive: Self, other: Self) -> Self {
        let mut out = other.0;
        for l in 0..4 {
            out[l] = if self.0[l] > 0.0 { positive.0[l] } else { out[l] };
        }
        Self(out)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Side by side as one by one: to the last digits, at every angle that a beam may have; NaN stays NaN.
    #[test]
    fn sines_side_by_side() {
        for k in -4000..4000 {
            let angle = 0.0037 * f64::from(k) + 1e-9;
            let angles: [f64; 4] = std::array::from_fn(|l| angle * (1.0 + l as f64));
            let (sin, cos) = Four(angles).sin_cos();
            for l in 0..4 {
                let (s, c) = angles[l].sin_cos();
                assert!((sin.0[l] - s).abs() <= 2e-16 && (cos.0[l] - c).abs() <= 2e-16, "{}", angles[l]);
            }
        }
        let (sin, cos) = Four([f64::NAN, 0.0, 0.0, 0.0]).sin_cos();
        assert!(sin.0[0].is_nan() && cos.0[0].is_nan() && (sin.0[1], cos.0[1]) == (0.0, 1.0));
    }
}
