//! The command, run as a user runs it.

use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Command;

/// Exit status, text and trouble of the command in a folder.
pub fn run(folder: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_peel")).current_dir(folder).args(arguments).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout), text(output.stderr))
}

/// The object that the command prints, which ends well.
#[track_caller]
pub fn json(folder: &Path, arguments: &[&str]) -> Value {
    let (status, text, trouble) = run(folder, &[arguments, &["--json"]].concat());
    assert_eq!(status, Some(0), "{arguments:?}: {trouble}");
    serde_json::from_str(&text).unwrap()
}

/// What the command is in trouble with, in one line, without the frame in which long messages are drawn.
pub fn plain(trouble: &str) -> String {
    trouble.replace(['│', '\n'], " ").split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Where a scene of `scenes/` is.
pub fn scene(name: &str) -> String {
    format!("{}/../../scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"))
}

/// The command is refused in a folder with a message that has these parts: exit status 2, and nothing on standard output.
#[track_caller]
pub fn is_refused(folder: &Path, arguments: &[&str], parts: &[&str]) {
    let (status, text, trouble) = run(folder, arguments);
    assert_eq!((status, text.as_str()), (Some(2), ""), "{arguments:?}: {trouble}");
    for part in parts {
        assert!(plain(&trouble).contains(part), "{arguments:?}: {part:?} is not in\n{trouble}");
    }
}

/// The same in a folder with these files alone, before anything is computed: nothing else is there then.
#[track_caller]
pub fn refuses(files: &[(&str, &str)], arguments: &[&str], parts: &[&str]) {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        fs::write(folder.path().join(name), text).unwrap();
    }
    is_refused(folder.path(), arguments, parts);
    let left = fs::read_dir(folder.path()).unwrap().count();
    assert_eq!(left, files.len(), "{arguments:?}: something is written");
}
