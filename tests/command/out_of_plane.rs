//! `peel run --out-of-plane` and `--branch`.
//!
//! Reference: verification/out_of_plane.csv, shooting. Expected: the first line of the summary, the object of
//! summary.json, the column of curve.csv and the mark of the picture say one thing; a scene for which it is not
//! computed is refused before anything is. Why: the user is to read it first.

use crate::peel;
use serde_json::Value;

fn run(dir: &std::path::Path, more: &[&str]) -> (Option<i32>, String, String) {
    peel::run(dir, &[&["run", &peel::scene("strip-100nm")], more].concat())
}

#[track_caller]
fn refuses(more: &[&str], parts: &[&str]) {
    peel::refuses(&[], &[&["run", &peel::scene("strip-100nm")], more].concat(), parts);
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
    for (key, why) in [
        ("grip.rotation=fixed", "grip.rotation is \"fixed\""),
        ("adhesion.line_load=force-only", "the load has no potential"),
    ] {
        refuses(&["--out-of-plane", "--set", key], &[why, "Omit --out-of-plane"]);
    }
}

/// Reference of its peak and its first jump: verification/out_of_plane_branch.csv, collocation in space.
#[test]
fn the_command_follows_the_branch() {
    let dir = tempfile::tempdir().unwrap();
    let (status, text, trouble) = run(dir.path(), &["--branch", "--set", "strip.width=40 nm"]);
    assert_eq!(status, Some(0), "{trouble}");
    let lines: Vec<&str> = text.lines().skip(2).take(5).map(str::trim).collect();
    let begins =
        ["out of the plane", "branch", "peak force: P = 13.1740", "snap-off: P = 1.50532", "end at u = 24.60659"];
    for (line, begin) in lines.iter().zip(begins) {
        assert!(line.starts_with(begin), "{line}");
    }
    assert!(lines[1].contains("to larger u, stable under displacement control"), "{}", lines[1]);
    assert!(lines[4].contains("back-in-plane: the strip has come back into its plane"), "{}", lines[4]);
    let folder = dir.path().join("out/strip-100nm-branch-strip.width-40nm");
    let read = |file: &str| std::fs::read_to_string(folder.join(file)).unwrap();
    let summary: Value = serde_json::from_str(&read("summary.json")).unwrap();
    let branch = &summary["out_of_plane"]["branch"];
    for (key, displacement, force) in
        [("peak", 0.222109755583, 13.17406487898), ("first_jump", 48.12007965384, 1.505321719858)]
    {
        let number = |name: &str| branch[key][name].as_f64().unwrap();
        assert!((number("displacement_nm") - displacement).abs() <= number("error_nm"), "{key}");
        assert!((number("force_nN") - force).abs() <= number("error_nN"), "{key}");
    }
    let first = &summary["out_of_plane"]["first_loss"];
    assert_eq!(
        (&branch["start"]["displacement_nm"], &branch["end"]),
        (&first["displacement_nm"], &"back-in-plane".into())
    );
    assert_eq!(branch["start"]["negative_eigenvalues"], 0);
    assert!((branch["rejoins"]["displacement_nm"].as_f64().unwrap() - 24.606596597).abs() < 1e-6);
    let table = read("branch.csv");
    assert!(table.starts_with("displacement_nm,force_nN,end_rotation_rad,work_aJ,negative_eigenvalues,"));
    assert!(
        table.lines().next().unwrap().ends_with("torque_nN_nm,roll_deg,yaw_deg,reaction_across_nN,reaction_lateral_nN")
    );
    assert_eq!(table.lines().count() - 1, branch["points"].as_u64().unwrap() as usize);
    let picture = read("curve.svg");
    assert!(picture.contains("branch out of the plane") && picture.to_uppercase().contains("#009E73"));
}

#[test]
fn a_branch_that_there_is_not_is_null() {
    let dir = tempfile::tempdir().unwrap();
    let (status, text, trouble) = run(dir.path(), &["--branch", "--json", "--set", "strip.width=10 nm"]);
    assert_eq!(status, Some(0), "{trouble}");
    let summary: Value = serde_json::from_str(&text).unwrap();
    let out_of_plane = summary["out_of_plane"].as_object().unwrap();
    assert_eq!((out_of_plane.get("branch"), &out_of_plane["first_loss"]), (Some(&Value::Null), &Value::Null));
}

#[test]
fn a_branch_that_is_not_computed_is_refused() {
    let held = "the branch out of the plane is not followed: grip.rotation is \"fixed\"";
    refuses(&["--branch", "--set", "grip.rotation=fixed"], &[held, "Omit --branch"]);
    let dir = tempfile::tempdir().unwrap();
    // a strip that falls over at rest: its path is written, and has no branch
    let (status, _, trouble) = run(dir.path(), &["--branch", "--set", "strip.width=0.15 nm"]);
    assert_eq!(status, Some(3));
    assert!(peel::plain(&trouble).contains("unstable out of the plane from its beginning on"), "{trouble}");
    assert!(dir.path().join("out/strip-100nm-branch-strip.width-0.15nm/summary.json").exists());
    assert!(!dir.path().join("out/strip-100nm-branch-strip.width-0.15nm/branch.csv").exists());
}
