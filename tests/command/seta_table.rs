//! A seta whose tips follow the table of `peel coarsen`.
//!
//!     peel coarsen spatula.toml --out tip      the table of a narrow range
//!     peel run seta.toml                       tips leave it, it grows, the seta is pulled off again
//!
//! Parameters: scenes/seta.toml with four tips, and with 64 where it is interrupted; scenes/spatula.toml, whose spatula is that of its tips; a
//! table to 1e-2. Reference: the seta by the curve of its normal pull, whose tips carry no moment; a table that was wide to begin with; the same run
//! without an interruption.
//! Expected: the peak is that of the curve within 2 %, as tips of a slender seta hardly turn, and that of the wide table within the bound of its error; summary.json says how
//! many tips left the table and what that changed, and how many were solved as spatulae and what that changed; the table of another spatula, one with too large an error and one of a pad that is held are
//! refused by name; a run that is stopped and goes on writes the same numbers.

use crate::peel::run as peel;
use serde_json::Value;
use std::fs;
use std::path::Path;
use tempfile::tempdir;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

fn coarsen(dir: &Path, more: &[&str]) {
    let scene = format!("{ROOT}/scenes/spatula.toml");
    let plain = ["coarsen", &scene, "--out", "tip", "--tolerance", "1e-2", "--force"];
    let (status, _, trouble) = peel(dir, &[&plain, more].concat());
    assert_eq!(status, Some(0), "{trouble}");
}

/// `peel run` of the seta beside the folder of the table.
fn run(dir: &Path, sets: &[&str], more: &[&str]) -> (Option<i32>, String, String) {
    fs::copy(format!("{ROOT}/scenes/seta.toml"), dir.join("seta.toml")).unwrap();
    let sets: Vec<&str> = sets.iter().flat_map(|set| ["--set", set]).collect();
    peel(dir, &[&["run", "seta.toml"], &sets[..], more].concat())
}

#[track_caller]
fn summary(found: (Option<i32>, String, String)) -> Value {
    let (status, text, trouble) = found;
    assert_eq!((status, trouble.as_str()), (Some(0), ""), "{text}");
    serde_json::from_str(&text).unwrap()
}

const NARROW: [&str; 4] = ["--rotation", "-0.02 rad,0.02 rad", "--press", "30 nm"];
const BY_TABLE: [&str; 3] = ["seta.tip_law=table", "seta.tip_tolerance=1e-2", "seta.forks=2"];

#[test]
fn tips_that_leave_a_table_make_it_grow() {
    let dir = tempdir().unwrap();
    coarsen(dir.path(), &NARROW);
    let read = [&BY_TABLE[..], &["seta.tip_table=tip"]].concat();
    let grown = summary(run(dir.path(), &read, &["--json"]));
    let wide = summary(run(dir.path(), &BY_TABLE, &["--json"]));
    let curve = summary(run(dir.path(), &["seta.forks=2"], &["--json"]));
    let peak = |of: &Value| of["peak"]["force_nN"].as_f64().unwrap();
    assert_eq!((&grown["tip"]["law"], &curve["tip"]["law"]), (&"table".into(), &"curve".into()));
    assert!(curve["tip_table"].is_null());
    let table = &grown["tip_table"];
    let number = |key: &str| table[key].as_f64().unwrap();
    assert!(
        number("pull_offs") > 1.0 && number("tips_outside_first") > 0.0 && number("tips_outside") == 0.0,
        "{table}"
    );
    assert!(number("relative_error") <= 1e-2 && number("rows") > 100.0, "{table}");
    let changed = peak(&grown) - number("first_peak_force_nN");
    // both pull-offs are on the same mesh, and the peak that is reported is on a finer one, where that is reached
    let mesh = grown["mesh_error"]["force_nN"].as_f64().unwrap_or(0.0);
    assert!(
        (number("peak_force_change_nN") - changed).abs() < mesh + 1e-12 && mesh < 1e-6 * peak(&grown),
        "{table} {mesh}"
    );
    let bound = 4.0 * (number("normal_force_error_nN") + wide["tip_table"]["normal_force_error_nN"].as_f64().unwrap());
    assert!((peak(&grown) - peak(&wide)).abs() < bound && bound < 0.5, "{} {} {bound}", peak(&grown), peak(&wide));
    assert!((peak(&wide) - peak(&curve)).abs() < 0.02 * peak(&curve), "{} {}", peak(&wide), peak(&curve));
    assert_eq!((&wide["tip_table"]["pull_offs"], &wide["tip_table"]["rows_added"]), (&1.into(), &0.into()));
    let (_, text, _) = run(dir.path(), &read, &["--out", "out"]);
    assert!(text.contains("tips left the first table") && text.contains("rows added"), "{text}");
}

