//! What a sweep has written when it is interrupted.
//!
//!     values:    o--o--o--o | o--o--o--o--o
//!     run        computed   ^ Ctrl-C: the rows to the left are in sweep.csv, and kept in sweep.partial
//!
//! Parameters: the strip of 100 nm, 40 lengths from 60 to 120 nm, whole peels. The reference is the same sweep without an
//! interruption, on one core. Expected: exit status 3 and the finished rows in sweep.csv after Ctrl-C, 130 after a second
//! one; fewer values of the same sweep are taken. How every kind of analysis goes on is tested in `resume.rs`. Why: what a sweep has found is of use before
//! its end.
#![cfg(unix)]

use crate::frames::frames;
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::sync::OnceLock;
use std::time::{Duration, Instant};
use tempfile::{TempDir, tempdir};

const VALUES: usize = 40;
const PARTIAL: &str = "out/sweep.partial";
const TABLE: &str = "out/sweep.csv";

/// `peel sweep` over the length in this folder, on so many cores.
fn sweep_over(dir: &Path, cores: &str, [from, to, points]: [&str; 3], more: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_peel"));
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/strip-100nm.toml");
    command.current_dir(dir).env("RAYON_NUM_THREADS", cores).stdout(Stdio::piped()).stderr(Stdio::piped());
    command.args(["sweep", scene, "--vary", "strip.length", "--from", from, "--to", to, "--points", points]);
    command.args(["--out", "out"]).args(more);
    command
}

/// The sweep of these tests.
fn sweep(dir: &Path, cores: &str, more: &[&str]) -> Command {
    sweep_over(dir, cores, ["60 nm", "120 nm", &VALUES.to_string()], more)
}

/// Runs to the end, which is a good one; what it printed.
#[track_caller]
fn finish(dir: &Path, cores: &str, more: &[&str]) -> String {
    let output = sweep(dir, cores, more).output().unwrap();
    let (stdout, stderr) = texts(&output);
    assert_eq!((output.status.code(), stderr.as_str()), (Some(0), ""));
    assert!(!dir.join(PARTIAL).exists(), "a finished sweep leaves nothing behind");
    for picture in ["out/sweep.svg", "out/sweep.png"] {
        assert!(dir.join(picture).exists(), "{picture}");
    }
    stdout
}

fn texts(output: &Output) -> (String, String) {
    (String::from_utf8(output.stdout.clone()).unwrap(), String::from_utf8(output.stderr.clone()).unwrap())
}

/// The lines of sweep.csv without the column `solve_s`.
fn table(dir: &Path) -> Vec<String> {
    let text = fs::read_to_string(dir.join(TABLE)).unwrap();
    let place = text.lines().next().unwrap().split(',').position(|name| name == "solve_s").unwrap();
    let without = |line: &str| {
        let cells = line.split(',').enumerate().filter(|&(i, _)| i != place).map(|(_, cell)| cell);
        cells.collect::<Vec<_>>().join(",")
    };
    text.lines().map(without).collect()
}

/// The table of the sweep without an interruption.
fn reference() -> &'static [String] {
    static TABLE: OnceLock<Vec<String>> = OnceLock::new();
    TABLE.get_or_init(|| {
        let dir = tempdir().unwrap();
        let stdout = finish(dir.path(), "1", &[]);
        assert!(!stdout.contains("remark"), "{stdout}");
        table(dir.path())
    })
}

/// Finished values in the file of the unfinished sweep.
fn kept(dir: &Path) -> usize {
    frames(&fs::read(dir.join(PARTIAL)).unwrap_or_default()).len().saturating_sub(1)
}

#[track_caller]
fn wait_for(what: &str, mut happened: impl FnMut() -> bool) {
    let began = Instant::now();
    while !happened() {
        assert!(began.elapsed() < Duration::from_secs(120), "waited in vain for {what}");
        std::thread::sleep(Duration::from_millis(1));
    }
}

fn signal(child: &Child, name: &str) {
    let status = Command::new("kill").args([&format!("-{name}"), &child.id().to_string()]).status().unwrap();
    assert!(status.success());
}

/// Whether these tests were started with a signal ignored, by nohup or in the background of a script: the command
/// leaves that as it is, and there is nothing to test.
pub fn signals_are_ignored() -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let ignored = ignored.map_or(0, |mask| u64::from_str_radix(mask.trim(), 16).unwrap());
    [1, 2, 15].iter().any(|signal| ignored >> (signal - 1) & 1 == 1)
}

/// A sweep that got this signal when it had finished a few of its values, and how it ended. A machine may be so busy
/// that the sweep is over before the signal comes: then once more.
fn stopped(name: &str) -> (TempDir, Output) {
    for _ in 0..10 {
        let dir = tempdir().unwrap();
        let mut child = sweep(dir.path(), "1", &[]).spawn().unwrap();
        wait_for("three values", || kept(dir.path()) >= 3 || child.try_wait().unwrap().is_some());
        signal(&child, name);
        let output = child.wait_with_output().unwrap();
        if output.status.code() != Some(0) {
            return (dir, output);
        }
    }
    panic!("the sweep was over before the signal came, ten times");
}

