//! `peel run --observed`.

use crate::peel;
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
    let run = |more: &[&str]| peel::run(dir.path(), &[&["run", &peel::scene("strip-100nm")], more].concat());
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

    let no_potential = ["run", &peel::scene("strip-100nm"), "--set", "adhesion.line_load=force-only", "--observed"];
    peel::refuses(&[], &no_potential, &["no potential"]);
}

/// Runs the test of a strip of length, height (nm), Young's modulus (GPa), Hamaker constant (J), equilibrium distance (nm), pulled at so many degrees, at a
/// relative accuracy of 1e-6.
fn tested(name: &str, [length, height, modulus, hamaker, distance, angle]: [&str; 6]) -> (Option<i32>, Value) {
    let dir = tempfile::tempdir().unwrap();
    let scene = format!(
        "[strip]\nlength = \"{length} nm\"\nheight = \"{height} nm\"\nyoungs_modulus = \"{modulus} GPa\"\n[adhesion]\nhamaker_constant = \"{hamaker} J\"\n\
         equilibrium_distance = \"{distance} nm\"\n[drive]\nangle = \"{angle} deg\"\n"
    );
    let path = dir.path().join(format!("{name}.toml"));
    std::fs::write(&path, scene).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_peel"))
        .current_dir(dir.path())
        .args(["run", path.to_str().unwrap(), "--observed", "--json", "--out", "out"])
        .output()
        .unwrap();
    let summary: Value = serde_json::from_slice(&output.stdout).unwrap();
    (output.status.code(), summary["observed"].clone())
}

/// Steps of the quick pace went over to another branch behind a jump, on every mesh: "the limit point of the displacement after path point 10 was not located".
/// Watched on the same mesh the test comes back to where it began.
#[test]
fn a_test_that_loses_its_branch_is_watched() {
    let (status, test) = tested("lost", ["645.84", "13.56", "5.359", "1.915e-20", "0.269", "45.4"]);
    assert_eq!((status, &test["end"]), (Some(0), &Value::from("closed")), "{test}");
    assert!(test["work_balance"]["cycle"]["relative_error"].as_f64().unwrap() <= 1e-6, "{test}");
    assert!(test["accuracy_reached"].as_f64().unwrap() <= 1e-6, "{test}");
    assert_eq!(test["jumps"].as_array().unwrap().len(), 6, "{test}");
    assert!(test["jumps"].as_array().unwrap().iter().all(|jump| jump["warning"].is_null()), "{test}");
}

/// Soft strips that adhere strongly collapse onto their end faces: on each mesh in another state, so that the error of the jump was not determined. The first
/// of them is collapsed before anything else has happened, the second has jumped twice before.
#[test]
fn a_strip_that_collapses_has_a_named_end() {
    let cases = [
        ("end", ["1078.6", "14.92", "1.781", "2.833e-19", "0.261", "90.0"], 1049.792347, 0),
        ("later", ["231.75", "16.18", "0.2399", "1.340e-19", "0.385", "124.8"], 293.359468, 1),
        ("thick", ["57.221", "19.92", "0.3989", "4.260e-19", "0.342", "137.8"], 58.601144, 2),
    ];
    for (name, strip, collapses_at, jumps) in cases {
        let (status, test) = tested(name, strip);
        assert_eq!((status, &test["end"]), (Some(0), &Value::from("collapsed")), "{name}: {test}");
        let found = test["jumps"].as_array().unwrap();
        assert_eq!(found.len(), jumps, "{name}: {test}");
        assert!(found.iter().all(|jump| jump["machine_displacement_nm"].as_f64().unwrap() < collapses_at), "{test}");
        let reason = test["reason"].as_str().unwrap();
        assert!(
            reason.contains("collapses onto the substrate") && reason.contains(&format!("{collapses_at:.3}")),
            "{reason}"
        );
        assert!(test["accuracy_reached"].as_f64().unwrap() <= 1e-6, "{name}: {test}");
    }
}
