//! Two columns: what a thing is called, and what was found.

use std::fmt::Write;

/// A title and the lines below it. A line without a name goes on with the one before.
pub(super) fn in_columns(title: &str, lines: &[(&str, String)]) -> String {
    let mut text = format!("{title}\n\n");
    for (name, value) in lines {
        let _ = writeln!(text, "  {name:<18} {value}");
    }
    text
}
