//! What is wrong with a scene, where, and what would be right.

use miette::{Diagnostic, NamedSource, SourceSpan};
use peelkit::model::ModelError;
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
    /// What it is about: "`strip.length`", "[strip]", "the scene"
    subject: String,
    /// What stands at its place in the text
    at: String,
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

    /// What is wrong, without where it stands: "`strip.length` is -1 nm, which is out of range".
    pub fn problem(&self) -> String {
        format!("{} {}", self.0.subject, self.0.label)
    }

    /// The file and the line where it stands: "strip.toml, line 4". Nothing of a `--set`.
    pub fn place(&self) -> Option<&str> {
        let before = self.0.message.strip_suffix(&self.problem())?.strip_suffix(": ")?;
        (!before.starts_with("--set ")).then_some(before)
    }

    /// The key that it is about, or the table: `strip.length`, `strip`. Nothing where it is about the text as a whole.
    pub fn key(&self) -> Option<&str> {
        let named = |open, close| self.0.subject.strip_prefix(open)?.strip_suffix(close);
        named('`', '`').or_else(|| named('[', ']'))
    }

    /// The value of that key as it was written, without its quotes. Nothing where it has none, as where the key itself is unknown.
    pub fn value(&self) -> Option<&str> {
        let key = self.key()?;
        let is_name = key == self.0.at || key.rsplit('.').next() == Some(&self.0.at);
        (!self.0.at.is_empty() && !is_name).then(|| self.0.at.trim_matches(['"', '\'']))
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

impl From<ModelError> for ValueError {
    fn from(error: ModelError) -> Self {
        Self::new(error.found(), error.remedy())
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
        let at = text.get(span.clone()).unwrap_or_default().trim().to_owned();
        let (excerpt, span) = excerpt(text, span);
        SceneError(Box::new(Message {
            message,
            subject: subject.to_owned(),
            at,
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

/// Longer words are misspellings of nothing.
const LONGEST_WORD: usize = 64;

/// The candidate that `word` is most likely a misspelling of, if one is near enough.
pub(crate) fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let length = word.chars().count();
    // the comparison takes time and memory in proportion to the word, and no name is as long
    if length > LONGEST_WORD {
        return None;
    }
    let word = word.to_lowercase();
    let slips = 1 + length / 4;
    let slips_to = |candidate: &str| strsim::damerau_levenshtein(&word, &candidate.to_lowercase());
    // Two short words are never far apart: more than half of the word has to be right.
    let near_enough = |slip: usize, candidate: &str| slip <= slips && 2 * slip < candidate.chars().count().max(2);
    candidates
        .into_iter()
        .map(|candidate| (slips_to(candidate), candidate))
        .filter(|&(slip, candidate)| near_enough(slip, candidate))
        .min_by_key(|&(slip, _)| slip)
        .map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn finds_slips_and_leaves_the_rest_alone() {
        let words = ["length", "height", "width"];
        assert_eq!(nearest("lenght", words), Some("length"));
        assert_eq!(nearest("Height", words), Some("height"));
        assert_eq!(nearest("colour", words), None);
        assert_eq!(nearest("", words), None);
        assert_eq!(nearest(&"length".repeat(1_000_000), words), None);
    }
}
