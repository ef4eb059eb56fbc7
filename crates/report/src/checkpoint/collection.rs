//! What a folder of `peel collect` holds beside its table while parts are missing: by it the same command knows its own folder again.

use super::part::DividedSweep;
use crate::error::ReportError;
use crate::file::{remove, write_whole};
use serde::{Deserialize, Serialize};
use std::fs;
use std::path::{Path, PathBuf};

/// The file of a collection in which parts are missing.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub struct PartialCollection {
    /// What is collected
    pub sweep: DividedSweep,
    /// The parts that are missing or not finished, counted from 1
    pub missing: Vec<usize>,
}

impl PartialCollection {
    /// Its name in the folder of the outputs.
    pub const NAME: &str = "collect.partial.json";

    /// Whether `dir` holds an unfinished collection of this sweep.
    pub fn is_in(dir: &Path, sweep: &DividedSweep) -> bool {
        let text = fs::read(dir.join(Self::NAME)).unwrap_or_default();
        serde_json::from_slice::<Self>(&text).is_ok_and(|known| known.sweep == *sweep)
    }

    /// Writes the file.
    ///
    /// Fails with [`ReportError::Write`].
    pub fn write(&self, dir: &Path) -> Result<PathBuf, ReportError> {
        let path = dir.join(Self::NAME);
        let text = serde_json::to_vec(self)
            .map_err(|error| ReportError::Write { path: path.clone(), source: error.into() })?;
        write_whole(&path, &text)?;
        Ok(path)
    }

    /// Removes the file in `dir`, if there is one.
    ///
    /// Fails with [`ReportError::Write`] where it cannot be removed.
    pub fn discard(dir: &Path) -> Result<(), ReportError> {
        remove(dir.join(Self::NAME))
    }
}
