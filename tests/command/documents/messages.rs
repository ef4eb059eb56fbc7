//! Every message of the code has its place in `docs/reference/troubleshooting.md` or on a page of its folder.

use super::{pages, text};
use std::path::{Path, PathBuf};

/// What a message begins behind.
const MARKS: [&str; 13] = [
    "#[error(",
    "ValueError::new(",
    "bad_input(",
    "cut_short(",
    "Refusal::asked(",
    "Refusal::scene(",
    "CutShort(",
    "Stop::other(",
    "OverlayError::new(path,",
    "OverlayError::new(&table,",
    "refused(py,",
    "computation_error(py,",
    "other(py,",
];

/// The files of the code, without those of tests.
fn sources() -> Vec<PathBuf> {
    let mut folders: Vec<PathBuf> = [
        "src",
        "crates/scene/src",
        "crates/report/src",
        "crates/serve/src",
        "crates/command/src",
        "crates/analyses/src",
        "python/src",
    ]
    .map(super::place)
    .to_vec();
    let mut files = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            match path.is_dir() {
                true => folders.push(path),
                false => files.push(path),
            }
        }
    }
    files.retain(|file| file.extension().is_some_and(|extension| extension == "rs"));
    files
}

/// The text of the string that the code begins with, if it does.
fn string(code: &str) -> Option<String> {
    let code = code.trim_start();
    let code = code.strip_prefix('&').unwrap_or(code);
    let code = code.strip_prefix("format!(").unwrap_or(code).trim_start().strip_prefix('"')?;
    let mut text = String::new();
    let mut rest = code.chars();
    loop {
        match rest.next()? {
            '"' => return Some(text),
            '\\' => match rest.next()? {
                ' ' => rest = rest.as_str().trim_start().chars(),
                escaped => text.push(escaped),
            },
            other => text.push(other),
        }
    }
}

/// What stands between the numbers and names of a message; the longest part.
fn longest_part(message: &str) -> String {
    let mut parts = vec![String::new()];
    let mut inside = false;
    for c in message.chars() {
        match c {
            '{' => inside = true,
            '}' => {
                inside = false;
                parts.push(String::new());
            }
            _ if inside => {}
            other => parts.last_mut().unwrap().push(other),
        }
    }
    plain(&parts.into_iter().max_by_key(|part| part.chars().count()).unwrap_or_default())
}

/// Without what a document adds.
fn plain(text: &str) -> String {
    text.replace(['`', '\\'], "").split_whitespace().collect::<Vec<_>>().join(" ")
}

fn messages(file: &Path) -> Vec<String> {
    let code = std::fs::read_to_string(file).unwrap();
    let code = code.split("#[cfg(test)]").next().unwrap();
    // as on one line
    let code = code.split_whitespace().collect::<Vec<_>>().join(" ").replace("( ", "(");
    MARKS.iter().flat_map(|mark| code.split(mark).skip(1).filter_map(string)).collect()
}

/// The text of the chapter with all of its pages.
fn chapter_on_trouble() -> String {
    pages("troubleshooting").iter().map(|page| text(page)).collect()
}

#[test]
fn every_message_is_in_the_chapter_on_trouble() {
    let chapter = plain(&chapter_on_trouble());
    let mut missing = Vec::new();
    let mut seen = 0;
    for file in sources() {
        for message in messages(&file) {
            let part = longest_part(&message);
            // no more than a number or another message
            if part.len() < 6 {
                continue;
            }
            seen += 1;
            if !chapter.contains(part.trim_matches([',', '.', ':', ';', ' ', '('])) {
                missing.push(format!("{}: {message}", file.display()));
            }
        }
    }
    assert!(seen > 150, "{seen}");
    assert!(missing.is_empty(), "docs/reference/troubleshooting lacks\n{}", missing.join("\n"));
}

#[test]
fn every_warning_and_every_end_is_explained() {
    let quoted = |path: &str, after: &str| -> Vec<String> {
        let code = text(path);
        code.lines()
            .filter(|line| line.contains("Self::") || line.contains("PathEnd::"))
            .filter_map(|line| Some(line.split_once(after)?.1.split('"').next()?.to_owned()))
            .collect()
    };
    let warnings = quoted("src/study/terms/warnings.rs", "=> \"");
    let ends = quoted("crates/report/src/writing/names.rs", "=> \"");
    assert!(warnings.len() >= 7 && ends.len() >= 11, "{warnings:?} {ends:?}");
    let (trouble, concepts) = (chapter_on_trouble(), text("docs/reference/concepts.md"));
    let missing = warnings.iter().filter(|code| !trouble.contains(&format!("`{code}`")));
    let unexplained = ends.iter().filter(|end| !concepts.contains(&format!("`{end}`")));
    let missing: Vec<_> = missing.chain(unexplained).collect();
    assert!(missing.is_empty(), "{missing:?}");
}
