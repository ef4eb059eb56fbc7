//! The frame and the strains at a point of a beam in space, and how they change with local changes of the fields.
//!
//! Symbols are those of the energy density.

use crate::beam::spatial::rotation::{Matrix3, apply_transposed, conjugate, cross, dot, inner, matrix, product};
use crate::number::Real;

/// Unknowns of a node.
pub(crate) const SPATIAL_UNKNOWNS: usize = 6;

/// Fields of a beam in space: x, y, z and the quaternion.
pub(crate) const SPATIAL_FIELDS: usize = 7;

/// What is known at a point: lengths, the frame, the strains.
pub(crate) struct Kinematics<T> {
    /// 1/|q|
    pub per_length: T,
    /// q̂
    pub unit: [T; 4],
    /// R
    pub frame: Matrix3<T>,
    /// g = Rᵀ r'
    pub stretch: [T; 3],
    /// k
    pub turn: [T; 3],
    /// v
    pub growth: T,
}

impl<T: Real> Kinematics<T> {
    #[inline(always)]
    pub(crate) fn new(value: &[T; SPATIAL_FIELDS], slope: &[T; SPATIAL_FIELDS]) -> Self {
        let [dx, dy, dz, s0, s1, s2, s3] = *slope;
        let q = [value[3], value[4], value[5], value[6]];
        let per_length = inner(q, q).each(|square| [1.0 / square.sqrt()])[0];
        let unit = q.map(|entry| entry * per_length);
        let change = [s0, s1, s2, s3].map(|entry| entry * per_length);
        let frame = matrix(unit);
        let [growth, turn @ ..] = product(conjugate(unit), change);
        Self {
            per_length,
            unit,
            stretch: apply_transposed(&frame, &[dx, dy, dz]),
            frame,
            turn: turn.map(|entry| entry * 2.0),
            growth,
        }
    }

    /// Γ and K - K0.
    #[inline(always)]
    pub(crate) fn strains(&self, rest: &[T; 3]) -> [T; 6] {
        let ([g0, g1, g2], k) = (self.stretch, self.turn);
        [g0 - 1.0, g1, g2, k[0] - rest[0], k[1] - rest[1], k[2] - rest[2]]
    }

    /// The columns of q̂ ∘ (1, e1, e2, e3), over |q|: from local changes to those of the field.
    #[inline(always)]
    pub(crate) fn basis(&self) -> [[T; 4]; 4] {
        let [w, x, y, z] = self.unit.map(|entry| entry * self.per_length);
        [[w, -x, -y, -z], [x, w, -z, y], [y, z, w, -x], [z, -y, x, w]]
    }
}

/// Second derivatives of p·(Rᵀ v), with e = Rᵀ v, by (α, ω) twice.
#[inline(always)]
pub(super) fn turned_twice<T: Real>(p: [T; 3], e: [T; 3], out: &mut [[T; 4]; 4]) {
    let mixed = cross(e, p);
    let both = dot(p, e) * 4.0;
    for i in 0..3 {
        out[0][i + 1] = out[0][i + 1] + mixed[i] * 2.0;
        out[i + 1][0] = out[i + 1][0] + mixed[i] * 2.0;
        for j in 0..3 {
            out[i + 1][j + 1] = out[i + 1][j + 1] + (p[i] * e[j] + e[i] * p[j]) * 2.0;
        }
        out[i + 1][i + 1] = out[i + 1][i + 1] - both;
    }
}
