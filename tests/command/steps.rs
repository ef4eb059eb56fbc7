//! Steps before the pull, reported and refused.

use crate::peel::refuses;
use crate::strip::{paper_strip, with_grip};
use peelkit::model::{Hold, PeelModel, Pull, Step};
use peelkit::study::{Accuracy, NoTest, StopCriteria, observed};
use serde_json::Value;
use std::f64::consts::FRAC_PI_3;
use std::path::Path;
use std::process::Command;

const BOUNDS: StopCriteria = StopCriteria::after_points(5000);
const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/strip-100nm.toml");

/// The strip in this grip, after these steps.
fn strip(rotation: Hold, horizontal: Hold, steps: &[Step]) -> PeelModel {
    let model = with_grip(paper_strip(100.0, 1.0), rotation, horizontal);
    PeelModel { steps: steps.to_vec(), ..model.into() }
}

#[track_caller]
fn assert_near(what: &str, a: f64, b: f64, bound: f64) {
    assert!((a - b).abs() <= bound, "{what}: {a} and {b}, apart by {:.1e}, bound {bound:.1e}", a - b);
}

fn turning() -> Vec<PeelModel> {
    let grip = |horizontal, angle, turn: f64| PeelModel {
        pull: Pull { angle, turn: turn.to_radians() },
        ..strip(Hold::Fixed, horizontal, &[])
    };
    vec![grip(Hold::Free, FRAC_PI_3, 0.5), grip(Hold::Fixed, 1.2, -0.5), grip(Hold::Free, Pull::UP.angle, 1.0)]
}

fn run(args: &[&str]) -> (Option<i32>, Value, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_peel")).args(args).output().unwrap();
    let summary = serde_json::from_slice(&output.stdout).unwrap_or_default();
    (output.status.code(), summary, String::from_utf8_lossy(&output.stderr).into_owned())
}

#[test]
fn the_command_tells_every_step() {
    let steps = "drive.steps=[\"press 0.02 nm\", \"drag 0.2 nm\", \"turn 2 deg\", \"hold\"]";
    let more = ["--set", "grip.rotation=fixed", "--set", "grip.horizontal=fixed", "--set", steps];
    let folder = std::env::temp_dir().join(format!("peelkit-steps-{}", std::process::id()));
    let (code, summary, told) = run(&[&["run", SCENE, "--json"], &more[..]].concat());
    assert_eq!(code, Some(0), "{told}");
    let ends = summary["steps"].as_array().unwrap();
    let words: Vec<&str> = ends.iter().map(|end| end["step"].as_str().unwrap()).collect();
    assert_eq!(words, ["press 0.02 nm", "drag 0.2 nm", "turn 2 deg", "hold"]);
    let last = &ends[3];
    assert_near("y", last["y_nm"].as_f64().unwrap(), -0.02, 1e-15);
    assert_near("x", last["x_nm"].as_f64().unwrap(), 0.2, 1e-15);
    for key in ["horizontal_force_nN", "vertical_force_nN", "moment_nN_nm", "end_rotation_rad"] {
        assert!(last[key].is_f64(), "{key} of {last}");
    }
    assert_eq!(summary["parameters"]["drive"]["steps"][2], "turn 2 deg");
    let output = Command::new(env!("CARGO_BIN_EXE_peel"))
        .args(["run", SCENE, "--out"])
        .arg(&folder)
        .args(more)
        .output()
        .unwrap();
    std::fs::remove_dir_all(folder).unwrap();
    let told = String::from_utf8_lossy(&output.stdout);
    assert!(
        told.contains("steps              press 0.02 nm: x = 0.0000 nm, y = -0.0200 nm, θ = 0.0000 deg; H = "),
        "{told}"
    );
    assert!(told.contains("hold: x = 0.2000 nm, y = -0.0200 nm, θ = 2.0000 deg"), "{told}");
}

#[test]
fn what_does_not_fit_is_refused_by_name() {
    let fixed = "grip.rotation=fixed";
    for (sets, command, parts) in [
        (vec!["drive.turn=1 deg/nm"], vec!["run"], vec!["`drive.turn`", "`grip.rotation` is \"free\""]),
        (vec!["drive.steps=[\"turn 1 deg\"]"], vec!["run"], vec!["`drive.steps`", "\"turn 1 deg\"", "`grip.rotation`"]),
        (
            vec![fixed, "drive.turn=1 deg/nm", "adhesion.line_load=force-only"],
            vec!["run"],
            vec!["`drive.turn`", "without a potential"],
        ),
        (vec![fixed, "drive.turn=1 deg/nm"], vec!["run", "--observed"], vec!["drive.turn", "Omit --observed"]),
        (vec!["drive.steps=[\"lift 1 nm\"]"], vec!["run", "--observed"], vec!["drive.steps", "Omit --observed"]),
        (
            vec!["drive.steps=[\"lift 1 nm\"]"],
            vec!["sweep", "--vary", "strip.height", "--from", "9 nm", "--to", "10 nm", "--points", "2", "--peak-only"],
            vec!["drive.steps", "--peak-only"],
        ),
    ] {
        let sets = sets.iter().flat_map(|set| ["--set", set]);
        let args: Vec<&str> =
            [command[0], SCENE, "--json"].into_iter().chain(sets).chain(command[1..].to_vec()).collect();
        refuses(&[], &args, &parts);
    }
    let turning = &turning()[2];
    assert_eq!(observed(turning, &Accuracy::to(1e-6), &BOUNDS).err(), Some(NoTest::Turn));
}

