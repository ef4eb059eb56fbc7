//! By which power of each parameter the results change.

use crate::text_summary::number::with_error;
use peelkit::study::Exponent;

/// A line a number and parameter, largest first; numbers whose exponents are those of another one stand with it.
pub fn sensitivities(exponents: &[Exponent], keys: &[String], refused: &[(String, String)]) -> String {
    let mut text = "d ln Q / d ln p, by which power of a parameter p a result Q changes\n".to_owned();
    let mut groups: Vec<(Vec<&str>, &[Exponent])> = Vec::new();
    for group in exponents.chunk_by(|a, b| a.of == b.of) {
        let same = |other: &[Exponent]| {
            other.len() == group.len()
                && other.iter().zip(group).all(|(a, b)| (a.variation, a.value) == (b.variation, b.value))
        };
        match groups.iter_mut().find(|(_, other)| same(other)) {
            Some((names, _)) => names.push(group[0].of.name()),
            None => groups.push((vec![group[0].of.name()], group)),
        }
    }
    let width = keys.iter().map(String::len).max().unwrap_or(0);
    for (names, group) in groups {
        text += &format!("\n  {}\n", names.join(", "));
        for exponent in group {
            let key = &keys[exponent.variation];
            text += &format!("    {key:<width$}  {}\n", signed(exponent.value, exponent.error));
        }
    }
    for (key, why) in refused {
        text += &format!("\n  not by {key}: {why}\n");
    }
    text
}

/// With its sign, where that is certain.
fn signed(value: f64, error: f64) -> String {
    let text = with_error(value, error);
    match value.abs() > error {
        true if value > 0.0 => format!("+{text}"),
        true => text,
        false => format!(" {}", text.trim_start_matches('-')),
    }
}
