//! `peel optimise`.
//!
//!     scene --> optimum.toml --> peel run: the objective of the optimum
//!
//! Reference: `peel run` of the scene that the command writes. Parameters: the strip of 100 nm, whose EI is free; five
//! widths of a strip 10 nm wide. Expected: terminal, summary.json, history.csv and optimum.toml say one thing; what cannot be optimised is refused before
//! anything is computed, with the key and what would be right. How a search that was interrupted goes on is tested in `resume.rs`.
//! Why: what is optimised is built.

use crate::peel::refuses;
use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output};

const SCENE: &str = "[strip]\nlength = \"100 nm\"\nheight = \"10 nm\"\nwidth = \"10 nm\"\nyoungs_modulus = \"2 GPa\"\n\
                     [adhesion]\nhamaker_constant = \"1e-19 J\"\nequilibrium_distance = \"0.4 nm\"\n[optimise]\n";
const STIFFNESS: &str = "objective = \"first_jump.work_aJ\"\nstarts = 1\nneighbours = 4\n\
                         parameters = [{ key = \"strip.bending_stiffness_factor\", from = 0.01, to = 100 }]\n";
const WIDTH: &str = "objective = \"initiation_peak.force_nN\"\nwidth = { from = \"5 nm\", to = \"20 nm\", slope = 0.2 }\n\
                     values = 5\nneighbours = 4\n";

fn peel(dir: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_peel")).current_dir(dir).args(arguments).output().unwrap()
}

fn with_scene(table: &str) -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("a.toml"), SCENE.to_owned() + table).unwrap();
    dir
}

fn json(text: &[u8]) -> Value {
    serde_json::from_slice(text).unwrap()
}

/// The object of the finished command in `out`.
#[track_caller]
fn finished(dir: &Path, more: &[&str]) -> Value {
    let output = peel(dir, &[&["optimise", "a.toml", "--out", "out"], more].concat());
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(!dir.join("out/optimise.partial").exists(), "a finished command leaves nothing behind");
    for file in ["history.csv", "optimum.toml", "parameters.toml", "optimum.svg", "optimum.png"] {
        assert!(dir.join("out").join(file).exists(), "{file}");
    }
    json(&std::fs::read(dir.join("out/summary.json")).unwrap())
}

#[test]
fn the_best_stiffness_is_written_as_a_scene() {
    let dir = with_scene(STIFFNESS);
    let summary = finished(dir.path(), &["--set", "optimise.check=true"]);
    let best = summary["variables"][0]["after"].as_f64().unwrap();
    assert!((best - 0.6745).abs() < 1e-3, "{best}");
    assert_eq!(summary["certificate"]["neighbours"]["better"], 0);
    assert!(summary["certificate"]["check"]["gain"].as_f64().unwrap() < 1e-6);
    let run = json(&peel(dir.path(), &["run", "out/optimum.toml", "--json"]).stdout);
    assert_eq!(run["first_jump"]["work_aJ"], summary["after"]["objective"]);
    let history = std::fs::read_to_string(dir.path().join("out/history.csv")).unwrap();
    let designs: u64 =
        summary["searches"].as_array().unwrap().iter().map(|of| of["evaluations"].as_u64().unwrap()).sum();
    assert_eq!(history.lines().count() as u64, 1 + designs);
}

#[test]
fn the_best_width_is_a_table() {
    let dir = with_scene(WIDTH);
    let output = peel(dir.path(), &["optimise", "a.toml", "--out", "out", "--set", "accuracy.relative=1e-4"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("largest initiation_peak.force_nN") && text.contains("volume"), "{text}");
    let summary = json(&std::fs::read(dir.path().join("out/summary.json")).unwrap());
    assert!(summary["gain"].as_f64().unwrap() > 1.3);
    let volume = |design: &str| summary[design]["volume_nm3"].as_f64().unwrap();
    assert!((volume("after") / volume("before") - 1.0).abs() < 1e-7);
    let run = json(&peel(dir.path(), &["run", "out/optimum.toml", "--json"]).stdout);
    let force = run["initiation_peak"]["force_nN"].as_f64().unwrap();
    assert!((force / summary["after"]["objective"].as_f64().unwrap() - 1.0).abs() < 1e-12, "{force}");
    let picture = std::fs::read_to_string(dir.path().join("out/optimum.svg")).unwrap();
    assert!(["before", "after", "width (nm)"].iter().all(|word| picture.contains(word)));
}

#[test]
fn what_cannot_be_optimised_is_refused() {
    const OBJECTIVE: &str = "objective = \"initiation_peak.force_nN\"\n";
    let free = |key: &str, from: &str, to: &str| {
        format!("{OBJECTIVE}parameters = [{{ key = \"{key}\", from = {from}, to = {to} }}]\n")
    };
    let modulus = free("strip.youngs_modulus", "\"1 GPa\"", "\"4 GPa\"");
    for (table, message) in [
        ("parameters = []\n".to_owned(), "[optimise] lacks `objective`"),
        (OBJECTIVE.into(), "neither width nor height is free: nothing can be optimised"),
        ("objective = \"peak.force\"\n".into(), "did you mean \"peak.force_nN\"?"),
        (free("strip.hight", "\"1 nm\"", "\"2 nm\""), "Did you mean `strip.height`?"),
        (free("strip.height", "1", "2"), "a number without a unit"),
        (free("strip.height", "\"2 nm\"", "\"1 nm\""), "the lower bound is not below the upper one"),
        (free("strip.poissons_ratio", "0.1", "0.9"), "has in parameter 1 strip.poissons_ratio with a bound that"),
        (free("spatula.neck_width", "\"1 nm\"", "\"2 nm\""), "is a key of [spatula]"),
        (free("accuracy.relative", "1e-6", "1e-3"), "which is no number of the model"),
        (free("grip.stiffness", "\"1 N/m\"", "\"2 N/m\""), "which the scene does not set"),
        (format!("{modulus}holding_angle = \"30 deg\"\n"), "is given without release_angle"),
        (
            format!("{OBJECTIVE}width = {{ from = \"12 nm\", to = \"20 nm\" }}\n"),
            "which optimise.volume does not allow",
        ),
        (
            format!("{OBJECTIVE}width = {{ from = \"20 nm\", to = \"5 nm\" }}\n"),
            "the lower bound is not above zero and below",
        ),
        (format!("{WIDTH}method = \"quasi-newton\"\n"), "which knows bounds alone"),
        (format!("{WIDTH}volum = \"free\"\n"), "Did you mean `volume`?"),
        (format!("{WIDTH}goal = \"maximize\"\n"), "did you mean \"maximise\"?"),
    ] {
        // every command reads the table, whether it uses it or not
        for command in ["optimise", "run"] {
            refuses(&[("a.toml", &(SCENE.to_owned() + &table))], &[command, "a.toml"], &[message]);
        }
    }
    let missing = STIFFNESS.replace("first_jump", "detachment");
    for (table, message) in
        [("".into(), "lacks"), (missing, "the peel of the design at the start has no detachment.work_aJ")]
    {
        let dir = with_scene(&table);
        if table.is_empty() {
            std::fs::write(dir.path().join("a.toml"), SCENE.replace("[optimise]\n", "")).unwrap();
        }
        let output = peel(dir.path(), &["optimise", "a.toml"]);
        let text = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{text}");
        assert!(text.contains(message), "{text}");
    }
}
