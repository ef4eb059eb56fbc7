//! The bilinear law: the traction rises over a tenth of its range and falls over the rest.
//!
//! Source: P. P. Camanho, C. G. Dávila, NASA/TM-2002-211737 (2002), for one mode and without damage: it closes as it has opened.
//! Its corners are rounded, so that elements of high order keep their order.

use super::at::At;
use super::ramp::{Corner, Lines};

pub(super) const NAME: &str = "bilinear";
pub(super) const CORNERS: f64 = 5.0;
pub(super) const KNOTS: &[f64] = &LAW.knots::<5>();

/// Where the top is, as a share of the range, which is rounded over ± half of that.
const RISE: f64 = 0.1;
/// The blunt corner at its end is rounded over ± this share.
const TAIL: f64 = 0.3;
/// How much less steeply it falls than it rises.
const FALL: f64 = RISE / (1.0 - RISE);

const LAW: Lines<2> = lines(1.0 / lines(1.0).top());

#[inline]
pub(super) fn at(t: f64) -> At {
    LAW.at(t)
}

#[inline]
pub(super) fn primitive(t: f64) -> f64 {
    LAW.primitive(t)
}

const fn lines(factor: f64) -> Lines<2> {
    let top = Corner { place: RISE, change: -1.0 - FALL, half: 0.5 * RISE };
    Lines { corners: [top, Corner { place: 1.0, change: FALL, half: TAIL }], factor }
}
