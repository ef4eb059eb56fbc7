//! One part of a sweep that several machines divide: the file from which `peel collect` puts the parts together again.

use super::lines::{first_line, read_lines, result_line};
use super::sweep::{Line, Part};
use crate::error::ReportError;
use crate::file::write_whole;
use crate::sweep_row::SweepRow;
use peelkit::study::PeelResult;
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

/// A key of a divided sweep and all of its values.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PartAxis {
    /// The key: `strip.length`
    pub key: String,
    /// Whether the axis of the picture is logarithmic
    pub log: bool,
    /// In the unit of the key
    pub values: Vec<f64>,
}

/// A sweep that is divided: what all of its parts have in common.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DividedSweep {
    /// The version of the program
    pub peelkit: String,
    /// The number of parts
    pub of: usize,
    /// What is varied
    pub vary: Vec<PartAxis>,
    /// The scene with its defaults, as a TOML text
    pub scene: String,
}

/// The first line of the file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PartHeader {
    /// Which part this is
    pub part: Part,
    /// What it is a part of
    pub sweep: DividedSweep,
    /// Where the scene was read from
    pub name: String,
    /// The folder to which the undivided sweep writes where the user names none
    pub folder: PathBuf,
    /// The command line of the undivided sweep, as words
    pub command: Vec<String>,
}

/// A part that was read again.
#[derive(Debug)]
pub struct SweepPart {
    /// What it is a part of, and which
    pub header: PartHeader,
    /// By the bits of the values.
    found: HashMap<(u64, Option<u64>), Line>,
}

impl SweepPart {
    /// The name of the file in the folder of the part.
    pub const NAME: &str = "sweep.part.jsonl";

    /// Writes the file: the header, then a line a finished value.
    ///
    /// Fails with [`ReportError::Write`].
    pub fn write(dir: &Path, header: &PartHeader, rows: &[SweepRow]) -> Result<PathBuf, ReportError> {
        let path = dir.join(Self::NAME);
        let refuse = |source| ReportError::Write { path: path.clone(), source };
        let mut text = first_line(header).map_err(refuse)?;
        for row in rows {
            text.extend(result_line(&Line::from(row)).map_err(refuse)?);
        }
        write_whole(&path, &text)?;
        Ok(path)
    }

    /// Reads the file in `dir`; `None` where there is none.
    ///
    /// Fails with [`ReportError::Read`], and with [`ReportError::NoPart`] where the first line is not that of a part, or a line is not as it was
    /// written.
    pub fn read(dir: &Path) -> Result<Option<Self>, ReportError> {
        let path = dir.join(Self::NAME);
        if !path.is_file() {
            return Ok(None);
        }
        let text = fs::read(&path).map_err(|source| ReportError::Read { path: path.clone(), source })?;
        let end = text.iter().position(|&byte| byte == b'\n').map_or(text.len(), |end| end + 1);
        let no_part = |reason| ReportError::NoPart { path: path.clone(), reason };
        let header = serde_json::from_slice::<PartHeader>(&text[..end]).map_err(|error| no_part(error.to_string()))?;
        let (lines, damaged) = read_lines::<Line>(&text[end..]);
        if let Some(line) = damaged.first() {
            return Err(no_part(format!("line {line} does not match its check sum")));
        }
        let found = lines.into_iter().map(|line| (line.place(), line)).collect();
        Ok(Some(Self { header, found }))
    }

    /// What was found at this value, or these two, and the seconds that it took.
    pub fn found(&self, value: f64, second: Option<f64>) -> Option<(&PeelResult, f64)> {
        self.found.get(&super::sweep::place(value, second)).map(|line| (&line.found, line.solve_s))
    }
}
