//! Folders of outputs: whole or not there, never overwritten unasked, and what is reported where they cannot be written.
//!
//! Reference: the files of a run to a new folder, and the bytes that a user had put into one. Expected: exit status 2 and
//! no computation where the folder holds something, unless --force is given; then the command's own files are new and
//! all others untouched. Where the disk is full, the folder read-only or the run killed, nothing stands under the name
//! of the folder that was not there before, and the message names the file and the system's reason (status 1). Why: a
//! person who finds a folder takes it for a result, and a person's files are theirs.
#![cfg(unix)]

use crate::frames::frames;
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};
use tempfile::{TempDir, tempdir};

const PEEL: &str = env!("CARGO_BIN_EXE_peel");
const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/strip-100nm.toml");
const RUN: [&str; 8] = [
    "curve.csv",
    "curve.png",
    "curve.svg",
    "limit_points.csv",
    "parameters.toml",
    "shapes.png",
    "shapes.svg",
    "summary.json",
];
/// Whole peels of so many values would take an hour.
const LONG_SWEEP: [&str; 11] =
    ["sweep", SCENE, "--vary", "strip.length", "--from", "60 nm", "--to", "120 nm", "--points", "20000", "--json"];

fn peel(dir: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(PEEL);
    command.current_dir(dir).args(args).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

fn texts(output: &Output) -> (Option<i32>, String, String) {
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    (output.status.code(), text(&output.stdout), text(&output.stderr))
}

/// What the command said, after a good end.
#[track_caller]
fn done(dir: &Path, args: &[&str]) -> String {
    let (status, stdout, stderr) = texts(&peel(dir, args).output().unwrap());
    assert_eq!((status, stderr.as_str()), (Some(0), ""));
    stdout
}

#[track_caller]
fn refused(dir: &Path, args: &[&str], status: i32, parts: &[&str]) {
    let (found, stdout, stderr) = texts(&peel(dir, args).output().unwrap());
    assert_eq!((found, stdout.as_str()), (Some(status), ""), "{stderr}");
    for part in parts {
        assert!(stderr.contains(part), "{part:?} is not in\n{stderr}");
    }
}

fn listing(dir: &Path) -> Vec<String> {
    let entries = fs::read_dir(dir).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<String> = entries.collect();
    names.sort();
    names
}

/// A folder `out` with one file of a user in it.
fn used() -> TempDir {
    let dir = tempdir().unwrap();
    fs::create_dir(dir.path().join("out")).unwrap();
    fs::write(dir.path().join("out/summary.json"), "mine").unwrap();
    dir
}

#[test]
fn a_new_or_empty_folder_holds_the_files_and_nothing_else() {
    for name in ["new", "deep/er", "empty"] {
        let dir = tempdir().unwrap();
        fs::create_dir(dir.path().join("empty")).unwrap();
        let said = done(dir.path(), &["run", SCENE, "--out", name]);
        assert_eq!(listing(&dir.path().join(name)), RUN);
        for file in RUN {
            assert!(said.contains(&format!("wrote {name}/{file}\n")), "{said}");
        }
        assert!(listing(dir.path()).iter().all(|name| !name.starts_with('.')), "{:?}", listing(dir.path()));
    }
}

#[test]
fn the_working_directory_stays_the_one_it_was() {
    let dir = tempdir().unwrap();
    let args = format!("'{PEEL}' run '{SCENE}' --out . && ls");
    let output = Command::new("bash").current_dir(dir.path()).args(["-c", &args]).output().unwrap();
    let (status, stdout, stderr) = texts(&output);
    assert_eq!((status, stderr.as_str()), (Some(0), ""));
    assert!(stdout.ends_with(&(RUN.join("\n") + "\n")), "{stdout}");
}

#[test]
fn a_folder_that_is_not_empty_is_refused_before_anything_is_computed() {
    let dir = used();
    let long = LONG_SWEEP;
    let followed = [&long[..], &["--peak-only"]].concat();
    for command in [&["run", SCENE][..], &["run", SCENE, "--json"], &long, &followed, &["accuracy"], &["figures"]] {
        let args = [command, &["--out", "out"]].concat();
        refused(dir.path(), &args, 2, &["out exists, is not empty and is not changed", "--force", "--out"]);
    }
    assert_eq!(listing(dir.path()), ["out"]);
    assert_eq!(listing(&dir.path().join("out")), ["summary.json"]);
    assert_eq!(fs::read(dir.path().join("out/summary.json")).unwrap(), b"mine");
}

/// A scene that is edited and run again; what another command or a person has put there is not touched.
#[test]
fn the_same_command_a_second_time_replaces_its_files() {
    let dir = tempdir().unwrap();
    let scene = dir.path().join("mine.toml");
    let text = fs::read_to_string(SCENE).unwrap();
    fs::write(&scene, &text).unwrap();
    let summary = || fs::read_to_string(dir.path().join("out/mine/summary.json")).unwrap();
    done(dir.path(), &["run", "mine.toml"]);
    let before = summary();
    fs::write(&scene, text.replace("\"10 nm\"", "\"9 nm\"")).unwrap();
    done(dir.path(), &["run", "mine.toml"]);
    assert_ne!(summary(), before);
    fs::write(dir.path().join("out/mine/notes.txt"), "mine").unwrap();
    done(dir.path(), &["run", "mine.toml", "--force"]);
    done(dir.path(), &["run", "mine.toml"]);
    assert_eq!(fs::read(dir.path().join("out/mine/notes.txt")).unwrap(), b"mine");
    refused(dir.path(), &["run", SCENE, "--out", "out/mine"], 2, &["out/mine exists", "--force"]);
    refused(dir.path(), &["run", "mine.toml", "--observed", "--out", "out/mine"], 2, &["out/mine exists"]);
}

#[test]
fn force_replaces_the_files_of_the_command_and_no_other() {
    let dir = used();
    let out = dir.path().join("out");
    fs::create_dir(out.join("notes")).unwrap();
    fs::write(out.join("notes/monday.txt"), "mine").unwrap();
    done(dir.path(), &["run", SCENE, "--out", "out", "--force"]);
    let mut expected = [&RUN[..], &["notes"]].concat();
    expected.sort_unstable();
    assert_eq!(listing(&out), expected);
    assert_eq!(listing(dir.path()), ["out"]);
    assert!(fs::read_to_string(out.join("summary.json")).unwrap().starts_with('{'));
    assert_eq!(fs::read(out.join("notes/monday.txt")).unwrap(), b"mine");
}

/// Commands that compute different things, one after the other, as a person types them.
#[test]
fn different_commands_have_different_folders() {
    let dir = tempdir().unwrap();
    let roughly = ["--set", "accuracy.relative=1e-3"];
    let sweep = ["sweep", SCENE, "--vary", "strip.length", "--values", "90 nm,100 nm"];
    for (command, folder) in [
        (vec!["run", SCENE], "strip-100nm-accuracy.relative-1e-3"),
        (vec!["run", SCENE, "--set", "strip.height=9 nm"], "strip-100nm-strip.height-9nm-accuracy.relative-1e-3"),
        (vec!["run", SCENE, "--states", "2"], "strip-100nm-states-2-accuracy.relative-1e-3"),
        (sweep.to_vec(), "strip-100nm-sweep-strip.length-accuracy.relative-1e-3"),
        ([&sweep[..], &["--peak-only"]].concat(), "strip-100nm-sweep-strip.length-follow-peak-accuracy.relative-1e-3"),
    ] {
        let said = done(dir.path(), &[&command[..], &roughly].concat());
        assert!(said.contains(&format!("wrote out/{folder}/")), "{said}");
    }
    assert_eq!(listing(&dir.path().join("out")).len(), 5);
}

#[test]
fn a_finished_sweep_is_replaced_by_the_same_one_and_no_other() {
    let dir = tempdir().unwrap();
    let sweep = ["sweep", SCENE, "--vary", "strip.length", "--from", "90 nm", "--to", "100 nm", "--points", "2"];
    let with = |more: &[&'static str]| [&sweep[..], more].concat();
    for more in [&[][..], &[], &["--fresh"], &["--force"]] {
        done(dir.path(), &with(more));
    }
    refused(dir.path(), &with(&["--log"]), 2, &["out/strip-100nm-sweep-strip.length exists", "--force"]);
    let files = ["parameters.toml", "sweep.csv", "sweep.png", "sweep.svg"];
    assert_eq!(listing(&dir.path().join("out/strip-100nm-sweep-strip.length")), files);
}

#[test]
fn a_place_that_cannot_be_written_is_told_before_anything_is_computed() {
    let dir = tempdir().unwrap();
    fs::write(dir.path().join("file"), "mine").unwrap();
    for (place, reason) in [("file", "irectory"), ("file/inner", "irectory"), ("/proc/inner", "No such file")] {
        for command in [&["run", SCENE][..], &LONG_SWEEP, &["accuracy"], &["figures"]] {
            let args = [command, &["--out", place, "--force"]].concat();
            refused(dir.path(), &args, 1, &[&format!("cannot write {place}: "), reason]);
        }
    }
    assert_eq!(listing(dir.path()), ["file"]);
}

// ---------------------------------------------------------------------------------------------------------------
// A disk that is full in the middle: no file may be longer than so many kB
// ---------------------------------------------------------------------------------------------------------------

/// A run in which a longer file fails as on a full disk: the small tables can be written, the pictures cannot.
fn on_a_small_disk(dir: &Path, args: &[&str]) -> (Option<i32>, String, String) {
    // where the signal is ignored the write fails
    let limited = "trap '' XFSZ; ulimit -f 30; exec \"$0\" \"$@\"";
    let output = Command::new("bash").current_dir(dir).args(["-c", limited, PEEL]).args(args).output().unwrap();
    texts(&output)
}

#[test]
fn a_full_disk_leaves_nothing_and_what_was_found_is_told() {
    for existing in [false, true] {
        let dir = if existing { used() } else { tempdir().unwrap() };
        let before = listing(dir.path());
        let (status, stdout, stderr) = on_a_small_disk(dir.path(), &["run", SCENE, "--out", "out", "--force"]);
        assert_eq!(status, Some(1), "{stderr}");
        assert!(stderr.contains("cannot write out/") && stderr.contains("File too large"), "{stderr}");
        assert!(stdout.contains("peak force") && !stdout.contains("wrote"), "{stdout}");
        assert_eq!(listing(dir.path()), before);
        if existing {
            assert_eq!(listing(&dir.path().join("out")), ["summary.json"]);
            assert_eq!(fs::read(dir.path().join("out/summary.json")).unwrap(), b"mine");
        }
    }
}

#[test]
fn a_full_disk_loses_no_value_of_a_sweep() {
    let dir = tempdir().unwrap();
    let sweep = ["sweep", SCENE, "--vary", "strip.length", "--from", "90 nm", "--to", "100 nm", "--points", "3"];
    let sweep = [&sweep[..], &["--out", "out"]].concat();
    let (status, stdout, stderr) = on_a_small_disk(dir.path(), &sweep);
    assert_eq!(status, Some(1), "{stderr}");
    assert!(stderr.contains("cannot write out/sweep.") && stderr.contains("File too large"), "{stderr}");
    assert!(stdout.contains("peak nN"), "{stdout}");
    assert_eq!(
        (listing(dir.path()), listing(&dir.path().join("out"))),
        (vec!["out".into()], vec!["sweep.partial".into()])
    );
    assert!(done(dir.path(), &sweep).contains("3 of 3 values taken"));
}

// ---------------------------------------------------------------------------------------------------------------
// Two commands and one folder; a folder that is removed
// ---------------------------------------------------------------------------------------------------------------

/// A sweep into out/ that takes an hour, once it has kept a value.
fn long_sweep(dir: &Path) -> Child {
    let child = peel(dir, &[&LONG_SWEEP[..], &["--out", "out"]].concat()).spawn().unwrap();
    wait_for_frames(dir, 2);
    child
}

/// Waits until its file has so many frames.
fn wait_for_frames(dir: &Path, count: usize) {
    let began = Instant::now();
    let kept = || frames(&fs::read(dir.join("out/sweep.partial")).unwrap_or_default()).len();
    while kept() < count {
        assert!(began.elapsed() < Duration::from_secs(120), "waited in vain for the checkpoint to grow");
        std::thread::sleep(Duration::from_millis(5));
    }
}

#[test]
fn a_folder_in_use_is_refused_with_the_process_and_one_of_a_killed_process_is_taken_over() {
    let dir = tempdir().unwrap();
    let mut first = long_sweep(dir.path());
    let same = [&LONG_SWEEP[..], &["--out", "out"]].concat();
    let other = ["run", SCENE, "--out", "out", "--force"];
    let process = format!("out is in use: process {} writes to it", first.id());
    for command in [&same[..], &other, &["run", SCENE, "--out", "./out/../out", "--json"]] {
        refused(dir.path(), command, 2, &[&process, "--out"]);
    }
    first.kill().unwrap();
    first.wait().unwrap();
    done(dir.path(), &[&LONG_SWEEP[..6], &["--to", "61 nm", "--points", "2", "--out", "out"]].concat());
    assert_eq!(listing(dir.path()), ["out"]);
    assert!(dir.path().join("out/sweep.csv").exists());
}

#[test]
fn a_folder_that_is_removed_meanwhile_costs_nothing() {
    let dir = tempdir().unwrap();
    let whole = [&LONG_SWEEP[..9], &["300", "--out", "out"]].concat();
    let sweep = peel(dir.path(), &whole).spawn().unwrap();
    wait_for_frames(dir.path(), 10);
    fs::remove_dir_all(dir.path().join("out")).unwrap();
    wait_for_frames(dir.path(), 11);
    assert_eq!(sweep.wait_with_output().unwrap().status.code(), Some(0));
    let rows = fs::read_to_string(dir.path().join("out/sweep.csv")).unwrap().lines().count();
    assert_eq!(rows, 301, "a header and every value");
}

// ---------------------------------------------------------------------------------------------------------------
// A run that is killed while it writes: the figures take long enough
// ---------------------------------------------------------------------------------------------------------------

/// `peel figures` killed when its first files were written; whether it was.
fn killed_figures(dir: &Path, staging: impl Fn(&Child) -> String) -> bool {
    let mut child = peel(dir, &["figures", "--out", "out"]).spawn().unwrap();
    let staging = dir.join(staging(&child));
    let began = Instant::now();
    while !staging.join("fig09-peeling.svg").exists() {
        assert!(child.try_wait().unwrap().is_none(), "it was over before anything was written");
        assert!(began.elapsed() < Duration::from_secs(300), "waited in vain for the first figure");
        std::thread::sleep(Duration::from_millis(2));
    }
    child.kill().unwrap();
    !child.wait().unwrap().success()
}

#[test]
fn a_killed_run_leaves_nothing_under_the_name_and_the_next_one_works() {
    let dir = tempdir().unwrap();
    assert!(killed_figures(dir.path(), |child| format!(".out.{}.part", child.id())));
    assert!(!dir.path().join("out").exists());
    done(dir.path(), &["run", SCENE, "--out", "out"]);
    assert_eq!(listing(&dir.path().join("out")), RUN);
}

/// Figures that `peel figures` has written are its own.
#[test]
fn figures_are_drawn_anew_unasked_and_stay_whole_when_that_is_killed() {
    let dir = tempdir().unwrap();
    let out = dir.path().join("out");
    fs::create_dir(&out).unwrap();
    let readme = include_str!("../../figures/README.md");
    fs::write(out.join("README.md"), readme).unwrap();
    fs::write(out.join("fig09-peeling.svg"), "old").unwrap();
    assert!(killed_figures(dir.path(), |child| format!("out/.{}.part", child.id())));
    assert_eq!(fs::read_to_string(out.join("README.md")).unwrap(), readme);
    assert_eq!(fs::read(out.join("fig09-peeling.svg")).unwrap(), b"old");
}
