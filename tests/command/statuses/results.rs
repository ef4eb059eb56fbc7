//! What the computation finds: ends, peaks and limit points of the ready scenes.
//!
//! Expected: the values of `verification/strip_points.csv`.

use super::{bench, peel};
use serde_json::Value;
use std::fs;

fn close(value: &Value, expected: f64, relative: f64) {
    let value = value.as_f64().expect("a number");
    assert!((value / expected - 1.0).abs() < relative, "{value} is not {expected} to {relative:e}");
}

#[test]
fn the_100nm_strip_pivots() {
    let dir = bench();
    let run = peel(dir.path(), &["run", "strip-100nm.toml", "--json", "--out", "out"]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    let summary = run.json();
    assert_eq!(summary["end"], "pivoting");
    assert_eq!(summary["reason"], Value::Null);
    assert_eq!((&summary["version"], &summary["schema"]), (&env!("CARGO_PKG_VERSION").into(), &1.into()));
    assert_eq!(summary["command"], "peel run strip-100nm.toml --json --out out");
    close(&summary["peak"]["force_nN"], 0.341121483196, 1e-6);
    close(&summary["peak"]["displacement_nm"], 0.249601344023, 1e-6);
    close(&summary["initiation_peak"]["force_nN"], 0.341121483196, 1e-6);
    close(&summary["snap_off"]["displacement_nm"], 48.2156178228, 1e-6);
    close(&summary["snap_off"]["force_nN"], 0.0375627292271, 1e-6);
    assert!(summary["snap_off"]["work_aJ"].as_f64().unwrap() > 0.0);
    for key in ["error_nN", "error_nm"] {
        let error = summary["peak"][key].as_f64().unwrap();
        assert!((0.0..1e-6).contains(&error), "peak.{key} = {error}");
    }
    let limit_points = summary["limit_points"].as_array().unwrap();
    let turns: Vec<&Value> = limit_points.iter().filter(|at| at["kind"] == "displacement").collect();
    close(&turns[0]["displacement_nm"], 48.2156178228, 1e-6);
    close(&turns[1]["displacement_nm"], 23.428330408, 1e-6);
    assert!(limit_points.iter().any(|at| at["kind"] == "load"));
    for picture in ["curve.svg", "curve.png", "shapes.svg", "shapes.png"] {
        assert!(dir.path().join("out").join(picture).exists(), "{picture}");
    }
}

#[test]
fn the_soft_strip_turns_back() {
    let dir = bench();
    let run = peel(dir.path(), &["run", "strip-soft.toml", "--json"]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    assert_eq!(run.json()["end"], "turned-back");
}

/// Strips too soft for their adhesion are refused before anything is solved; the summary and the message have the ratio.
#[test]
fn a_strip_without_a_stable_state_is_bad_input() {
    let dir = bench();
    let args = ["run", "strip-100nm.toml", "--json", "--set", "strip.youngs_modulus=5 MPa"];
    let run = peel(dir.path(), &args);
    assert_eq!(run.status, 2, "{}", run.stderr);
    let summary = run.json();
    assert_eq!(summary["end"], "refused");
    assert!(summary["reason"].as_str().unwrap().contains("1.7620 times"), "{}", summary["reason"]);
    assert_eq!(summary["path"]["points"], 0);
    let told = run.stderr.replace(['\n', ' '], "");
    assert!(told.contains("1.7620times") && told.contains("strip.height"), "{}", run.stderr);
}

#[test]
fn warnings_have_a_code_and_their_numbers() {
    let dir = bench();
    let run = peel(dir.path(), &["run", "strip-100nm.toml", "--json", "--set", "strip.length=40 nm"]);
    let summary = run.json();
    let warnings = summary["warnings"].as_array().unwrap();
    let short = warnings.iter().find(|warning| warning["code"] == "short-beam").expect("a warning of four heights");
    assert_eq!((short["value"].as_f64(), short["limit"].as_f64()), (Some(4.0), Some(5.0)));
    assert!(short["meaning"].as_str().is_some_and(|meaning| meaning.contains("as long as it is high")), "{short}");
}

#[test]
fn a_bound_is_an_end_and_no_failure() {
    let dir = bench();
    for (set, word) in [("bounds.points=20", "20"), ("bounds.displacement=5nm", "5")] {
        let run = peel(dir.path(), &["run", "strip.toml", "--json", "--set", set]);
        assert_eq!(run.status, 0, "{}", run.stderr);
        let summary = run.json();
        assert_eq!(summary["end"], "bound", "{set}");
        assert!(summary["reason"].as_str().unwrap().contains(word), "{set}: {}", summary["reason"]);
        assert_eq!(summary["snap_off"], Value::Null);
    }
}

#[test]
fn a_followed_peak_fills_its_own_columns_and_is_drawn() {
    let dir = bench();
    let key =
        ["sweep", "strip-100nm.toml", "--vary", "strip.bending_stiffness_factor", "--from", "1e-2", "--to", "1e2"];
    let rest = ["--points", "41", "--log", "--json", "--out", "out", "--peak-only"];
    let sweep = peel(dir.path(), &[&key[..], &rest].concat());
    assert_eq!((sweep.status, sweep.stderr.as_str()), (0, ""));
    let json = sweep.json();
    assert_eq!(json["followed"], "initiation peak");
    let row = &json["rows"][20];
    close(&row["initiation_peak_nN"], 0.341121483196, 1e-6);
    assert!(row["initiation_peak_error_nN"].as_f64().unwrap() < 0.35e-6);
    for empty in ["peak_force_nN", "peak_error_nN", "plateau_force_nN", "snap_off_displacement_nm", "work_aJ", "end"] {
        assert_eq!(row[empty], Value::Null, "{empty} is not computed");
    }
    let table = fs::read_to_string(dir.path().join("out/sweep.csv")).unwrap();
    assert!(table.starts_with("value,strip.bending_stiffness_factor,peak_force_nN,peak_error_nN,"), "{table}");
    assert_eq!(table.lines().count(), 42);
    for file in ["sweep.svg", "sweep.png"] {
        assert!(dir.path().join("out").join(file).exists(), "{file}");
    }
}

#[test]
fn a_followed_snap_off_says_where_it_vanishes() {
    let dir = bench();
    let key = ["sweep", "strip-100nm.toml", "--vary", "strip.bending_stiffness_factor", "--from", "10", "--to", "1000"];
    let sweep =
        peel(dir.path(), &[&key[..], &["--points", "5", "--log", "--follow", "snap-off", "--out", "o"]].concat());
    assert_eq!((sweep.status, sweep.stderr.as_str()), (0, ""));
    for part in ["snap-off followed", "vanishes between 74.6", "the path has no snap-off"] {
        assert!(sweep.stdout.contains(part), "{part:?} is not in\n{}", sweep.stdout);
    }
    let both = peel(dir.path(), &[&key[..], &["--points", "5", "--follow", "peak", "--peak-only"]].concat());
    both.is_bad_input(&["--follow", "--peak-only"]);
    // a term that only the values bring in
    let rubs = ["sweep", "strip-100nm.toml", "--vary", "friction.strength", "--from", "1 MPa", "--to", "2 MPa"];
    peel(dir.path(), &[&rubs[..], &["--points", "2", "--peak-only"]].concat()).is_bad_input(&["without friction only"]);
}

#[test]
fn what_does_not_matter_is_left_out_and_told() {
    let dir = bench();
    let args = ["run", "strip-100nm.toml", "--set", "strip.height=40nm", "--set", "accuracy.relative=1e-3"];
    let auto = peel(dir.path(), &[&args[..], &["--set", "terms=auto", "--json"]].concat());
    assert_eq!((auto.status, auto.stderr.as_str()), (0, ""));
    let json = auto.json();
    assert_eq!(json["parameters"]["terms"], "auto");
    let considered = &json["considered"];
    let left: Vec<&Value> = considered["left_out"].as_array().unwrap().iter().map(|left| &left["term"]).collect();
    assert_eq!(left, ["far face", "horizontal unknowns"]);
    assert!(considered["left_out"][0]["largest_relative_change"].as_f64().unwrap() > 1e-6);
    let kept: Vec<&Value> = considered["kept"].as_array().unwrap().iter().map(|kept| &kept["term"]).collect();
    assert_eq!(kept, ["shear", "extension", "contact moment"]);
    let told = peel(dir.path(), &[&args[..], &["--set", "terms=auto", "--out", "o"]].concat()).stdout;
    assert!(told.contains("far face: the initiation peak would change by -5.4e-7 nN"), "{told}");
    let all = peel(dir.path(), &[&args[..], &["--json"]].concat());
    assert_eq!(all.json()["considered"], Value::Null);
}

#[test]
fn the_summary_for_people_says_what_was_found() {
    let dir = bench();
    let run = peel(dir.path(), &["run", "strip-100nm.toml"]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    for part in ["peak force", "0.3411", "initiation peak", "snap-off", "48.2156", "limit points", "pivoting: "] {
        assert!(run.stdout.contains(part), "{part:?} is not in\n{}", run.stdout);
    }
}

#[test]
fn a_sweep_of_the_stiffness_ends_well_and_is_drawn() {
    let dir = bench();
    let args =
        ["sweep", "strip-100nm.toml", "--vary", "strip.bending_stiffness_factor", "--from", "1e-4", "--to", "1e4"];
    let sweep = peel(dir.path(), &[&args[..], &["--points", "5", "--log", "--json", "--out", "out"]].concat());
    assert_eq!((sweep.status, sweep.stderr.as_str()), (0, ""));
    let rows = sweep.json()["rows"].as_array().unwrap().clone();
    let peaks: Vec<f64> = rows.iter().map(|row| row["peak_force_nN"].as_f64().unwrap()).collect();
    assert!(peaks.windows(2).all(|pair| pair[0] < pair[1]), "a stiffer strip holds more: {peaks:?}");
    close(&rows[2]["peak_force_nN"], 0.341121483196, 1e-6);
    close(&rows[2]["snap_off_displacement_nm"], 48.2156178228, 1e-6);
    for file in ["sweep.csv", "sweep.svg", "sweep.png"] {
        assert!(dir.path().join("out").join(file).exists(), "{file}");
    }
}
