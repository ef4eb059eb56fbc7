//! The stress-free configuration of a beam in space: its axis is a straight line, an arc or a helix, or varies with its outline.

use super::rotation::{Matrix3, Quaternion, apply, cross, dot, exponential, matrix, product};
use crate::beam::planar::planar_beam::FrontPosition;
use crate::beam::reference_configuration::VaryingReference;
use std::sync::Arc;

/// A curve along which the directors turn evenly: R0' = R0 K0×, r0' = R0 e1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpatialRestCurve {
    /// r0(0), nm
    pub start: [f64; 3],
    /// The directors at S = 0
    pub directors: Quaternion,
    /// K0: the twist and the two curvatures in the axes of the directors, 1/nm
    pub curvature: [f64; 3],
}

/// Directors of a beam that lies along x with its width sideways: d1 = e_x, d2 = -e_z, d3 = e_y.
pub const ALONG_X: Quaternion = [std::f64::consts::FRAC_1_SQRT_2, -std::f64::consts::FRAC_1_SQRT_2, 0.0, 0.0];

/// Below this angle series are exact to the last digit.
const SMALL: f64 = 1e-2;

impl SpatialRestCurve {
    /// A straight beam along x at this height above the ground, nm.
    pub fn along_x(height: f64) -> Self {
        Self { start: [0.0, height, 0.0], directors: ALONG_X, curvature: [0.0; 3] }
    }

    /// r0 and the directors at S.
    pub fn at(&self, place: f64) -> ([f64; 3], Quaternion) {
        let turn = self.curvature.map(|k| k * place);
        let square = dot(turn, turn);
        let angle = square.sqrt();
        // (1 - cos φ)/φ² and (φ - sin φ)/φ³
        let (first, second) = if angle < SMALL {
            (
                0.5 - square * (1.0 / 24.0 - square * (1.0 / 720.0 - square / 40320.0)),
                1.0 / 6.0 - square * (1.0 / 120.0 - square * (1.0 / 5040.0 - square / 362_880.0)),
            )
        } else {
            (2.0 * (0.5 * angle).sin().powi(2) / square, (angle - angle.sin()) / (square * angle))
        };
        let along = [1.0, 0.0, 0.0];
        let once = cross(turn, along);
        let twice = cross(turn, once);
        let local: [f64; 3] = std::array::from_fn(|i| place * (along[i] + first * once[i] + second * twice[i]));
        let frame: Matrix3 = matrix(self.directors);
        let moved = apply(&frame, &local);
        (std::array::from_fn(|i| self.start[i] + moved[i]), product(self.directors, exponential(turn)))
    }
}

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
                ([x, y, 0.0], product(exponential([0.0, 0.0, rotation]), ALONG_X))
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
    pub(crate) fn fronts(&self) -> &FrontPosition {
        match self {
            Self::Curve(_) => EVEN,
            Self::Outline(outline) => &outline.fronts,
        }
    }

    /// S up to which a beam of this length adheres at rest, nm.
    pub(crate) fn front(&self, length: f64) -> f64 {
        match self {
            Self::Curve(_) => length,
            Self::Outline(outline) => outline.rest_front,
        }
    }
}

// -- Of a branch of a tree --

/// The stress-free axis and directors of a branch.
#[derive(Clone, Debug)]
pub enum BranchRest {
    /// A curve whose directors turn evenly
    Curve(SpatialRestCurve),
    /// That of a beam, as it was placed
    Placed(PlacedRest),
}

/// The stress-free configuration of a beam, turned, and then moved.
#[derive(Clone, Debug)]
pub struct PlacedRest {
    /// Of the beam where it is made
    pub rest: Arc<SpatialRest>,
    /// How it is turned about the origin
    pub turn: Quaternion,
    /// Where the origin is moved to, nm
    pub origin: [f64; 3],
}

impl BranchRest {
    /// Of a beam that stays where it is made.
    pub(crate) fn as_made(rest: &Arc<SpatialRest>) -> Self {
        Self::Placed(PlacedRest { rest: Arc::clone(rest), turn: [1.0, 0.0, 0.0, 0.0], origin: [0.0; 3] })
    }

    /// Place (nm) and directors at S.
    pub fn at(&self, place: f64) -> ([f64; 3], Quaternion) {
        match self {
            Self::Curve(curve) => curve.at(place),
            Self::Placed(PlacedRest { rest, turn, origin }) => {
                let ([x, y, z], directors) = rest.at(place);
                let own = [x, rest.lifted(place, y), z];
                let turned = apply(&matrix(*turn), &own);
                (std::array::from_fn(|i| origin[i] + turned[i]), product(*turn, directors))
            }
        }
    }

    /// S up to which a branch of this length adheres at rest, as a front, nm.
    pub(super) fn front_at_rest(&self, length: f64) -> f64 {
        match self {
            Self::Curve(_) => length,
            Self::Placed(PlacedRest { rest, .. }) => rest.fronts().near(rest.front(length)),
        }
    }

    /// S of a front of a branch of this length, nm.
    pub(super) fn place_of_front(&self, front: f64, length: f64) -> f64 {
        match self {
            Self::Curve(_) => front.clamp(0.0, length),
            Self::Placed(PlacedRest { rest, .. }) => {
                let fronts = rest.fronts();
                fronts.place(front.clamp(0.0, fronts.near(length)))
            }
        }
    }

    /// K0 of a curve, 1/nm; sections of a beam that is placed say their own.
    pub(super) fn curvature(&self) -> [f64; 3] {
        match self {
            Self::Curve(curve) => curve.curvature,
            Self::Placed(_) => [0.0; 3],
        }
    }
}