/// The peak followed in the turn is that of whole peels.
#[test]
fn the_peak_is_followed_in_the_turn() {
    let sweep = |more: &[&str]| {
        let vary = ["--vary", "drive.turn", "--from", "-1 deg/nm", "--to", "1 deg/nm", "--points", "5", "--json"];
        let (code, summary, told) = run(&[&["sweep", SCENE, "--set", "grip.rotation=fixed"], &vary[..], more].concat());
        assert_eq!(code, Some(0), "{told}");
        summary["rows"].as_array().unwrap().clone()
    };
    for (followed, whole) in sweep(&["--peak-only"]).iter().zip(&sweep(&[])) {
        for column in ["initiation_peak_nN", "value"] {
            let [a, b] = [followed, whole].map(|row| row[column].as_f64().unwrap());
            assert!((a - b).abs() <= 1e-6 * a.abs(), "at {} rad/nm: {a} and {b}", followed["value"]);
        }
    }
}

/// The columns `step`, `displacement_nm` and `force_nN` of steps.csv.
fn way(dir: &Path) -> Vec<(usize, f64, f64)> {
    let mut table = csv::Reader::from_path(dir.join("steps.csv")).unwrap();
    let place = |name: &str, header: &csv::StringRecord| header.iter().position(|own| own == name).unwrap();
    let header = table.headers().unwrap().clone();
    let [step, displacement, force] = ["step", "displacement_nm", "force_nN"].map(|name| place(name, &header));
    let row = |row: csv::StringRecord| {
        (row[step].parse().unwrap(), row[displacement].parse().unwrap(), row[force].parse().unwrap())
    };
    table.records().map(|found| row(found.unwrap())).collect()
}

/// Of the strip of the scene, nm.
const SNAP_OFF: f64 = 48.2156;

/// A lift passes the equilibria of the pull from rest: each row of steps.csv lies on its curve, to 1e-6 of the peak, and so do those of a step that
/// jumps at the snap-off, up to there.
#[test]
fn the_way_of_a_lift_is_the_curve_from_rest() {
    let curve = |u: f64| {
        let (code, summary, told) = run(&["run", SCENE, "--json", "--at", &format!("u={u} nm")]);
        assert_eq!(code, Some(0), "{told}");
        summary["stations"][0]["found"][0]["force_nN"].as_f64().unwrap()
    };
    let dir = tempfile::tempdir().unwrap();
    for (lift, end, jumps) in [("30 nm", 30.0, 0), ("60 nm", 60.0, 1)] {
        let folder = dir.path().join(lift);
        let output = Command::new(env!("CARGO_BIN_EXE_peel"))
            .args(["run", SCENE, "--set", &format!("drive.steps=[\"lift {lift}\"]"), "--out"])
            .arg(&folder)
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        let way = way(&folder);
        assert!(way[0].1 == 0.0 && way[way.len() - 1].1 >= end && way.len() > 10, "{way:?}");
        let summary = std::fs::read_to_string(folder.join("summary.json")).unwrap();
        let summary: Value = serde_json::from_str(&summary).unwrap();
        let found = summary["steps"][0]["jumps"].as_array().map_or(&[][..], Vec::as_slice);
        assert_eq!(found.len(), jumps);
        let told = String::from_utf8_lossy(&output.stdout);
        assert_eq!(told.contains("it jumps at y = 48.2156 nm"), jumps == 1, "{told}");
        for &(step, u, force) in way.iter().skip(1).step_by(4).take_while(|row| row.1 < SNAP_OFF) {
            assert_eq!(step, 1);
            assert_near(&format!("force at {u} nm"), force, curve(u), 1e-6 * 0.341);
        }
        assert!(folder.join("steps.png").exists());
    }
}

/// An arm that does not heal comes back along a straight line to nothing, and its pull goes up that line again.
#[test]
fn the_way_back_of_an_arm_that_does_not_heal_is_straight() {
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/double-cantilever.toml");
    let dir = tempfile::tempdir().unwrap();
    let steps = "drive.steps=[\"lift 3 mm\", \"press 1.5 mm\"]";
    let output = Command::new(env!("CARGO_BIN_EXE_peel"))
        .args(["run", scene, "--set", "adhesion.healing=false", "--set", steps, "--out"])
        .arg(dir.path())
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let back: Vec<_> = way(dir.path()).into_iter().filter(|row| row.0 == 2).collect();
    let compliance = |&(_, u, force): &(usize, f64, f64)| u / force;
    let first = compliance(&back[0]);
    assert!(back.len() >= 3 && back.iter().all(|row| (compliance(row) / first - 1.0).abs() < 3e-3), "{back:?}");
}
