//! The folder of a command's outputs: all of its files appear together, or none does.

mod lock;

use crate::checkpoint::kind::JournalKind;
use crate::writing::error::ReportError;
use lock::{FolderLock, NotLocked};
use std::env;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// What becomes of a folder that holds something.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Existing {
    /// It is left as it is, and nothing is written.
    Keep,
    /// Files of the same names are replaced, one by one, and all others stay.
    Replace,
}

/// A folder that may be written to. Its files are written to a hidden folder, `.NAME.PID.part` beside it, which takes its
/// name once all of them are there. Where the folder exists and cannot be replaced as a whole, because it holds something,
/// is the working directory, or its parent is closed or on another disk, the hidden folder lies in it and the files are moved.
#[derive(Debug)]
pub struct OutputFolder {
    /// As the user named it.
    name: PathBuf,
    /// Where that is.
    place: PathBuf,
    existing: Existing,
    /// How an unfinished command keeps a file in it, if it does.
    journal: Option<JournalKind>,
    /// Nobody else writes there as long as this is held.
    _lock: Option<FolderLock>,
}

impl OutputFolder {
    /// Refuses a folder that must not be written to, or cannot be, or to which another process writes; to be asked before anything is computed. Of a
    /// command with such a journal a folder that holds one is to go on with.
    ///
    /// Fails with [`ReportError::Exists`], [`ReportError::InUse`] or [`ReportError::Write`].
    pub fn claim(name: &Path, existing: Existing, journal: Option<JournalKind>) -> Result<Self, ReportError> {
        let refuse = |source: io::Error| ReportError::Write { path: name.to_path_buf(), source };
        let place = whereabouts(name).map_err(refuse)?;
        let lock = FolderLock::take(&place).map_err(|error| match error {
            NotLocked::InUse(process) => ReportError::InUse { path: name.to_path_buf(), process },
            NotLocked::System(source) => refuse(source),
        })?;
        let goes_on = journal.is_some_and(|journal| journal.is_in(&place));
        let existing = if goes_on { Existing::Replace } else { existing };
        let folder = Self { name: name.to_path_buf(), place, existing, journal, _lock: lock };
        folder.refuse_full()?;
        staging(&folder.place).map_err(refuse)?;
        Ok(folder)
    }

    /// Has `write` put files into the folder that it is given, and then shows them all under the name of this one: the
    /// paths that it returns, and those in its error, are reported as of there. A folder that was removed since it was claimed is made again.
    ///
    /// Fails as `write` does, or with [`ReportError::Exists`] or [`ReportError::Write`]; nothing new is shown then.
    pub fn write(
        &self,
        write: impl FnOnce(&Path) -> Result<Vec<PathBuf>, ReportError>,
    ) -> Result<Vec<PathBuf>, ReportError> {
        let above = self.place.parent().map_or(Ok(()), fs::create_dir_all);
        let staging = above.and_then(|()| staging(&self.place)).and_then(|staging| fresh(&staging).map(|()| staging));
        let staging = staging.map_err(|source| ReportError::Write { path: self.name.clone(), source })?;
        let written = write(&staging).and_then(|files| self.show(&staging, &files));
        // Gone if all went well; what a failed attempt may leave behind is not worth a second error.
        let _ = fs::remove_dir_all(&staging);
        written.map_err(|error| error.with_path(|path| self.named(&staging, path)))
    }

    /// Another program may have filled the folder since it was claimed.
    fn refuse_full(&self) -> Result<(), ReportError> {
        let full = holds_something(&self.place, self.journal);
        let full = full.map_err(|source| ReportError::Write { path: self.name.clone(), source })?;
        match self.existing {
            Existing::Keep if full => Err(ReportError::Exists { path: self.name.clone() }),
            _ => Ok(()),
        }
    }

    fn show(&self, staging: &Path, files: &[PathBuf]) -> Result<Vec<PathBuf>, ReportError> {
        self.refuse_full()?;
        let beside = staging.parent() == self.place.parent();
        if !(beside && fs::rename(staging, &self.place).is_ok()) {
            files.iter().try_for_each(|file| self.move_in(staging, file))?;
        }
        Ok(files.iter().map(|file| self.named(staging, file)).collect())
    }

    fn move_in(&self, staging: &Path, file: &Path) -> Result<(), ReportError> {
        let to = self.place.join(file.strip_prefix(staging).unwrap_or(file));
        let inner = to.parent().map_or(Ok(()), fs::create_dir_all);
        inner
            .and_then(|()| fs::rename(file, &to))
            .map_err(|source| ReportError::Write { path: file.to_path_buf(), source })
    }

    /// A file of the hidden folder under the name that it gets.
    fn named(&self, staging: &Path, path: &Path) -> PathBuf {
        path.strip_prefix(staging).map_or_else(|_| path.to_path_buf(), |inner| self.name.join(inner))
    }
}

