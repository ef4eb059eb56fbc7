//! What can go wrong while results are written.

use std::path::PathBuf;

/// A result that could not be written.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// The file system refused.
    #[error("cannot write {path}: {source}")]
    Write { path: PathBuf, source: std::io::Error },
    /// What an earlier run has left cannot be read.
    #[error("cannot read {path}: {source}")]
    Read { path: PathBuf, source: std::io::Error },
    /// There is nothing to draw, or the drawing failed.
    #[error("cannot draw {path}: {reason}")]
    Draw { path: PathBuf, reason: String },
}
