//! Of which analysis a file of what is unfinished is, and what it is called in a folder of outputs.

use super::header;
use crate::writing::error::ReportError;
use crate::writing::file::remove;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// How the names of files of lines of text end, in peel 0.2 and before.
pub(super) const OLDER_ENDING: &str = ".jsonl";

/// Of which analysis a journal is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct JournalKind {
    /// The name of its file in the folder of the outputs
    pub name: &'static str,
    /// What is interrupted
    pub(super) analysis: &'static str,
    /// What is kept
    pub(super) entries: &'static str,
    /// Nothing is written before a command has lasted so long, and then no oftener. With zero the file is there at once.
    pub interval: Duration,
}

impl JournalKind {
    /// Of the path of a run.
    pub const RUN: Self = Self::seldom("run.partial", "run", "points");
    /// Of the pull-off of a seta.
    pub const SETA: Self = Self::seldom("run.partial", "run", "equilibria");
    /// Of a sweep, or one part of it.
    pub const SWEEP: Self = Self::at_once("sweep.partial", "sweep", "values");
    /// Of an uncertain peel.
    pub const SAMPLE: Self = Self::at_once("uncertainty.partial", "sample", "samples");
    /// Of an optimisation.
    pub const OPTIMISATION: Self = Self::at_once("optimise.partial", "optimisation", "designs");

    const fn seldom(name: &'static str, analysis: &'static str, entries: &'static str) -> Self {
        Self { name, analysis, entries, interval: Duration::from_millis(200) }
    }

    const fn at_once(name: &'static str, analysis: &'static str, entries: &'static str) -> Self {
        Self { name, analysis, entries, interval: Duration::ZERO }
    }

    /// Whether `dir` holds such a file, or one of an older version.
    pub fn is_in(&self, dir: &Path) -> bool {
        self.names().iter().any(|name| dir.join(name).is_file())
    }

    /// Removes the file in `dir`, if there is one.
    ///
    /// Fails with [`ReportError::Write`] where it cannot be removed.
    pub fn discard(&self, dir: &Path) -> Result<(), ReportError> {
        self.names().into_iter().try_for_each(|name| remove(dir.join(name)))
    }

    /// The names of such files: this one, and that of an older version.
    pub(crate) fn names(&self) -> [String; 2] {
        [self.name.to_owned(), format!("{}{OLDER_ENDING}", self.name)]
    }

    /// Refuses the file of an older version: this one, by its bytes, or one beside it with the name of such a file. What it holds would be computed
    /// again, unasked.
    pub(super) fn refuse_older(&self, path: &Path, bytes: &[u8]) -> Result<(), ReportError> {
        let older = |path: PathBuf, version| ReportError::OlderCheckpoint { path, analysis: self.analysis, version };
        let [_, name] = self.names();
        let beside = path.with_file_name(name);
        match header::older_version(bytes) {
            Some(version) => Err(older(path.to_path_buf(), Some(version))),
            None if beside.is_file() => {
                let version = fs::read(&beside).ok().and_then(|bytes| header::older_version(&bytes));
                Err(older(beside, version))
            }
            None => Ok(()),
        }
    }
}