/// Where a folder is or would be, as a path that ends in its name.
fn whereabouts(name: &Path) -> io::Result<PathBuf> {
    match fs::canonicalize(name) {
        Ok(place) if place.is_dir() => Ok(place),
        Ok(_) => Err(ErrorKind::NotADirectory.into()),
        // a link to nowhere is something that exists
        Err(error) if error.kind() == ErrorKind::NotFound && fs::symlink_metadata(name).is_err() => {
            let last = name.file_name().ok_or(ErrorKind::InvalidInput)?;
            let parent = name.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
            fs::create_dir_all(parent)?;
            Ok(fs::canonicalize(parent)?.join(last))
        }
        Err(error) => Err(error),
    }
}

/// Whether anything but what a killed run has left, or this one keeps, is there.
fn holds_something(place: &Path, journal: Option<JournalKind>) -> io::Result<bool> {
    let entries = match fs::read_dir(place) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(false),
        entries => entries?,
    };
    let kept = journal.map(|journal| journal.names());
    for entry in entries {
        let name = entry?.file_name();
        let name = name.to_string_lossy();
        let is_hidden = name.starts_with('.') && (name.ends_with(".part") || name.ends_with(lock::ENDING));
        if !(is_hidden || kept.iter().flatten().any(|kept| *kept == name)) {
            return Ok(true);
        }
    }
    Ok(false)
}

/// A hidden folder from which files can be moved to `place`: tried, and not there yet.
fn staging(place: &Path) -> io::Result<PathBuf> {
    let process = std::process::id();
    let name = place.file_name().unwrap_or_default().to_string_lossy();
    let beside = place.with_file_name(format!(".{name}.{process}.part"));
    if !place.exists() {
        fresh(&beside)?;
        fs::remove_dir(&beside)?;
        return Ok(beside);
    }
    // whoever stands in a folder that is replaced stands in none
    let stands_there = env::current_dir().and_then(fs::canonicalize).is_ok_and(|here| here == place);
    // as it will be replaced: empty, and on the same disk
    if !stands_there && fresh(&beside).and_then(|()| fs::rename(&beside, place)).is_ok() {
        return Ok(beside);
    }
    let _ = fs::remove_dir(&beside);
    let inside = place.join(format!(".{process}.part"));
    fresh(&inside)?;
    fs::remove_dir(&inside)?;
    Ok(inside)
}

