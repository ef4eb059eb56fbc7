//! Straight lines with rounded corners: what bilinear and Dugdale's law are made of.
//!
//! A corner at x = 0 is the ramp max(x, 0), rounded over |x| < e: with t = x/e, e R(t), where R'' = (35/32)(1 - t²)³. R is four
//! times continuously differentiable; its corner is lifted by 35/256 e, and its integral by e²/18.

use super::at::At;

/// One corner.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    pub place: f64,
    /// By how much the slope changes; with one, the slope at the origin, all changes add up to zero.
    pub change: f64,
    /// Half of the width over which it is rounded.
    pub half: f64,
}

/// Straight lines through the origin, at zero behind the last corner.
pub(super) struct Lines<const CORNERS: usize> {
    /// Ascending
    pub corners: [Corner; CORNERS],
    /// What everything is multiplied by.
    pub factor: f64,
}

impl<const CORNERS: usize> Lines<CORNERS> {
    /// The integral from t on, the value, and the slope. As r(x) - r(-x) = x for a ramp r, the lines t + Σ c r(t - place) with
    /// changes c of the slope are Σ c r(place - t) as well, which is nothing behind the last corner.
    #[inline]
    pub(crate) const fn at(&self, t: f64) -> At {
        let mut sums = [0.0; 3];
        let mut k = 0;
        while k < CORNERS {
            let Corner { place, change, half } = self.corners[k];
            let [behind, value, slope] = rounded((place - t) / half);
            sums[0] += change * half * half * behind;
            sums[1] += change * half * value;
            sums[2] -= change * slope;
            k += 1;
        }
        [self.factor * sums[0], self.factor * sums[1], self.factor * sums[2]]
    }

    /// The integral of the integral of `at`, from t on.
    #[inline]
    pub(crate) const fn primitive(&self, t: f64) -> f64 {
        let mut sum = 0.0;
        let mut k = 0;
        while k < CORNERS {
            let Corner { place, change, half } = self.corners[k];
            sum += change * half * half * half * twice_behind((place - t) / half);
            k += 1;
        }
        self.factor * sum
    }

    /// Zero, and where the rounding of each corner begins and ends: one more than twice the corners.
    pub(crate) const fn knots<const KNOTS: usize>(&self) -> [f64; KNOTS] {
        let mut knots = [0.0; KNOTS];
        let mut k = 1;
        while k < KNOTS {
            let Corner { place, half, .. } = self.corners[(k - 1) / 2];
            knots[k] = if k % 2 == 1 { place - half } else { place + half };
            k += 1;
        }
        knots
    }

    /// The largest value, where it is at the first corner.
    pub(crate) const fn top(&self) -> f64 {
        let Corner { place, half, .. } = self.corners[0];
        let (mut low, mut high) = (place - half, place + half);
        let mut k = 0;
        while k < 80 {
            let middle = 0.5 * (low + high);
            if self.at(middle)[2] > 0.0 {
                low = middle
            } else {
                high = middle
            }
            k += 1;
        }
        self.at(low)[1]
    }
}

/// ∫ R up to t, R and R', the integral from where R is nothing.
#[inline]
const fn rounded(t: f64) -> At {
    if t <= -1.0 {
        return [0.0; 3];
    }
    if t >= 1.0 {
        return [0.5 * t * t + 1.0 / 18.0, t, 1.0];
    }
    let z = t * t;
    let third = t * z * (1.0 / 6.0 - z * (1.0 / 20.0 - z * (1.0 / 70.0 - z / 504.0)));
    let second = z * (0.5 - z * (0.25 - z * (0.1 - z / 56.0)));
    let first = t * (1.0 - z * (1.0 - z * (0.6 - z / 7.0)));
    const FACTOR: f64 = 35.0 / 32.0;
    const LIFT: f64 = 35.0 / 256.0;
    [FACTOR * third + 0.25 * z + LIFT * t + BEHIND, FACTOR * second + 0.5 * t + LIFT, FACTOR * first + 0.5]
}

/// The integral of ∫ R up to t.
#[inline]
const fn twice_behind(t: f64) -> f64 {
    if t <= -1.0 {
        return 0.0;
    }
    if t >= 1.0 {
        return t * (t * t / 6.0 + 1.0 / 18.0) + (inside(1.0) - inside(-1.0)) - (1.0 / 6.0 + 1.0 / 18.0);
    }
    return inside(t) - inside(-1.0);

    const fn inside(t: f64) -> f64 {
        let z = t * t;
        let fourth = z * z * (1.0 / 24.0 - z * (1.0 / 120.0 - z * (1.0 / 560.0 - z / 5040.0)));
        35.0 / 32.0 * fourth + t * (z / 12.0 + 35.0 / 512.0 * t + BEHIND)
    }
}

/// ∫ R from -1 to 0: such that the integral goes on as t²/2 + 1/18 beyond 1.
const BEHIND: f64 =
    0.5 + 1.0 / 18.0 - (35.0 / 32.0) * (1.0 / 6.0 - 1.0 / 20.0 + 1.0 / 70.0 - 1.0 / 504.0) - 0.25 - 35.0 / 256.0;