#[test]
fn detaching_tips_are_resolved() {
    let dir = tempdir().unwrap();
    coarsen(dir.path(), &["--rotation", "-0.3 rad,0.1 rad", "--press", "100 nm"]);
    let sets = [&BY_TABLE[..], &["seta.tip_table=tip", "seta.resolve_within=20 nm"]].concat();
    let found = summary(run(dir.path(), &sets, &["--json"]));
    let table = &found["tip_table"];
    let number = |key: &str| table[key].as_f64().unwrap();
    assert_eq!((number("resolve_within_nm"), number("tips_resolved"), number("tips_unresolved")), (20.0, 4.0, 0.0));
    assert!(number("pull_offs") >= 2.0 && number("tips_outside") == 0.0, "{table}");
    let (change, bound) = (number("resolved_peak_force_change_nN"), 4.0 * number("normal_force_error_nN"));
    assert!(change != 0.0 && change.abs() < bound, "{table}");
    assert!(number("resolved_force_change_nN") > 0.0 && number("resolved_moment_change_nN_nm") > 0.0, "{table}");
    let (_, text, _) = run(dir.path(), &sets, &["--out", "out"]);
    assert!(text.contains("within 20.000 nm of where they snap off"), "{text}");
    let (status, _, trouble) = run(dir.path(), &["seta.resolve_within=20 nm"], &["--json"]);
    assert!(status == Some(2) && trouble.contains("which tips are no longer taken from a table"), "{trouble}");
}

#[test]
fn the_table_of_another_tip_is_refused_by_name() {
    let dir = tempdir().unwrap();
    coarsen(dir.path(), &NARROW);
    let read = |set: &str| run(dir.path(), &[&BY_TABLE[..], &["seta.tip_table=tip", set]].concat(), &["--json"]);
    for (set, words) in [
        ("spatula.pad_length=230 nm", "spatula.pad_length_nm is 240.0 there, and 230.0 in the scene"),
        ("adhesion.hamaker_constant=2e-19 J", "adhesion.hamaker_constant_aJ is 0.1 there, and 0.2 in the scene"),
        ("seta.tip_tolerance=1e-5", "the error of the table is "),
        ("seta.tip_table=none", "none/summary.json is not a part of the law of a tip"),
    ] {
        let (status, _, trouble) = read(set);
        assert!(status == Some(2) && trouble.contains(words) && trouble.contains("peel coarsen"), "{set}: {trouble}");
    }
    coarsen(
        dir.path(),
        &["--set", "grip.horizontal=fixed", "--lateral", "-1 nm,1 nm", "--rotation", "-0.01 rad,0.01 rad"],
    );
    let (status, _, trouble) = read("seta.tip_tolerance=1e-2");
    assert!(status == Some(2) && trouble.contains("pad_end is held there, and sliding in the scene"), "{trouble}");
}

