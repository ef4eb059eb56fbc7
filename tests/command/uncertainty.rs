//! `peel uncertainty`: what it prints and writes, what it refuses, and that what is interrupted goes on.
//!
//!     samples:   o--o--o--o | o--o--o--o--o
//!     run 1      computed   ^ Ctrl-C: what is to the left is kept, and written
//!     run 2      taken        computed
//!
//! Parameters: the scene strip-uncertain, its initiation peak, some hundred samples. Expected: the same table of samples on one core and on two, in one run
//! and in two; files as the help lists them; exit status 0, 2 for what is refused, 3 for what is cut short. Why: a sample may take hours, and neither the
//! machine nor an interruption may change a digit.

#[cfg(unix)]
use crate::frames::frames;
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use tempfile::tempdir;

const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/strip-uncertain.toml");
const PEAK: [&str; 2] = ["--set", "uncertainty.quantities=[\"initiation_peak.force_nN\"]"];
const FEW: [&str; 4] = ["--set", "uncertainty.samples=480", "--set", "accuracy.relative=1e-3"];

fn peel(dir: &Path, cores: &str, more: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_peel"));
    command.current_dir(dir).env("RAYON_NUM_THREADS", cores).stdout(Stdio::piped()).stderr(Stdio::piped());
    command.args(["uncertainty", SCENE]).args(PEAK).args(FEW).args(more);
    command
}

fn texts(output: &Output) -> (String, String) {
    (String::from_utf8(output.stdout.clone()).unwrap(), String::from_utf8(output.stderr.clone()).unwrap())
}

/// Runs to a good end; what it printed.
#[track_caller]
fn done(dir: &Path, cores: &str, more: &[&str]) -> String {
    let output = peel(dir, cores, more).output().unwrap();
    let (stdout, stderr) = texts(&output);
    assert_eq!((output.status.code(), stderr.as_str()), (Some(0), ""));
    stdout
}

/// Ends with this status; what it said.
#[track_caller]
fn stopped(dir: &Path, status: i32, more: &[&str]) -> String {
    let output = peel(dir, "2", more).output().unwrap();
    let (_, stderr) = texts(&output);
    assert_eq!(output.status.code(), Some(status), "{stderr}");
    stderr
}

fn samples(dir: &Path) -> String {
    fs::read_to_string(dir.join("out/samples.csv")).unwrap()
}

