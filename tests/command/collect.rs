//! A sweep that is divided into parts, on machines that know nothing of each other, and put together again.
//!
//!     values     1  2  3  4  5  6  7  8  9 10 ... 20
//!     part       1  2  3  4  5  6  7  8  1  2 ...        each value in one part, neighbours in different ones
//!     folders    p1 p2 p3 p4    p6 p7 p8  and p2 again   part 5 is late, part 2 was computed twice
//!     collect    rows of all parts but 5, exit status 3; then, with p5, the whole sweep
//!
//! Parameters: the strip of 100 nm, 20 lengths from 60 to 120 nm, whole peels at a tolerance of 1e-3. The reference is the undivided sweep.
//! Expected: every file of the collection is that of the undivided sweep, byte for byte but for the column `solve_s`; a part that was
//! computed twice counts once and is reported; parts of different sweeps are refused with what differs, and so are results of one part that
//! differ. Why: on a batch system parts run twice, late, or with a scene that was changed in between, and nobody looks at each.

use crate::frames::{framed, frames};
use peelkit::study::{Effort, PeelResult};
use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use tempfile::tempdir;

const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/strip-100nm.toml");
const PARTS: usize = 8;
const LENGTHS: [&str; 8] = ["--vary", "strip.length", "--from", "60 nm", "--to", "120 nm", "--points", "20"];
const ROUGHLY: [&str; 2] = ["--set", "accuracy.relative=1e-3"];

fn peel(dir: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_peel")).current_dir(dir).args(args).output().unwrap()
}

/// Ends with this status and a message that contains these parts; what it printed.
#[track_caller]
fn ends(output: Output, status: i32, parts: &[&str]) -> String {
    // long messages are drawn with a frame
    let stderr = String::from_utf8(output.stderr).unwrap().replace(['│', '\n'], " ");
    let stderr = stderr.split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(output.status.code(), Some(status), "{stderr}");
    for part in parts {
        assert!(stderr.contains(part), "{part:?} is not in\n{stderr}");
    }
    String::from_utf8(output.stdout).unwrap()
}

/// The sweep over these keys, with these words behind.
#[track_caller]
fn sweep(dir: &Path, varied: &[&str], more: &[&str]) -> String {
    ends(peel(dir, &[&["sweep", SCENE][..], varied, &ROUGHLY, more].concat()), 0, &[])
}

#[track_caller]
fn part(dir: &Path, varied: &[&str], index: usize, of: usize, out: &str) {
    sweep(dir, varied, &["--part", &format!("{index}/{of}"), "--out", out]);
}

fn collect(dir: &Path, folders: &[&str], more: &[&str]) -> Output {
    peel(dir, &[&["collect"][..], folders, more].concat())
}

/// The lines of sweep.csv without the column `solve_s`.
fn table(folder: &Path) -> Vec<String> {
    let mut reader = csv::Reader::from_path(folder.join("sweep.csv")).unwrap();
    let names = reader.headers().unwrap().clone();
    let kept: Vec<usize> = (0..names.len()).filter(|&at| &names[at] != "solve_s").collect();
    let line = |record: &csv::StringRecord| kept.iter().map(|&at| &record[at]).collect::<Vec<_>>().join(",");
    [line(&names)].into_iter().chain(reader.records().map(|record| line(&record.unwrap()))).collect()
}

/// All files are the same but for the times.
#[track_caller]
fn assert_same(a: &Path, b: &Path) {
    let names = |folder: &Path| {
        let mut names: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        names.sort();
        names
    };
    assert_eq!(names(a), names(b));
    for name in names(a).iter().filter(|name| *name != "sweep.csv") {
        assert!(fs::read(a.join(name)).unwrap() == fs::read(b.join(name)).unwrap(), "{name:?}");
    }
    assert_eq!(table(a), table(b));
}

