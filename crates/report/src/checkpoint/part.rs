//! One part of a sweep that several machines divide: the file from which `peel collect` puts the parts together again, made of the frames of a checkpoint.
//! While parts are missing their collection has a file too: by it the same command knows its own folder again.

use super::frames::{Scan, framed};
use super::header::older_version;
use super::kind::OLDER_ENDING;
use crate::swept::SweepRow;
use crate::writing::error::ReportError;
use crate::writing::file::{remove, write_whole};
use peelkit::study::PeelResult;
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::{fmt, fs, io};

/// Most parts.
const MOST: usize = 1_000_000;

/// Which part of a divided sweep: `index`, counted from 1, of `of`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Part {
    /// From 1 to `of`
    pub index: usize,
    /// The number of parts
    pub of: usize,
}

impl Part {
    /// Whether this part computes the case of this number, counted from 0. Neighbours lie in different parts: they cost alike, so parts do.
    pub fn has(self, case: usize) -> bool {
        Self::with_case(case, self.of) == self
    }

    /// The part, of so many, that computes the case of this number, counted from 0.
    pub fn with_case(case: usize, of: usize) -> Self {
        Self { index: case % of + 1, of }
    }

    /// Those of the cases that a part has; all of them where no part is asked for.
    pub fn chosen<T>(part: Option<Self>, cases: impl IntoIterator<Item = T>) -> impl Iterator<Item = T> {
        let numbered = cases.into_iter().enumerate();
        numbered.filter(move |(case, _)| part.is_none_or(|part| part.has(*case))).map(|(_, one)| one)
    }
}

impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.of)
    }
}

impl FromStr for Part {
    type Err = String;

    /// Reads `I/N`.
    fn from_str(text: &str) -> Result<Self, String> {
        let wrong =
            || format!("write I/N with I from 1 to N and N at most {MOST}, such as 3/8 for the third of eight parts");
        let (index, of) = text.split_once('/').ok_or_else(wrong)?;
        let number = |text: &str| text.trim().parse::<usize>().ok().filter(|&number| (1..=MOST).contains(&number));
        let part = number(index).zip(number(of)).map(|(index, of)| Self { index, of });
        part.filter(|part| part.index <= part.of).ok_or_else(wrong)
    }
}

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

/// What the file begins with.
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

/// The values of the keys that are varied.
type Place = (f64, Option<f64>);

/// A part that was read again.
#[derive(Debug)]
pub struct SweepPart {
    /// What it is a part of, and which
    pub header: PartHeader,
    /// By the bytes of the values
    found: HashMap<Vec<u8>, (PeelResult, f64)>,
}

fn key(place: Place) -> io::Result<Vec<u8>> {
    postcard::to_stdvec(&place).map_err(io::Error::other)
}

impl SweepPart {
    /// The name of the file in the folder of the part.
    pub const NAME: &str = "sweep.part";

    /// Writes the file: the header, then a frame a finished value.
    ///
    /// Fails with [`ReportError::Write`].
    pub fn write(dir: &Path, header: &PartHeader, rows: &[SweepRow]) -> Result<PathBuf, ReportError> {
        let path = dir.join(Self::NAME);
        let frames = || {
            let mut bytes = framed(&[], &serde_json::to_vec(header)?)?;
            for row in rows {
                let value = postcard::to_stdvec(&(&row.found, row.solve_s)).map_err(io::Error::other)?;
                bytes.extend(framed(&key((row.value, row.second))?, &value)?);
            }
            Ok(bytes)
        };
        let bytes = frames().map_err(|source| ReportError::Write { path: path.clone(), source })?;
        write_whole(&path, &bytes)?;
        Ok(path)
    }

    /// Reads the file in `dir`; `None` where there is none.
    ///
    /// Fails with [`ReportError::Read`], and with [`ReportError::NoPart`] where it does not begin as a part does, or is not as it was written.
    pub fn read(dir: &Path) -> Result<Option<Self>, ReportError> {
        let path = dir.join(Self::NAME);
        let older = dir.join(format!("{}{OLDER_ENDING}", Self::NAME));
        if !path.is_file() && older.is_file() {
            let version = fs::read(&older).ok().and_then(|bytes| older_version(&bytes));
            let version = version.map_or("an older version".to_owned(), |version| format!("peel {version}"));
            return Err(ReportError::NoPart {
                path: older,
                reason: format!("{version} has written it in another form"),
            });
        }
        if !path.is_file() {
            return Ok(None);
        }
        let bytes = fs::read(&path).map_err(|source| ReportError::Read { path: path.clone(), source })?;
        let scan = Scan::of(&bytes);
        let no_part = |reason: String| Err(ReportError::NoPart { path: path.clone(), reason });
        if let Some(damage) = scan.damage() {
            return no_part(damage);
        }
        let [first, others @ ..] = scan.frames.as_slice() else {
            return no_part("it ends in its header".to_owned());
        };
        if scan.end < bytes.len() {
            return no_part("its end is torn".to_owned());
        }
        let header = match serde_json::from_slice(&bytes[first.value()]) {
            Ok(header) => header,
            Err(error) => return no_part(error.to_string()),
        };
        let found = others
            .iter()
            .map(|frame| postcard::from_bytes(&bytes[frame.value()]).map(|found| (bytes[frame.key()].to_vec(), found)));
        match found.collect() {
            Ok(found) => Ok(Some(Self { header, found })),
            Err(error) => no_part(error.to_string()),
        }
    }

    /// What was found at this value, or these two, and the seconds that it took.
    pub fn found(&self, value: f64, second: Option<f64>) -> Option<(&PeelResult, f64)> {
        let (found, solve_s) = self.found.get(&key((value, second)).ok()?)?;
        Some((found, *solve_s))
    }
}

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_is_one_of_so_many() {
        assert_eq!("3/8".parse(), Ok(Part { index: 3, of: 8 }));
        for wrong in ["0/8", "9/8", "3", "3/", "/8", "-1/8", "1/0", "a/b", "1.5/2", "1/2000000"] {
            assert!(wrong.parse::<Part>().is_err(), "{wrong}");
        }
    }
}
