//! A file of lines that grows while something is computed: a first line that says of what, then a line a result, in no order.

use crate::error::ReportError;
use crate::file::write_whole;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::marker::PhantomData;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// The file of something that is not finished.
#[derive(Debug)]
pub(super) struct Lines<T> {
    path: PathBuf,
    file: Mutex<File>,
    of: PhantomData<fn(T)>,
}

impl<T: Serialize + DeserializeOwned + PartialEq> Lines<T> {
    /// Opens the file, or begins it, and gives what it holds behind this first line. A file with another first line is refused by `other`.
    ///
    /// Fails with that, with [`ReportError::Read`] or with [`ReportError::Write`].
    pub fn open(
        path: &Path,
        header: &impl Serialize,
        other: impl FnOnce(PathBuf) -> ReportError,
    ) -> Result<(Self, Vec<T>), ReportError> {
        let refuse = |source: io::Error| ReportError::Write { path: path.to_path_buf(), source };
        let header = text_line(header).map_err(refuse)?;
        let old = match fs::read(path) {
            Err(error) if error.kind() == ErrorKind::NotFound => Vec::new(),
            read => read.map_err(|source| ReportError::Read { path: path.to_path_buf(), source })?,
        };
        let lines = match old.strip_prefix(header.as_slice()) {
            Some(kept) => read_lines(kept),
            None if old.is_empty() => Vec::new(),
            None => return Err(other(path.to_path_buf())),
        };
        // Written anew, so that what comes next does not continue a torn line, and whole or not at all.
        let mut text = header;
        for line in &lines {
            text.extend(text_line(line).map_err(refuse)?);
        }
        write_whole(path, &text)?;
        let file = OpenOptions::new().append(true).open(path).map_err(refuse)?;
        Ok((Self { path: path.to_path_buf(), file: Mutex::new(file), of: PhantomData }, lines))
    }

    /// Appends a line, at once and from any thread.
    ///
    /// Fails with [`ReportError::Write`].
    pub fn keep(&self, line: &T) -> Result<(), ReportError> {
        let refuse = |source: io::Error| ReportError::Write { path: self.path.clone(), source };
        let text = text_line(line).map_err(refuse)?;
        // What would not come back as it is, such as a NaN, is computed again.
        if read_lines::<T>(&text).as_slice() != std::slice::from_ref(line) {
            return Ok(());
        }
        let mut file = self.file.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        file.write_all(&text).map_err(refuse)
    }
}

pub(super) fn text_line<T: Serialize>(line: &T) -> io::Result<Vec<u8>> {
    let mut text = serde_json::to_vec(line)?;
    text.push(b'\n');
    Ok(text)
}

/// The lines that can be read: one that was torn when its run was killed is left out.
pub(super) fn read_lines<T: DeserializeOwned>(text: &[u8]) -> Vec<T> {
    text.split(|&byte| byte == b'\n').filter_map(|line| serde_json::from_slice(line).ok()).collect()
}
