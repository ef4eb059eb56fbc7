//! Means of a power of the height over what is symmetric about its middle: f(y, e) = v^m Σ_j g_j (e v)ʲ, v = 1/(y² -
//! e).
//!
//! √e is half the rise of a width, or that of an ellipse. With z = e v, dz/de = v (1 + z) and dz/dy = -2 y v z every
//! derivative is of the same kind. Of v^m g(z)
//!
//!   ∂/∂e = v^(m+1) [m g + (1 + z) g'],   ∂/∂y = -2 y v^(m+1) [m g + z g'],
//!
//! all of whose coefficients are positive where those of g are, so that nothing cancels.

use crate::number::Real;

/// Coefficients of f and of its derivatives.
pub(super) struct EvenPower<const N: usize> {
    g: [f64; N],
    by_e: [f64; N],
    by_ee: [f64; N],
    /// of f_y/(-2 y), and so on
    by_y: [f64; N],
    by_ye: [f64; N],
    by_yy: [f64; N],
}

/// m g + (shift + z) g'
const fn slope<const N: usize>(power: f64, g: &[f64; N], shift: f64) -> [f64; N] {
    let mut out = [0.0; N];
    let mut j = 0;
    while j < N {
        out[j] = (power + j as f64) * g[j];
        if j + 1 < N {
            out[j] += shift * (j + 1) as f64 * g[j + 1];
        }
        j += 1;
    }
    out
}

#[inline(always)]
fn sum<T: Real, const N: usize>(coefficients: &[f64; N], z: T) -> T {
    let mut sum = T::splat(coefficients[N - 1]);
    for j in (0..N - 1).rev() {
        sum = sum * z + coefficients[j];
    }
    sum
}

impl<const N: usize> EvenPower<N> {
    /// Of the exponent m and the coefficients g_j.
    pub(crate) const fn new(power: f64, g: [f64; N]) -> Self {
        let (by_e, by_y) = (slope(power, &g, 1.0), slope(power, &g, 0.0));
        let (by_ee, by_ye) = (slope(power + 1.0, &by_e, 1.0), slope(power + 1.0, &by_y, 1.0));
        let by_yy = slope(power + 1.0, &by_y, 0.0);
        Self { g, by_e, by_ee, by_y, by_ye, by_yy }
    }

    /// f. `power` is v^m.
    #[inline(always)]
    pub(crate) fn value<T: Real>(&self, e: T, v: T, power: T) -> T {
        power * sum(&self.g, e * v)
    }

    /// f, f_y, f_e, f_yy, f_ye, f_ee. `power` is v^m.
    #[inline(always)]
    pub(crate) fn derivatives<T: Real>(&self, y: T, e: T, v: T, power: T) -> [T; 6] {
        let (z, first) = (e * v, power * v);
        let second = first * v;
        let twice = y * -2.0;
        let by_y = sum(&self.by_y, z);
        [
            power * sum(&self.g, z),
            twice * first * by_y,
            first * sum(&self.by_e, z),
            twice * twice * second * sum(&self.by_yy, z) - first * by_y * 2.0,
            twice * second * sum(&self.by_ye, z),
            second * sum(&self.by_ee, z),
        ]
    }
}
