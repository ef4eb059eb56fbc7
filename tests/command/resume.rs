//! A single path that is interrupted or killed, and goes on where it stopped: the command, on a path that takes seconds. How
//! points are kept is tested in `tests/report/resume.rs`.

use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::sync::LazyLock;
use std::thread::sleep;
use std::time::{Duration, Instant};
use tempfile::tempdir;

const SLOW: [&str; 4] = ["--set", "accuracy.elements=320", "--set", "accuracy.step=1e-5"];
const PARTIAL: &str = "out/run.partial";
const ALL: [&str; 6] = ["curve.png", "curve.svg", "limit_points.csv", "shapes.png", "shapes.svg", "summary.json"];

/// `peel run` of a nearly unshearable strip, on which Newton's method is slow, into out/ in this folder.
fn peel_run(dir: &Path, more: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_peel"));
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/hard/unshearable.toml");
    command.current_dir(dir).stdout(Stdio::piped()).stderr(Stdio::piped());
    command.args(["run", scene, "--out", "out"]).args(SLOW).args(more);
    command
}

fn texts(output: &Output) -> (String, String) {
    (String::from_utf8(output.stdout.clone()).unwrap(), String::from_utf8(output.stderr.clone()).unwrap())
}

/// Runs to a good end; what it printed.
#[track_caller]
fn finish(dir: &Path, more: &[&str]) -> String {
    let output = peel_run(dir, more).output().unwrap();
    let (stdout, stderr) = texts(&output);
    assert_eq!((output.status.code(), stderr.as_str()), (Some(0), ""));
    stdout
}

/// Every file of out/ but curve.csv, which stands for itself, with summary.json without times and bounds.
fn files(dir: &Path) -> Vec<Vec<u8>> {
    let mut files = vec![fs::read(dir.join("out/curve.csv")).unwrap()];
    for name in ALL {
        let file = fs::read(dir.join("out").join(name)).unwrap();
        let timed = |line: &&[u8]| !line.windows(9).any(|part| part == b"\"solve_s\"" || part == b"\"time_s\":");
        files.push(file.split(|&byte| byte == b'\n').filter(timed).collect::<Vec<_>>().join(&b'\n'));
    }
    files
}

/// The files of a run that nothing has stopped, which left nothing else behind.
static WHOLE: LazyLock<Vec<Vec<u8>>> = LazyLock::new(|| {
    let whole = tempdir().unwrap();
    finish(whole.path(), &[]);
    assert!(!whole.path().join(PARTIAL).exists(), "a finished run leaves nothing behind");
    files(whole.path())
});

fn kept(dir: &Path) -> u64 {
    fs::metadata(dir.join(PARTIAL)).map_or(0, |file| file.len())
}

/// Sends a signal to a run once it has kept more than before; nothing where it was over before that.
fn stopped(dir: &Path, signal: &str) -> Option<Output> {
    let before = kept(dir);
    let mut child = peel_run(dir, &[]).spawn().unwrap();
    let began = Instant::now();
    while kept(dir) <= before {
        assert!(began.elapsed() < Duration::from_secs(120), "waited in vain for {PARTIAL} to grow");
        if child.try_wait().unwrap().is_some() {
            return None;
        }
        sleep(Duration::from_millis(1));
    }
    Command::new("kill").args([&format!("-{signal}"), &child.id().to_string()]).status().unwrap();
    let output = child.wait_with_output().unwrap();
    (output.status.code() != Some(0)).then_some(output)
}

#[track_caller]
fn check_interrupted(output: &Output) {
    let (stdout, stderr) = texts(output);
    assert_eq!(output.status.code(), Some(3), "{stderr}");
    for part in ["interrupted", PARTIAL, "the same command", "--fresh"] {
        assert!(stderr.contains(part), "{part:?} is not in\n{stderr}");
    }
    assert!(stdout.contains("bound: ") && stdout.contains("curve.csv"), "what was reached is written: {stdout}");
}

/// A machine may be so fast, or have signals ignored, that a run is over before the signal: then there is less to go on from.
#[test]
fn a_killed_and_interrupted_run_goes_on_and_gives_the_same_files() {
    let dir = tempdir().unwrap();
    for signal in ["KILL", "INT", "KILL"] {
        match stopped(dir.path(), signal) {
            Some(output) if signal == "INT" => check_interrupted(&output),
            Some(output) => assert_eq!(output.status.signal(), Some(9)),
            None => break,
        }
    }
    if kept(dir.path()) > 0 {
        let stdout = finish(dir.path(), &[]);
        assert!(stdout.contains("path points taken from an earlier"), "{stdout}");
        assert!(!dir.path().join(PARTIAL).exists());
    }
    assert!(files(dir.path()) == *WHOLE, "the files differ");
}

#[test]
fn a_run_that_ran_out_of_time_goes_on() {
    let dir = tempdir().unwrap();
    let first = finish(dir.path(), &["--set", "bounds.time=0.1 s"]);
    assert!(first.contains("bounds.time = 0.1 s") && first.contains(PARTIAL), "{first}");
    let other = peel_run(dir.path(), &["--set", "strip.height=9 nm", "--force"]).output().unwrap();
    let (before, (stdout, stderr)) = (kept(dir.path()), texts(&other));
    assert_eq!((other.status.code(), stdout.as_str()), (Some(2), ""));
    assert!(stderr.contains(PARTIAL) && stderr.contains("another scene") && stderr.contains("--fresh"), "{stderr}");
    let second = finish(dir.path(), &["--set", "bounds.time=0.15 s"]);
    assert!(second.contains("path points taken from an earlier") && kept(dir.path()) > before, "{second}");
    finish(dir.path(), &[]);
    assert!(files(dir.path()) == *WHOLE, "the files differ");
}