/// What is kept is that of the second pull-off: the table has grown before.
#[test]
fn a_pull_off_by_a_table_goes_on_where_it_was_stopped() {
    let dir = tempdir().unwrap();
    coarsen(dir.path(), &["--rotation", "-0.3 rad,0.05 rad", "--press", "100 nm"]);
    let sets = ["seta.tip_law=table", "seta.tip_tolerance=1e-2", "seta.tip_table=tip", "seta.forks=6"];
    let whole = summary(run(dir.path(), &sets, &["--json"]));
    assert!(whole["tip_table"]["pull_offs"].as_f64().unwrap() > 1.0, "{}", whole["tip_table"]);
    let mut taken = 0;
    for time in ["0.3 s", "0.6 s", "1.2 s", "2.4 s", "1000 s"] {
        let bound = format!("bounds.time={time}");
        let (status, text, trouble) = run(dir.path(), &[&sets[..], &[&bound]].concat(), &["--out", "out", "--force"]);
        // the table has grown before, and what it has to hold is not computed again in so short a time
        let ends_early = trouble.contains("the table of the tips of the seta: bounds.time");
        assert!((status, trouble.as_str()) == (Some(0), "") || (status == Some(3) && ends_early), "{text} {trouble}");
        taken += usize::from(text.contains("equilibria taken from an earlier, unfinished run"));
    }
    assert!(taken > 0 && !dir.path().join("out/run.partial").exists());
    assert_eq!(numbers(written(dir.path())), numbers(whole));
}

/// A pull-off whose tips are solved as spatulae is stopped, and goes on, with what is known of the spatulae gone.
#[test]
fn a_resolved_pull_off_goes_on_where_it_was_stopped() {
    let dir = tempdir().unwrap();
    coarsen(dir.path(), &["--rotation", "-0.3 rad,0.1 rad", "--press", "100 nm"]);
    let sets = [&BY_TABLE[..2], &["seta.tip_table=tip", "seta.forks=3", "seta.resolve_within=20 nm"]].concat();
    let whole = summary(run(dir.path(), &sets, &["--json"]));
    assert_eq!(whole["tip_table"]["tips_resolved"], 8);
    let (mut time, mut went_on) = (0.01, 0);
    while time < 1000.0 {
        let bound = format!("bounds.time={time} s");
        let (status, text, trouble) = run(dir.path(), &[&sets[..], &[&bound]].concat(), &["--out", "out", "--force"]);
        assert!(status == Some(0) || status == Some(3), "{text} {trouble}");
        if !dir.path().join("out/run.partial").exists() {
            went_on += usize::from(text.contains("equilibria taken from an earlier, unfinished run"));
            break;
        }
        // what was reached has tips that are solved: it is of the last pull-off
        let is_resolved = written(dir.path())["tip_table"]["resolved_force_change_nN"].as_f64().is_some();
        (time, went_on) = if is_resolved { (1000.0 / 3.0, 1) } else { (1.3 * time, 0) };
    }
    assert_eq!(numbers(written(dir.path())), numbers(whole));
    assert_eq!(went_on, 2, "the machine is so fast that the last pull-off was not stopped");
}

/// Heights that are scattered by 2 µm: where the highest tips hold the most, the lowest ones are pressed far below where any table can begin.
#[test]
fn a_peak_outside_of_the_table_is_status_3() {
    let dir = tempdir().unwrap();
    coarsen(dir.path(), &NARROW);
    let scattered = ["seta.forks=3", "seta.height_scatter=2000 nm", "seta.youngs_modulus=100 MPa"];
    let sets = [&BY_TABLE[..2], &["seta.tip_table=tip"], &scattered].concat();
    let (status, text, trouble) = run(dir.path(), &sets, &["--json"]);
    assert!(status == Some(3) && trouble.contains("it is not known"), "{status:?} {trouble}");
    let found: Value = serde_json::from_str(&text).unwrap();
    let warning = &found["warnings"][0];
    assert_eq!(warning["code"], "peak-outside-table", "{warning}");
    assert!(found["tip_table"]["tips_outside"].as_f64().unwrap() >= 1.0, "{}", found["tip_table"]);
}

fn written(dir: &Path) -> Value {
    serde_json::from_slice(&fs::read(dir.join("out/summary.json")).unwrap()).unwrap()
}

/// All of it but how long it took and how it was asked for.
fn numbers(mut summary: Value) -> Value {
    let own = summary.as_object_mut().unwrap();
    for key in ["timing", "command", "parameters"] {
        own.remove(key);
    }
    summary
}
