//! Needleman's polynomial law: s = 27/4 t (1 - t)² up to t = 1, beyond which nothing pulls; ∫ s from t on = 27/4 ((1-t)³/3 - (1-t)⁴/4).
//!
//! Source: A. Needleman, A continuum model for void nucleation by inclusion debonding, J. Appl. Mech. 54 (1987) 525, for one mode. It is as
//! smooth as the exponential law but at its end, where its slope has a corner, and has a range of its own, outside of which it is zero.

use super::at::At;

pub(super) const NAME: &str = "polynomial";
pub(super) const CORNERS: f64 = 2.0;

/// The largest of t (1 - t)², at t = 1/3, is one over it.
const TOP: f64 = 27.0 / 4.0;

#[inline]
pub(super) fn at(t: f64) -> At {
    let left = (1.0 - t).max(0.0);
    let square = left * left;
    [TOP * left * square * (1.0 / 3.0 - 0.25 * left), TOP * t * square, TOP * left * (1.0 - 3.0 * t)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn work_strength_and_range_are_those_of_the_source() {
        assert_relative_eq!(at(0.0)[0], 9.0 / 16.0, max_relative = 1e-15);
        assert_relative_eq!(at(1.0 / 3.0)[1], 1.0, max_relative = 1e-15);
        assert!(at(1.0 / 3.0)[2].abs() < 1e-15);
        assert_eq!(at(1.0), [0.0; 3]);
        assert_eq!(at(7.0), [0.0; 3]);
        assert!(at(-0.1)[1] < 0.0);
    }
}
