//! The table of a beam or of a substrate: in the scene, or in a file beside it.

use super::error::one_line;
use crate::adhesion::Heights;
use crate::model::ProfileTable;
use std::fmt::Display;
use std::fs;
use std::path::Path;

/// Largest file that is read, bytes.
const LARGEST: u64 = 1 << 20;

/// Reads the outline of a beam.
pub(super) fn read_table(name: &str, text: &str) -> Result<ProfileTable, String> {
    read(name, text, ProfileTable::parse)
}

/// Reads the heights of a substrate.
pub(super) fn read_heights(name: &str, text: &str) -> Result<Heights, String> {
    read(name, text, Heights::parse)
}

/// Reads a table from a CSV of several lines, or from the file that a text of one line names, beside the scene `name`. The error
/// says what was found.
fn read<T, E: Display>(name: &str, text: &str, parse: fn(&str) -> Result<T, E>) -> Result<T, String> {
    if text.contains('\n') {
        return parse(text).map_err(|error| error.to_string());
    }
    let path = Path::new(name).parent().unwrap_or(Path::new("")).join(text);
    let shown = one_line(&path.display().to_string());
    let told = fs::metadata(&path).map_err(|error| format!("names the file {shown}, which cannot be read: {error}"))?;
    if !told.is_file() || told.len() > LARGEST {
        return Err(format!("names {shown}, which is no file of at most {LARGEST} bytes"));
    }
    let text =
        fs::read_to_string(&path).map_err(|error| format!("names the file {shown}, which cannot be read: {error}"))?;
    parse(&text).map_err(|error| format!("names the file {shown}, which {error}"))
}
