//! The command: exit statuses, what goes to which stream, and the files it writes.
//!
//! Expected: 0 done, 2 bad input with a message that names what, where and what would be right, 3 when the computation
//! stopped short, 1 for the rest. Standard output carries the result alone and standard error the trouble alone, so
//! that the command can stand in a pipe. Why: scripts and other programs rest on these names and numbers.

use assert_cmd::Command;
use serde_json::Value;
use std::fs;
use std::path::Path;
use tempfile::{TempDir, tempdir};

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
    let output = Command::cargo_bin("peel").unwrap().current_dir(dir).args(args).output().unwrap();
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

// ---------------------------------------------------------------------------------------------------------------
// What needs no computation
// ---------------------------------------------------------------------------------------------------------------

#[test]
fn help_is_enough_to_work_from() {
    let dir = bench();
    for args in [vec!["--help"], vec!["run", "--help"], vec!["sweep", "--help"]] {
        let help = peel(dir.path(), &args);
        assert_eq!((help.status, help.stderr.as_str()), (0, ""));
        for part in ["strip.length", "youngs_modulus", "GPa", "force-only", "Exit status", "Examples", "required"] {
            assert!(help.stdout.contains(part), "{part} is not in the help of {args:?}");
        }
        let widest = help.stdout.lines().map(|line| line.chars().count()).max();
        assert!(widest <= Some(120), "{args:?}: {widest:?} columns");
    }
}

#[test]
fn usage_errors_are_bad_input() {
    let dir = bench();
    peel(dir.path(), &[]).is_bad_input(&["Usage"]);
    peel(dir.path(), &["pull"]).is_bad_input(&["pull"]);
    peel(dir.path(), &["run"]).is_bad_input(&["SCENE"]);
    peel(dir.path(), &["run", "strip.toml", "--colour"]).is_bad_input(&["--colour"]);
    peel(dir.path(), &["run", "strip.toml", "--set", "strip.length"]).is_bad_input(&["KEY=VALUE"]);
    peel(dir.path(), &["sweep", "strip.toml", "--vary", "strip.length"]).is_bad_input(&["--from", "--to", "--points"]);
}

#[test]
fn a_scene_that_cannot_be_read_is_bad_input() {
    let dir = bench();
    peel(dir.path(), &["run", "none.toml"]).is_bad_input(&["none.toml", "peel new"]);
    peel(dir.path(), &["run", "."]).is_bad_input(&["cannot read the scene"]);
    fs::write(dir.path().join("latin.toml"), b"# first\ntitle = \"na\xefve\"").unwrap();
    peel(dir.path(), &["run", "latin.toml"]).is_bad_input(&["latin.toml, line 2", "UTF-8"]);
    fs::write(dir.path().join("empty.toml"), "").unwrap();
    peel(dir.path(), &["run", "empty.toml"]).is_bad_input(&["empty.toml, line 1", "[strip]"]);
    assert!(!dir.path().join("out").exists(), "nothing is written for a scene that cannot be used");
}

#[test]
fn a_mistake_in_a_scene_is_shown_where_it_stands() {
    let dir = bench();
    let text = fs::read_to_string(dir.path().join("strip.toml")).unwrap();
    let line = 1 + text.lines().position(|line| line.starts_with("length")).unwrap();
    let place = format!("bad.toml, line {line}: ");
    for (wrong, parts) in [
        ("length = 200", ["`strip.length` is 200, a number without a unit", "\"200 nm\""]),
        ("length = \"200 GPa\"", ["`strip.length` is \"200 GPa\": GPa measures a pressure", "for example length ="]),
        ("length = 200 nm", ["`length` is not TOML", "length = \"100 nm\""]),
        ("lenght = \"200 nm\"", ["`strip.lenght` is not a key", "Did you mean `length`?"]),
        ("length = \"-1 nm\"", ["`strip.length` is -1 nm", "above zero"]),
        ("length = \"nan nm\"", ["`strip.length` is NaN nm", "above zero"]),
    ] {
        fs::write(dir.path().join("bad.toml"), text.replace("length = \"200 nm\"", wrong)).unwrap();
        for command in [&["run", "bad.toml"][..], &["run", "bad.toml", "--json"]] {
            peel(dir.path(), command).is_bad_input(&[&place, parts[0], parts[1], wrong]);
        }
    }
}