#[test]
fn the_files_are_those_of_the_help_on_any_number_of_cores() {
    let (one, two) = (tempdir().unwrap(), tempdir().unwrap());
    let stdout = done(one.path(), "1", &["--out", "out"]);
    for part in ["mean", "quantile 95 %", "first-order", "share of the variance", "adhesion.hamaker_constant"] {
        assert!(stdout.contains(part), "{part:?} is not in\n{stdout}");
    }
    // of 480 samples the total shares are below the first orders
    assert!(
        stdout.contains("the sample is too small for 4 of these: a total share is below its first order"),
        "{stdout}"
    );
    let mut files: Vec<String> = fs::read_dir(one.path().join("out"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    files.sort();
    let expected = [
        "indices.csv",
        "initiation_peak-force.png",
        "initiation_peak-force.svg",
        "parameters.toml",
        "samples.csv",
        "statistics.csv",
        "summary.json",
    ];
    assert_eq!(files, expected);
    let json: Value = serde_json::from_str(&done(two.path(), "2", &["--out", "out", "--json"])).unwrap();
    assert_eq!(samples(one.path()), samples(two.path()));
    let written: Value =
        serde_json::from_str(&fs::read_to_string(two.path().join("out/summary.json")).unwrap()).unwrap();
    assert_eq!(json["results"], written["results"]);
    assert_eq!(json["sample"]["computed"].as_u64(), Some(480));
    assert_eq!(samples(one.path()).lines().count(), 481);
    // the scene that is written gives the same
    let again = ["uncertainty", "out/parameters.toml", "--json"];
    let output = Command::new(env!("CARGO_BIN_EXE_peel")).current_dir(one.path()).args(again).output().unwrap();
    let again: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(again["results"], json["results"]);
}

/// A sample is what `peel run` finds with its inputs.
#[test]
fn a_sample_is_a_run() {
    let dir = tempdir().unwrap();
    let results = ["--set", "uncertainty.quantities=[\"peak.force_nN\", \"first_jump.work_aJ\"]"];
    done(dir.path(), "2", &[&results[..], &["--set", "uncertainty.samples=240", "--out", "out"]].concat());
    let table = samples(dir.path());
    let mut rows = csv::Reader::from_reader(table.as_bytes());
    let names = rows.headers().unwrap().clone();
    let row = rows.records().nth(7).unwrap().unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_peel"));
    command.current_dir(dir.path()).args(["run", SCENE, "--json", "--set", "accuracy.relative=1e-3"]);
    for (name, value) in names.iter().zip(row.iter()).filter(|(name, _)| name.starts_with(['s', 'a'])) {
        let set = [("_nm", " nm"), ("_GPa", " GPa"), ("_aJ", " aJ")]
            .into_iter()
            .find_map(|(ending, unit)| Some(format!("{}={value}{unit}", name.strip_suffix(ending)?)));
        command.args(set.into_iter().flat_map(|set| ["--set".to_owned(), set]));
    }
    let run: Value = serde_json::from_slice(&command.output().unwrap().stdout).unwrap();
    for (name, expected) in
        [("peak.force_nN", &run["peak"]["force_nN"]), ("first_jump.work_aJ", &run["first_jump"]["work_aJ"])]
    {
        let place = names.iter().position(|other| other == name).unwrap();
        let (found, expected) = (row[place].parse::<f64>().unwrap(), expected.as_f64().unwrap());
        assert!((found / expected - 1.0).abs() < 1e-12, "{name}: {found} {expected}");
    }
}

#[test]
fn without_indices_all_samples_are_points() {
    let dir = tempdir().unwrap();
    let json = done(dir.path(), "2", &["--json", "--set", "uncertainty.indices=false"]);
    let json: Value = serde_json::from_str(&json).unwrap();
    assert_eq!(json["results"][0]["indices"].as_array().map(Vec::len), Some(0));
    assert_eq!((json["sample"]["points"].as_u64(), json["sample"]["samples"].as_u64()), (Some(32), Some(480)));
    assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 0, "--json alone writes nothing");
}

#[test]
fn what_is_refused_is_said_with_its_key() {
    let dir = tempdir().unwrap();
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/strip-100nm.toml");
    let output =
        Command::new(env!("CARGO_BIN_EXE_peel")).current_dir(dir.path()).args(["uncertainty", scene]).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(texts(&output).1.contains("lacks the table [uncertainty]"));
    let wide = "uncertainty.inputs=[{ key = \"strip.height\", distribution = \"normal\", deviation = \"5 nm\" }]";
    let text = stopped(dir.path(), 2, &["--set", wide]);
    assert!(text.contains("2.28 %") && text.contains("lognormal"), "{text}");
    let text = stopped(dir.path(), 2, &["--set", "uncertainty.samples=20"]);
    assert!(text.contains("20 samples are too few"), "{text}");
    // peel run checks the table and computes nothing of it
    let run = ["run", SCENE, "--json", "--set", "uncertainty.samples=20"];
    let output = Command::new(env!("CARGO_BIN_EXE_peel")).current_dir(dir.path()).args(run).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn samples_that_are_cut_short_are_counted() {
    let dir = tempdir().unwrap();
    let whole = ["--set", "uncertainty.quantities=[\"first_jump.work_aJ\"]", "--set", "uncertainty.samples=240"];
    let cut = [&whole[..], &["--set", "bounds.points=20", "--out", "out"]].concat();
    let text = stopped(dir.path(), 3, &cut);
    assert!(text.contains("240 of 240 samples") && text.contains("bounds.points = 20"), "{text}");
    let json: Value = serde_json::from_str(&fs::read_to_string(dir.path().join("out/summary.json")).unwrap()).unwrap();
    assert_eq!((json["sample"]["cut_short"].as_u64(), json["cut_short"][0]["count"].as_u64()), (Some(240), Some(240)));
    assert!(json["results"][0]["mean"].is_null());
}

#[cfg(unix)]
#[test]
fn what_is_interrupted_goes_on_with_more_samples() {
    let dir = tempdir().unwrap();
    let partial = dir.path().join("out/uncertainty.partial");
    let kept = || frames(&fs::read(&partial).unwrap_or_default()).len().saturating_sub(1);
    let long = ["--out", "out", "--set", "uncertainty.samples=4000"];
    let mut child = peel(dir.path(), "1", &long).spawn().unwrap();
    while kept() < 20 && child.try_wait().unwrap().is_none() {
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    let (stdout, stderr) = texts(&output);
    if output.status.code() == Some(130) || stderr.is_empty() {
        // started with the signal ignored: nothing to test
        return;
    }
    assert_eq!(output.status.code(), Some(3), "{stderr}");
    assert!(stderr.contains("interrupted") && stdout.contains("were computed"), "{stdout}{stderr}");
    assert!(samples(dir.path()).lines().count() > 20);
    // another seed is another sample
    let text = stopped(dir.path(), 2, &["--out", "out", "--set", "uncertainty.seed=1"]);
    assert!(text.contains("interrupted sample of another scene"), "{text}");
    let stdout = done(dir.path(), "2", &["--out", "out"]);
    assert!(
        stdout.contains("480 samples taken from an earlier") || stdout.contains("of 480 samples taken"),
        "{stdout}"
    );
    assert!(!partial.exists());
    let fresh = tempdir().unwrap();
    done(fresh.path(), "2", &["--out", "out"]);
    assert_eq!(samples(dir.path()), samples(fresh.path()));
}
