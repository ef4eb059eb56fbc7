//! Every command that a document or a scene names is run.
//!
//! `peel run` and `peel sweep` are run on few path points and values, which is enough for every key and flag to be read and used; of
//! the others the flags are read. Of other programs the names are looked for: tests, examples, benches, scripts. A command with `...` in it is a
//! pattern and none to run.

use super::{ROOT, documents, files_in, place, text};
use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

/// The lines of code of a document, without what stands behind two spaces, and what stands between backticks.
fn code(text: &str) -> Vec<String> {
    let mut fenced = false;
    let mut all = Vec::new();
    for line in text.lines() {
        if line.starts_with("```") {
            fenced = !fenced;
            continue;
        }
        let indented = line.strip_prefix("    ").or_else(|| line.strip_prefix("#   "));
        let line_of_code = if fenced { Some(line.strip_prefix("$ ").unwrap_or(line)) } else { indented };
        match line_of_code {
            Some(code) => all.push(code.split("  ").next().unwrap_or(code).to_owned()),
            None => all.extend(line.split('`').skip(1).step_by(2).map(str::to_owned)),
        }
    }
    all
}

/// What follows `peel` in a document.
fn commands(text: &str) -> BTreeSet<String> {
    let command = |code: String| {
        let code = code.strip_prefix("time ").unwrap_or(&code);
        let command = code.strip_prefix("peel ").or_else(|| code.strip_prefix("cargo run --release -- "))?;
        Some(command.trim().to_owned())
    };
    let found = code(text).into_iter().filter_map(command);
    found.filter(|command| !command.contains("...") && !command.contains('|')).collect()
}

fn texts() -> Vec<(String, String)> {
    let scenes = ["scenes", "scenes/teaching"].into_iter().flat_map(|folder| files_in(folder, ".toml"));
    documents().into_iter().chain(scenes).map(|path| (path.clone(), text(&path))).collect()
}

/// Values of a sweep.
const FEW: usize = 2;

#[test]
fn commands_of_the_documents_run() {
    let words = |command: &String| -> Vec<String> {
        let words = shlex::split(command).unwrap_or_else(|| panic!("quotes are not closed: peel {command}"));
        words.iter().map(|word| with_place(word)).collect()
    };
    let all: BTreeSet<Vec<String>> =
        texts().iter().flat_map(|(_, text)| commands(text)).map(|command| words(&command)).collect();
    assert!(all.len() > 80, "{all:?}");
    let folder = tempfile::tempdir().unwrap();
    let failed: Vec<String> = all.into_iter().filter_map(|words| failure(words, folder.path())).collect();
    assert!(failed.is_empty(), "{}", failed.join("\n"));
}

/// What the command says if it fails, cut down to what takes little time.
fn failure(mut words: Vec<String>, folder: &Path) -> Option<String> {
    let has = |words: &[String], flag: &str| words.iter().any(|word| word == flag);
    let given = words.join(" ");
    let is_scene = words.get(1).is_some_and(|word| word.ends_with(".toml"));
    if matches!(words[0].as_str(), "run" | "sweep") && is_scene {
        if let Some(at) = words.iter().position(|word| word == "--points") {
            words[at + 1] = FEW.to_string();
        }
        let scene = std::fs::read_to_string(&words[1]).unwrap_or_default();
        let mut set = |text: &str| words.extend(["--set", text].map(str::to_owned));
        // a seta is small with few forks and a coarse table of its tips
        if scene.contains("[seta]") {
            if scene.contains("\nforks")
                && !["seta.forks", "seta.branches", "seta.tree"].iter().any(|key| given.contains(key))
            {
                set("seta.forks=2");
            }
            if given.contains("seta.tip_law=table") {
                set("seta.tip_tolerance=5e-2");
            }
        }
        // a point that is followed is looked for on a whole path; an array has no points, and is small with few setae in a row
        if scene.contains("[setae]") {
            set("setae.columns=2");
        } else if !["--follow", "--peak-only"].iter().any(|flag| given.contains(flag)) {
            set("bounds.points=6");
        }
        // pictures take longer than so few points; what writes files of its own writes them anew
        if ["--states", "--animate", "--part"].iter().any(|flag| has(&words, flag)) {
            words.push("--force".into());
        } else if !has(&words, "--json") {
            words.push("--json".into());
        }
    } else {
        words.push("--help".into());
    }
    let output = Command::new(env!("CARGO_BIN_EXE_peel")).args(&words).current_dir(folder).output().unwrap();
    // steps before the pull stop short where a document shows that they do, and a pull in time does after so few steps
    let stops = output.status.code() == Some(3) && ["drive.steps", "at-a-rate"].iter().any(|part| given.contains(part));
    let failed = !output.status.success() && !stops;
    failed.then(|| format!("peel {given}: {}", String::from_utf8_lossy(&output.stderr)))
}

/// A word of a command; a scene of the repository with its place.
fn with_place(word: &str) -> String {
    let candidates = [word.to_owned(), format!("scenes/{word}"), format!("scenes/teaching/{word}")];
    let scene = candidates.iter().map(|path| Path::new(ROOT).join(path)).find(|path| path.is_file());
    match scene.filter(|_| word.ends_with(".toml")) {
        Some(path) => path.to_str().unwrap().to_owned(),
        None => word.to_owned(),
    }
}

#[test]
fn other_programs_that_documents_name_are_there() {
    let manifests: String = ["Cargo.toml", "benches/Cargo.toml"]
        .map(str::to_owned)
        .into_iter()
        .chain(manifests())
        .map(|path| text(&path))
        .collect();
    let mut missing = Vec::new();
    for (path, text) in texts() {
        for code in code(&text).iter().filter(|code| !code.contains("...")) {
            let words: Vec<&str> = code.split_whitespace().collect();
            let after = |flag: &str| words.iter().skip_while(|&&word| word != flag).nth(1).copied();
            if words.first() == Some(&"cargo") {
                let named = ["--test", "--example", "--bench"].into_iter().filter_map(after);
                missing.extend(
                    named
                        .filter(|name| !manifests.contains(&format!("name = \"{name}\"")))
                        .map(|name| format!("{path}: {name}")),
                );
            }
            let scripts = words.iter().filter(|word| word.starts_with("verification/") && word.ends_with(".py"));
            missing.extend(scripts.filter(|script| !place(script).is_file()).map(|script| format!("{path}: {script}")));
        }
    }
    assert!(missing.is_empty(), "{missing:?}");
}

fn manifests() -> Vec<String> {
    ["checks", "command", "report", "scene", "serve"].map(|name| format!("crates/{name}/Cargo.toml")).to_vec()
}
