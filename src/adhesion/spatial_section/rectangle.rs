//! The body force of eq. (9) summed over a rectangle that is tilted both ways, in closed form.
//!
//! The axis of a rectangle b × h is at the height y; from side to side it rises by a = b d2·e_y, from bottom to top by
//! c = h d3·e_y. Its points are at y + α a + γ c, α and γ from -1/2 to 1/2. With V' = -W, that is
//! V = A_H/(2π r0) [ (r0/r)⁷/2520 - (r0/r)/6 ], the energy per length is
//!
//!   Ψ = b h ∫∫ T(y + α a + γ c) dα dγ
//!     = b h [V(y - a/2 - c/2) - V(y - a/2 + c/2) - V(y + a/2 - c/2) + V(y + a/2 + c/2)] / (a c).
//!
//! That is 0/0 where one of the tilts is zero. With s = ((a + c)/2)², t = ((a - c)/2)², whose difference is a c, it is
//! one divided difference,
//!
//!   Ψ = b h Φ\[s, t\],   Φ(x) = V(y - √x) + V(y + √x).
//!
//! Φ_kl is the divided difference over k times s and l times t. With D = Φ21 + Φ12, E = Φ22, F = Φ22 + Φ31 + Φ13,
//! G = Φ32 + Φ23, H = Φ33, and times b h,
//!
//!   Ψ_a = (a/2) (D + c² E),   Ψ_aa = (D + c² E)/2 + (a²/2) (F + 2 c² G + c⁴ H),
//!   Ψ_ac = (a c/2) (F + 2 E + (a² + c²) G + a² c² H).
//!
//! For V = r⁻ⁿ it is Φ = 2 N(x) (y² - x)⁻ⁿ with N = Σ_j C(n, 2j) yⁿ⁻²ʲ xʲ. The divided difference of a product is
//! Leibniz's sum over the nodes; that of xʲ is h_(j-k-l+1)(s.., t..), that of (y² - x)⁻ⁿ is Aᵏ Bˡ h_(n-1)(A.., B..)
//! with A = 1/(y² - s) and B = 1/(y² - t), where h_j are the complete homogeneous symmetric polynomials,
//! h_j(X, x) = h_j(X) + x h_(j-1)(X, x). Every term of a power is positive: nothing cancels at any tilt, and nothing is
//! divided by a or c. A derivative by y is -n times the same with n + 1.

use super::response::SpatialSectionResponse;
use crate::adhesion::levels::half_space::HalfSpace;
use crate::number::Real;
use std::f64::consts::PI;

/// What the powers of V are multiplied by in 2 b h V: of r⁻⁷ and of -r⁻¹.
#[inline(always)]
fn factors<T: Real>(half_space: &HalfSpace, area: T) -> [T; 2] {
    let r0 = half_space.equilibrium_distance;
    let r0_cubed = r0 * r0 * r0;
    let scale = area * half_space.hamaker_constant * (1.0 / PI);
    [scale * (r0_cubed * r0_cubed) * (1.0 / 2520.0), scale * (1.0 / 6.0)]
}

/// h_j of the numbers of `fewer` and one more number, for j from 0.
#[inline(always)]
fn with<T: Real, const M: usize, const N: usize>(fewer: &[T; M], x: T) -> [T; N] {
    let mut h = [fewer[0]; N];
    for j in 1..N {
        h[j] = fewer[j] + x * h[j - 1];
    }
    h
}

/// s, t, A and B.
#[inline(always)]
fn nodes<T: Real>(y: T, a: T, c: T) -> [T; 4] {
    let (u, d) = ((a + c) * 0.5, (a - c) * 0.5);
    [u * u, d * d, ((y - u) * (y + u)).recip(), ((y - d) * (y + d)).recip()]
}

