//! Where results go: the folder of a command, standard output, and the bar on a terminal.

use crate::terminal::command_line::words;
use crate::terminal::stop::Stop;
use clap::Args;
use console::Term;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle, TermLike};
use peelkit_report::{Existing, JournalKind, OutputFolder, ReportError, command_of_results};
use std::io::{self, ErrorKind, Write};
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
    /// go on with, and one that the same command has written before is written again.
    pub fn claim(&self, folder: &Path, journal: Option<JournalKind>) -> Result<OutputFolder, ReportError> {
        let existing = if self.force || holds_the_same(folder) { Existing::Replace } else { Existing::Keep };
        OutputFolder::claim(folder, existing, journal)
    }

    /// Whether the folder has the whole results of the same command, which the user does not want to lose to those of an interrupted one.
    pub fn is_again(&self, folder: &Path, journal: Option<JournalKind>) -> bool {
        let goes_on = journal.is_some_and(|journal| journal.is_in(folder));
        !self.force && !goes_on && holds_the_same(folder)
    }

    /// Where files go, if they are written: to `usual` where the user names no folder, and nowhere where one JSON object is asked for then.
    pub fn folder(&self, json: bool, usual: impl FnOnce() -> PathBuf) -> Option<PathBuf> {
        match &self.out {
            None if json => None,
            None => Some(usual()),
            given => given.clone(),
        }
    }
}

/// Whether the files of a folder are those of the command that is given now.
fn holds_the_same(folder: &Path) -> bool {
    let own =
        |words: Vec<String>| words.into_iter().filter(|word| !["--force", "--fresh"].contains(&&**word)).collect();
    let before: Option<Vec<String>> = command_of_results(folder).and_then(|line| shlex::split(&line)).map(own);
    before == Some(own(words()))
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

/// Standard error as a terminal that is a little narrower than it is: behind a line there is room for the ^C that a terminal shows, which would
/// begin a new one and leave that line standing.
#[derive(Debug)]
struct Narrower(Term);

/// Columns of "^C".
const CTRL_C: u16 = 2;

impl TermLike for Narrower {
    fn width(&self) -> u16 {
        TermLike::width(&self.0).saturating_sub(CTRL_C).max(1)
    }
    fn height(&self) -> u16 {
        TermLike::height(&self.0)
    }
    fn move_cursor_up(&self, lines: usize) -> io::Result<()> {
        self.0.move_cursor_up(lines)
    }
    fn move_cursor_down(&self, lines: usize) -> io::Result<()> {
        self.0.move_cursor_down(lines)
    }
    fn move_cursor_right(&self, columns: usize) -> io::Result<()> {
        self.0.move_cursor_right(columns)
    }
    fn move_cursor_left(&self, columns: usize) -> io::Result<()> {
        self.0.move_cursor_left(columns)
    }
    fn write_line(&self, text: &str) -> io::Result<()> {
        self.0.write_line(text)
    }
    fn write_str(&self, text: &str) -> io::Result<()> {
        self.0.write_str(text)
    }
    fn clear_line(&self) -> io::Result<()> {
        self.0.clear_line()
    }
    fn flush(&self) -> io::Result<()> {
        self.0.flush()
    }
}

/// Where a bar is drawn: standard error if that is a terminal, and nowhere in a pipe.
pub fn terminal() -> ProgressDrawTarget {
    let stderr = Term::buffered_stderr();
    if stderr.is_term() {
        ProgressDrawTarget::term_like_with_hz(Box::new(Narrower(stderr)), FRAMES)
    } else {
        ProgressDrawTarget::hidden()
    }
}

/// Drawings of a bar a second, at most.
const FRAMES: u8 = 20;

/// A bar on standard error if that is a terminal; nothing in a pipe.
pub fn progress_bar(length: usize) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(length as u64), terminal());
    match ProgressStyle::with_template("{bar:40} {pos} of {len}, {elapsed} elapsed, {eta} left") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
