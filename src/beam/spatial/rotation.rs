//! Rotations as unit quaternions (w, x, y, z), and small matrices.
//!
//! A quaternion q turns a vector v into the vector part of q ∘ (0, v) ∘ q̄. The directors of a section are the columns of R(q), which is
//! homogeneous of degree zero here: a quaternion that is not of length one means the rotation of the one that is.

use crate::number::Real;

/// A quaternion (w, x, y, z).
pub type Quaternion<T = f64> = [T; 4];
/// A 3 × 3 matrix by rows.
pub type Matrix3<T = f64> = [[T; 3]; 3];

/// p ∘ q
#[inline(always)]
pub fn product<T: Real>(p: Quaternion<T>, q: Quaternion<T>) -> Quaternion<T> {
    [
        p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
        p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
        p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
        p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0],
    ]
}

/// q̄
#[inline(always)]
pub fn conjugate<T: Real>(q: Quaternion<T>) -> Quaternion<T> {
    [q[0], -q[1], -q[2], -q[3]]
}

/// Σ pᵢ qᵢ
#[inline(always)]
pub fn inner<T: Real>(p: Quaternion<T>, q: Quaternion<T>) -> T {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3]
}

/// q times a number.
#[inline(always)]
pub fn times<T: Real>(q: Quaternion<T>, factor: T) -> Quaternion<T> {
    q.map(|entry| entry * factor)
}

/// q of length one.
pub(crate) fn normalised(q: Quaternion) -> Quaternion {
    times(q, 1.0 / inner(q, q).sqrt())
}

/// The rotation by |v| about v, rad.
pub fn exponential(v: [f64; 3]) -> Quaternion {
    let half = 0.5 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
    let (sin, cos) = half.sin_cos();
    let factor = if half == 0.0 { 0.5 } else { 0.5 * sin / half };
    [cos, factor * v[0], factor * v[1], factor * v[2]]
}

/// Below this square of the sine of half a turn four terms of a series are exact to round-off.
const SMALL: f64 = 1e-4;

/// The rotation vector of q, of length one, at most π, rad: q or -q is the exponential of it.
pub fn logarithm(q: Quaternion) -> [f64; 3] {
    let q = if q[0] < 0.0 { q.map(|entry| -entry) } else { q };
    let square = q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    let factor = if square < SMALL {
        // 2 asin(s)/s, to round-off
        2.0 + square * (1.0 / 3.0 + square * (3.0 / 20.0 + square * (5.0 / 56.0)))
    } else {
        let sin = square.sqrt();
        2.0 * sin.atan2(q[0]) / sin
    };
    [factor * q[1], factor * q[2], factor * q[3]]
}

/// The rotation matrix of a quaternion of length one.
#[inline(always)]
pub fn matrix<T: Real>([w, x, y, z]: Quaternion<T>) -> Matrix3<T> {
    let one = T::splat(1.0);
    [
        [one - (y * y + z * z) * 2.0, (x * y - w * z) * 2.0, (x * z + w * y) * 2.0],
        [(x * y + w * z) * 2.0, one - (x * x + z * z) * 2.0, (y * z - w * x) * 2.0],
        [(x * z - w * y) * 2.0, (y * z + w * x) * 2.0, one - (x * x + y * y) * 2.0],
    ]
}

/// a × b
#[inline(always)]
pub fn cross<T: Real>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// a · b
#[inline(always)]
pub fn dot<T: Real>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The matrix of a × .
#[inline(always)]
pub fn skew<T: Real>(a: [T; 3]) -> Matrix3<T> {
    let zero = T::splat(0.0);
    [[zero, -a[2], a[1]], [a[2], zero, -a[0]], [-a[1], a[0], zero]]
}

/// M v
#[inline(always)]
pub fn apply<T: Real, const N: usize, const M: usize>(m: &[[T; N]; M], v: &[T; N]) -> [T; M] {
    let mut out = [T::splat(0.0); M];
    for i in 0..M {
        out[i] = m[i][0] * v[0];
        for j in 1..N {
            out[i] = out[i] + m[i][j] * v[j];
        }
    }
    out
}

/// Mᵀ v
#[inline(always)]
pub fn apply_transposed<T: Real, const N: usize, const M: usize>(m: &[[T; N]; M], v: &[T; M]) -> [T; N] {
    let mut out = m[0];
    for j in 0..N {
        out[j] = out[j] * v[0];
    }
    for i in 1..M {
        for j in 0..N {
            out[j] = out[j] + m[i][j] * v[i];
        }
    }
    out
}

/// A B
#[inline(always)]
pub fn multiply<T: Real, const L: usize, const M: usize, const N: usize>(
    a: &[[T; M]; L],
    b: &[[T; N]; M],
) -> [[T; N]; L] {
    let mut out = [[T::splat(0.0); N]; L];
    for i in 0..L {
        for j in 0..N {
            out[i][j] = a[i][0] * b[0][j];
        }
        for k in 1..M {
            for j in 0..N {
                out[i][j] = out[i][j] + a[i][k] * b[k][j];
            }
        }
    }
    out
}

/// Aᵀ B
#[inline(always)]
pub(crate) fn multiply_transposed<T: Real, const L: usize, const M: usize, const N: usize>(
    a: &[[T; L]; M],
    b: &[[T; N]; M],
) -> [[T; N]; L] {
    let mut out = [[T::splat(0.0); N]; L];
    for i in 0..L {
        for j in 0..N {
            out[i][j] = a[0][i] * b[0][j];
        }
        for k in 1..M {
            for j in 0..N {
                out[i][j] = out[i][j] + a[k][i] * b[k][j];
            }
        }
    }
    out
}

/// A Bᵀ
#[inline(always)]
pub(crate) fn multiply_by_transposed<T: Real, const L: usize, const M: usize, const N: usize>(
    a: &[[T; M]; L],
    b: &[[T; M]; N],
) -> [[T; N]; L] {
    let mut out = [[T::splat(0.0); N]; L];
    for i in 0..L {
        for j in 0..N {
            out[i][j] = a[i][0] * b[j][0];
            for k in 1..M {
                out[i][j] = out[i][j] + a[i][k] * b[j][k];
            }
        }
    }
    out
}