#[test]
fn a_mistake_in_an_override_is_bad_input() {
    let dir = bench();
    let set = |text: &str| peel(dir.path(), &["run", "strip.toml", "--set", text]);
    set("strip.length=100").is_bad_input(&["--set strip.length=100", "without a unit", "\"100 nm\""]);
    set("length=100nm").is_bad_input(&["--set length=100nm", "Did you mean `strip.length`?"]);
    set("strip.poissons_ratio=0.5").is_bad_input(&["`strip.poissons_ratio` is 0.5", "between -1 and 0.5"]);
    set("grip.rotation=fix").is_bad_input(&["`grip.rotation` is \"fix\"", "\"free\" or \"fixed\""]);
}

#[test]
fn a_sweep_that_makes_no_sense_is_bad_input() {
    let dir = bench();
    let dir = dir.path();
    sweep(dir, "strip.lengh", "1 nm", "2 nm", "2").is_bad_input(&["--vary strip.lengh", "`strip.length`"]);
    sweep(dir, "colour", "1 nm", "2 nm", "2").is_bad_input(&["--vary colour", "strip.height"]);
    sweep(dir, "grip.rotation", "1", "2", "2").is_bad_input(&["--vary grip.rotation is not a number", "strip.length"]);
    sweep(dir, "strip.length", "1", "2 nm", "2").is_bad_input(&["--from for strip.length", "without a unit"]);
    sweep(dir, "strip.length", "1 nm", "2 GPa", "2").is_bad_input(&["--to for strip.length", "measures a pressure"]);
    sweep(dir, "strip.length", "0 nm", "2 nm", "2").is_bad_input(&["--from for strip.length", "above zero"]);
    sweep(dir, "strip.length", "1 nm", "nan nm", "2").is_bad_input(&["--to for strip.length", "not a finite number"]);
    sweep(dir, "strip.poissons_ratio", "-0.5", "0.5", "2").is_bad_input(&["--to for strip.poissons_ratio", "0.5"]);
    sweep(dir, "strip.poissons_ratio", "-0.5 nm", "0.4", "2").is_bad_input(&["--from", "not a number"]);
    sweep(dir, "strip.length", "1 nm", "2 nm", "0").is_bad_input(&["--points", "1..="]);
    sweep(dir, "strip.length", "1 nm", "2 nm", "-3").is_bad_input(&["-3"]);
    sweep(dir, "bounds.points", "1", "2", "3").is_bad_input(&["bounds.points between --from and --to", "1.5"]);
    let log = ["sweep", "strip.toml", "--vary", "strip.poissons_ratio", "--from", "-0.5", "--to", "0.4"];
    let log = [&log[..], &["--points", "3", "--log"]].concat();
    peel(dir, &log).is_bad_input(&["--from -0.5 is not above zero", "--log"]);
}

#[test]
fn new_writes_a_scene_that_is_right_and_overwrites_nothing() {
    let dir = tempdir().unwrap();
    let new = |args: &[&str]| peel(dir.path(), &[&["new"], args].concat());
    for (args, file) in [(&[][..], "strip.toml"), (&["mine"], "mine.toml"), (&["v1.2"], "v1.2.toml")] {
        let made = new(args);
        assert_eq!((made.status, made.stderr.as_str()), (0, ""));
        assert!(made.stdout.contains(file), "{}", made.stdout);
        let text = fs::read_to_string(dir.path().join(file)).unwrap();
        assert_eq!(text, include_str!("../../scenes/strip.toml"));
    }
    fs::write(dir.path().join("mine.toml"), "kept").unwrap();
    for name in ["mine", "mine.toml"] {
        new(&[name]).is_bad_input(&["mine.toml exists", "peel new NAME"]);
    }
    assert_eq!(fs::read_to_string(dir.path().join("mine.toml")).unwrap(), "kept");
    assert_eq!(new(&["no/such/folder/x"]).status, 1);
}

