//! Polynomials through the last points in time: predictions, their errors, rates and integrals.

/// Weights that extrapolate from `times`, the newest first, to `to`: Lagrange's.
pub(super) fn extrapolation(times: &[f64], to: f64) -> Vec<f64> {
    let weight = |i: usize| {
        (0..times.len()).filter(|&j| j != i).map(|j| (to - times[j]) / (times[i] - times[j])).product::<f64>()
    };
    (0..times.len()).map(weight).collect()
}

/// BDF of the second order, dm/dt = c (m₁ - w₀ m₀ - w₋ m₋) at the end of a step h behind one of the length h₋; of the first order where
/// there was none. Returns c, w₀ and w₋.
pub(super) fn backward_differences(h: f64, before: Option<f64>) -> (f64, [f64; 2]) {
    let Some(before) = before else { return (1.0 / h, [1.0, 0.0]) };
    let r = h / before;
    let scale = 1.0 + 2.0 * r;
    (scale / (h * (1.0 + r)), [(1.0 + r).powi(2) / scale, -r * r / scale])
}

/// ∫ p dt over the last step h, from p at its end, at its beginning and at the beginning of the step before, by the parabola through these.
pub(super) fn integral(h: f64, [now, last]: [f64; 2], before: Option<(f64, f64)>) -> f64 {
    let Some((length, first)) = before else { return 0.5 * h * (now + last) };
    let r = h / length;
    h * ((3.0 + 2.0 * r) / (6.0 * (1.0 + r)) * now + (3.0 + r) / 6.0 * last - r * r / (6.0 * (1.0 + r)) * first)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// All three are exact of parabolas on steps of any length.
    #[test]
    fn exact_of_parabolas() {
        let (first, last, now) = (0.3, 0.7, 1.6);
        let p = |t: f64| 2.0 - 3.0 * t + 1.5 * t * t;
        let weights = extrapolation(&[now, last, first], 2.0);
        let found = weights[0] * p(now) + weights[1] * p(last) + weights[2] * p(first);
        assert_relative_eq!(found, p(2.0), max_relative = 1e-13);
        let (c, [w0, w1]) = backward_differences(now - last, Some(last - first));
        assert_relative_eq!(c * (p(now) - w0 * p(last) - w1 * p(first)), -3.0 + 3.0 * now, max_relative = 1e-13);
        let whole = |t: f64| 2.0 * t - 1.5 * t * t + 0.5 * t.powi(3);
        let found = integral(now - last, [p(now), p(last)], Some((last - first, p(first))));
        assert_relative_eq!(found, whole(now) - whole(last), max_relative = 1e-13);
    }
}
