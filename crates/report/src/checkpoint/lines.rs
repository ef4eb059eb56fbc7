//! A file of lines that grows while something is computed: a first line that says of what, then a line a result, in no order. Each of these is an array
//! of JSON, `["1f2e3d4c", RESULT]`: the check sum of the text of the result, and the result.

use super::damaged::{Damaged, check_sum};
use super::growing_file::GrowingFile;
use crate::error::ReportError;
use crate::file::write_whole;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::fs;
use std::io::{self, ErrorKind};
use std::marker::PhantomData;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// The file of something that is not finished.
#[derive(Debug)]
pub(super) struct Lines<T> {
    path: PathBuf,
    file: Mutex<GrowingFile>,
    damaged: Option<Damaged>,
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
        let header = first_line(header).map_err(refuse)?;
        let old = match fs::read(path) {
            Err(error) if error.kind() == ErrorKind::NotFound => Vec::new(),
            read => read.map_err(|source| ReportError::Read { path: path.to_path_buf(), source })?,
        };
        let (lines, damaged) = match old.strip_prefix(header.as_slice()) {
            Some(kept) => read_lines(kept),
            None if old.is_empty() => (Vec::new(), Vec::new()),
            None => return Err(other(path.to_path_buf())),
        };
        // Written anew, so that what comes next does not continue a torn line, and whole or not at all.
        let mut text = header;
        for line in &lines {
            text.extend(result_line(line).map_err(refuse)?);
        }
        write_whole(path, &text)?;
        let file = GrowingFile::open(path, text.len() as u64).map_err(refuse)?;
        let damaged = Damaged::lines(path, damaged);
        Ok((Self { path: path.to_path_buf(), file: Mutex::new(file), damaged, of: PhantomData }, lines))
    }

    /// The lines that were not as they had been written, and are left out.
    pub fn damaged(&self) -> Option<&Damaged> {
        self.damaged.as_ref()
    }

    /// Appends a line, at once and from any thread.
    ///
    /// Fails with [`ReportError::Write`].
    pub fn keep(&self, line: &T) -> Result<(), ReportError> {
        let refuse = |source: io::Error| ReportError::Write { path: self.path.clone(), source };
        let text = result_line(line).map_err(refuse)?;
        // What would not come back as it is, such as a NaN, is computed again.
        if read_lines::<T>(&text).0.as_slice() != std::slice::from_ref(line) {
            return Ok(());
        }
        let mut file = self.file.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        file.append(&text).map_err(refuse)
    }
}

/// The line that says of what the others are: it is compared, byte by byte.
pub(super) fn first_line(header: &impl Serialize) -> io::Result<Vec<u8>> {
    let mut text = serde_json::to_vec(header)?;
    text.push(b'\n');
    Ok(text)
}

/// A result with its check sum.
pub(super) fn result_line(result: &impl Serialize) -> io::Result<Vec<u8>> {
    let result = serde_json::to_vec(result)?;
    let mut text = format!("[\"{:08x}\",", check_sum(&result)).into_bytes();
    text.extend(result);
    text.extend(b"]\n");
    Ok(text)
}

/// The results of a text behind its first line, and the numbers, counted from 1 with that, of lines that are not as they were written. A last one
/// without an end was torn when its run was killed, and is left out without a word.
pub(super) fn read_lines<T: DeserializeOwned>(text: &[u8]) -> (Vec<T>, Vec<usize>) {
    let (mut lines, mut damaged) = (Vec::new(), Vec::new());
    for (index, line) in text.split_inclusive(|&byte| byte == b'\n').enumerate() {
        let Some(line) = line.strip_suffix(b"\n") else { break };
        match result_of(line) {
            Some(result) => lines.push(result),
            None => damaged.push(index + 2),
        }
    }
    (lines, damaged)
}

fn result_of<T: DeserializeOwned>(line: &[u8]) -> Option<T> {
    let (sum, result) = line.strip_prefix(b"[\"")?.split_at_checked(8)?;
    let result = result.strip_prefix(b"\",")?.strip_suffix(b"]")?;
    let sum = u32::from_str_radix(std::str::from_utf8(sum).ok()?, 16).ok()?;
    (check_sum(result) == sum).then(|| serde_json::from_slice(result).ok()).flatten()
}

#[cfg(test)]
mod tests {
    use super::super::damaged::DamagedPart;
    use super::*;

    fn open(path: &Path) -> (Lines<[f64; 2]>, Vec<[f64; 2]>) {
        Lines::open(path, &"header", |path| ReportError::Exists { path }).unwrap()
    }

    fn kept(dir: &Path) -> PathBuf {
        let path = dir.join("out/x.partial.jsonl");
        let (lines, _) = open(&path);
        [[1.0, 0.25], [2.0, 0.5], [3.0, 0.75]].iter().for_each(|line| lines.keep(line).unwrap());
        path
    }

    #[test]
    fn a_line_with_one_changed_digit_is_named_and_left_out() {
        let dir = tempfile::tempdir().unwrap();
        let path = kept(dir.path());
        let whole = fs::read_to_string(&path).unwrap();
        for (from, to) in
            [("[2.0,0.5]", "[2.0,0.6]"), ("[2.0,0.5]", "[2.0;0.5]"), ("\",[2", "0\",[2"), ("\n[\"", "\n{\"")]
        {
            fs::write(&path, whole.replacen(from, to, if from.starts_with('\n') { 2 } else { 1 })).unwrap();
            let (lines, found) = open(&path);
            let what = lines.damaged().map(|damaged| damaged.what.clone());
            let several = from.starts_with('\n');
            let (expected, left): (Vec<usize>, &[[f64; 2]]) =
                if several { (vec![2, 3], &[[3.0, 0.75]]) } else { (vec![3], &[[1.0, 0.25], [3.0, 0.75]]) };
            assert_eq!((what, found.as_slice()), (Some(DamagedPart::Lines(expected)), left), "{to}");
        }
        assert!(open(&path).0.damaged().is_none(), "what was left out is gone");
    }

    #[test]
    fn lines_of_a_version_without_check_sums_are_computed_again() {
        let dir = tempfile::tempdir().unwrap();
        let path = kept(dir.path());
        fs::write(&path, "\"header\"\n[1.0,0.25]\n").unwrap();
        let (lines, found) = open(&path);
        assert_eq!((lines.damaged().unwrap().what.clone(), found.len()), (DamagedPart::Lines(vec![2]), 0));
    }

    #[test]
    fn a_file_whose_folder_is_removed_meanwhile_is_written_again_with_all_lines() {
        let dir = tempfile::tempdir().unwrap();
        let path = kept(dir.path());
        let (lines, _) = open(&path);
        for line in [[4.0, 0.0], [5.0, 0.0]] {
            fs::remove_dir_all(dir.path().join("out")).unwrap();
            lines.keep(&line).unwrap();
        }
        assert_eq!(open(&path).1.len(), 5);
    }
}
