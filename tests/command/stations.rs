//! Stations: what `peel run --at` and `output.stations` write, print and refuse.
//!
//! Reference: `verification/stations.csv`, a collocation without finite elements. Strip of the paper, 100 nm.
//!
//! Expected: the same numbers from the command line, from the scene and from the scene that the run has written; a value that the path does not pass
//! is told with the range of those that it passes, and is no failure. An event that stops ends the path with a name, and with the exit status 0.

use crate::peel::refuses;
use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output};

const STRIP: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/strip-100nm.toml");
const SETA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/seta.toml");

fn peel(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_peel")).args(arguments).output().unwrap()
}

fn found(arguments: &[&str]) -> Value {
    let output = peel(&[arguments, &["--json"]].concat());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let summary: Value = serde_json::from_slice(&output.stdout).unwrap();
    summary["stations"].clone()
}

fn rows(out: &Path) -> Vec<Vec<String>> {
    let text = std::fs::read_to_string(out.join("stations.csv")).unwrap();
    text.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

#[test]
fn stations_of_the_command_line_are_those_of_the_scene() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("at");
    let output =
        peel(&["run", STRIP, "--at", "u=30 nm", "--at", "P=0.04 nN", "--at", "u=1 um", "--out", out.to_str().unwrap()]);
    let printed = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    for line in [
        "stations           u = 30 nm: P = 0.0504094",
        "u = 30 nm: P = 0.0124050647",
        "nN, unstable under displacement control",
        "P = 0.04 nN: u = 47.65671",
        "u = 1000 nm: the path does not pass it; it goes from 0 nm to 69.744 nm",
    ] {
        assert!(printed.contains(line), "{line}\n{printed}");
    }
    let rows = rows(&out);
    assert_eq!(rows[0][..4], ["quantity", "value", "displacement_nm", "force_nN"]);
    let number = |row: usize, column: usize| rows[row][column].parse::<f64>().unwrap();
    let expected = [
        (30.0, 0.0504094198094),
        (30.0, 0.0124050647891),
        (30.0, f64::NAN),
        (0.00695345575897, 0.04),
        (47.6567102566, 0.04),
    ];
    assert_eq!(rows.len(), 1 + expected.len());
    for (row, (displacement, force)) in expected.into_iter().enumerate().filter(|(_, expected)| !expected.1.is_nan()) {
        assert!((number(row + 1, 2) - displacement).abs() <= number(row + 1, 9), "{:?}", rows[row + 1]);
        assert!((number(row + 1, 3) - force).abs() <= number(row + 1, 10), "{:?}", rows[row + 1]);
    }
    let of_line = found(&["run", STRIP, "--at", "u=30 nm", "--at", "P=0.04 nN"]);
    let of_scene =
        found(&["run", STRIP, "--set", "output.stations={ displacement = \"30 nm\", force = [\"0.04 nN\"] }"]);
    assert_eq!(of_line, of_scene);
    let again = found(&["run", out.join("parameters.toml").to_str().unwrap()]);
    // a scene has those of one quantity together
    assert_eq!((&again[0], &again[2]), (&of_line[0], &of_line[1]));
    assert_eq!(again[1]["found"], Value::Array(Vec::new()));
}

#[test]
fn events_of_the_command_line_are_those_of_the_scene() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("events");
    let asked = ["--event", "P > 0.04 nN", "--stop-at", "half off: front < 50 nm"];
    let output = peel(&[&["run", STRIP, "--out", out.to_str().unwrap()], &asked[..]].concat());
    let printed = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    for line in [
        "events             P > 0.04 nN: u = 0.00695345",
        "half off, front < 50 nm: u = 19.10649",
        "event: the path is followed no further: the event \"half off\"",
    ] {
        assert!(printed.contains(line), "{line}\n{printed}");
    }
    let rows = rows(&out);
    let last = |row: &Vec<String>| row.last().unwrap().clone();
    assert_eq!(rows.iter().map(last).collect::<Vec<_>>(), ["event", "P > 0.04 nN", "half off"]);
    let events = |arguments: &[&str]| {
        let output = peel(&[arguments, &["--json"]].concat());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let summary: Value = serde_json::from_slice(&output.stdout).unwrap();
        (summary["end"].clone(), summary["events"].clone())
    };
    let of_line = events(&[&["run", STRIP], &asked[..]].concat());
    let in_scene = "output.events=[{ when = \"P > 0.04 nN\" }, { name = \"half off\", when = \"front < 50 nm\", action = \"stop\" }]";
    assert_eq!(of_line, events(&["run", STRIP, "--set", in_scene]));
    assert_eq!(of_line, events(&["run", out.join("parameters.toml").to_str().unwrap()]));
    assert_eq!(of_line.0, Value::from("event"));
}

#[test]
fn what_is_no_event_is_refused() {
    for (option, event, message) in [
        ("--event", "front 50 nm", "--event is \"front 50 nm\", which has no =, < or >"),
        ("--stop-at", "x < 3 nm", "--stop-at is \"x\", which is none of"),
        ("--event", "attached < 3", "`output.events` is given, and the path of a beam has no `attached` to look for"),
    ] {
        refuses(&[], &["run", STRIP, option, event, "--json"], &[message]);
    }
    let twice = ["run", STRIP, "--event", "u = 3 nm", "--stop-at", "u=3 nm", "--json"];
    refuses(&[], &twice, &["--stop-at has the name \"u = 3 nm\" of another event"]);
}

#[test]
fn a_run_without_stations_has_none() {
    assert_eq!(found(&["run", STRIP]), Value::Null);
}

#[test]
fn what_is_no_station_is_refused() {
    for (scene, at, message) in [
        (STRIP, "x=3 nm", "--at is \"x\", which is none of"),
        (STRIP, "u", "--at is \"u\", which has no ="),
        (STRIP, "u=3", "--at is `displacement` = \"3\", which is not a length with its unit"),
        (STRIP, "P=3 nm", "--at is `force` = \"3 nm\", which is not a force with its unit"),
        (STRIP, "t=3 us", "`output.stations` is given, and the path of a beam has no `time` to look for"),
        (SETA, "front=3 nm", "`output.stations` is given, and the pull-off of a seta has no `front` to look for"),
    ] {
        refuses(&[], &["run", scene, "--at", at, "--json"], &[message]);
    }
}
