//! The verification suite as a user reads it: one line a check, or one JSON object.

use crate::check::{Check, Measure};
use peelkit_report::to_json;
use serde::Serialize;

/// One check as text: pass or FAIL, topic, name, both values, difference, tolerance, source.
pub fn check_line(check: &Check) -> String {
    let word = if check.passes() { "pass" } else { "FAIL" };
    let (difference, tolerance) = (check.difference(), check.tolerance);
    let difference = difference.map_or("-".to_owned(), |difference| format!("{difference:.1e}"));
    let computed = match (&check.failure, check.computed) {
        (Some(reason), _) => format!("not computed: {reason}"),
        (None, computed) => computed.map_or_else(String::new, digits),
    };
    let (expects, counts) = match check.measure {
        Measure::Relative => ("expected", "relative"),
        Measure::Absolute => ("expected", "absolute"),
        Measure::AtLeast => ("at least", "below"),
        Measure::AtMost => ("at most", "above"),
    };
    format!(
        "{word}  {}: {} | computed {computed} | {expects} {} | difference {difference} {counts} | tolerance {tolerance:.1e} | {}",
        check.topic,
        check.name,
        digits(check.expected),
        check.source
    )
}

/// Every check as one JSON object: `passed`, `failed` and `checks`.
///
/// An error names the key that could not be written.
pub fn checks_json(checks: &[Check]) -> std::io::Result<String> {
    #[derive(Serialize)]
    struct Line<'a> {
        #[serde(flatten)]
        check: &'a Check,
        difference: Option<f64>,
        pass: bool,
    }
    #[derive(Serialize)]
    struct Suite<'a> {
        passed: usize,
        failed: usize,
        checks: Vec<Line<'a>>,
    }
    let passed = checks.iter().filter(|check| check.passes()).count();
    let line = |check| Line { check, difference: check.difference(), pass: check.passes() };
    let suite = Suite { passed, failed: checks.len() - passed, checks: checks.iter().map(line).collect() };
    to_json(&suite)
}

/// Ten significant digits, without a power of ten where the number is neither large nor small.
fn digits(value: f64) -> String {
    let size = value.abs();
    if value != 0.0 && !(1e-3..1e6).contains(&size) {
        return format!("{value:.9e}");
    }
    let before = if size < 1.0 { 0 } else { size.log10() as usize };
    format!("{value:.*}", 9 - before)
}