// ---------------------------------------------------------------------------------------------------------------
// What needs a computation, whatever it finds
// ---------------------------------------------------------------------------------------------------------------

/// Exit status 3 says that the computation stopped short, and says why; 0 that it did not.
#[track_caller]
fn assert_status_tells_the_end(outcome: &Outcome, end: &Value, reason: &Value) {
    match outcome.status {
        0 => {
            assert_ne!(end, "failed");
            assert_eq!(outcome.stderr, "", "nothing to say in a pipe");
        }
        3 => {
            assert_eq!(end, "failed");
            let line = reason.as_str().unwrap().lines().next().unwrap();
            assert!(outcome.stderr.contains(line), "{}", outcome.stderr);
        }
        other => panic!("exit status {other}: {}", outcome.stderr),
    }
}

#[test]
fn json_is_one_object_and_writes_no_file() {
    let dir = bench();
    let run = peel(dir.path(), &["run", "strip.toml", "--json", "--set", "strip.length=150nm"]);
    let summary = run.json();
    assert_status_tells_the_end(&run, &summary["end"], &summary["reason"]);
    let keys = ["peak", "initiation_peak", "plateau", "snap_off", "reason"];
    let object = summary.as_object().unwrap();
    assert!(keys.iter().all(|&key| object.contains_key(key)), "{keys:?} are there, null where a thing does not occur");
    assert_eq!(summary["scene"], "strip.toml");
    assert_eq!(summary["title"], "Peeling of an elastic strip");
    assert!(summary["limit_points"].is_array());
    assert!(summary["timing"]["solve_s"].is_number());
    for key in ["points", "newton_iterations", "elements", "order"] {
        assert!(summary["path"][key].is_u64(), "path.{key}");
    }
    assert_eq!(summary["parameters"]["strip"]["length_nm"], 150.0);
    assert_eq!(summary["parameters"]["adhesion"]["hamaker_constant_aJ"], 0.1);
    assert_eq!(summary["parameters"]["grip"]["rotation"], "free");
    assert_eq!(summary["parameters"]["bounds"]["displacement_nm"], Value::Null);
    assert!(!dir.path().join("out").exists());
}

#[test]
fn run_writes_its_files_into_the_folder_of_the_scene() {
    let dir = bench();
    let run = peel(dir.path(), &["run", "strip-100nm.toml"]);
    assert!(matches!(run.status, 0 | 3), "{}", run.stderr);
    let out = dir.path().join("out/strip-100nm");
    let read = |name: &str| fs::read_to_string(out.join(name)).unwrap();
    let summary: Value = serde_json::from_str(&read("summary.json")).unwrap();
    assert_status_tells_the_end(&run, &summary["end"], &summary["reason"]);
    let curve = read("curve.csv");
    assert!(curve.starts_with("displacement_nm,force_nN,end_rotation_rad,work_aJ,negative_eigenvalues,"), "{curve}");
    let points = summary["path"]["points"].as_u64().unwrap() as usize;
    assert_eq!(curve.lines().count(), 1 + points, "one row a path point");
    let limit_points = summary["limit_points"].as_array().unwrap().len();
    assert_eq!(read("limit_points.csv").lines().count(), 1 + limit_points);
    for name in ["summary.json", "curve.csv", "limit_points.csv"] {
        assert!(run.stdout.contains(name), "{} does not list {name}", run.stdout);
    }
    let leftover = fs::read_dir(&out).unwrap().find(|file| {
        let name = file.as_ref().unwrap().file_name();
        name.to_string_lossy().starts_with('.')
    });
    assert!(leftover.is_none(), "half-written: {leftover:?}");
}

#[test]
fn json_with_a_folder_does_both() {
    let dir = bench();
    let run = peel(dir.path(), &["run", "strip-soft.toml", "--json", "--out", "here/there"]);
    assert!(matches!(run.status, 0 | 3), "{}", run.stderr);
    assert_eq!(run.stdout, fs::read_to_string(dir.path().join("here/there/summary.json")).unwrap());
}

