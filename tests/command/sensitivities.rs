//! `peel run --sensitivities`.
//!
//! Reference: dimensional analysis, P ~ E^a A_H^(1-a); the width multiplies every force. Expected: terminal, summary.json and picture say one
//! thing, largest first; a scene that has none is refused before anything is computed.

use crate::peel;
use serde_json::Value;

fn run(dir: &std::path::Path, scene: &str, more: &[&str]) -> (Option<i32>, String, String) {
    peel::run(dir, &[&["run", &peel::scene(scene), "--sensitivities"], more].concat())
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
    let summary = peel::json(dir.path(), &["run", "beam.toml", "--sensitivities"]);
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
    let auto: &[&str] = &["--set", "terms=auto"];
    for (scene, more, why) in [("strip-friction", &[][..], "with friction"), ("strip-100nm", auto, "terms = \"auto\"")]
    {
        let scene = peel::scene(scene);
        peel::refuses(&[], &[&["run", &scene, "--sensitivities"], more].concat(), &[why, "Omit --sensitivities"]);
    }
}