/// Makes this folder, which a killed run of the same number may have left.
fn fresh(folder: &Path) -> io::Result<()> {
    match fs::remove_dir_all(folder) {
        Err(error) if error.kind() != ErrorKind::NotFound => Err(error),
        _ => fs::create_dir(folder),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::writing::file::write_whole;

    fn fill(dir: &Path) -> Result<Vec<PathBuf>, ReportError> {
        let files = [dir.join("a.csv"), dir.join("b.csv")];
        for file in &files {
            write_whole(file, b"new")?;
        }
        Ok(files.to_vec())
    }

    fn fail(dir: &Path) -> Result<Vec<PathBuf>, ReportError> {
        fill(dir)?;
        Err(ReportError::Draw { path: dir.join("c.svg"), reason: "no ink".into() })
    }

    fn listing(dir: &Path) -> Vec<String> {
        let name = |entry: io::Result<fs::DirEntry>| entry.unwrap().file_name().into_string().unwrap();
        let mut names: Vec<String> = fs::read_dir(dir).unwrap().map(name).collect();
        names.sort();
        names
    }

    #[test]
    fn all_files_appear_under_the_name_or_none() {
        let dir = tempfile::tempdir().unwrap();
        for name in ["new", "deep/er", "empty"] {
            let out = dir.path().join(name);
            if name == "empty" {
                fs::create_dir(&out).unwrap();
            }
            let folder = OutputFolder::claim(&out, Existing::Keep, None).unwrap();
            let error = folder.write(fail).unwrap_err().to_string();
            assert_eq!(error, format!("cannot draw {}: no ink", out.join("c.svg").display()));
            assert!(!out.exists() || listing(&out).is_empty());
            assert_eq!(folder.write(fill).unwrap(), [out.join("a.csv"), out.join("b.csv")]);
            assert_eq!(listing(&out), ["a.csv", "b.csv"]);
        }
        assert_eq!(listing(dir.path()), ["deep", "empty", "new"]);
    }

    #[test]
    fn what_is_there_is_kept_unless_it_may_be_replaced() {
        let dir = tempfile::tempdir().unwrap();
        let out = dir.path().join("out");
        let folder = OutputFolder::claim(&out, Existing::Keep, None).unwrap();
        fs::create_dir(&out).unwrap();
        for name in ["a.csv", "mine"] {
            fs::write(out.join(name), "old").unwrap();
        }
        let refused = |result: Result<Vec<PathBuf>, ReportError>| {
            assert!(matches!(result, Err(ReportError::Exists { path }) if path == out));
            assert_eq!(
                (listing(&out), fs::read(out.join("a.csv")).unwrap()),
                (vec!["a.csv".into(), "mine".into()], b"old".into())
            );
        };
        refused(folder.write(fill));
        drop(folder);
        refused(OutputFolder::claim(&out, Existing::Keep, None).map(|_| Vec::new()));
        let folder = OutputFolder::claim(&out, Existing::Replace, None).unwrap();
        folder.write(fail).unwrap_err();
        assert_eq!(fs::read(out.join("a.csv")).unwrap(), b"old");
        folder.write(fill).unwrap();
        assert_eq!(listing(&out), ["a.csv", "b.csv", "mine"]);
        assert_eq!(
            (fs::read(out.join("a.csv")).unwrap(), fs::read(out.join("mine")).unwrap()),
            (b"new".into(), b"old".into())
        );
        // and no lock
        drop(folder);
        assert_eq!(listing(dir.path()), ["out"]);
    }

    #[test]
    fn a_folder_that_is_removed_meanwhile_is_made_again() {
        let dir = tempfile::tempdir().unwrap();
        let out = dir.path().join("deep/out");
        for exists in [false, true] {
            if exists {
                fs::create_dir_all(&out).unwrap();
                fs::write(out.join("mine"), "old").unwrap();
            }
            let folder = OutputFolder::claim(&out, Existing::Replace, None).unwrap();
            fs::remove_dir_all(dir.path().join("deep")).unwrap();
            assert_eq!(folder.write(fill).unwrap(), [out.join("a.csv"), out.join("b.csv")]);
            assert_eq!(listing(&out), ["a.csv", "b.csv"]);
            drop(folder);
            fs::remove_dir_all(dir.path().join("deep")).unwrap();
        }
    }

    #[test]
    fn a_folder_that_another_holds_is_refused_until_it_lets_go() {
        let dir = tempfile::tempdir().unwrap();
        let out = dir.path().join("out");
        let holder = OutputFolder::claim(&out, Existing::Replace, None).unwrap();
        let refused = OutputFolder::claim(&out, Existing::Replace, None).unwrap_err();
        let mine = std::process::id();
        assert_eq!(refused.to_string(), format!("{} is in use: process {mine} writes to it", out.display()));
        drop(holder);
        OutputFolder::claim(&out, Existing::Replace, None).unwrap();
        assert!(listing(dir.path()).is_empty());
    }

    #[test]
    fn a_folder_with_its_own_checkpoint_is_one_to_go_on_with() {
        for name in ["sweep.partial", "sweep.partial.jsonl"] {
            let dir = tempfile::tempdir().unwrap();
            let out = dir.path().join("out");
            fs::create_dir(&out).unwrap();
            fs::write(out.join(name), "").unwrap();
            fs::write(out.join("mine"), "old").unwrap();
            let claim = |journal| OutputFolder::claim(&out, Existing::Keep, Some(journal));
            assert!(matches!(claim(JournalKind::RUN).unwrap_err(), ReportError::Exists { .. }));
            claim(JournalKind::SWEEP).unwrap().write(fill).unwrap();
            assert_eq!(listing(&out), ["a.csv", "b.csv", "mine", name]);
        }
    }

    #[test]
    fn what_a_killed_run_has_left_is_nothing_to_keep() {
        let dir = tempfile::tempdir().unwrap();
        let out = dir.path().join("out");
        fs::create_dir_all(out.join(".123.part")).unwrap();
        fs::write(out.join(".sweep.partial.123.part"), "").unwrap();
        let folder = OutputFolder::claim(&out, Existing::Keep, None).unwrap();
        fs::create_dir_all(staging(&folder.place).unwrap().join("of the same number")).unwrap();
        assert_eq!(folder.write(fill).unwrap().len(), 2);
        assert!(listing(&out).contains(&"b.csv".into()));
    }

    #[test]
    fn what_cannot_be_a_folder_is_an_error_that_names_it() {
        let dir = tempfile::tempdir().unwrap();
        let file = dir.path().join("file");
        fs::write(&file, "mine").unwrap();
        for place in
            [file.clone(), file.join("inner"), "/proc/none/of/this".into(), dir.path().join("no/.."), "".into()]
        {
            for existing in [Existing::Keep, Existing::Replace] {
                let error = OutputFolder::claim(&place, existing, None).unwrap_err();
                assert!(matches!(&error, ReportError::Write { path, .. } if *path == place), "{error}");
            }
        }
        assert_eq!(fs::read(&file).unwrap(), b"mine");
    }
}
