//! What a computation writes, whatever it finds.

use super::{assert_status_tells_the_end, bench, peel, sweep};
use serde_json::Value;
use std::fs;

#[test]
fn json_is_one_object_and_writes_no_file() {
    let dir = bench();
    let run = peel(dir.path(), &["run", "strip.toml", "--json", "--set", "strip.length=150nm"]);
    let summary = run.json();
    assert_status_tells_the_end(&run, &summary["end"], &summary["reason"]);
    let keys =
        ["peak", "initiation_peak", "plateau", "snap_off", "first_jump", "pad_detachment", "detachment", "reason"];
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
    let table = fs::read_to_string(dir.path().join("out/strip-sweep-strip.length/sweep.csv")).unwrap();
    let header = "value,strip.length_nm,peak_force_nN,peak_error_nN,peak_displacement_nm,peak_error_nm,\
                  initiation_peak_nN,initiation_peak_error_nN,initiation_peak_displacement_nm,initiation_peak_error_nm,\
                  plateau_force_nN,plateau_error_nN,plateau_displacement_nm,plateau_error_nm,snap_off_displacement_nm,\
                  snap_off_error_nm,snap_off_force_nN,snap_off_error_nN,work_aJ,work_error_aJ,work_to,\
                  pad_detachment_displacement_nm,pad_detachment_error_nm,pad_detachment_force_nN,\
                  pad_detachment_error_nN,pad_detachment_work_aJ,pad_detachment_work_error_aJ,\
                  detachment_displacement_nm,detachment_error_nm,detachment_force_nN,detachment_error_nN,\
                  detachment_work_aJ,detachment_work_error_aJ,largest_computed_force_nN,end,accuracy_reached,solve_s,\
                  points,newton_iterations,elements,order\n";
    assert!(table.starts_with(header), "{table}");
    let values: Vec<&str> = table.lines().skip(1).map(|line| line.split(',').next().unwrap()).collect();
    assert_eq!(values, ["80.0", "100.0", "120.0"]);
}

/// A path that is cut short while the force rises has no peak: an empty cell in the table, a gap in the picture, a mark at its work.
#[test]
fn a_sweep_over_paths_that_are_cut_short_has_gaps() {
    let dir = bench();
    let args = ["sweep", "strip-100nm.toml", "--vary", "bounds.displacement", "--from", "0.1 nm", "--to", "60 nm"];
    let sweep = peel(dir.path(), &[&args[..], &["--points", "3", "--out", "cut"]].concat());
    assert_eq!(sweep.status, 0, "{}", sweep.stderr);
    let table = fs::read_to_string(dir.path().join("cut/sweep.csv")).unwrap();
    let header: Vec<&str> = table.lines().next().unwrap().split(',').collect();
    let cell = |line: usize, name: &str| {
        let column = header.iter().position(|&column| column == name).unwrap();
        table.lines().nth(1 + line).unwrap().split(',').nth(column).unwrap().to_owned()
    };
    assert_eq!((cell(0, "peak_force_nN"), cell(0, "work_to")), (String::new(), "end of path".into()));
    assert!(cell(0, "largest_computed_force_nN").starts_with("0.29"), "{table}");
    for line in 1..3 {
        assert!(cell(line, "peak_force_nN").starts_with("0.3411"), "{table}");
        assert_eq!(cell(line, "largest_computed_force_nN"), "");
    }
    assert_eq!(cell(2, "work_to"), "first jump");
    assert!(dir.path().join("cut/sweep.svg").exists());
    assert!(sweep.stdout.contains("* work to the end of a path without a jump"), "{}", sweep.stdout);
}

#[test]
fn a_run_that_was_cut_short_tells_no_peak() {
    let dir = bench();
    let cut = ["run", "strip-100nm.toml", "--set", "bounds.displacement=0.1 nm"];
    let run = peel(dir.path(), &[&cut[..], &["--json"]].concat());
    let summary = run.json();
    assert_eq!((&summary["peak"], &summary["initiation_peak"]), (&Value::Null, &Value::Null));
    assert_eq!(summary["largest_computed_force"]["located"], false);
    assert_eq!(summary["accuracy"]["met"], Value::Null);
    let text = peel(dir.path(), &cut).stdout;
    assert!(text.contains("peak force         none") && text.contains("largest computed   0.29"), "{text}");
    assert!(text.contains("not the work of peeling"), "{text}");
}

#[test]
fn a_tolerance_that_was_not_met_is_told_first() {
    let dir = bench();
    let coarse = ["run", "strip-100nm.toml", "--set", "accuracy.elements=12", "--set", "accuracy.relative=1e-9"];
    let text = peel(dir.path(), &coarse).stdout;
    let first = text.lines().nth(2).unwrap_or_default();
    assert!(first.starts_with("  accuracy           ") && first.contains("requested 1e-9"), "{text}");
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

/// What has no finite stiffness, no reach or no end is reported in an end, never by a panic.
#[test]
fn absurd_scenes_end_in_a_status() {
    let dir = bench();
    for set in ["strip.height=1e200 m", "strip.youngs_modulus=1e-290 GPa", "adhesion.equilibrium_distance=1e100 nm"] {
        peel(dir.path(), &["run", "strip-100nm.toml", "--set", set]).is_bad_input(&["out of range"]);
    }
    for set in ["strip.youngs_modulus=1e-30 GPa", "strip.length=1e25 nm", "strip.bending_stiffness_factor=1e-30"] {
        peel(dir.path(), &["run", "strip-100nm.toml", "--set", set]).is_bad_input(&["process zones long"]);
    }
    for set in [
        "strip.height=1e30 nm",
        "strip.youngs_modulus=1e-8 GPa",
        "strip.length=1e-9 nm",
        "strip.length=4e6 nm",
        "adhesion.hamaker_constant=1e-30 aJ",
        "adhesion.equilibrium_distance=1e30 nm",
        "strip.bending_stiffness_factor=1e-17",
    ] {
        let args = ["run", "strip-100nm.toml", "--json", "--set", "bounds.time=1 s", "--set", set];
        let run = peel(dir.path(), &args);
        let summary = run.json();
        assert_status_tells_the_end(&run, &summary["end"], &summary["reason"]);
    }
}

#[test]
fn a_reader_that_goes_away_is_no_panic() {
    let dir = bench();
    let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_peel"))
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
