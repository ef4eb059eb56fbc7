//! Numbers, one or four side by side, so that one text of a law and of an element serves one element and four.

pub mod gauss;
pub mod root;

use std::f64::consts::FRAC_2_PI;
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
    fn select(self, positive: Self, other: Self) -> Self;
    /// Whether it is above zero, everywhere.
    fn is_positive(self) -> bool;
    /// Several functions of each number, computed one by one.
    fn each<const K: usize>(self, function: impl Fn(f64) -> [f64; K]) -> [Self; K];
    /// Several functions of each pair of numbers, computed one by one.
    fn each_pair<const K: usize>(self, other: Self, function: impl Fn(f64, f64) -> [f64; K]) -> [Self; K];
    /// Several functions of several numbers, computed one by one.
    fn each_of<const N: usize, const K: usize>(of: [Self; N], function: impl Fn([f64; N]) -> [f64; K]) -> [Self; K];
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
    fn select(self, positive: Self, other: Self) -> Self {
        if self > 0.0 { positive } else { other }
    }
    #[inline(always)]
    fn is_positive(self) -> bool {
        self > 0.0
    }
    #[inline(always)]
    fn each<const K: usize>(self, function: impl Fn(f64) -> [f64; K]) -> [Self; K] {
        function(self)
    }
    #[inline(always)]
    fn each_pair<const K: usize>(self, other: Self, function: impl Fn(f64, f64) -> [f64; K]) -> [Self; K] {
        function(self, other)
    }
    #[inline(always)]
    fn each_of<const N: usize, const K: usize>(of: [Self; N], function: impl Fn([f64; N]) -> [f64; K]) -> [Self; K] {
        function(of)
    }
}

/// Below this angle four sines are computed side by side.
const FAR: f64 = 1e5;
/// A number to which adding rounds to a whole number.
const ROUNDING: f64 = 6_755_399_441_055_744.0;
/// π/2 in three parts, the first two of 33 bits, so that their multiples are exact.
const RIGHT_ANGLE: [f64; 3] = [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_795_950_6e-21];
/// (sin x - x)/x³ and (cos x - 1 + x²/2)/x⁴ in powers of x², for |x| up to π/4; the coefficients are those of FreeBSD's libm.
const SINE: [f64; 6] = [
    -1.666_666_666_666_663_2e-1,
    8.333_333_333_322_49e-3,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_006_8e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];
const COSINE: [f64; 6] = [
    4.166_666_666_666_66e-2,
    -1.388_888_888_887_411e-3,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

#[inline(always)]
fn polynomial(coefficients: &[f64; 6], z: f64) -> f64 {
    let mut sum = coefficients[5];
    for k in (0..5).rev() {
        sum = sum * z + coefficients[k];
    }
    sum
}

/// Four numbers side by side.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(32))]
pub struct F64x4(pub [f64; 4]);

macro_rules! side_by_side {
    ($trait:ident, $method:ident, $assign:tt) => {
        impl $trait for F64x4 {
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
        impl $trait<f64> for F64x4 {
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

impl Neg for F64x4 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self * -1.0
    }
}

impl Real for F64x4 {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self([value; 4])
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        if !self.0.iter().all(|angle| angle.abs() < FAR) {
            return (Self(self.0.map(f64::sin)), Self(self.0.map(f64::cos)));
        }
        let (mut sin, mut cos) = ([0.0; 4], [0.0; 4]);
        for l in 0..4 {
            // the nearest multiple of a right angle, as the last bits of a large number
            let turns = self.0[l] * FRAC_2_PI + ROUNDING;
            let quarter = turns.to_bits();
            let turns = turns - ROUNDING;
            let x = ((self.0[l] - turns * RIGHT_ANGLE[0]) - turns * RIGHT_ANGLE[1]) - turns * RIGHT_ANGLE[2];
            let z = x * x;
            let s = x + z * x * polynomial(&SINE, z);
            let half = 0.5 * z;
            let one = 1.0 - half;
            let c = one + (((1.0 - one) - half) + z * z * polynomial(&COSINE, z));
            let (a, b) = if quarter & 1 == 0 { (s, c) } else { (c, s) };
            sin[l] = f64::from_bits(a.to_bits() ^ ((quarter & 2) << 62));
            cos[l] = f64::from_bits(b.to_bits() ^ ((quarter.wrapping_add(1) & 2) << 62));
        }
        (Self(sin), Self(cos))
    }
    #[inline(always)]
    fn select(self, positive: Self, other: Self) -> Self {
        let mut out = other.0;
        for l in 0..4 {
            out[l] = if self.0[l] > 0.0 { positive.0[l] } else { out[l] };
        }
        Self(out)
    }
    #[inline(always)]
    fn is_positive(self) -> bool {
        self.0.iter().all(|&number| number > 0.0)
    }
    #[inline(always)]
    fn each<const K: usize>(self, function: impl Fn(f64) -> [f64; K]) -> [Self; K] {
        let mut out = [Self([0.0; 4]); K];
        for l in 0..4 {
            let values = function(self.0[l]);
            for k in 0..K {
                out[k].0[l] = values[k];
            }
        }
        out
    }
    #[inline(always)]
    fn each_pair<const K: usize>(self, other: Self, function: impl Fn(f64, f64) -> [f64; K]) -> [Self; K] {
        let mut out = [Self([0.0; 4]); K];
        for l in 0..4 {
            let values = function(self.0[l], other.0[l]);
            for k in 0..K {
                out[k].0[l] = values[k];
            }
        }
        out
    }
    #[inline(always)]
    fn each_of<const N: usize, const K: usize>(of: [Self; N], function: impl Fn([f64; N]) -> [f64; K]) -> [Self; K] {
        let each: [[f64; K]; 4] = std::array::from_fn(|l| function(of.map(|number| number.0[l])));
        std::array::from_fn(|k| Self(each.map(|values| values[k])))
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
            let (sin, cos) = F64x4(angles).sin_cos();
            for l in 0..4 {
                let (s, c) = angles[l].sin_cos();
                assert!((sin.0[l] - s).abs() <= 2e-16 && (cos.0[l] - c).abs() <= 2e-16, "{}", angles[l]);
            }
        }
        let (sin, cos) = F64x4([f64::NAN, 0.0, 0.0, 0.0]).sin_cos();
        assert!(sin.0[0].is_nan() && cos.0[0].is_nan() && (sin.0[1], cos.0[1]) == (0.0, 1.0));
    }
}
