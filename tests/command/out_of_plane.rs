//! `peel run --out-of-plane`.
//!
//! Reference: verification/out_of_plane.csv, shooting. Expected: the first line of the summary, the object of
//! summary.json, the column of curve.csv and the mark of the picture say one thing; a scene for which it is not
//! computed is refused before anything is. Why: the user is to read it first.

use serde_json::Value;
use std::process::Command;

fn run(dir: &std::path::Path, more: &[&str]) -> (Option<i32>, String, String) {
    let scene = format!("{}/../../scenes/strip-100nm.toml", env!("CARGO_MANIFEST_DIR"));
    let output = Command::new(env!("CARGO_BIN_EXE_peel")).current_dir(dir).args(["run", &scene]).args(more).output();
    let output = output.unwrap();
    (output.status.code(), String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap())
}

#[test]
fn the_command_says_where_the_path_leaves_the_plane() {
    let dir = tempfile::tempdir().unwrap();
    let (status, text, trouble) = run(dir.path(), &["--out-of-plane"]);
    assert_eq!(status, Some(0), "{trouble}");
    let first = text.lines().nth(2).unwrap();
    assert!(first.contains("out of the plane") && first.contains("stable up to u = 0.48974387"), "{first}");
    let folder = dir.path().join("out/strip-100nm-out-of-plane");
    let read = |file: &str| std::fs::read_to_string(folder.join(file)).unwrap();
    let summary: Value = serde_json::from_str(&read("summary.json")).unwrap();
    let found = &summary["out_of_plane"];
    let number = |key: &str| found["first_loss"][key].as_f64().unwrap();
    assert!((number("displacement_nm") - 0.489743875867).abs() <= number("error_nm"));
    assert!((number("force_nN") - 0.312661701292).abs() <= number("error_nN"));
    assert_eq!((&found["first_loss"]["at_start"], &found["most_negative_eigenvalues"]), (&false.into(), &19.into()));
    let table = read("curve.csv");
    let column = table.lines().map(|line| line.rsplit(',').next().unwrap());
    let counts: Vec<usize> = column.skip(1).map(|cell| cell.parse().unwrap()).collect();
    assert_eq!((counts[0], counts.iter().max()), (0, Some(&19)));
    let unstable = counts.iter().filter(|&&count| count > 0).count();
    assert_eq!(found["unstable_points"], unstable);
    assert!(read("curve.svg").contains("leaves the plane"));
}

#[test]
fn a_path_that_stays_in_its_plane_is_null() {
    let dir = tempfile::tempdir().unwrap();
    let (status, text, trouble) = run(dir.path(), &["--out-of-plane", "--json", "--set", "strip.width=10 nm"]);
    assert_eq!(status, Some(0), "{trouble}");
    let summary: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(summary["out_of_plane"]["first_loss"], Value::Null);
    assert_eq!(summary["out_of_plane"]["unstable_points"], 0);
    let (_, text, _) = run(dir.path(), &["--json"]);
    assert!(serde_json::from_str::<Value>(&text).unwrap().get("out_of_plane").is_none());
}

#[test]
fn scenes_that_it_does_not_cover_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    for (key, why) in [
        ("drive.angle=60 deg", "drive.angle is 60 degrees"),
        ("grip.rotation=fixed", "grip.rotation is \"fixed\""),
        ("grip.horizontal=fixed", "grip.horizontal is \"fixed\""),
        ("adhesion.line_load=force-only", "the load has no potential"),
    ] {
        let (status, _, trouble) = run(dir.path(), &["--out-of-plane", "--set", key]);
        assert_eq!(status, Some(2));
        let plain = trouble.replace("\n", " ").replace("│", " ").split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(plain.contains(why) && plain.contains("Omit --out-of-plane"), "{trouble}");
    }
    assert!(!dir.path().join("out").exists());
}