#[test]
fn eight_parts_one_twice_and_one_late_make_the_whole() {
    let dir = tempdir().unwrap();
    let (here, out) = (dir.path(), dir.path().join("out/strip-100nm-sweep-strip.length-accuracy.relative-1e-3"));
    sweep(here, &LENGTHS, &[]);
    let whole = here.join("whole");
    fs::rename(&out, &whole).unwrap();
    let folders: Vec<String> = (1..=PARTS).map(|index| format!("p{index}")).collect();
    for (index, folder) in (1..=PARTS).zip(&folders).filter(|(index, _)| *index != 5) {
        part(here, &LENGTHS, index, PARTS, folder);
    }
    part(here, &LENGTHS, 2, PARTS, "again");
    let mut given: Vec<&str> = folders.iter().map(String::as_str).filter(|folder| *folder != "p5").collect();
    given.insert(0, "again");

    let missing = ["2 of 20 values are missing", "parts of 8 that were not given: 5"];
    let said = ends(collect(here, &given, &[]), 3, &missing);
    assert!(said.contains("part 2/8 is in again and p2: the results are equal, each value counts once"), "{said}");
    let there: Vec<String> =
        table(&whole).into_iter().enumerate().filter(|(at, _)| !matches!(at, 5 | 13)).map(|(_, line)| line).collect();
    assert_eq!(table(&out), there, "every row but those of part 5");
    assert!(out.join("collect.partial.json").exists());

    part(here, &LENGTHS, 5, PARTS, "p5");
    given.push("p5");
    ends(collect(here, &given, &[]), 0, &[]);
    assert_same(&whole, &out);
    ends(collect(here, &given, &[]), 2, &["exists, is not empty and is not changed"]);
    // the object is that of the undivided sweep, and no file is written
    let rows = |text: &str| serde_json::from_str::<serde_json::Value>(text).unwrap()["rows"].as_array().unwrap().len();
    assert_eq!(rows(&ends(collect(&whole, &["../p1", "../p2"], &["--json"]), 3, &["14 of 20 values", "3-8"])), 6);
    assert!(!whole.join("out").exists());
}

#[test]
fn parts_of_a_plane_make_its_map() {
    let dir = tempdir().unwrap();
    let plane = ["--vary", "strip.height", "--values", "9,10,11 nm", "--vary", "strip.youngs_modulus", "--log"];
    let plane = [&plane[..], &["--from", "1 GPa", "--to", "4 GPa", "--points", "3"]].concat();
    sweep(dir.path(), &plane, &["--out", "whole"]);
    part(dir.path(), &plane, 1, 2, "a");
    part(dir.path(), &plane, 2, 2, "b");
    ends(collect(dir.path(), &["b", "a"], &["--out", "joined"]), 0, &[]);
    let [whole, joined] = ["whole", "joined"].map(|name| dir.path().join(name));
    // the folder stands in the command
    let renamed = fs::read_to_string(joined.join("parameters.toml")).unwrap().replace("--out joined", "--out whole");
    fs::write(joined.join("parameters.toml"), renamed).unwrap();
    assert_same(&whole, &joined);
}

/// The file of a part whose first result was found on so many points, with the check sums of another machine.
fn on_other_points(bytes: &[u8], points: usize) -> Vec<u8> {
    let frame = &frames(bytes)[1];
    let (found, seconds): (PeelResult, f64) = postcard::from_bytes(&bytes[frame.value.clone()]).unwrap();
    let changed = PeelResult { effort: Effort { points, ..found.effort }, ..found };
    let value = postcard::to_stdvec(&(changed, seconds)).unwrap();
    let changed = framed(&bytes[frame.key.clone()], &value);
    [&bytes[..frame.place.start], &changed, &bytes[frame.place.end..]].concat()
}

