//! The stress-free configuration of a beam in space.

use super::end_rotation::turned;
use super::rest_curve::{ALONG_X, SpatialRestCurve};
use super::rotation::Quaternion;
use crate::beam::{FrontPosition, VaryingReference};

/// Where a beam in space is in its stress-free configuration.
#[derive(Clone, Debug)]
pub enum SpatialRest {
    /// Along a curve whose directors turn evenly; what adheres of it lies along x.
    Curve(SpatialRestCurve),
    /// As its outline says, in the plane z = 0
    Outline(Box<RestOutline>),
}

/// The stress-free configuration of a beam whose section varies along S, with its width along z.
#[derive(Clone, Debug)]
pub struct RestOutline {
    reference: VaryingReference,
    fronts: FrontPosition,
    rest_front: f64,
    /// Gap of a section that lies on the ground, nm
    gap: f64,
    /// Heights of the axis at which the thinnest and the thickest section lie on the ground, nm
    lying: [f64; 2],
}

/// Where every unit of length adheres alike.
const EVEN: &FrontPosition = &FrontPosition::Even;
/// Places at which the thinnest and the thickest section are looked for.
const PLACES: usize = 400;

impl From<SpatialRestCurve> for SpatialRest {
    fn from(curve: SpatialRestCurve) -> Self {
        Self::Curve(curve)
    }
}

impl RestOutline {
    /// Of an outline that begins on the ground, `length` nm long; where the front is for what adheres, and up to which S it
    /// adheres at rest, nm.
    pub fn new(reference: VaryingReference, length: f64, fronts: FrontPosition, rest_front: f64) -> Self {
        let gap = reference.at(0.0)[1];
        let heights = (0..=PLACES).map(|k| reference.height(length * k as f64 / PLACES as f64));
        let [thinnest, thickest] =
            heights.fold([f64::INFINITY, 0.0], |[low, high]: [f64; 2], h| [low.min(h), high.max(h)]);
        let lying = [gap + 0.5 * thinnest, gap + 0.5 * thickest];
        Self { reference, fronts, rest_front, gap, lying }
    }
}

impl SpatialRest {
    /// r0 and the directors at S.
    pub fn at(&self, place: f64) -> ([f64; 3], Quaternion) {
        match self {
            Self::Curve(curve) => curve.at(place),
            Self::Outline(outline) => {
                let [x, gap, rotation] = outline.reference.at(place);
                let y = gap + 0.5 * outline.reference.height(place);
                ([x, y, 0.0], turned([rotation, 0.0, 0.0], ALONG_X))
            }
        }
    }

    /// The angle θ0 of an end at S whose angles count from the directors along x, rad; zero of a curve, where they count from rest.
    pub fn rotation(&self, place: f64) -> f64 {
        match self {
            Self::Curve(_) => 0.0,
            Self::Outline(outline) => outline.reference.at(place)[2],
        }
    }

    /// Height of the axis at S where that is lifted to where its section is no nearer to the ground than one that lies there, nm.
    pub(super) fn lifted(&self, place: f64, y: f64) -> f64 {
        match self {
            Self::Curve(_) => y,
            Self::Outline(outline) => {
                let [_, _, rotation] = outline.reference.at(place);
                y.max(outline.gap + 0.5 * outline.reference.height(place) * rotation.cos().abs())
            }
        }
    }

    /// How far the height y of an axis is from those of sections that lie on the ground, nm.
    #[inline(always)]
    pub(super) fn lift(&self, y: f64) -> f64 {
        match self {
            Self::Curve(curve) => (y - curve.start[1]).abs(),
            Self::Outline(outline) => {
                let [low, high] = outline.lying;
                (low - y).max(y - high).max(0.0)
            }
        }
    }

    /// Where the front is.
    pub fn fronts(&self) -> &FrontPosition {
        match self {
            Self::Curve(_) => EVEN,
            Self::Outline(outline) => &outline.fronts,
        }
    }

    /// S up to which a beam of this length adheres at rest, nm.
    pub fn front(&self, length: f64) -> f64 {
        match self {
            Self::Curve(_) => length,
            Self::Outline(outline) => outline.rest_front,
        }
    }
}
