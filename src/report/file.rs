//! Writing a file so that nobody ever finds it half-written.

use super::ReportError;
use std::fs;
use std::path::{Path, PathBuf};

/// Writes `dir/name`, making the folder where it is missing: beside it first, then renamed. Gives the path.
pub fn write_file(dir: &Path, name: &str, content: &[u8]) -> Result<PathBuf, ReportError> {
    let path = dir.join(name);
    let part = dir.join(format!(".{name}.{}.part", std::process::id()));
    let written =
        fs::create_dir_all(dir).and_then(|()| fs::write(&part, content)).and_then(|()| fs::rename(&part, &path));
    match written {
        Ok(()) => Ok(path),
        Err(source) => {
            // The error is told; that the rest of a failed attempt may stay is not worth a second one.
            let _ = fs::remove_file(&part);
            Err(ReportError::Write { path, source })
        }
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
            let path = write_file(&inner, "x.csv", content.as_bytes()).unwrap();
            assert_eq!(fs::read_to_string(path).unwrap(), content);
        }
        assert_eq!(fs::read_dir(&inner).unwrap().count(), 1);
    }

    #[test]
    fn a_folder_that_is_a_file_is_an_error_with_its_path() {
        let dir = tempfile::tempdir().unwrap();
        let blocked = dir.path().join("blocked");
        fs::write(&blocked, "").unwrap();
        let error = write_file(&blocked, "x.csv", b"").unwrap_err();
        assert!(error.to_string().contains("blocked"), "{error}");
    }
}
