//! A file that cannot be drawn.

use std::path::PathBuf;

/// A file that cannot be drawn.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{} {found}", path.display())]
pub struct OverlayError {
    /// The file or folder
    pub path: PathBuf,
    /// What is wrong with it: completes its path to a sentence
    pub found: String,
    /// What would be right: a sentence of its own
    pub remedy: String,
}

impl OverlayError {
    pub(super) fn new(path: impl Into<PathBuf>, found: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self { path: path.into(), found: found.into(), remedy: remedy.into() }
    }
}
