//! Standard output, and the bar on a terminal.

use super::stop::Stop;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::{ErrorKind, Write};
use std::path::PathBuf;

/// Writes to standard output. A reader that has read enough and closed the pipe is no error.
pub fn say(text: &str) -> Result<(), Stop> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Stop::other(format!("cannot print: {error}"))),
        _ => Ok(()),
    }
}

/// The files that were written, a line each.
pub fn list_files(files: &[PathBuf]) -> String {
    files.iter().map(|file| format!("wrote {}\n", file.display())).collect()
}

/// A bar on standard error if that is a terminal; nothing in a pipe.
pub fn progress_bar(length: usize) -> ProgressBar {
    let bar = ProgressBar::new(length as u64);
    match ProgressStyle::with_template("{bar:40} {pos} of {len}, {elapsed} gone, {eta} to go") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
