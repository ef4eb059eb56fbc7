//! The axis of a stress-free beam in space: a straight line, an arc, a helix.

use super::rotation::{Matrix3, Quaternion, apply, cross, dot, exponential, matrix, product};

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
