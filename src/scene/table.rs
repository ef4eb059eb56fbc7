//! The table of a profile: in the scene, or in a file beside it.

use super::error::one_line;
use crate::model::ProfileTable;
use std::fs;
use std::path::Path;

/// Largest file that is read, bytes.
const LARGEST: u64 = 1 << 20;

/// Reads a table from a CSV of several lines, or from the file that a text of one line names, beside the scene `name`. The error
/// says what was found.
pub(super) fn read_table(name: &str, text: &str) -> Result<ProfileTable, String> {
    if text.contains('\n') {
        return ProfileTable::parse(text).map_err(|error| error.to_string());
    }
    let path = Path::new(name).parent().unwrap_or(Path::new("")).join(text);
    let shown = one_line(&path.display().to_string());
    let told = fs::metadata(&path).map_err(|error| format!("names the file {shown}, which cannot be read: {error}"))?;
    if !told.is_file() || told.len() > LARGEST {
        return Err(format!("names {shown}, which is no file of at most {LARGEST} bytes"));
    }
    let text =
        fs::read_to_string(&path).map_err(|error| format!("names the file {shown}, which cannot be read: {error}"))?;
    ProfileTable::parse(&text).map_err(|error| format!("names the file {shown}, which {error}"))
}
