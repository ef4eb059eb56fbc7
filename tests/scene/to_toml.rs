//! A scene that is written and read again is the same, to the last bit.

use peelkit_scene::Scene;
use std::fs;

#[track_caller]
fn same(name: &str, text: &str, overrides: &[(&str, &str)]) -> String {
    let overrides: Vec<_> = overrides.iter().map(|(key, value)| ((*key).to_owned(), (*value).to_owned())).collect();
    let scene = Scene::parse_any(name, text, &overrides).unwrap();
    let written = scene.to_toml();
    // beside no other file: tables stand in the text
    let again = Scene::parse_any("nowhere/parameters.toml", &written, &[]).unwrap();
    assert_eq!(Scene { name: scene.name.clone(), ..again }, scene, "{written}");
    written
}

#[test]
fn every_ready_scene_comes_back() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes");
    let mut count = 0;
    for folder in [folder.to_owned(), format!("{folder}/hard")] {
        for entry in fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_some_and(|extension| extension == "toml") {
                same(&path.display().to_string(), &fs::read_to_string(&path).unwrap(), &[]);
                count += 1;
            }
        }
    }
    assert!(count > 20, "{count}");
}

#[test]
fn what_was_set_comes_back_in_any_unit() {
    let text = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/strip-100nm.toml")).unwrap();
    let written = same(
        "strip.toml",
        &text,
        &[
            ("title", "a \"strip\"\nof two lines"),
            ("strip.length", "0.0712345678901234 um"),
            ("adhesion.hamaker_constant", "0.4 eV"),
            ("drive.angle", "37.3 deg"),
            ("grip.rotation", "fixed"),
            ("drive.turn", "0.3 deg/nm"),
            ("drive.steps", "[\"press 0.01 nm\", \"turn 5 deg\"]"),
            ("grip.stiffness", "20 mN/m"),
            ("accuracy.elements", "33"),
            ("accuracy.step", "1e-3"),
            ("terms", "auto"),
        ],
    );
    assert!(written.contains("elements = 33\n") && written.contains("terms = \"auto\"\n"), "{written}");
}

#[test]
fn tables_come_along() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("beam.csv"), "s_nm,width_nm,height_nm\n0,20,5\n40,20,5\n100,10,10\n").unwrap();
    fs::write(folder.path().join("ground.csv"), "x_nm,height_nm\n0,0\n50,-8\n100,0\n").unwrap();
    let text = "profile = { table = \"beam.csv\", youngs_modulus = \"2 GPa\" }\n\
                adhesion = { hamaker_constant = \"1e-19 J\", equilibrium_distance = \"0.4 nm\" }\n\
                substrate = { shape = \"profile\", table = \"ground.csv\" }\n";
    same(&folder.path().join("a.toml").display().to_string(), text, &[]);
}
