//! The trapezoidal law: the traction rises over 0.15 of its range, stays up to one half of it and falls over the rest.
//!
//! Source: V. Tvergaard, J. W. Hutchinson, The relation between crack growth resistance and fracture process parameters in elastic-plastic
//! solids, J. Mech. Phys. Solids 40 (1992) 1377, with λ1 = 0.15 and λ2 = 0.5. Its corners are rounded, so that elements of high order keep
//! their order; the flank is far less steep than Dugdale's, so it takes fewer elements.

use super::at::At;
use super::ramp::{Corner, Lines};

pub(super) const NAME: &str = "trapezoidal";
pub(super) const CORNERS: f64 = 5.0;
pub(super) const KNOTS: &[f64] = &LAW.knots::<7>();

/// λ1 and λ2
const UP: f64 = 0.15;
const LEVEL: f64 = 0.5;
/// Half of the width over which each of the three corners is rounded.
const ROUNDED: [f64; 3] = [0.5 * UP, 0.2, 0.25];

/// How much less steeply it falls than it rises.
const DOWN: f64 = UP / (1.0 - LEVEL);
const LAW: Lines<3> = Lines {
    corners: [
        Corner { place: UP, change: -1.0, half: ROUNDED[0] },
        Corner { place: LEVEL, change: -DOWN, half: ROUNDED[1] },
        Corner { place: 1.0, change: DOWN, half: ROUNDED[2] },
    ],
    factor: 1.0 / UP,
};

#[inline]
pub(super) fn at(t: f64) -> At {
    LAW.at(t)
}

#[inline]
pub(super) fn primitive(t: f64) -> f64 {
    LAW.primitive(t)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Level between the first two corners, half of that in the middle of the flank, nothing behind the last corner; its work is about the
    /// area of the trapezoid, (1 + λ2 - λ1)/2.
    #[test]
    fn it_is_the_trapezoid_of_the_source() {
        for t in [0.23, 0.26, 0.29] {
            assert_relative_eq!(at(t)[1], 1.0, max_relative = 1e-14);
        }
        assert_relative_eq!(at(0.725)[1], 0.55, max_relative = 1e-14);
        assert_eq!(at(1.26), [0.0; 3]);
        assert_relative_eq!(at(0.0)[0], 0.5 * (1.0 + LEVEL - UP), max_relative = 0.02);
    }
}
