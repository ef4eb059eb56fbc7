//! Numbers with their units, and lines in two columns, as a person reads them.

use std::fmt::Write;

/// " nm", or nothing where there is no unit.
pub fn spaced(unit: &str) -> String {
    if unit.is_empty() { String::new() } else { format!(" {unit}") }
}

/// ", in nm", or nothing where there is no unit.
pub(super) fn in_unit(unit: &str) -> String {
    if unit.is_empty() { String::new() } else { format!(", in {unit}") }
}

/// As many decimals as the error leaves, and the error.
pub(super) fn with_error(value: f64, error: f64) -> String {
    if !(error > 0.0 && error.is_finite()) {
        return format!("{value}");
    }
    let decimals = (-error.log10().floor()).clamp(0.0, 15.0) as usize;
    format!("{value:.decimals$} ± {error:.0e}")
}

/// Six digits are enough to recognise a value.
pub(super) fn short(value: f64) -> String {
    if value == 0.0 || (1e-3..1e6).contains(&value.abs()) {
        let decimals = (5.0 - value.abs().max(1e-3).log10().floor()).clamp(0.0, 9.0) as usize;
        let text = format!("{value:.decimals$}");
        if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
    } else {
        format!("{value:.5e}")
    }
}

/// A title and the lines below it. A line without a name goes on with the one before.
pub(super) fn in_columns(title: &str, lines: &[(&str, String)]) -> String {
    let mut text = format!("{title}\n\n");
    for (name, value) in lines {
        let _ = writeln!(text, "  {name:<18} {value}");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_end_where_the_error_begins() {
        assert_eq!(with_error(0.341121483196, 3e-8), "0.34112148 ± 3e-8");
        assert_eq!(with_error(48.2156178228, 0.02), "48.22 ± 2e-2");
        assert_eq!(with_error(48.2156178228, 2.0), "48 ± 2e0");
        assert_eq!(with_error(0.5, 0.0), "0.5");
        assert_eq!(with_error(0.5, f64::NAN), "0.5");
    }

    #[test]
    fn values_of_a_sweep_are_short() {
        assert_eq!(short(100.0), "100");
        assert_eq!(short(0.4), "0.4");
        assert_eq!(short(1e-4), "1.00000e-4");
        assert_eq!(short(1.0 / 3.0), "0.333333");
    }
}
