//! `peel run --sensitivities`.
//!
//! Reference: dimensional analysis, P ~ E^a A_H^(1-a); the width multiplies every force. Expected: terminal, summary.json and picture say one
//! thing, largest first; a scene that has none is refused before anything is computed.

use serde_json::Value;
use std::process::Command;

fn run(dir: &std::path::Path, scene: &str, more: &[&str]) -> (Option<i32>, String, String) {
    let scene = format!("{}/../../scenes/{scene}.toml", env!("CARGO_MANIFEST_DIR"));
    let output = Command::new(env!("CARGO_BIN_EXE_peel"))
        .current_dir(dir)
        .args(["run", &scene, "--sensitivities"])
        .args(more)
        .output()
        .unwrap();
    (output.status.code(), String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap())
}

#[test]
fn the_command_says_which_parameter_matters() {
    let dir = tempfile::tempdir().unwrap();
    let (status, text, trouble) = run(dir.path(), "strip-100nm", &[]);
    assert_eq!(status, Some(0), "{trouble}");
    let lines: Vec<&str> =
        text.lines().skip_while(|line| !line.contains("initiation_peak.force_nN, peak.force_nN")).collect();
    assert!(lines[1].trim().starts_with("adhesion.equilibrium_distance   -1.6436"), "{}", lines[1]);
    assert!(lines[2].trim().starts_with("strip.width                     +1.0000"), "{}", lines[2]);
    let folder = dir.path().join("out/strip-100nm-sensitivities");
    let summary: Value = serde_json::from_slice(&std::fs::read(folder.join("summary.json")).unwrap()).unwrap();
    let rows = summary["sensitivities"].as_array().unwrap();
    let of = |name: &str| rows.iter().filter(|row| row["of"] == name).collect::<Vec<_>>();
    let peak = of("initiation_peak.force_nN");
    let number = |row: &Value, key: &str| row[key].as_f64().unwrap();
    let by = |key: &str| peak.iter().find(|row| row["key"] == key).map(|row| number(row, "d_ln_d_ln")).unwrap();
    assert!((by("strip.youngs_modulus") + by("adhesion.hamaker_constant") - 1.0).abs() < 1e-6);
    assert!(peak.windows(2).all(|pair| number(pair[0], "d_ln_d_ln").abs() >= number(pair[1], "d_ln_d_ln").abs()));
    assert!(rows.iter().all(|row| number(row, "error") < 1e-5));
    let picture = std::fs::read_to_string(folder.join("sensitivities.svg")).unwrap();
    assert!(picture.contains("strip.youngs_modulus") && folder.join("sensitivities.png").exists());
}

#[test]
fn the_cells_of_a_table_are_parameters() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("beam.csv"), "s_nm,width_nm,height_nm\n0,1,8\n20,1.3,10\n50,1,12\n").unwrap();
    let scene = "[profile]\ntable = \"beam.csv\"\nyoungs_modulus = \"2 GPa\"\n[adhesion]\nhamaker_constant = \"1e-19 J\"\n\
                 equilibrium_distance = \"0.4 nm\"\n[accuracy]\nrelative = 1e-4\n";
    std::fs::write(dir.path().join("beam.toml"), scene).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_peel"))
        .current_dir(dir.path())
        .args(["run", "beam.toml", "--sensitivities", "--json"])
        .output()
        .unwrap();
    let summary: Value = serde_json::from_slice(&output.stdout).unwrap();
    let rows = summary["sensitivities"].as_array().unwrap();
    let widths = rows.iter().filter(|row| {
        row["of"] == "initiation_peak.force_nN" && row["key"].as_str().unwrap().starts_with("profile.table.width_nm")
    });
    // all widths together multiply the force
    let (count, sum) = widths.fold((0, 0.0), |(count, sum), row| (count + 1, sum + row["d_ln_d_ln"].as_f64().unwrap()));
    assert!(count == 3 && f64::abs(sum - 1.0) < 1e-3, "{count}: {sum}");
}

#[test]
fn scenes_without_them_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    let auto: &[&str] = &["--set", "terms=auto"];
    for (scene, more, why) in [("strip-friction", &[][..], "with friction"), ("strip-100nm", auto, "terms = \"auto\"")]
    {
        let (status, _, trouble) = run(dir.path(), scene, more);
        let plain = trouble.replace(['\n', '│'], " ").split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(status, Some(2), "{trouble}");
        assert!(plain.contains(why) && plain.contains("Omit --sensitivities"), "{plain}");
    }
    assert!(!dir.path().join("out").exists());
}
