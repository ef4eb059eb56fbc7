//! Where results go: the folder of a command, standard output, and the bar on a terminal.

use super::stop::Stop;
use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use peelkit_report::{Existing, JournalKind, OutputFolder, ReportError};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

/// Where a command that writes files writes them.
#[derive(Args)]
pub struct OutArgs {
    /// Folder for the outputs [default: in out/, named after what is asked]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,

    /// Writes to a folder that is not empty; its other files stay
    #[arg(long)]
    pub force: bool,
}

impl OutArgs {
    /// The folder, if it may be written to; to be asked before anything is computed. One that holds such a journal of an unfinished command is one to
    /// go on with.
    pub fn claim(&self, folder: &Path, journal: Option<JournalKind>) -> Result<OutputFolder, ReportError> {
        OutputFolder::claim(folder, self.existing(), journal)
    }

    /// Where files go, if they are written: to `usual` where the user names no folder, and nowhere where one JSON object is asked for then.
    pub fn folder(&self, json: bool, usual: impl FnOnce() -> PathBuf) -> Option<PathBuf> {
        match &self.out {
            None if json => None,
            None => Some(usual()),
            given => given.clone(),
        }
    }

    fn existing(&self) -> Existing {
        if self.force { Existing::Replace } else { Existing::Keep }
    }
}

/// Says on standard error what is good to know before the command ends.
pub fn note(text: impl std::fmt::Display) {
    // nobody reads it where standard error is closed
    let _ = writeln!(std::io::stderr(), "note: {text}");
}

/// Writes to standard output. A reader that has closed the pipe is no error.
pub fn say(text: &str) -> Result<(), Stop> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Stop::other(format!("cannot print: {error}"))),
        _ => Ok(()),
    }
}

/// The files that were written, if they were, a line each; the grids of a time series, which its list names, are counted.
pub fn list_files(files: &Result<Vec<PathBuf>, ReportError>) -> String {
    let is_grid = |file: &&PathBuf| file.extension().is_some_and(|extension| extension == "vtu");
    let line = |file: &PathBuf| format!("wrote {}\n", file.display());
    let all = || files.iter().flatten();
    let mut text: String = all().filter(|file| !is_grid(file)).map(line).collect();
    if let Some(grid) = all().find(is_grid) {
        let folder = grid.parent().unwrap_or(Path::new("")).display();
        text += &format!(
            "wrote {folder}/ with {} files for ParaView, which the .pvd lists name\n",
            all().filter(is_grid).count()
        );
    }
    text
}

/// A bar on standard error if that is a terminal; nothing in a pipe.
pub fn progress_bar(length: usize) -> ProgressBar {
    let bar = ProgressBar::new(length as u64);
    match ProgressStyle::with_template("{bar:40} {pos} of {len}, {elapsed} elapsed, {eta} left") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
