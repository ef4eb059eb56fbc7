//! What a sweep writes and says of its rows, whatever they are of.

use super::args::Sweep;
use super::failed::stopped_short;
use super::kept::Computed;
use crate::output::{list_files, say};
use crate::stop::Stop;
use peelkit_report::{ReportError, Storable};
use std::io;
use std::path::{Path, PathBuf};

/// What there is to write and to say.
pub struct Conclusion<'c> {
    /// Rows that were computed, of so many values.
    pub done: [usize; 2],
    /// The files, into a folder. Nothing is written where nothing was reached.
    pub write: &'c dyn Fn(&Path) -> Result<Vec<PathBuf>, ReportError>,
    /// What is to be said of the rows besides.
    pub remark: Option<String>,
    /// The rows with all remarks, as one object.
    pub json: &'c dyn Fn(&[String]) -> io::Result<String>,
    /// The same as a table.
    pub text: &'c dyn Fn(&[String]) -> String,
    /// The values that stopped short.
    pub failed: Option<String>,
}

impl<F: Storable> Computed<'_, F> {
    /// Writes the files, says what was found, and ends with what is missing.
    pub fn conclude(self, args: &Sweep, conclusion: Conclusion) -> Result<(), Stop> {
        let Conclusion { done: [rows, values], write, remark, json, text, failed } = conclusion;
        let output = self.output.as_ref().filter(|_| rows > 0);
        let files = output.map_or(Ok(Vec::new()), |output| output.write(write));
        if files.is_ok() && rows == values {
            self.discard()?;
        }
        let mut remarks = self.remarks;
        remarks.extend(remark);
        if args.json {
            say(&json(&remarks).map_err(Stop::other)?)?;
        } else {
            say(&format!("{}\n{}", text(&remarks), list_files(&files)))?;
        }
        files?;
        stopped_short([rows, values], failed)
    }
}
