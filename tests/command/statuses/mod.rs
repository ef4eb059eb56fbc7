//! The command: exit statuses, what goes to which stream, and the files it writes.
//!
//! Expected: 0 done, 2 bad input with a message that names what, where and what would be right, 3 when the computation
//! stopped short, 1 for the rest. Standard output carries the result alone and standard error the trouble alone, so
//! that the command can stand in a pipe. Why: scripts and other programs rest on these names and numbers.

use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Command;
use tempfile::{TempDir, tempdir};

mod files;
mod input;
mod results;

/// A folder with the ready scenes in it.
fn bench() -> TempDir {
    let dir = tempdir().unwrap();
    for name in ["strip", "strip-100nm", "strip-soft"] {
        let scene = format!("{}/../../scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
        fs::copy(scene, dir.path().join(format!("{name}.toml"))).unwrap();
    }
    dir
}

/// What one run of the command gave.
struct Outcome {
    status: i32,
    stdout: String,
    stderr: String,
}

impl Outcome {
    #[track_caller]
    fn is_bad_input(&self, parts: &[&str]) {
        assert_eq!(self.status, 2, "{}", self.stderr);
        assert_eq!(self.stdout, "", "a refusal says nothing on standard output");
        for part in parts {
            assert!(self.stderr.contains(part), "{part:?} is not in\n{}", self.stderr);
        }
    }

    #[track_caller]
    fn json(&self) -> Value {
        serde_json::from_str(&self.stdout).expect(&self.stdout)
    }
}

fn peel(dir: &Path, args: &[&str]) -> Outcome {
    let output = Command::new(env!("CARGO_BIN_EXE_peel")).current_dir(dir).args(args).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    Outcome {
        status: output.status.code().expect("ended by itself"),
        stdout: text(output.stdout),
        stderr: text(output.stderr),
    }
}

/// `peel sweep` over the length, with three arguments that may be wrong.
fn sweep(dir: &Path, vary: &str, from: &str, to: &str, points: &str) -> Outcome {
    peel(dir, &["sweep", "strip.toml", "--vary", vary, "--from", from, "--to", to, "--points", points])
}

/// Exit status 3 says that the computation stopped short, and says why; 0 that it did not.
#[track_caller]
fn assert_status_tells_the_end(outcome: &Outcome, end: &Value, reason: &Value) {
    match outcome.status {
        0 => {
            assert!(end != "failed" && end != "refused", "{end}");
            assert_eq!(outcome.stderr, "", "nothing to say in a pipe");
        }
        3 => {
            assert_eq!(end, "failed");
            let line = reason.as_str().unwrap().lines().next().unwrap();
            assert!(outcome.stderr.contains(line), "{}", outcome.stderr);
        }
        2 => {
            assert_eq!(end, "refused");
            assert!(reason.as_str().is_some_and(|reason| reason.contains("no stable state")), "{reason}");
            assert!(outcome.stderr.contains("no stable state"), "{}", outcome.stderr);
        }
        other => panic!("exit status {other}: {}", outcome.stderr),
    }
}
