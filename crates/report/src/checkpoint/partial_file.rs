//! What all checkpoints have in common: a name in the folder of the outputs.

use super::damaged::Damaged;
use crate::error::ReportError;
use crate::file::remove;
use std::path::Path;

/// The file of something that is not finished.
pub trait PartialFile {
    /// Its name in the folder of the outputs.
    const NAME: &'static str;

    /// What of it is computed again, because it is not as it was written.
    fn damaged(&self) -> Option<&Damaged>;

    /// Whether `dir` holds such a file.
    fn is_in(dir: &Path) -> bool {
        dir.join(Self::NAME).is_file()
    }

    /// Removes the file in `dir`, if there is one.
    ///
    /// Fails with [`ReportError::Write`] where it cannot be removed.
    fn discard(dir: &Path) -> Result<(), ReportError> {
        remove(dir.join(Self::NAME))
    }
}
