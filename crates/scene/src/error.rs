//! What is wrong with a scene, where, and what would be right.

use miette::{Diagnostic, NamedSource, SourceSpan};
use std::ops::Range;

/// A scene that cannot be used: one message that names the place, the key, what was found and what would be right.
#[derive(Debug, thiserror::Error, Diagnostic)]
#[error(transparent)]
#[diagnostic(transparent)]
pub struct SceneError(Box<Message>);

#[derive(Debug, thiserror::Error, Diagnostic)]
#[error("{message}")]
struct Message {
    message: String,
    statement: String,
    #[source_code]
    source_code: NamedSource<String>,
    #[label("{label}")]
    span: SourceSpan,
    label: String,
    #[help]
    remedy: String,
}

impl SceneError {
    /// What would be right.
    pub fn remedy(&self) -> &str {
        &self.0.remedy
    }

    /// The message without its place: "`strip.length` is ...".
    pub fn statement(&self) -> &str {
        &self.0.statement
    }
}

/// What is wrong with one value, without its place.
#[derive(Clone, Debug, PartialEq)]
pub struct ValueError {
    /// What was found: completes "`strip.length` ...".
    pub found: String,
    /// What would be right: a sentence of its own.
    pub remedy: String,
    /// Which item of a list it is in, counted from 0, where the value is one.
    pub item: Option<usize>,
}

impl ValueError {
    pub(crate) fn new(found: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self { found: found.into(), remedy: remedy.into(), item: None }
    }
}

/// What a user wrote as it stands in a message: on one line and not too long.
pub(crate) fn one_line(text: &str) -> String {
    const LONGEST: usize = 80;
    let plain = |c: char| if c.is_control() { c.escape_default().collect() } else { c.to_string() };
    let cut: String = text.chars().take(LONGEST).map(plain).collect();
    if text.chars().nth(LONGEST).is_some() { cut + "…" } else { cut }
}

/// A text that a user wrote: the scene's file, or one `--set`.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Origin<'a> {
    File { name: &'a str, text: &'a str },
    Override { text: &'a str },
}

impl Origin<'_> {
    /// The error that `subject` is as the problem says, at `span` of this text.
    pub(crate) fn error(&self, span: Range<usize>, subject: &str, problem: ValueError) -> SceneError {
        let ValueError { found, remedy, .. } = problem;
        let (message, name, text) = match self {
            Self::File { name, text } => {
                let line = 1 + text.as_bytes().iter().take(span.start).filter(|&&byte| byte == b'\n').count();
                (format!("{name}, line {line}: {subject} {found}"), *name, *text)
            }
            Self::Override { text } => (format!("--set {}: {subject} {found}", one_line(text)), "--set", *text),
        };
        let (excerpt, span) = excerpt(text, span);
        SceneError(Box::new(Message {
            message,
            statement: format!("{subject} {found}"),
            source_code: NamedSource::new(name, excerpt),
            span: span.into(),
            label: found,
            remedy,
        }))
    }
}

/// What is shown of a text around a place in it, and the place there: all of it, of which the reader cuts out the lines, or the
/// beginning of the one line where lines are too long to be read.
fn excerpt(text: &str, span: Range<usize>) -> (String, Range<usize>) {
    const LONGEST_LINE: usize = 400;
    if text.lines().all(|line| line.len() <= LONGEST_LINE) {
        // a span at the end of a text needs a line to stand on
        return (format!("{text}\n"), span);
    }
    let start = text.as_bytes().iter().take(span.start).rposition(|&byte| byte == b'\n').map_or(0, |end| end + 1);
    let line = text.get(start..).and_then(|rest| rest.lines().next()).unwrap_or_default();
    (one_line(line) + "\n", 0..0)
}
