//! Every command that a document or a scene names is run, and the library example of the README is one that is compiled.
//!
//! `peel run` and `peel sweep` are run on few path points, which is enough for every key and flag to be read and used; of the others the flags are
//! read. A command with `...` in it is a pattern and none to run.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

fn text(path: &str) -> String {
    std::fs::read_to_string(Path::new(ROOT).join(path)).unwrap()
}

/// What follows `peel` in a document: in lines of code, which may end in a remark behind two spaces, and between backticks.
fn commands(text: &str) -> BTreeSet<String> {
    let in_lines = text.lines().filter_map(|line| {
        let code = line.strip_prefix("    ").or_else(|| line.strip_prefix("#   "))?;
        let command = code.strip_prefix("peel ").or_else(|| code.strip_prefix("cargo run --release -- "))?;
        Some(command.split("  ").next().unwrap_or(command).to_owned())
    });
    let in_text = text.lines().flat_map(|line| line.split('`').skip(1).step_by(2)).filter_map(|code| {
        let command = code.strip_prefix("peel ")?;
        Some(command.to_owned())
    });
    let found = in_lines.chain(in_text).map(|command| command.trim().to_owned());
    found.filter(|command| !command.contains("...") && !command.contains('|')).collect()
}

#[test]
fn commands_of_the_documents_run() {
    let mut all = BTreeSet::new();
    let mut files = vec!["README.md".to_owned(), "verification/README.md".into(), "figures/README.md".into()];
    for folder in ["scenes", "docs"] {
        for file in std::fs::read_dir(Path::new(ROOT).join(folder)).unwrap() {
            let name = file.unwrap().file_name().into_string().unwrap();
            if name.ends_with(".toml") || name.ends_with(".md") {
                files.push(format!("{folder}/{name}"));
            }
        }
    }
    for file in files {
        all.extend(commands(&text(&file)));
    }
    assert!(all.len() > 30, "{all:?}");
    let folder = tempfile::tempdir().unwrap();
    let mut failed = Vec::new();
    for command in &all {
        let words = shlex::split(command).unwrap_or_else(|| panic!("quotes are not closed: peel {command}"));
        let runs =
            matches!(words[0].as_str(), "run" | "sweep") && words.get(1).is_some_and(|word| word.ends_with(".toml"));
        let mut peel = Command::new(env!("CARGO_BIN_EXE_peel"));
        peel.current_dir(folder.path());
        for word in &words {
            let name = word.strip_prefix("scenes/").unwrap_or(word);
            let scene = Path::new(ROOT).join("scenes").join(name);
            if word.ends_with(".toml") && scene.exists() {
                peel.arg(scene)
            } else {
                peel.arg(word)
            };
        }
        if runs {
            peel.args(["--set", "bounds.points=6"]);
            if !words.iter().any(|word| word == "--json") {
                peel.arg("--force");
            }
        } else {
            peel.arg("--help");
        }
        let output = peel.output().unwrap();
        if !output.status.success() {
            failed.push(format!("peel {command}: {}", String::from_utf8_lossy(&output.stderr)));
        }
    }
    assert!(failed.is_empty(), "{}", failed.join("\n"));
}

/// The lines of the README's library example stand in `examples/as_a_library.rs`, one after the other.
#[test]
fn the_library_example_is_compiled() {
    let lines = |text: &str| -> Vec<String> {
        text.lines().map(|line| line.trim().to_owned()).filter(|line| !line.is_empty()).collect()
    };
    let readme = text("README.md");
    let example = readme.split("## As a library").nth(1).unwrap();
    let code: Vec<&str> =
        example.lines().skip(1).take_while(|line| line.is_empty() || line.starts_with("    ")).collect();
    let (wanted, compiled) = (lines(&code.join("\n")), lines(&text("examples/as_a_library.rs")));
    assert!(wanted.len() > 10, "{wanted:?}");
    let mut rest = compiled.iter();
    for line in &wanted {
        assert!(rest.any(|compiled| compiled == line), "not in examples/as_a_library.rs: {line}");
    }
}
