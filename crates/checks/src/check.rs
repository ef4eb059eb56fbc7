//! One line of the verification suite.

use peelkit::study::PathEnd;
use serde::Serialize;

/// How a computed value is held against an expected one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Measure {
    /// |computed - expected| / |expected| ≤ tolerance
    Relative,
    /// |computed - expected| ≤ tolerance
    Absolute,
    /// expected - computed ≤ tolerance
    AtLeast,
    /// computed - expected ≤ tolerance
    AtMost,
}

/// A computed value against an expected one.
#[derive(Clone, Debug, Serialize)]
pub struct Check {
    /// Name of the topic that reports it; empty in a check by itself.
    pub topic: &'static str,
    /// What is computed, with its parameters and its unit.
    pub name: String,
    /// Where the expected value comes from, to the equation.
    pub source: String,
    /// Absent where the computation failed; `failure` says why.
    pub computed: Option<f64>,
    /// Why there is no computed value.
    pub failure: Option<String>,
    /// In the unit that the name says.
    pub expected: f64,
    /// How both are compared.
    pub measure: Measure,
    /// Largest difference that passes, as the measure counts.
    pub tolerance: f64,
}

impl Check {
    /// A check of a value that may have failed to be computed.
    pub fn new(
        name: impl Into<String>,
        source: impl Into<String>,
        computed: Result<f64, String>,
        expected: f64,
        measure: Measure,
        tolerance: f64,
    ) -> Self {
        let computed = computed.and_then(|x| if x.is_finite() { Ok(x) } else { Err(format!("the result is {x}")) });
        let (computed, failure) = match computed {
            Ok(value) => (Some(value), None),
            Err(reason) => (None, Some(reason)),
        };
        Self { topic: "", name: name.into(), source: source.into(), computed, failure, expected, measure, tolerance }
    }

    /// How far the computed value lies on the wrong side of the expected one, as its measure counts.
    pub fn difference(&self) -> Option<f64> {
        let off = self.computed? - self.expected;
        Some(match self.measure {
            Measure::Relative => (off / self.expected).abs(),
            Measure::Absolute => off.abs(),
            Measure::AtLeast => (-off).max(0.0),
            Measure::AtMost => off.max(0.0),
        })
    }

    /// Whether the difference is within the tolerance.
    pub fn passes(&self) -> bool {
        self.difference().is_some_and(|difference| difference <= self.tolerance)
    }
}

/// Why a path that ended so does not have what was looked for.
pub(super) fn missing(end: &PathEnd) -> String {
    match end {
        PathEnd::Failed(why) => why.to_string(),
        end => format!("not found before the path ended ({end:?})"),
    }
}

/// A named group of checks.
#[derive(Clone, Copy)]
pub struct Topic {
    /// The word after `--only`.
    pub name: &'static str,
    /// What is checked, in half a line.
    pub about: &'static str,
    /// Computes them.
    pub checks: fn() -> Vec<Check>,
}

impl Topic {
    /// Computes the checks, under the name of the topic.
    pub fn run(&self) -> Vec<Check> {
        under(self.name, (self.checks)())
    }
}

/// The checks, reported under the name of a topic.
pub(super) fn under(topic: &'static str, checks: Vec<Check>) -> Vec<Check> {
    checks.into_iter().map(|check| Check { topic, ..check }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(computed: f64, expected: f64, measure: Measure, tolerance: f64) -> Check {
        Check::new("n", "s", Ok(computed), expected, measure, tolerance)
    }

    #[test]
    fn each_measure_passes_and_fails() {
        assert!(check(2.0, 2.1, Measure::Relative, 0.05).passes());
        assert!(!check(2.0, 2.1, Measure::Relative, 0.04).passes());
        assert!(check(2.0, 2.1, Measure::Absolute, 0.11).passes());
        assert!(!check(2.0, 2.1, Measure::Absolute, 0.09).passes());
        assert!(check(1.0, 0.99, Measure::AtLeast, 0.0).passes());
        assert!(!check(0.98, 0.99, Measure::AtLeast, 0.0).passes());
        assert!(check(3.0, 20.0, Measure::AtMost, 0.0).passes());
        assert!(!check(21.0, 20.0, Measure::AtMost, 0.0).passes());
    }

    #[test]
    fn what_was_not_computed_fails_and_says_why() {
        let nan = check(f64::NAN, 1.0, Measure::AtMost, 1e9);
        assert!(!nan.passes() && nan.failure.is_some());
        let failed = Check::new("n", "s", Err("no peak".into()), 1.0, Measure::AtLeast, 1e9);
        assert!(!failed.passes() && failed.computed.is_none());
        // a NaN tolerance or expectation lets nothing through
        assert!(!check(1.0, f64::NAN, Measure::Absolute, 1.0).passes());
        assert!(!check(1.0, 1.0, Measure::Absolute, f64::NAN).passes());
    }
}
