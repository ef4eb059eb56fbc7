//! Two commands must not write to one folder at once: the first holds a lock, which the system releases when its process is gone.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

/// How the name of the file ends.
pub(super) const ENDING: &str = ".lock";

/// A locked file with the number of this process, `.NAME.lock` beside a folder, or `.lock` in it where nothing can be written beside it. It is removed in
/// the end; one that a killed process has left is taken over.
#[derive(Debug)]
pub(super) struct FolderLock {
    path: PathBuf,
    _file: File,
}

/// Why there is no lock.
#[derive(Debug)]
pub(super) enum NotLocked {
    /// Another process, of this number where it can be read, holds it
    InUse(Option<u32>),
    /// The system refused
    System(io::Error),
}

impl FolderLock {
    /// Takes the lock of a folder, which need not exist. There is none where the file system knows no locks.
    pub fn take(place: &Path) -> Result<Option<Self>, NotLocked> {
        let name = place.file_name().unwrap_or_default().to_string_lossy();
        let beside = place.with_file_name(format!(".{name}{ENDING}"));
        match Self::at(&beside) {
            Err(NotLocked::System(_)) if place.is_dir() => Self::at(&place.join(ENDING)),
            taken => taken,
        }
    }

    fn at(path: &Path) -> Result<Option<Self>, NotLocked> {
        // of this attempt alone, and the number of the process in the first line
        let mine = format!("{}\n{:?}\n", std::process::id(), std::thread::current().id());
        loop {
            let opened = OpenOptions::new().create(true).truncate(false).read(true).write(true).open(path);
            let mut file = opened.map_err(NotLocked::System)?;
            match file.try_lock() {
                Err(TryLockError::WouldBlock) => {
                    let holder = fs::read_to_string(path).unwrap_or_default();
                    return Err(NotLocked::InUse(holder.lines().next().and_then(|process| process.parse().ok())));
                }
                Err(TryLockError::Error(error)) if error.kind() == ErrorKind::Unsupported => return Ok(None),
                Err(TryLockError::Error(error)) => return Err(NotLocked::System(error)),
                Ok(()) => {}
            }
            let written = file.set_len(0).and_then(|()| file.write_all(mine.as_bytes()));
            written.map_err(NotLocked::System)?;
            // whoever held it may have removed the file between the two: then what is locked has no name, and another one may
            if fs::read_to_string(path).is_ok_and(|found| found == mine) {
                return Ok(Some(Self { path: path.to_path_buf(), _file: file }));
            }
        }
    }
}

impl Drop for FolderLock {
    fn drop(&mut self) {
        // before it is released; one that cannot be removed is taken over
        let _ = fs::remove_file(&self.path);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn listing(dir: &Path) -> Vec<PathBuf> {
        fs::read_dir(dir).unwrap().map(|entry| entry.unwrap().path()).collect()
    }

    #[test]
    fn one_holds_it_and_the_other_learns_who() {
        let dir = tempfile::tempdir().unwrap();
        let place = dir.path().join("out");
        let lock = FolderLock::take(&place).unwrap().unwrap();
        let refused = FolderLock::take(&place).unwrap_err();
        assert!(matches!(refused, NotLocked::InUse(Some(process)) if process == std::process::id()), "{refused:?}");
        assert!(FolderLock::take(&dir.path().join("other")).unwrap().is_some());
        drop(lock);
        assert!(FolderLock::take(&place).unwrap().is_some());
        assert!(listing(dir.path()).is_empty());
    }

    #[test]
    fn what_a_killed_process_has_left_is_taken_over() {
        let dir = tempfile::tempdir().unwrap();
        let left = dir.path().join(".out.lock");
        for found in ["1", "a garbled number that is longer than any process has", ""] {
            fs::write(&left, found).unwrap();
            let lock = FolderLock::take(&dir.path().join("out")).unwrap().unwrap();
            assert_eq!(fs::read_to_string(&left).unwrap().lines().next(), Some(&*std::process::id().to_string()));
            drop(lock);
        }
    }

    #[test]
    fn of_many_that_come_at_once_one_has_it_at_a_time() {
        use std::sync::atomic::{AtomicUsize, Ordering};
        let dir = tempfile::tempdir().unwrap();
        let (place, holders, times) = (dir.path().join("out"), AtomicUsize::new(0), AtomicUsize::new(0));
        std::thread::scope(|scope| {
            for _ in 0..4 {
                scope.spawn(|| {
                    for _ in 0..500 {
                        if let Ok(Some(lock)) = FolderLock::take(&place) {
                            assert_eq!(holders.fetch_add(1, Ordering::SeqCst), 0, "two hold it");
                            times.fetch_add(1, Ordering::SeqCst);
                            holders.fetch_sub(1, Ordering::SeqCst);
                            drop(lock);
                        }
                    }
                });
            }
        });
        assert!(times.into_inner() > 0);
    }
}
