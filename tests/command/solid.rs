//! `peel run` and its kin of a strip that is computed as a solid.
//!
//! Reference: the beam of the same strip, and two families of meshes of an independent program (`verification/solid.csv`): 0.325137 nN at the first
//! peak in a rigid grip. Parameters: `scenes/solid-strip.toml`, on the mesh that it names.
//!
//! Expected: the first peak is within its bound of that; what a beam alone has is refused; a fit, an optimum and a sample compute whole paths. Why: a
//! first peak depends on its grip by a fifth, so that another solid would pass for this one.

use crate::peel::{is_refused, json, run};
use serde_json::Value;

const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/solid-strip.toml");
const SPATULA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/solid-spatula.toml");
const COARSE: [&str; 6] =
    ["--set", "solid.along=4 nm", "--set", "solid.through=1", "--set", "bounds.displacement=0.6 nm"];

fn printed(arguments: &[&str]) -> Value {
    json(tempfile::tempdir().unwrap().path(), arguments)
}

#[test]
fn the_first_peak_is_within_its_bound() {
    let near = ["run", SCENE, "--set", "adhesion.far_face=false", "--set", "bounds.displacement=0.6 nm"];
    let found = printed(&[&near[..], &["--at", "u=0.2 nm"]].concat());
    let [force, error] = ["force_nN", "error_nN"].map(|key| found["initiation_peak"][key].as_f64().unwrap());
    assert!((force - 0.325137).abs() < error && error < 0.02 * force, "{force} ± {error}");
    let station = &found["stations"][0];
    assert!((station["displacement_nm"].as_f64().unwrap() / 0.2 - 1.0).abs() < 1e-11, "{station}");
    assert_eq!((found["end"].as_str(), found["mesh"]["element"].as_str()), (Some("bound"), Some("Q1CH")));
}

#[test]
fn what_a_beam_alone_has_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    for option in ["--observed", "--out-of-plane", "--branch", "--sensitivities", "--animate"] {
        is_refused(folder.path(), &["run", SCENE, option], &["has no meaning for a solid", "remove [solid]"]);
    }
    is_refused(
        folder.path(),
        &["run", SCENE, "--at", "t=1 us"],
        &["has no `time` to look for", "Give values of `displacement`, `force`"],
    );
    let vary = ["sweep", SCENE, "--vary", "strip.height", "--values", "9 nm, 10 nm"];
    is_refused(folder.path(), &[&vary[..], &["--peak-only"]].concat(), &["have no meaning for a solid"]);
    is_refused(folder.path(), &["coarsen", SCENE], &["[solid] is a table of a body that is computed as a solid"]);
}

/// A station and an event of the coarse strip: in stations.csv, in print, and an event that stops is the end, which is no failure.
#[test]
fn stations_and_events_are_written_and_stop_a_run() {
    let folder = tempfile::tempdir().unwrap();
    let asked = ["--out", "out", "--at", "P=0.1 nN", "--event", "P > 0.2 nN", "--stop-at", "near: u > 0.3 nm"];
    let (status, text, trouble) = run(folder.path(), &[&["run", SCENE], &COARSE[..], &asked[..]].concat());
    assert_eq!((status, trouble.as_str()), (Some(0), ""), "{text}");
    assert!(text.contains("end                event") && text.contains("P > 0.2 nN: u = "), "{text}");
    let table = std::fs::read_to_string(folder.path().join("out/stations.csv")).unwrap();
    let names: Vec<&str> = table.lines().skip(1).map(|line| line.split(',').next().unwrap()).collect();
    assert_eq!(names, ["", "P > 0.2 nN", "near"], "{table}");
    let curve = std::fs::read_to_string(folder.path().join("out/curve.csv")).unwrap();
    let last: f64 = curve.lines().last().unwrap().split(',').next().unwrap().parse().unwrap();
    assert!((last / 0.3 - 1.0).abs() < 1e-11, "{last}");
}

/// A small spatula: the curve to its first peak, pictures and states of its plane of symmetry, and what a strip alone has is refused.
#[test]
fn a_spatula_is_pulled_as_a_solid() {
    let folder = tempfile::tempdir().unwrap();
    let small = [
        "spatula.pad_length=60 nm",
        "spatula.neck_length=40 nm",
        "spatula.bend_length=20 nm",
        "spatula.shaft_length=60 nm",
        "spatula.tip_width=40 nm",
        "spatula.neck_width=20 nm",
        "spatula.shaft_diameter=20 nm",
        "solid.along=4 nm",
        "solid.across=1",
        "bounds.displacement=3 nm",
    ];
    let small: Vec<&str> = small.iter().flat_map(|set| ["--set", set]).collect();
    let asked = ["--out", "out", "--states", "2", "--at", "u=2 nm"];
    let (status, text, trouble) = run(folder.path(), &[&["run", SPATULA], &small[..], &asked[..]].concat());
    assert_eq!((status, trouble.as_str()), (Some(0), ""), "{text}");
    assert!(text.contains("elements H1(2)"), "{text}");
    for file in ["curve.csv", "curve.svg", "solid.svg", "stations.csv", "states/solid-000.vtu"] {
        assert!(folder.path().join("out").join(file).is_file(), "{file}");
    }
    is_refused(folder.path(), &["run", SPATULA, "--set", "solid.through=2"], &["a key of [solid] for a strip"]);
}

#[test]
fn long_elements_are_warned_of_with_both_lengths() {
    let found = printed(&[&["run", SCENE], &COARSE[..]].concat());
    let warning = found["warnings"][0].as_str().unwrap();
    assert!(warning.contains("4.000 nm long and the process zone 2."), "{warning}");
}

#[test]
fn a_sample_computes_whole_paths() {
    let inputs = "uncertainty.inputs=[{ key = \"strip.height\", distribution = \"lognormal\", log_deviation = 0.01 }]";
    let few = [
        "--set",
        inputs,
        "--set",
        "uncertainty.samples=40",
        "--set",
        "uncertainty.indices=false",
        "--set",
        "strip.length=40 nm",
    ];
    let found = printed(&[&["uncertainty", SCENE, "--set", "path.until=first-jump"], &COARSE[..4], &few].concat());
    assert!(found.to_string().contains("peak.force_nN"), "{found}");
}

#[test]
fn states_are_written_for_paraview() {
    let folder = tempfile::tempdir().unwrap();
    let (status, _, trouble) =
        run(folder.path(), &[&["run", SCENE, "--states", "2", "--out", "out"], &COARSE[..]].concat());
    assert_eq!(status, Some(0), "{trouble}");
    let list = std::fs::read_to_string(folder.path().join("out/solid.pvd")).unwrap();
    assert_eq!(list.matches("states/solid-").count(), 3);
    let state = std::fs::read_to_string(folder.path().join("out/states/solid-001.vtu")).unwrap();
    // 25 columns in three parts each, one row
    assert!(state.contains("NumberOfPoints=\"152\" NumberOfCells=\"75\"") && state.contains("stress_yy_GPa"));
}
