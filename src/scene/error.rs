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
}

/// What is wrong with one value, without its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// What was found: completes "`strip.length` ...".
    pub found: String,
    /// What would be right: a sentence of its own.
    pub remedy: String,
}

impl Problem {
    pub(crate) fn new(found: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self { found: found.into(), remedy: remedy.into() }
    }
}

/// A text that a user wrote: the scene's file, or one `--set`.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Origin<'a> {
    File { name: &'a str, text: &'a str },
    Override { text: &'a str },
}

impl Origin<'_> {
    /// The error that `subject` is as the problem says, at `span` of this text.
    pub(crate) fn error(&self, span: Range<usize>, subject: &str, problem: Problem) -> SceneError {
        let Problem { found, remedy } = problem;
        let (message, name, text) = match self {
            Self::File { name, text } => {
                let line = 1 + text.as_bytes().iter().take(span.start).filter(|&&byte| byte == b'\n').count();
                (format!("{name}, line {line}: {subject} {found}"), *name, *text)
            }
            Self::Override { text } => (format!("--set {text}: {subject} {found}"), "--set", *text),
        };
        SceneError(Box::new(Message {
            message,
            // A span at the end of a text needs a line to stand on.
            source_code: NamedSource::new(name, if text.is_empty() { "\n".to_owned() } else { text.to_owned() }),
            span: span.into(),
            label: found,
            remedy,
        }))
    }
}