#[test]
fn a_folder_that_cannot_be_written_is_status_1() {
    let dir = bench();
    fs::write(dir.path().join("blocked"), "").unwrap();
    let run = peel(dir.path(), &["run", "strip-100nm.toml", "--out", "blocked"]);
    assert_eq!(run.status, 1, "{}", run.stderr);
    assert!(run.stderr.contains("cannot write blocked: "), "{}", run.stderr);
}

#[test]
fn a_sweep_writes_a_row_a_value() {
    let dir = bench();
    let sweep = sweep(dir.path(), "strip.length", "80 nm", "0.12 um", "3");
    assert!(matches!(sweep.status, 0 | 3), "{}", sweep.stderr);
    let table = fs::read_to_string(dir.path().join("out/strip/sweep.csv")).unwrap();
    let header = "value,peak_force_nN,peak_error_nN,initiation_peak_nN,plateau_force_nN,snap_off_displacement_nm,\
                  work_aJ,solve_s,end,points,newton_iterations,elements,order,initiation_peak_error_nN,\
                  snap_off_error_nm\n";
    assert!(table.starts_with(header), "{table}");
    let values: Vec<&str> = table.lines().skip(1).map(|line| line.split(',').next().unwrap()).collect();
    assert_eq!(values, ["80.0", "100.0", "120.0"]);
}

#[test]
fn a_sweep_as_json_is_one_object() {
    let dir = bench();
    let args = ["sweep", "strip-100nm.toml", "--vary", "strip.bending_stiffness_factor", "--from", "0.01", "--to", "1"];
    let sweep = peel(dir.path(), &[&args[..], &["--points", "3", "--log", "--json"]].concat());
    assert!(matches!(sweep.status, 0 | 3), "{}", sweep.stderr);
    let object = sweep.json();
    assert_eq!(object["scene"], "strip-100nm.toml");
    assert_eq!(object["vary"], "strip.bending_stiffness_factor");
    assert_eq!(object["unit"], Value::Null);
    let rows = object["rows"].as_array().unwrap();
    let values: Vec<f64> = rows.iter().map(|row| row["value"].as_f64().unwrap()).collect();
    assert_eq!(values, [0.01, 0.1, 1.0]);
    assert!(rows.iter().all(|row| row["end"].is_string() && row["solve_s"].is_number()));
    assert_eq!(sweep.status == 3, rows.iter().any(|row| row["end"] == "failed"));
    assert!(!dir.path().join("out").exists());
}

/// What has no finite stiffness, no reach or no end is told in an end, never by a panic.
#[test]
fn absurd_scenes_end_in_a_status() {
    let dir = bench();
    for set in [
        "strip.height=1e200 m",
        "strip.youngs_modulus=1e-290 GPa",
        "strip.length=1e-9 nm",
        "strip.length=1e150 nm",
        "adhesion.hamaker_constant=1e-250 aJ",
        "adhesion.equilibrium_distance=1e100 nm",
        "strip.bending_stiffness_factor=1e-200",
    ] {
        let args = ["run", "strip-100nm.toml", "--json", "--set", "bounds.time=5 s", "--set", set];
        let run = peel(dir.path(), &args);
        let summary = run.json();
        assert_status_tells_the_end(&run, &summary["end"], &summary["reason"]);
    }
}

#[test]
fn a_reader_that_goes_away_is_no_panic() {
    let dir = bench();
    let mut child = std::process::Command::new(assert_cmd::cargo::cargo_bin("peel"))
        .current_dir(dir.path())
        .args(["run", "strip-100nm.toml", "--json"])
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert!(matches!(output.status.code(), Some(0 | 3)), "{output:?}");
    assert!(!String::from_utf8_lossy(&output.stderr).contains("panicked"), "{output:?}");
}

// ---------------------------------------------------------------------------------------------------------------
// What the computation finds: ends, peaks and special points of the ready scenes
// (design.md, section 5: reference/strip.csv)
// ---------------------------------------------------------------------------------------------------------------

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
    assert!(table.starts_with("value,peak_force_nN,peak_error_nN,initiation_peak_nN,"), "{table}");
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
