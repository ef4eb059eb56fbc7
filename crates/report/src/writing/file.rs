//! Writing a file so that nobody ever finds it half-written, and reading one that may be anything.

use crate::writing::error::ReportError;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// Writes a file beside its place and then renames it; makes the folder where it is missing.
///
/// Fails with [`ReportError::Write`]; what stood there before is untouched then.
pub fn write_whole(path: &Path, content: &[u8]) -> Result<(), ReportError> {
    replace(path, content).map_err(|source| ReportError::Write { path: path.to_path_buf(), source })
}

/// The same, with the error of the system.
pub(crate) fn replace(path: &Path, content: &[u8]) -> io::Result<()> {
    let dir = path.parent().unwrap_or(Path::new(""));
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let part = dir.join(format!(".{name}.{}.part", std::process::id()));
    let written =
        fs::create_dir_all(dir).and_then(|()| fs::write(&part, content)).and_then(|()| fs::rename(&part, path));
    // The error is reported; what a failed attempt may leave behind is not worth a second one.
    written.inspect_err(|_| drop(fs::remove_file(&part)))
}

/// Largest file of a user that is read, bytes.
const LARGEST: u64 = 64 << 20;

/// Reads a file that a user names. What is no file, as a pipe or a device, and what is larger than 64 MiB is refused before it is opened.
pub(crate) fn read_whole(path: &Path) -> io::Result<Vec<u8>> {
    let metadata = fs::metadata(path)?;
    if !metadata.is_file() || metadata.len() > LARGEST {
        return Err(io::Error::other(format!("it is no file of at most {LARGEST} bytes")));
    }
    fs::read(path)
}

/// Removes a file, if it is there.
pub(crate) fn remove(path: PathBuf) -> Result<(), ReportError> {
    match fs::remove_file(&path) {
        Err(source) if source.kind() != ErrorKind::NotFound => Err(ReportError::Write { path, source }),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn replaces_a_file_and_leaves_nothing_beside_it() {
        let dir = tempfile::tempdir().unwrap();
        let inner = dir.path().join("a/b");
        for content in ["first", "second"] {
            write_whole(&inner.join("x.csv"), content.as_bytes()).unwrap();
            assert_eq!(fs::read_to_string(inner.join("x.csv")).unwrap(), content);
        }
        assert_eq!(fs::read_dir(&inner).unwrap().count(), 1);
    }

    #[test]
    fn a_folder_that_is_a_file_is_an_error_with_its_path() {
        let dir = tempfile::tempdir().unwrap();
        let blocked = dir.path().join("blocked");
        fs::write(&blocked, "").unwrap();
        let error = write_whole(&blocked.join("x.csv"), b"").unwrap_err();
        assert!(error.to_string().contains("blocked"), "{error}");
    }
}
