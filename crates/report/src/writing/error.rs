//! What can go wrong while results are written.

use std::path::{Path, PathBuf};

/// A result that could not be written.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// The file system refused.
    #[error("cannot write {path}: {source}")]
    Write {
        /// The file or folder.
        path: PathBuf,
        /// The reason of the system.
        source: std::io::Error,
    },
    /// The folder holds something that must not be replaced.
    #[error("{path} exists, is not empty and is not changed")]
    Exists {
        /// The folder.
        path: PathBuf,
    },
    /// Another process writes to the folder.
    #[error("{path} is in use: {} writes to it", process.map_or("another process".to_owned(), |process| format!("process {process}")))]
    InUse {
        /// The folder.
        path: PathBuf,
        /// The number of that process, where it is known.
        process: Option<u32>,
    },
    /// What another command has found would be lost.
    #[error("{path} is the checkpoint of an interrupted {analysis} of another {of}: {difference}")]
    OtherCheckpoint {
        /// The checkpoint.
        path: PathBuf,
        /// What is interrupted, as the file says: `run`, `sweep`, `sample`, `optimisation`.
        analysis: String,
        /// What of it is another one: `kind`, `scene`, `version`, or a setting such as `key`.
        of: String,
        /// Where the two differ, and what stands there in each.
        difference: String,
    },
    /// A checkpoint that this version of the program does not read.
    #[error("{path} is a checkpoint that {} has written in another form, and this version of peel does not read it", version.as_ref().map_or("an older version of peel".to_owned(), |version| format!("peel {version}")))]
    OlderCheckpoint {
        /// The checkpoint.
        path: PathBuf,
        /// What is interrupted: `run`, `sweep`, `sample`, `optimisation`.
        analysis: &'static str,
        /// The version that wrote it, where the file says so.
        version: Option<String>,
    },
    /// A file that should be a checkpoint.
    #[error("{path} is not a checkpoint that this version of peel can read: {reason}")]
    NoCheckpoint {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// A file that should be a part of a sweep.
    #[error("{path} is not a part of a sweep that this version of peel can read: {reason}")]
    NoPart {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// A folder that should hold the law of a tip.
    #[error("{path} is not a part of the law of a tip that this version of peel can read: {reason}")]
    NoTipLaw {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// The folder holds the law of another tip.
    #[error("{path} is the law of another tip: {key} is {found} there, and {wanted} in the scene")]
    OtherTipLaw {
        /// The file.
        path: PathBuf,
        /// What differs.
        key: String,
        /// What it is there.
        found: String,
        /// What the scene asks for.
        wanted: String,
    },
    /// What an earlier run has left cannot be read.
    #[error("cannot read {path}: {source}")]
    Read {
        /// The file or folder.
        path: PathBuf,
        /// The reason of the system.
        source: std::io::Error,
    },
    /// There is nothing to draw, or the drawing failed.
    #[error("cannot draw {path}: {reason}")]
    Draw {
        /// The picture.
        path: PathBuf,
        /// Why there is none.
        reason: String,
    },
}

impl ReportError {
    /// The same about another path.
    pub(crate) fn with_path(mut self, other: impl Fn(&Path) -> PathBuf) -> Self {
        let (Self::Write { path, .. }
        | Self::Exists { path }
        | Self::InUse { path, .. }
        | Self::OtherCheckpoint { path, .. }
        | Self::OlderCheckpoint { path, .. }
        | Self::NoCheckpoint { path, .. }
        | Self::NoPart { path, .. }
        | Self::NoTipLaw { path, .. }
        | Self::OtherTipLaw { path, .. }
        | Self::Read { path, .. }
        | Self::Draw { path, .. }) = &mut self;
        *path = other(path);
        self
    }
}