#[test]
fn what_does_not_belong_together_is_refused_with_the_difference() {
    let dir = tempdir().unwrap();
    let here = dir.path();
    let few = ["--vary", "strip.length", "--values", "90,100 nm"];
    part(here, &few, 1, 2, "p1");
    part(here, &few, 2, 3, "thirds");
    part(here, &["--vary", "strip.length", "--values", "90,101 nm"], 2, 2, "value");
    part(here, &["--vary", "strip.height", "--values", "9,10 nm"], 2, 2, "key");
    sweep(here, &few, &["--part", "2/2", "--out", "scene", "--set", "strip.height=11 nm"]);
    for (folder, difference) in [
        ("thirds", "p1 and thirds are parts of different sweeps: one is divided into 2 parts, the other into 3"),
        ("value", "value 2 of strip.length is 100 nm in one and 101 nm in the other"),
        ("key", "one varies strip.length, the other strip.height"),
        ("scene", "strip.height is 10 nm in one and 11 nm in the other"),
    ] {
        ends(collect(here, &["p1", folder], &["--out", "none"]), 2, &[difference]);
    }
    // a result that another machine computes differently, and a part of another version
    let whole = fs::read(here.join("p1/sweep.part")).unwrap();
    let write = |folder: &str, name: &str, bytes: &[u8]| {
        fs::create_dir_all(here.join(folder)).unwrap();
        fs::write(here.join(folder).join(name), bytes).unwrap();
    };
    let [header, first, ..] = &frames(&whole)[..] else { panic!("a part has a header and a result") };
    let mut changed = whole.clone();
    changed[first.value.start + 9] ^= 1;
    write("changed", "sweep.part", &changed);
    let place =
        format!("frame 2 (bytes {} to {}) does not match its check sum", first.place.start, first.place.end - 1);
    ends(collect(here, &["p1", "changed"], &[]), 2, &[&place]);
    write("differs", "sweep.part", &on_other_points(&whole, 7));
    ends(collect(here, &["p1", "differs"], &[]), 2, &["different results at strip.length = 90 nm", "on 7 points"]);
    let text = String::from_utf8(whole[header.value.clone()].to_vec()).unwrap();
    let old = framed(&[], text.replace(env!("CARGO_PKG_VERSION"), "0.0.9").as_bytes());
    write("old", "sweep.part", &[&old[..], &whole[header.place.end..]].concat());
    ends(collect(here, &["old"], &[]), 2, &["old was computed by peel 0.0.9"]);
    write("older", "sweep.part.jsonl", text.replace(env!("CARGO_PKG_VERSION"), "0.0.8").as_bytes());
    ends(
        collect(here, &["older"], &[]),
        2,
        &["older/sweep.part.jsonl is not a part", "peel 0.0.8 has written it in another form"],
    );
    write("torn", "sweep.part", &whole[..header.place.end / 2]);
    ends(collect(here, &["torn"], &[]), 2, &["is not a part of a sweep that this version of peel can read"]);
    ends(collect(here, &["p1", "nowhere"], &[]), 2, &["nowhere holds no part of a sweep"]);
    assert!(!here.join("none").exists());
}

#[test]
fn a_part_that_is_still_computed_counts_as_missing() {
    let dir = tempdir().unwrap();
    let few = ["--vary", "strip.length", "--values", "90,100 nm"];
    part(dir.path(), &few, 1, 2, "p1");
    fs::create_dir(dir.path().join("p2")).unwrap();
    fs::write(dir.path().join("p2/sweep.partial"), "").unwrap();
    let message = ["parts of 2 that were not given: 2", "p2 is not finished: its own command resumes it"];
    ends(collect(dir.path(), &["p1", "p2"], &["--out", "out"]), 3, &message);
    ends(
        collect(dir.path(), &["p2"], &["--out", "out"]),
        2,
        &["no part is finished: 1 folders hold checkpoints alone"],
    );
}

#[test]
fn a_part_that_cannot_be_one_is_refused_before_anything_is_computed() {
    let dir = tempdir().unwrap();
    let refused = |more: &[&str], message: &str| {
        let args = [&["sweep", SCENE, "--vary", "strip.length", "--values", "90,100 nm"][..], more].concat();
        ends(peel(dir.path(), &args), 2, &[message]);
    };
    refused(&["--part", "3/2"], "write I/N with I from 1 to N");
    refused(&["--part", "3/3"], "--part 3/3 has no values: the sweep has 2");
    refused(&["--part", "1/2", "--peak-only"], "--part 1/2 divides sweeps of whole paths");
    refused(&["--part", "1/2", "--json"], "--part 1/2 leaves files for peel collect");
    assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 0);
}
