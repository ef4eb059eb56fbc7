//! A strip in space, run by the command.
//!
//! Expected: the numbers of an independent computation of the sideways pull, and the numbers of the plane where the
//! solution stays there. Why: what is pulled sideways is another structure, and the summary has to say which one was
//! computed.

use crate::peel::refuses;
use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output};

const SIDEWAYS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/strip-sideways.toml");
const PLANE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/strip-100nm.toml");
/// A larger tolerance, and not past the first fold.
const SHORT: [&str; 4] = ["--set", "accuracy.relative=1e-4", "--set", "bounds.displacement=12.775 nm"];

fn peel(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_peel")).args(arguments).output().unwrap()
}

#[track_caller]
fn json(arguments: &[&str]) -> Value {
    let output = peel(&[arguments, &["--json"]].concat());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

fn columns(path: &Path) -> (Vec<String>, Vec<Vec<f64>>) {
    let text = std::fs::read_to_string(path).unwrap();
    let mut lines = text.lines();
    let names = lines.next().unwrap().split(',').map(str::to_owned).collect();
    (names, lines.map(|line| line.split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)).collect()).collect())
}

#[test]
fn the_sideways_pull_has_the_peak_of_an_independent_computation() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("run");
    let found = json(&[&["run", SIDEWAYS, "--out", out.to_str().unwrap()], &SHORT[..]].concat());
    assert_eq!(found["solved_in_plane"], false);
    let number = |path: &str| found.pointer(path).and_then(Value::as_f64).unwrap_or_else(|| panic!("{path}"));
    let near =
        |path: &str, expected: f64| assert!((number(path) / expected - 1.0).abs() < 1e-6, "{path}: {}", number(path));
    near("/initiation_peak/force_nN", 15.2800787641);
    near("/initiation_peak/displacement_nm", 12.7708027014);
    near("/parameters/drive/azimuth_rad", std::f64::consts::FRAC_PI_2);
    assert_eq!(
        (&found["parameters"]["space"], &found["parameters"]["strip"]["section"]),
        (&true.into(), &"rectangle".into())
    );
    assert_eq!(found["parameters"]["grip"]["roll"], "free");
    // a grip that holds nothing exerts a force along the pull alone
    for path in ["torque_nN_nm", "reaction_across_nN", "reaction_lateral_nN"] {
        assert_eq!(number(&format!("/limit_points/0/{path}")), 0.0);
    }
    assert!(number("/limit_points/0/roll_deg").abs() > 0.1 && number("/limit_points/0/yaw_deg").abs() > 0.1);
    let (names, rows) = columns(&out.join("curve.csv"));
    assert_eq!(names[9..], ["torque_nN_nm", "roll_deg", "yaw_deg", "reaction_across_nN", "reaction_lateral_nN"]);
    assert!(rows.len() > 3 && rows.iter().all(|row| row.len() == names.len() && row[9] == 0.0));
    let (names, _) = columns(&out.join("limit_points.csv"));
    assert_eq!(names[10..], ["torque_nN_nm", "roll_deg", "yaw_deg", "reaction_across_nN", "reaction_lateral_nN"]);
}

#[test]
fn the_states_of_a_run_are_written_with_its_surface() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("run");
    let arguments =
        ["run", SIDEWAYS, "--states", "2", "--out", out.to_str().unwrap(), "--set", "bounds.displacement=1 nm"];
    let output = peel(&arguments);
    let told = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(told.contains("states/ with 4 files for ParaView, which the .pvd lists name"), "{told}");
    let (names, rows) = columns(&out.join("states.csv"));
    assert_eq!(names[5..9], ["S_nm", "x_nm", "y_nm", "z_nm"]);
    assert!(rows.iter().all(|row| row.len() == names.len()));
    for name in ["states.pvd", "states-surface.pvd", "states/state-001.vtu", "states/surface-001.vtu"] {
        assert!(out.join(name).exists(), "{name}");
    }
}

#[test]
fn what_the_grip_holds_takes_a_reaction() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("run");
    let held = ["--set", "grip.roll=fixed", "--set", "grip.lateral=fixed", "--set", "bounds.displacement=1 nm"];
    json(&[&["run", SIDEWAYS, "--out", out.to_str().unwrap(), "--set", "accuracy.elements=8"], &held[..]].concat());
    let (_, rows) = columns(&out.join("curve.csv"));
    let last = rows.last().unwrap();
    let [torque, roll, _, across, lateral] = [9, 10, 11, 12, 13].map(|column| last[column]);
    assert!(torque.abs() > 1e-3 && lateral.abs() > 1e-6, "{last:?}");
    assert!(roll.abs() < 1e-9 && across == 0.0, "{last:?}");
}

#[test]
fn what_stays_in_the_plane_is_solved_there_and_said_so() {
    let roughly = ["--set", "accuracy.relative=1e-4", "--set", "bounds.displacement=1 nm"];
    let plane = json(&[&["run", PLANE], &roughly[..]].concat());
    let space = json(&[&["run", PLANE, "--set", "space=true"], &roughly[..]].concat());
    assert_eq!((&plane["solved_in_plane"], &space["solved_in_plane"]), (&Value::Null, &Value::Bool(true)));
    assert_eq!(plane["initiation_peak"], space["initiation_peak"]);
    assert_eq!((&plane["parameters"]["space"], plane["parameters"]["drive"].get("azimuth_rad")), (&false.into(), None));
    assert!(space["limit_points"][0].get("torque_nN_nm").is_none(), "the grip in space is that of a run in space");
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("run");
    let told = peel(&[&["run", PLANE, "--set", "space=true", "--out", out.to_str().unwrap()], &roughly[..]].concat());
    let told = String::from_utf8(told.stdout).unwrap();
    assert!(told.contains("solved in the plane: the solution stays in the vertical plane of the strip"), "{told}");
}

