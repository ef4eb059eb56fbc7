//! `peel run --observed`.

use serde_json::Value;
use std::process::Command;

#[track_caller]
fn assert_close(what: &str, found: f64, expected: f64, relative: f64) {
    let off = (found / expected - 1.0).abs();
    assert!(off <= relative, "{what}: {found} is {off:.1e} from {expected}");
}

#[test]
fn the_command_writes_what_a_test_would_record() {
    let dir = tempfile::tempdir().unwrap();
    let scene = format!("{}/../../scenes/strip-100nm.toml", env!("CARGO_MANIFEST_DIR"));
    let run = |more: &[&str]| {
        let output =
            Command::new(env!("CARGO_BIN_EXE_peel")).current_dir(dir.path()).args(["run", &scene]).args(more).output();
        let output = output.unwrap();
        (output.status.code(), String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap())
    };
    let grip = ["--set", "grip.rotation=fixed", "--set", "grip.stiffness=50 mN/m"];
    let (status, plain, _) = run(&[&grip[..], &["--json", "--out", "plain"]].concat());
    assert_eq!(status, Some(0));
    let plain: Value = serde_json::from_str(&plain).unwrap();
    assert!(plain.get("observed").is_none() && !dir.path().join("plain/observed.csv").exists());
    assert_eq!(plain["parameters"]["grip"]["stiffness_N_per_m"], 0.05);

    let (status, text, trouble) = run(&[&grip[..], &["--observed", "--out", "test"]].concat());
    assert_eq!(status, Some(0), "{trouble}");
    assert!(text.contains("Displacement-controlled test") && text.contains("jump into contact"), "{text}");
    let summary = std::fs::read_to_string(dir.path().join("test/summary.json")).unwrap();
    let summary: Value = serde_json::from_str(&summary).unwrap();
    // the path is that of the strip without its spring
    assert_eq!(summary["limit_points"], plain["limit_points"]);
    let test = &summary["observed"];
    assert_eq!(test["end"], "closed");
    assert_eq!(test["pull_off_adheres"], "pad");
    let jumps = test["jumps"].as_array().unwrap();
    let released: f64 = jumps.iter().map(|jump| jump["released_aJ"].as_f64().unwrap()).sum();
    assert_close("hysteresis", test["hysteresis_aJ"].as_f64().unwrap(), released, 1e-6);
    assert_eq!(jumps.last().unwrap()["kind"], "jump into contact");
    assert!(jumps.iter().any(|jump| jump["landed"] == "detached"));
    assert!(test["work_balance"]["cycle"]["relative_error"].as_f64().unwrap() <= 1e-6);
    let table = std::fs::read_to_string(dir.path().join("test/observed.csv")).unwrap();
    assert_eq!(
        table.lines().next().unwrap(),
        "branch,machine_displacement_nm,displacement_nm,force_nN,work_aJ,front_nm,jump,adheres"
    );
    assert_eq!(table.matches("true").count(), jumps.len());
    assert!(table.contains("retreat,") && table.contains("approach,"));
    for picture in ["observed.svg", "observed.png"] {
        assert!(dir.path().join("test").join(picture).metadata().unwrap().len() > 10_000);
    }

    let (status, _, trouble) = run(&["--set", "adhesion.line_load=force-only", "--observed"]);
    assert_eq!(status, Some(2));
    assert!(trouble.contains("no potential"), "{trouble}");
}
