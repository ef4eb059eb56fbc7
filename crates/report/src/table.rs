//! A table in CSV, written whole or not at all.

use super::error::ReportError;
use super::file::write_whole;
use super::record::{Record, columns, csv};
use std::io;
use std::path::{Path, PathBuf};

/// Writes `dir/name`: a header, the keys of the record, and a row a record.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_table<R: Record>(
    dir: &Path,
    name: &str,
    rows: impl IntoIterator<Item = R>,
) -> Result<PathBuf, ReportError> {
    write_text(dir, name, table(rows))
}

/// The text of such a table.
pub(crate) fn table<R: Record>(rows: impl IntoIterator<Item = R>) -> io::Result<Vec<u8>> {
    csv(&columns::<R>(), rows.into_iter().map(|row| row.object()))
}

/// Writes this text, and says where it stands.
pub(crate) fn write_text(dir: &Path, name: &str, text: io::Result<Vec<u8>>) -> Result<PathBuf, ReportError> {
    let path = dir.join(name);
    let text = text.map_err(|source| ReportError::Write { path: path.clone(), source })?;
    write_whole(&path, &text)?;
    Ok(path)
}