#[test]
fn the_azimuth_is_swept() {
    let swept = |scene: &str, values: &str, more: &[&str], column: &str| -> Vec<f64> {
        let vary = ["sweep", scene, "--vary", "drive.azimuth", "--values", values];
        let swept = json(&[&vary[..], more].concat());
        assert_eq!((&swept["vary"], &swept["unit"]), (&"drive.azimuth".into(), &"rad".into()));
        swept["rows"].as_array().unwrap().iter().map(|row| row[column].as_f64().unwrap()).collect()
    };
    let forces = swept(SIDEWAYS, "0,90 deg", &SHORT, "initiation_peak_nN");
    let plane = json(&[&["run", SIDEWAYS, "--set", "drive.azimuth=0 deg"], &SHORT[..]].concat());
    assert_eq!(Some(forces[0]), plane["initiation_peak"]["force_nN"].as_f64());
    assert!((forces[1] / 15.2800787641 - 1.0).abs() < 1e-6, "{forces:?}");
    // a scene in the plane is put in space by the key
    let roughly =
        ["--set", "drive.angle=60 deg", "--set", "accuracy.relative=1e-3", "--set", "bounds.displacement=0.1 nm"];
    let forces = swept(PLANE, "20,40 deg", &roughly, "work_aJ");
    assert!(forces.len() == 2 && (forces[0] / forces[1] - 1.0).abs() > 0.01, "{forces:?}");
}

/// One degree of the azimuth apart, the peak is followed, and is that of whole peels.
#[test]
fn the_peak_is_followed_in_the_azimuth() {
    let sweep = |more: &[&str]| {
        let vary = ["--vary", "drive.azimuth", "--from", "55 deg", "--to", "65 deg", "--points", "3"];
        let held = ["--set", "strip.width=20 nm", "--set", "accuracy.relative=1e-4"];
        let bound = ["--set", "bounds.displacement=25 nm"];
        let found = json(&[&["sweep", SIDEWAYS][..], &vary, &held, &bound, more].concat());
        found["rows"].as_array().unwrap().clone()
    };
    for (followed, whole) in sweep(&["--peak-only"]).iter().zip(&sweep(&[])) {
        for column in ["initiation_peak_nN", "value"] {
            let [a, b] = [followed, whole].map(|row| row[column].as_f64().unwrap());
            assert!((a - b).abs() <= 2e-4 * a.abs(), "at {} rad: {a} and {b}", followed["value"]);
        }
    }
}

/// Steps of space are told with what the grip exerts out of the plane.
#[test]
fn a_rolled_grip_tells_its_torque() {
    let rolled = SIDEWAYS.replace("sideways", "rolled");
    let found = json(&["run", &rolled, "--set", "bounds.displacement=1 nm"]);
    let number = |path: &str| found.pointer(path).and_then(Value::as_f64).unwrap_or_else(|| panic!("{path}"));
    let near = |path: &str, expected: f64, most: f64| {
        assert!((number(path) - expected).abs() <= most, "{path}: {}", number(path));
    };
    assert_eq!(found["steps"][2]["step"], "release");
    near("/steps/2/y_nm", 0.320543328, 1e-9);
    near("/steps/2/torque_nN_nm", 24.1300635, 1e-6);
    near("/steps/2/roll_deg", 5.0, 1e-12);
    near("/steps/2/vertical_force_nN", 0.0, 1e-9);
    near("/initiation_peak/displacement_nm", 0.577228347 - 0.320543328, 1e-8);
    near("/initiation_peak/force_nN", 2.61014616, 3e-8);
    near("/limit_points/0/torque_nN_nm", 10.0460141, 1e-5);
}

/// What a testing machine records of a sideways pull: its first jump is the fold of the whole path.
#[test]
fn a_test_in_space_is_recorded() {
    let short = ["--set", "accuracy.relative=1e-4", "--set", "bounds.displacement=13 nm", "--observed"];
    let found = json(&[&["run", SIDEWAYS][..], &short].concat());
    assert_eq!(found["observed"]["end"], "bound");
    let jump = &found["observed"]["jumps"][0];
    let at = jump["machine_displacement_nm"].as_f64().unwrap_or_else(|| panic!("{jump}"));
    assert!((at / 12.7781279884 - 1.0).abs() < 1e-6, "{at}");
}

#[test]
fn what_is_not_computed_in_space_is_refused_by_name() {
    let rolled = SIDEWAYS.replace("sideways", "rolled");
    for (arguments, says) in [
        (vec!["run", &rolled, "--observed"], "drive.steps has steps before the pull; the test has to begin at rest"),
        (
            vec!["sweep", &rolled, "--vary", "strip.width", "--values", "9,10 nm", "--peak-only"],
            "--follow computes a limit point from rest only, and drive.steps has steps before the pull",
        ),
    ] {
        refuses(&[], &arguments, &[says]);
    }
}
