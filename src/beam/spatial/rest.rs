//! The stress-free configuration of a beam in space.

use super::end_rotation::turned;
use super::rest_curve::{ALONG_X, SpatialRestCurve};
use super::rotation::Quaternion;
use crate::beam::planar::front_position::FrontPosition;
use crate::beam::reference_configuration::VaryingReference;

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
}

/// Where every unit of length adheres alike.
const EVEN: &FrontPosition = &FrontPosition::Even;

impl From<SpatialRestCurve> for SpatialRest {
    fn from(curve: SpatialRestCurve) -> Self {
        Self::Curve(curve)
    }
}

impl RestOutline {
    /// Of an outline that begins on the ground; where the front is for what adheres, and up to which S it
    /// adheres at rest, nm.
    pub fn new(reference: VaryingReference, fronts: FrontPosition, rest_front: f64) -> Self {
        let gap = reference.at(0.0)[1];
        Self { reference, fronts, rest_front, gap }
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

    /// How far a section with its axis at the height y and this lowest point is from one that lies on the ground, nm: of an outline by the lowest
    /// point, along a curve by the axis.
    #[inline(always)]
    pub(super) fn lift(&self, y: f64, lowest: f64) -> f64 {
        match self {
            Self::Curve(curve) => (y - curve.start[1]).abs(),
            Self::Outline(outline) => (lowest - outline.gap).abs(),
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
