//! What of a checkpoint is not as it was written: it is computed again, and the user is told.

use std::fmt;
use std::path::{Path, PathBuf};

/// A checkpoint of which something does not match its check sum.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Damaged {
    /// The checkpoint
    pub path: PathBuf,
    /// What is computed again
    pub what: DamagedPart,
}

/// What of a checkpoint is computed again.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum DamagedPart {
    /// These lines of it, counted from 1
    Lines(Vec<usize>),
    /// This path point, counted from 1, and those behind it
    PointsFrom(usize),
    /// All
    Everything,
}

/// So many lines are named.
const NAMED: usize = 5;

impl Damaged {
    pub(super) fn lines(path: &Path, lines: Vec<usize>) -> Option<Self> {
        let found = |what| Self { path: path.to_path_buf(), what };
        (!lines.is_empty()).then(|| found(DamagedPart::Lines(lines)))
    }
}

/// The CRC-32 of what is kept, which stands beside it in every checkpoint.
pub(super) fn check_sum(kept: &[u8]) -> u32 {
    crc32fast::hash(kept)
}

impl fmt::Display for Damaged {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}: {}", self.path.display(), self.what)
    }
}

impl fmt::Display for DamagedPart {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Lines(lines) if lines.len() == 1 => {
                write!(f, "line {} does not match its check sum; it is computed again", lines[0])
            }
            Self::Lines(lines) => {
                let named: Vec<String> = lines.iter().take(NAMED).map(ToString::to_string).collect();
                let more = lines.len() - named.len();
                let more = if more > 0 { format!(" and {more} more") } else { String::new() };
                write!(f, "lines {}{more} do not match their check sums; they are computed again", named.join(", "))
            }
            Self::PointsFrom(point) => {
                write!(f, "path point {point} does not match its check sum; it and those behind it are computed again")
            }
            Self::Everything => {
                write!(f, "what it holds does not match its check sum; the run begins anew")
            }
        }
    }
}
