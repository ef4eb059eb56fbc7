//! A table in CSV, written whole or not at all.

use crate::error::ReportError;
use crate::file::write_whole;
use serde::Serialize;
use std::io;
use std::path::{Path, PathBuf};

/// Writes `dir/name`: a header, the names of the fields of a line, and the lines.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_table<T: Serialize + Default>(
    dir: &Path,
    name: &str,
    lines: impl Iterator<Item = T>,
) -> Result<PathBuf, ReportError> {
    let path = dir.join(name);
    let text = table_like(T::default(), lines).map_err(|source| ReportError::Write { path: path.clone(), source })?;
    write_whole(&path, &text)?;
    Ok(path)
}

/// The lines below a header, the names of the fields of `sample`; the header alone where there are none.
pub(super) fn table_like<T: Serialize>(sample: impl Serialize, lines: impl Iterator<Item = T>) -> io::Result<Vec<u8>> {
    let mut header = csv::Writer::from_writer(Vec::new());
    header.serialize(sample)?;
    let mut text = header.into_inner().map_err(|error| error.into_error())?;
    let header_length = text.iter().position(|&byte| byte == b'\n').map_or(0, |end| end + 1);
    text.truncate(header_length);

    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(text);
    for line in lines {
        writer.serialize(line)?;
    }
    writer.into_inner().map_err(|error| error.into_error())
}
