//! Dugdale's law: one traction over the whole range.
//!
//! Source: D. S. Dugdale, Yielding of steel sheets containing slits (1960); D. Maugis (1992) for adhesion. It rises over a tenth of
//! its range and falls over a fifth, with rounded corners, so that elements of high order keep their order.

use super::at::At;
use super::ramp::{Corner, Lines};

pub(super) const NAME: &str = "dugdale";
pub(super) const CORNERS: f64 = 10.0;
pub(super) const KNOTS: &[f64] = &LAW.knots::<7>();

/// What the flanks take of the range; the corners at their ends are rounded over ± half of that.
const RISE: f64 = 0.1;
const FALL: f64 = 0.2;

const DOWN: f64 = RISE / FALL;
const LAW: Lines<3> = Lines {
    corners: [
        Corner { place: RISE, change: -1.0, half: 0.5 * RISE },
        Corner { place: 1.0 - FALL, change: -DOWN, half: 0.5 * FALL },
        Corner { place: 1.0, change: DOWN, half: 0.5 * FALL },
    ],
    factor: 1.0 / RISE,
};

#[inline]
pub(super) fn at(t: f64) -> At {
    LAW.at(t)
}

#[inline]
pub(super) fn primitive(t: f64) -> f64 {
    LAW.primitive(t)
}
