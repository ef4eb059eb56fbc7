//! What the documents say is run, read, compiled and compared.
//!
//!     cargo test --test command documents
//!     PEELKIT_WRITE=1 cargo test --test command documents        writes again what documents take from the program
//!
//! The Rust programs of `docs/reference/library.md` and of its pages are doc tests of `peelkit-checks`.

mod commands;
#[cfg(unix)]
mod console;
mod dependencies;
mod examples;
mod links;
mod messages;
mod output_reference;
mod scene_reference;
mod scenes;
mod teaching;

use std::path::{Path, PathBuf};

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// Where a document or a scene is.
fn place(path: &str) -> PathBuf {
    Path::new(ROOT).join(path)
}

fn text(path: &str) -> String {
    std::fs::read_to_string(place(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// The chapters of the book, from the folder of the repository.
fn chapters() -> Vec<String> {
    let mut folders = vec!["docs".to_owned()];
    let mut found = Vec::new();
    while let Some(folder) = folders.pop() {
        found.extend(files_in(&folder, ".md"));
        let entries = std::fs::read_dir(place(&folder)).unwrap().map(|entry| entry.unwrap());
        let inner = entries.filter(|entry| entry.file_type().unwrap().is_dir());
        folders.extend(inner.map(|entry| format!("{folder}/{}", entry.file_name().into_string().unwrap())));
    }
    found.sort();
    found
}

/// What a user reads: README, the book, and the two other documents with commands.
fn documents() -> Vec<String> {
    let others = ["README.md", "CONTRIBUTING.md", "ARCHITECTURE.md", "verification/README.md", "figures/README.md"];
    others.map(str::to_owned).into_iter().chain(chapters()).collect()
}

/// A chapter of the reference, `docs/reference/NAME.md`, and the pages of its folder.
fn pages(name: &str) -> Vec<String> {
    let chapter = format!("docs/reference/{name}.md");
    std::iter::once(chapter).chain(files_in(&format!("docs/reference/{name}"), ".md")).collect()
}

/// The files of a folder of the repository whose name ends so.
fn files_in(folder: &str, ending: &str) -> Vec<String> {
    let files = std::fs::read_dir(place(folder)).unwrap().map(|file| file.unwrap().file_name().into_string().unwrap());
    let mut files: Vec<String> =
        files.filter(|name| name.ends_with(ending)).map(|name| format!("{folder}/{name}")).collect();
    files.sort();
    files
}

/// A fenced block of a document.
struct Block {
    /// What stands behind the fence: `toml`, `console`.
    kind: String,
    /// Its first line in the file, counted from 0, and the one behind its last.
    lines: std::ops::Range<usize>,
    text: String,
}

/// The fenced blocks of a document, in order.
fn blocks(text: &str) -> Vec<Block> {
    let lines: Vec<&str> = text.lines().collect();
    let fences: Vec<usize> = (0..lines.len()).filter(|&line| lines[line].starts_with("```")).collect();
    assert!(fences.len().is_multiple_of(2), "a fence is not closed");
    let block = |pair: &[usize]| Block {
        kind: lines[pair[0]].trim_start_matches('`').to_owned(),
        lines: pair[0] + 1..pair[1],
        text: lines[pair[0] + 1..pair[1]].join("\n"),
    };
    fences.chunks(2).map(block).collect()
}

/// Whether documents are to be written again instead of compared.
fn writing() -> bool {
    std::env::var_os("PEELKIT_WRITE").is_some()
}

/// Holds the text of a document against what it should be, or writes it again.
fn hold(path: &str, wanted: &str) {
    if text(path) == wanted {
        return;
    }
    if writing() {
        return std::fs::write(place(path), wanted).unwrap();
    }
    let found = text(path);
    let differs = found.lines().zip(wanted.lines()).find(|(found, wanted)| found != wanted);
    panic!(
        "{path} is not what the program says: {differs:?}. PEELKIT_WRITE=1 cargo test --test command documents writes it again"
    );
}

/// The text with what stands between `<!-- NAME: begin -->` and `<!-- NAME: end -->` replaced.
fn with_part(text: &str, name: &str, part: &str) -> String {
    let (begin, end) = (format!("<!-- {name}: begin -->\n"), format!("<!-- {name}: end -->"));
    let (before, rest) = text.split_once(&begin).unwrap_or_else(|| panic!("no {begin}"));
    let (_, after) = rest.split_once(&end).unwrap_or_else(|| panic!("no {end}"));
    format!("{before}{begin}\n{part}\n{end}{after}")
}

/// A row of a table in Markdown.
fn row(cells: &[&str]) -> String {
    format!("| {} |\n", cells.join(" | ")).replace("|  |", "| |").replace("|  |", "| |")
}
