//! A file that only grows, while something is computed.

use crate::file::replace;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// A file to whose end is written. Where it was removed meanwhile it is written again, whole: what it held is still read through its handle.
#[derive(Debug)]
pub(super) struct GrowingFile {
    path: PathBuf,
    file: File,
}

impl GrowingFile {
    /// Opens the file, or makes it and its folder; what stands behind so many bytes is cut off.
    pub fn open(path: &Path, length: u64) -> io::Result<Self> {
        path.parent().map_or(Ok(()), fs::create_dir_all)?;
        let file = reopened(path)?;
        file.set_len(length)?;
        Ok(Self { path: path.to_path_buf(), file })
    }

    /// Writes to its end.
    pub fn append(&mut self, bytes: &[u8]) -> io::Result<()> {
        if !self.path.exists() {
            self.restore()?;
        }
        self.file.write_all(bytes)
    }

    fn restore(&mut self) -> io::Result<()> {
        let mut held = Vec::new();
        self.file.seek(SeekFrom::Start(0))?;
        self.file.read_to_end(&mut held)?;
        replace(&self.path, &held)?;
        self.file = reopened(&self.path)?;
        Ok(())
    }
}

fn reopened(path: &Path) -> io::Result<File> {
    OpenOptions::new().create(true).read(true).append(true).open(path)
}