/// Ψ of a rectangle of this `area`, nm²; its lowest corner, y - (|a| + |c|)/2, is above zero.
#[inline(always)]
pub(super) fn energy<T: Real>(half_space: &HalfSpace, area: T, y: T, a: T, c: T) -> T {
    let [s, t, p, q] = nodes(y, a, c);
    let yy = y * y;
    let (pq, p2, q2) = (p * q, p * p, q * q);
    let (p4, q4, pp, pairs) = (p2 * p2, q2 * q2, p2 + q2, pq * pq);
    // h_6(A, B) = A⁶ + A⁵B + ... + B⁶
    let h6 = p4 * p2 + q4 * q2 + pq * (p4 + q4) + pairs * pp + pairs * pq;
    let n10 = yy * (yy * (yy + s * 21.0) + s * s * 35.0) + s * s * s * 7.0;
    let n11 = yy * (yy * 21.0 + (s + t) * 35.0) + (s * (s + t) + t * t) * 7.0;
    let [repel, attract] = factors(half_space, area);
    y * ((n10 * (pq * h6) + n11 * (q4 * q2 * q)) * repel - pq * attract)
}

/// Ψ with gradient and Hessian.
#[inline(always)]
pub(super) fn response<T: Real>(half_space: &HalfSpace, area: T, y: T, a: T, c: T) -> SpatialSectionResponse<T> {
    let [s, t, p, q] = nodes(y, a, c);
    let one = T::splat(1.0);
    let (p2, q2, pq, sum) = (p * p, q * q, p * q, p + q);
    let (p4, q4) = (p2 * p2, q2 * q2);
    let (p7, q7) = (p4 * p2 * p, q4 * q2 * q);
    let (p8, q8) = (p4 * p4, q4 * q4);
    let q9 = q8 * q;
    let (p2q, pq2, p2q2) = (p2 * q, p * q2, pq * pq);

    // h_j of k times A and l times B
    let h1: [T; 9] = [one, p, p2, p2 * p, p4, p4 * p, p4 * p2, p7, p8];
    let h11: [T; 9] = with(&h1, q);
    let h21: [T; 8] = with(&h11, p);
    let h12: [T; 8] = with(&h11, q);
    let h22: [T; 8] = with(&h21, q);
    let h31: [T; 7] = with(&h21, p);
    let h13: [T; 7] = with(&h12, q);
    let h32: [T; 7] = with(&h22, p);
    let h23: [T; 7] = with(&h22, q);
    let h33: [T; 7] = with(&h32, q);

    // h_j of s and t
    let yy = y * y;
    let (s2, t2, st) = (s * s, t * t, s + t);
    let (s3, t3) = (s2 * s, t2 * t);
    let st2 = s2 + t * st;
    let st3 = s3 + t * st2;

    // n = 7: y N(x), N(x) = y⁶ + 21 y⁴ x + 35 y² x² + 7 x³
    let n10 = yy * (yy * (yy + s * 21.0) + s2 * 35.0) + s3 * 7.0;
    let n01 = yy * (yy * (yy + t * 21.0) + t2 * 35.0) + t3 * 7.0;
    let n11 = yy * (yy * 21.0 + st * 35.0) + st2 * 7.0;
    let n21 = yy * 35.0 + (s + st) * 7.0;
    let n12 = yy * 35.0 + (t + st) * 7.0;
    let (g11, g21, g12, g22) = (pq * h11[6], p2q * h21[6], pq2 * h12[6], p2q2 * h22[6]);
    let (g31, g13) = (p2q * p * h31[6], pq2 * q * h13[6]);
    let (g32, g23, g33) = (p2q2 * p * h32[6], p2q2 * q * h23[6], p2q2 * pq * h33[6]);
    let value = n10 * g11 + n11 * q7;
    let d7 = n10 * g21 + n01 * g12 + n11 * g11 * 2.0 + n21 * p7 + n12 * q7;
    let e7 = n10 * g22 + n11 * g12 + n21 * g11 + q7 * 7.0;
    let by_31 = n10 * g31 + n11 * g21 + (n21 * p8 + p7) * 7.0;
    let by_13 = n01 * g13 + n11 * g12 + (n12 * q8 + q7) * 7.0;
    let f7 = e7 + by_31 + by_13;
    let by_32 = n10 * g32 + n21 * g21;
    let by_23 = n01 * g23 + n12 * g12;
    let g7 = by_32 + by_23 + (n11 * g22 + g11 * 7.0) * 2.0;
    let h7 = n10 * g33 + n11 * g23 + n21 * g22 + g12 * 7.0;

    // n = 8: N(x) = y⁸ + 28 y⁶ x + 70 y⁴ x² + 28 y² x³ + x⁴
    let n10 = yy * (yy * (yy * (yy + s * 28.0) + s2 * 70.0) + s3 * 28.0) + s2 * s2;
    let n01 = yy * (yy * (yy * (yy + t * 28.0) + t2 * 70.0) + t3 * 28.0) + t2 * t2;
    let n11 = yy * (yy * (yy * 28.0 + st * 70.0) + st2 * 28.0) + st3;
    let n21 = yy * (yy * 70.0 + (s + st) * 28.0) + s * (s + st) + st2;
    let n12 = yy * (yy * 70.0 + (t + st) * 28.0) + t * (t + st) + st2;
    let n22 = yy * 28.0 + st * 2.0;
    let (g11, g21, g12, g22) = (pq * h11[7], p2q * h21[7], pq2 * h12[7], p2q2 * h22[7]);
    let value_8 = n10 * g11 + n11 * q8;
    let d8 = n10 * g21 + n01 * g12 + n11 * g11 * 2.0 + n21 * p8 + n12 * q8;
    let e8 = n10 * g22 + n11 * g12 + n21 * g11 + n22 * q8;

    // n = 9: y N(x), N(x) = y⁸ + 36 y⁶ x + 126 y⁴ x² + 84 y² x³ + 9 x⁴
    let n10 = yy * (yy * (yy * (yy + s * 36.0) + s2 * 126.0) + s3 * 84.0) + s2 * s2 * 9.0;
    let n11 = yy * (yy * (yy * 36.0 + st * 126.0) + st2 * 84.0) + st3 * 9.0;
    let value_9 = n10 * (pq * h11[8]) + n11 * q9;

    // n = 1: N = y; n = 2: N = y² + x; n = 3: N = y (y² + 3 x)
    let (n10, n01) = (yy + s, yy + t);
    let value_2 = n10 * (pq * sum) + q2;
    let d2 = n10 * (p2q * h21[1]) + n01 * (pq2 * h12[1]) + pq * sum * 2.0;
    let e2 = n10 * (p2q2 * h22[1]) + pq2 * h12[1];
    let value_3 = (yy + s * 3.0) * (pq * h11[2]) + q2 * q * 3.0;

    let (aa, cc) = (a * a, c * c);
    let [repel, attract] = factors(half_space, area);
    let (repel_y, attract_y) = (y * repel, y * attract);
    let both = |n7: T, n1: T| n7 * repel_y - n1 * attract_y;
    let d = both(d7, pq * sum);
    let e = both(e7, p2q2);
    let f = both(f7, pq * (pq + p2 + q2));
    let g = both(g7, p2q2 * sum);
    let h = both(h7, p2q2 * pq);
    let d_y = d2 * attract - d8 * (repel * 7.0);
    let e_y = e2 * attract - e8 * (repel * 7.0);
    let (slope_a, slope_c) = (d + cc * e, d + aa * e);
    let (half_a, half_c) = (a * 0.5, c * 0.5);
    SpatialSectionResponse {
        energy: both(value, pq),
        gradient: [value_2 * attract - value_8 * (repel * 7.0), half_a * slope_a, half_c * slope_c],
        hessian: [
            value_9 * (repel_y * 56.0) - value_3 * (attract_y * 2.0),
            half_a * (d_y + cc * e_y),
            half_c * (d_y + aa * e_y),
            (slope_a + aa * (f + cc * (g * 2.0 + cc * h))) * 0.5,
            half_a * c * (f + e * 2.0 + (aa + cc) * g + aa * cc * h),
            (slope_c + cc * (f + aa * (g * 2.0 + aa * h))) * 0.5,
        ],
    }
}
