//! How an end of a beam in space is turned: by any turn, or by three angles of which each may be held or driven.
//!
//! With angles the directors are R = Rz(θ) Ry(ψ) Rx(ρ) R_rest: the roll ρ about the axis at rest, then the yaw ψ, then the rotation θ of
//! the plane. With yaw held at zero the axis stays in the plane, d1·e_z = 0, and the roll is the one about the axis as it is; what works on
//! ρ is then the moment about d1, on θ that about e_z, and on ψ, at ψ = 0, that about the normal of the axis in the plane. The angles fail where
//! the yaw is a right angle. Without them a turn is a vector in the axes of the directors, and the moment on all three is held to be zero.

use super::rotation::{
    Matrix3, Quaternion, apply_transposed, conjugate, cross, dot, exponential, matrix, normalised, product, skew,
};
use super::section::kinematics::SPATIAL_UNKNOWNS;

/// What an end's rotation is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EndRotation {
    /// Free to turn in any way
    Free,
    /// θ, ψ, ρ
    Angles,
}

/// q of the directors with these angles.
pub fn turned([rotation, yaw, roll]: [f64; 3], rest: Quaternion) -> Quaternion {
    let about = |k: usize, angle: f64| {
        let mut vector = [0.0; 3];
        vector[k] = angle;
        exponential(vector)
    };
    product(about(2, rotation), product(about(1, yaw), product(about(0, roll), rest)))
}

/// The angles of the directors q, each within half a turn.
pub fn angles(q: Quaternion, rest: Quaternion) -> [f64; 3] {
    let r = matrix(product(q, conjugate(rest)));
    let yaw = (-r[2][0]).atan2(r[0][0].hypot(r[1][0]));
    [r[1][0].atan2(r[0][0]), yaw, r[2][1].atan2(r[2][2])]
}

/// The axes that the angles turn about, as columns of ∂φ/∂(θ, ψ, ρ), in the axes of the directors.
pub(crate) fn axes([rotation, yaw, _]: [f64; 3], q: Quaternion) -> Matrix3 {
    let r = matrix(q);
    let about_z = [0.0, 0.0, 1.0];
    let (sin, cos) = rotation.sin_cos();
    let about_y = [-sin, cos, 0.0];
    let about_x = [yaw.cos() * cos, yaw.cos() * sin, -yaw.sin()];
    let columns = [about_z, about_y, about_x].map(|axis| apply_transposed(&r, &axis));
    std::array::from_fn(|i| std::array::from_fn(|k| columns[k][i]))
}

/// Σ g ∂²φ/∂c∂c of the angles, for the gradient g by φ: turns one after the other make that of their sum and half of their cross product.
pub(crate) fn bent(axes: &Matrix3, gradient: [f64; 3]) -> Matrix3 {
    let column = |k: usize| -> [f64; 3] { std::array::from_fn(|i| axes[i][k]) };
    let mut out = [[0.0; 3]; 3];
    for (first, second) in [(0, 1), (0, 2), (1, 2)] {
        let across = cross(column(first), column(second));
        let entry = 0.5 * (0..3).map(|i| gradient[i] * across[i]).sum::<f64>();
        out[first][second] = entry;
        out[second][first] = entry;
    }
    out
}

impl EndRotation {
    /// From the unknowns of an end to those of its node, and what bends them; `gradient` by the turn of the node.
    pub(super) fn map(self, place: Matrix3, angles: [f64; 3], q: Quaternion, gradient: [f64; 3]) -> (EndMap, Matrix3) {
        match self {
            Self::Free => {
                let turn = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
                (EndMap { place, turn }, [[0.0; 3]; 3])
            }
            Self::Angles => {
                let turn = axes(angles, q);
                (EndMap { place, turn }, bent(&turn, gradient))
            }
        }
    }

    /// How the work of a moment that keeps its direction in space changes with the unknowns of an end whose axes are `turn`;
    /// `moment` in the axes of the directors. Of an end that is free, the second derivative along a turn by exp(φ/2).
    pub(super) fn moment_change(self, turn: &Matrix3, moment: [f64; 3]) -> Matrix3 {
        match self {
            Self::Free => skew(moment).map(|row| row.map(|entry| 0.5 * entry)),
            Self::Angles => {
                // an axis is carried along by the turns about those before it
                let column = |k: usize| -> [f64; 3] { std::array::from_fn(|i| turn[i][k]) };
                let change = |row, by| if by < row { dot(cross(column(by), column(row)), moment) } else { 0.0 };
                std::array::from_fn(|row| std::array::from_fn(|by| change(row, by)))
            }
        }
    }
}

/// Turns a quaternion on by a vector in the axes of the directors, and keeps its length one.
pub(crate) fn turn_on(q: Quaternion, by: [f64; 3]) -> Quaternion {
    let next = product(q, exponential(by));
    normalised(next)
}

/// From the unknowns of an end of the chain to those of its last node: of its place and of its turn, and how that is bent,
/// Σ g ∂²φ/∂c².
#[derive(Clone, Copy, Debug)]
pub(crate) struct EndMap {
    /// Columns: the axes along which the end is moved.
    pub place: Matrix3,
    /// ∂φ/∂c
    pub turn: Matrix3,
}

impl EndMap {
    /// A direction of the end as one of its node.
    pub(crate) fn forward(&self, end: &[f64]) -> [f64; SPATIAL_UNKNOWNS] {
        self.both(|map, k| (0..3).map(|j| map[k % 3][j] * end[3 * (k / 3) + j]).sum())
    }

    /// A gradient by the unknowns of the node as one by those of the end.
    pub(crate) fn back(&self, node: &[f64]) -> [f64; SPATIAL_UNKNOWNS] {
        self.both(|map, k| (0..3).map(|j| map[j][k % 3] * node[3 * (k / 3) + j]).sum())
    }

    fn both(&self, sum: impl Fn(&Matrix3, usize) -> f64) -> [f64; SPATIAL_UNKNOWNS] {
        std::array::from_fn(|k| sum(if k < 3 { &self.place } else { &self.turn }, k))
    }
}
