//! Central differences with an error estimate.

/// A number with a bound on its error.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Estimate {
    pub value: f64,
    pub error: f64,
}

/// Step of a parameter's coordinate. The error of a difference of the fourth order is a multiple of its fourth power, 1e-13, and round-off is
/// divided by it.
pub(super) const STEP: f64 = 5e-4;
/// Where a parameter is taken, in steps.
pub(super) const STEPS: [f64; 4] = [1.0, -1.0, 2.0, -2.0];
/// Farthest that a parameter is changed for a derivative, in its coordinate.
pub const MOST_CHANGED: f64 = 2.0 * STEP;
/// Multiplies the square of what the second order misses, relative, which is the size of what the fourth order does.
const NEXT_ORDER: f64 = 4.0;
/// Round-off of a function value, relative.
const ROUNDED: f64 = 4.0 * f64::EPSILON;

/// What changing a parameter does to a number: its derivative to the second and to the fourth order, and the round-off of that.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Change {
    second: f64,
    fourth: f64,
    rounded: f64,
}

impl Change {
    /// Of a number whose values at [`STEPS`] times [`STEP`] are given, with the size of the sums that cancel in them.
    pub fn between(values: [f64; 4], scale: f64) -> Self {
        let [second, far] = [0, 2].map(|k| (values[k] - values[k + 1]) / (2.0 * STEPS[k] * STEP));
        Self { second, fourth: (4.0 * second - far) / 3.0, rounded: ROUNDED * scale / STEP }
    }

    /// With what it may be wrong by.
    pub fn estimate(&self) -> Estimate {
        let missed = (self.second - self.fourth).abs();
        let size = self.fourth.abs().max(missed);
        let truncated = if size > 0.0 { NEXT_ORDER * missed * missed / size } else { 0.0 };
        Estimate { value: self.fourth, error: truncated + self.rounded }
    }
}

/// Where a function along the path is taken, in steps.
pub(super) const ALONG: [f64; 6] = [1.0, -1.0, 2.0, -2.0, 4.0, -4.0];

/// The derivative of a function whose values at [`ALONG`] times `step` are given: of the sixth order, with what that changes of the fourth.
pub(super) fn along_path(values: [f64; 6], step: f64) -> Estimate {
    let [one, two, four] = [0, 2, 4].map(|k| (values[k] - values[k + 1]) / (2.0 * ALONG[k] * step));
    let [near, far] = [(4.0 * one - two) / 3.0, (4.0 * two - four) / 3.0];
    let value = (16.0 * near - far) / 15.0;
    Estimate { value, error: (value - near).abs() }
}

/// How the change of a number by a parameter changes along the path, from those at [`ALONG`] times `step`.
pub(super) fn change_along_path(changes: [Change; 6], step: f64) -> Estimate {
    let along = along_path(changes.map(|change| change.fourth), step);
    let second = along_path(changes.map(|change| change.second), step).value;
    let rounded = changes.iter().fold(0.0f64, |most, change| most.max(change.rounded)) / step;
    let by_parameter = Change { second, fourth: along.value, rounded }.estimate();
    Estimate { value: along.value, error: along.error + by_parameter.error }
}

impl Estimate {
    /// Of what is not known.
    pub const NAN: Self = Self { value: f64::NAN, error: f64::NAN };

    /// The quotient.
    pub fn over(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self { value, error: (self.error + value.abs() * other.error) / other.value.abs() }
    }

    /// Times a number that is known.
    pub fn times(self, factor: f64) -> Self {
        Self { value: factor * self.value, error: factor.abs() * self.error }
    }

    /// The sum.
    pub fn plus(self, other: Self) -> Self {
        Self { value: self.value + other.value, error: self.error + other.error }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// e^(3x) and a sum that cancels: errors are as estimated or less.
    #[test]
    fn differences_hold_their_bounds() {
        let found = Change::between(STEPS.map(|k| (3.0 * k * STEP).exp()), 1.0).estimate();
        assert!((found.value - 3.0).abs() <= found.error && found.error < 1e-10, "{found:?}");
        let found = Change::between(STEPS.map(|k| 1e6 + (k * STEP).sin() - 1e6), 1e6).estimate();
        assert!((found.value - 1.0).abs() <= found.error && found.error < 1e-5, "{found:?}");
        let found = along_path(ALONG.map(|k| (1.0 + 0.01 * k).ln()), 0.01);
        assert!((found.value - 1.0).abs() <= found.error && found.error < 1e-6, "{found:?}");
    }

    #[test]
    fn errors_of_quotients_add_up() {
        let (one, other) = (Estimate { value: 2.0, error: 0.1 }, Estimate { value: -4.0, error: 0.2 });
        let found = one.over(other);
        assert!((found.value + 0.5).abs() < 1e-15 && (found.error - 0.05).abs() < 1e-15, "{found:?}");
    }
}
