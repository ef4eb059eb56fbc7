//! Numbers, one or several side by side, so that one text of a law serves a single point and a whole element.

use std::ops::{Add, Div, Mul, Neg, Sub};

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

/// L numbers side by side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lanes<const L: usize>(pub [f64; L]);

macro_rules! lanewise {
    ($trait:ident, $method:ident, $op:tt) => {
        impl<const L: usize> $trait for Lanes<L> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(std::array::from_fn(|l| self.0[l] $op other.0[l]))
            }
        }
        impl<const L: usize> $trait<f64> for Lanes<L> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: f64) -> Self {
                Self(std::array::from_fn(|l| self.0[l] $op other))
            }
        }
    };
}
lanewise!(Add, add, +);
lanewise!(Sub, sub, -);
lanewise!(Mul, mul, *);
lanewise!(Div, div, /);

impl<const L: usize> Neg for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(std::array::from_fn(|l| -self.0[l]))
    }
}

impl<const L: usize> Real for Lanes<L> {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self([value; L])
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let both: [(f64, f64); L] = std::array::from_fn(|l| self.0[l].sin_cos());
        (Self(std::array::from_fn(|l| both[l].0)), Self(std::array::from_fn(|l| both[l].1)))
    }
    #[inline(always)]
    fn choose(self, positive: Self, other: Self) -> Self {
        Self(std::array::from_fn(|l| if self.0[l] > 0.0 { positive.0[l] } else { other.0[l] }))
    }
}