#[test]
fn the_number_of_cores_changes_no_digit() {
    let dir = tempdir().unwrap();
    finish(dir.path(), "2", &[]);
    assert_eq!(table(dir.path()), reference());
}

#[test]
fn ctrl_c_writes_what_is_done_and_the_same_command_goes_on() {
    if signals_are_ignored() {
        return;
    }
    let (dir, output) = stopped("INT");
    let (stdout, stderr) = texts(&output);
    assert_eq!(output.status.code(), Some(3), "{stderr}");
    let done = kept(dir.path());
    assert!((3..VALUES).contains(&done), "{done}");
    for part in [&format!("{done} of {VALUES} values"), "the same command", "--fresh"] {
        assert!(stderr.contains(part), "{part:?} is not in\n{stderr}");
    }
    assert!(stdout.contains("sweep.csv") && dir.path().join("out/sweep.svg").exists(), "{stdout}");
    let (rows, reference) = (table(dir.path()), reference());
    assert_eq!((rows.len(), &rows[0]), (1 + done, &reference[0]));
    let places: Vec<_> = rows.iter().map(|row| reference.iter().position(|other| other == row)).collect();
    assert!(places.iter().all(Option::is_some) && places.is_sorted(), "rows of the sweep in its order: {places:?}");

    let stdout = finish(dir.path(), "2", &[]);
    assert!(stdout.contains(&format!("{done} of {VALUES} values taken")), "{stdout}");
    assert_eq!(table(dir.path()), reference);
}

#[test]
fn fewer_values_of_the_same_sweep_are_taken() {
    let (dir, _) = stopped("KILL");
    let kept = fs::read(dir.path().join(PARTIAL)).unwrap();
    for (more, taken) in [(&[][..], true), (&["--fresh"], false)] {
        fs::write(dir.path().join(PARTIAL), &kept).unwrap();
        let output = sweep_over(dir.path(), "1", ["60 nm", "60 nm", "1"], more).output().unwrap();
        let (stdout, stderr) = texts(&output);
        assert!(output.status.success() && !dir.path().join(PARTIAL).exists(), "{stderr}");
        assert_eq!(stdout.contains("1 of 1 values taken"), taken, "{stdout}");
        assert_eq!(table(dir.path())[1], reference()[1]);
    }
}

/// Values that take long: each of hundreds of times the work that it needs. Where the first signal comes before a value
/// is begun the sweep ends by itself: then once more, later.
#[test]
fn a_second_ctrl_c_quits_at_once() {
    if signals_are_ignored() {
        return;
    }
    let slow = ["--set", "accuracy.elements=2000", "--set", "accuracy.step=1e-6"];
    for wait in [100, 200, 400, 800, 1600].map(Duration::from_millis) {
        let dir = tempdir().unwrap();
        let mut child = sweep_over(dir.path(), "1", ["10 um", "11 um", "3"], &slow).spawn().unwrap();
        wait_for("the sweep to begin", || dir.path().join(PARTIAL).exists());
        std::thread::sleep(wait);
        signal(&child, "INT");
        // signals that come together are one
        std::thread::sleep(wait);
        if child.try_wait().unwrap().is_some() {
            continue;
        }
        signal(&child, "INT");
        let status = child.wait().unwrap();
        if status.code() != Some(3) {
            assert_eq!((status.code(), kept(dir.path())), (Some(130), 0));
            return;
        }
    }
    panic!("no value was under way when the second signal came, five times");
}

#[test]
fn a_folder_that_cannot_be_written_is_told_before_anything_is_computed() {
    let dir = tempdir().unwrap();
    fs::write(dir.path().join("out"), "in the way").unwrap();
    let output = sweep(dir.path(), "1", &[]).output().unwrap();
    let (stdout, stderr) = texts(&output);
    assert_eq!((output.status.code(), stdout.as_str()), (Some(1), ""));
    assert!(stderr.contains("cannot write out: "), "{stderr}");
}

/// The whole results of a sweep are not given up for those of the same sweep that is stopped.
#[test]
fn an_interrupted_second_sweep_keeps_the_files_of_the_first() {
    if signals_are_ignored() {
        return;
    }
    let dir = tempdir().unwrap();
    finish(dir.path(), "1", &[]);
    for _ in 0..10 {
        let mut child = sweep(dir.path(), "1", &[]).spawn().unwrap();
        wait_for("three values", || kept(dir.path()) >= 3 || child.try_wait().unwrap().is_some());
        signal(&child, "INT");
        let output = child.wait_with_output().unwrap();
        let (stdout, _) = texts(&output);
        if output.status.code() == Some(0) {
            continue;
        }
        assert_eq!(output.status.code(), Some(3));
        assert!(stdout.contains("out keeps the files of before") && kept(dir.path()) >= 3, "{stdout}");
        assert_eq!(table(dir.path()), reference());
        // and goes on from what it has kept
        finish(dir.path(), "1", &[]);
        return;
    }
    panic!("the sweep was over before the signal came, ten times");
}
