//! What an analysis is asked, and what it answers.

use crate::session::Session;
use peelkit_report::{Journal, JournalKind, ReportError, write_in_units};
use peelkit_scene::{Scene, ValueError};
use std::fmt::{self, Display};
use std::io;
use std::path::{Path, PathBuf};

/// Something that can be asked of a scene, checked: it can be computed.
pub trait Analysis {
    /// What it finds
    type Found: Outcome;

    /// How it keeps what it finds while it computes; none where it keeps nothing.
    fn journal(&self) -> Option<JournalKind> {
        None
    }

    /// Computes it.
    ///
    /// Fails where nothing was found, and where what was found cannot be kept.
    fn run(&self, session: &Session) -> Result<Self::Found, Refusal>;
}

/// What an analysis of a scene has found. The scene is that of the analysis.
pub trait Outcome {
    /// The object of `summary.json`, units in the names of its keys, with the command that has asked for it.
    ///
    /// Fails where a number is not finite.
    fn json(&self, scene: &Scene, command: Option<&str>) -> io::Result<String>;

    /// Writes all files to a folder: tables, pictures, the summary, and the scene with the command as a remark.
    ///
    /// Fails as [`peelkit_report::OutputFolder::write`] says.
    fn write(&self, scene: &Scene, dir: &Path, command: &str) -> Result<Vec<PathBuf>, ReportError>;

    /// The same, with tables once more in the units that the scene names.
    ///
    /// Fails as [`Outcome::write`].
    fn write_all(&self, scene: &Scene, dir: &Path, command: &str) -> Result<Vec<PathBuf>, ReportError> {
        let mut files = self.write(scene, dir, command)?;
        files.extend(write_in_units(dir, &files, scene.written_units())?);
        Ok(files)
    }

    /// How it ended.
    fn end(&self) -> End;

    /// Whether there is anything to write.
    fn is_written(&self) -> bool {
        true
    }

    /// Where it was kept, and whether all of it is computed.
    fn kept(&self) -> Option<(&Journal, bool)> {
        None
    }

    /// To be asked once the files are written, or were not: what is finished and written needs its journal no more, and of what is not finished all
    /// is kept; where, in words.
    ///
    /// Fails with [`ReportError::Write`].
    fn settle(&self, written: bool) -> Result<Option<String>, ReportError> {
        self.kept().map_or(Ok(None), |(journal, is_finished)| journal.settle(is_finished, written))
    }
}

/// A summary with the command that has asked for it, if one has.
pub(crate) fn by<S>(summary: S, command: Option<&str>, with: impl FnOnce(S, &str) -> S) -> S {
    match command {
        Some(command) => with(summary, command),
        None => summary,
    }
}

/// How an analysis ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum End {
    /// All was computed.
    Done,
    /// It stopped short by itself, with the reason.
    CutShort(String),
    /// It was asked to stop.
    Interrupted {
        /// What is done of how much, where it computes one after the other
        done: Option<String>,
        /// What stopped short of that by itself
        short: Option<String>,
    },
    /// The model is one that cannot be computed, which the computation has found.
    Refused {
        /// What is wrong
        found: String,
        /// What to try
        remedy: String,
    },
}

impl End {
    /// Of so many that were computed one after the other, and what stopped short among these.
    pub(crate) fn of_many([done, all]: [usize; 2], what: &str, short: Option<String>) -> Self {
        match short {
            short if done < all => Self::Interrupted { done: Some(format!("{done} of {all} {what} are done")), short },
            Some(short) => Self::CutShort(short),
            None => Self::Done,
        }
    }
}

/// Why there is no outcome.
#[derive(Debug)]
pub enum Refusal {
    /// What was asked has no meaning, or is wrong.
    Asked {
        /// What is wrong
        found: String,
        /// What to try
        remedy: String,
    },
    /// The scene is one of which it cannot be computed. What is wrong is to be told with the name of the scene.
    Scene {
        /// What is wrong
        found: String,
        /// What to try
        remedy: String,
    },
    /// The computation stopped short before anything was found.
    CutShort(String),
    /// A file could not be read or written.
    Report(ReportError),
    /// Something that neither what was asked nor the computation is to blame for
    Other(String),
}

impl Refusal {
    pub(crate) fn asked(found: impl Display, remedy: impl Display) -> Self {
        Self::Asked { found: found.to_string(), remedy: remedy.to_string() }
    }

    pub(crate) fn scene(found: impl Display, remedy: impl Display) -> Self {
        Self::Scene { found: found.to_string(), remedy: remedy.to_string() }
    }

    pub(crate) fn cut_short(why: impl Display) -> Self {
        Self::CutShort(why.to_string())
    }

    /// A value of this name that is as the problem says.
    pub(crate) fn value(name: impl Display, problem: &ValueError) -> Self {
        Self::asked(format!("{name} {}", problem.found), &problem.remedy)
    }
}

impl From<ReportError> for Refusal {
    fn from(error: ReportError) -> Self {
        Self::Report(error)
    }
}

impl Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Asked { found, remedy } | Self::Scene { found, remedy } => write!(f, "{found}. {remedy}"),
            Self::CutShort(why) => write!(f, "the computation stopped short: {why}"),
            Self::Report(error) => write!(f, "{error}"),
            Self::Other(why) => write!(f, "{why}"),
        }
    }
}

impl std::error::Error for Refusal {}
