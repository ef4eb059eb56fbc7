//! What is said of a text that is not TOML, and where.

use super::error::{Origin, SceneError, ValueError, one_line};
use super::value::quantity::Comma;
use std::ops::Range;

/// Behind the last character of a text.
pub(crate) fn end_of(text: &str) -> Range<usize> {
    let end = text.trim_end().len();
    end..end
}

pub(crate) fn not_toml(file: &Origin, text: &str, error: &toml::de::Error) -> SceneError {
    let span = error.span().unwrap_or_else(|| end_of(text));
    let reason = error.message().lines().collect::<Vec<_>>().join("; ");
    let general = "A scene is a TOML file: [table] on a line of its own, below it key = value; \
                   texts and quantities are in quotes: length = \"100 nm\". `peel new` writes a template.";
    let comma = value_on_line(text, span.start).and_then(Comma::find);
    let remedy = match comma {
        Some(comma) => format!("A number has a decimal point: {}. {general}", one_line(&comma.decimal)),
        None => general.to_owned(),
    };
    file.error(span.clone(), &key_on_line(text, span.start), ValueError::new(format!("is not TOML: {reason}"), remedy))
}

/// The key that stands on the line of this place in a text that is not TOML, or "this".
fn key_on_line(text: &str, at: usize) -> String {
    let key = entry_on_line(text, at).map_or("", |(key, _)| key.trim());
    let is_key = !key.is_empty() && key.chars().all(|c| c.is_alphanumeric() || "._-".contains(c));
    if is_key { format!("`{}`", one_line(key)) } else { "this".to_owned() }
}

/// What stands behind the key on the line of this place.
fn value_on_line(text: &str, at: usize) -> Option<&str> {
    entry_on_line(text, at).map(|(_, value)| value.trim())
}

/// What stands before and behind the sign of equality on the line of this place.
fn entry_on_line(text: &str, at: usize) -> Option<(&str, &str)> {
    let start = text.as_bytes()[..at.min(text.len())].iter().rposition(|&byte| byte == b'\n').map_or(0, |end| end + 1);
    text.get(start..)?.lines().next()?.split_once('=')
}
