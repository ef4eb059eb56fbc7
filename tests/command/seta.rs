//! `peel run` of a scene with a seta.
//!
//! Reference: what the command writes in one file against what it writes in another: the last row of curve.csv, the events, summary.json.
//!
//! Expected: the pull-off of a small seta writes all of its files, its tips all detach and each stands in events.csv once; work is energy and
//! what was released; an option without a meaning is refused, every command that computes single beams refuses the scene with its line; a row of a sweep and a sample are what `peel run` gives. Why: a scene of a
//! seta that some command takes for that of one spatula would give a number that means something else.

use crate::peel::{refuses, run};
use serde_json::Value;
use std::fs;

/// Four tips on branches of 0.09 µm.
pub const SMALL: [&str; 12] = [
    "--set",
    "seta.forks=2",
    "--set",
    "seta.shaft_length=7 um",
    "--set",
    "seta.brush_height=3 um",
    "--set",
    "seta.shaft_diameter=240 nm",
    "--set",
    "seta.height_scatter=20 nm",
    "--set",
    "accuracy.relative=1e-6",
];

/// With which most of them are pulled off to their end.
const UPRIGHT: [&str; 2] = ["--set", "seta.shaft_angle=30 deg"];

fn scene() -> String {
    format!("{}/../../scenes/seta.toml", env!("CARGO_MANIFEST_DIR"))
}

#[test]
fn a_small_seta_is_pulled_off_and_written() {
    let dir = tempfile::tempdir().unwrap();
    let scene = scene();
    let arguments = [&["run", &scene, "--out", "out", "--states", "3", "--animate"], &SMALL[..]].concat();
    let (status, text, trouble) = run(dir.path(), &arguments);
    assert_eq!(status, Some(0), "{trouble}");
    assert!(text.contains("4 tips") && text.contains("detached"), "{text}");
    let file = |name: &str| fs::read_to_string(dir.path().join("out").join(name)).unwrap();
    for name in
        ["tip.csv", "tips.csv", "parameters.toml", "curve.svg", "tips.svg", "seta.svg", "states.pvd", "animation.html"]
    {
        assert!(!file(name).is_empty(), "{name}");
    }
    let summary: Value = serde_json::from_str(&file("summary.json")).unwrap();
    assert_eq!(summary["end"], "detached");
    assert_eq!((&summary["tips"], &summary["events"]["tips_detached"]), (&4.into(), &4.into()));
    let balance = |key: &str| summary["balance"][key].as_f64().unwrap();
    let off = balance("work_aJ") - balance("released_aJ") - balance("energy_change_aJ");
    assert!(off.abs() <= 1e-6 * balance("work_aJ"), "{off}");
    // each tip once, and the last state has none
    let events = file("events.csv");
    let mut tips: Vec<&str> = events.lines().skip(1).map(|line| line.split(',').nth(3).unwrap()).collect();
    tips.sort_unstable();
    assert_eq!(tips, ["0", "1", "2", "3"]);
    assert_eq!(events.lines().last().unwrap().split(',').nth(10), Some("0"));
    // four tips cannot hold more than four times what one holds
    let peak = summary["peak"]["force_nN"].as_f64().unwrap();
    assert!(peak > 6.0 && peak < 4.0 * summary["tip"]["peak_force_nN"].as_f64().unwrap(), "{peak}");
    let curve = file("curve.csv");
    let largest = curve.lines().skip(1).map(|line| line.split(',').nth(3).unwrap().parse::<f64>().unwrap());
    // the largest force of the curve is off by what is said, to round-off
    let off = (largest.reduce(f64::max).unwrap() - peak).abs();
    let said = summary["mesh_error"]["curve_nN"].as_f64().unwrap();
    assert!((off - said).abs() <= 1e-14 * peak, "{off:e} {said:e}");
    // what was computed is computed again
    let (status, json, trouble) = run(dir.path(), &["run", "out/parameters.toml", "--json"]);
    assert_eq!(status, Some(0), "{trouble}");
    assert_eq!(serde_json::from_str::<Value>(&json).unwrap()["peak"], summary["peak"]);
}

/// Two setae of eight tips whose steps are so short, at 1e-8, that an equilibrium of the branch is its maximum to 1e-9: one between two equilibria on
/// the way of a tip that lets go, one at the start of a step.
#[test]
fn a_maximum_at_an_equilibrium_of_the_branch_is_located() {
    let dir = tempfile::tempdir().unwrap();
    for (angle, scatter) in [("30 deg", "100 nm"), ("45 deg", "0 nm")] {
        let sets = [
            "seta.forks=3".to_owned(),
            format!("seta.shaft_angle={angle}"),
            format!("seta.height_scatter={scatter}"),
            "accuracy.relative=1e-8".to_owned(),
        ];
        let sets: Vec<&str> = sets.iter().flat_map(|set| ["--set", set]).collect();
        let (status, json, trouble) = run(dir.path(), &[&["run", &scene(), "--json"], &sets[..]].concat());
        assert_eq!(status, Some(0), "{trouble}");
        let peak = serde_json::from_str::<Value>(&json).unwrap()["peak"].clone();
        let number = |key: &str| peak[key].as_f64();
        let (force, error) = (number("force_nN").unwrap(), number("location_error_nN"));
        assert!(error.is_some_and(|error| error <= 1e-9 * force), "{angle} {scatter}: {peak}");
        assert!(number("location_error_nm").is_some(), "{peak}");
    }
}

#[test]
fn a_seta_that_is_cut_short_is_written_as_far_as_it_goes() {
    let dir = tempfile::tempdir().unwrap();
    let scene = scene();
    let arguments = [&["run", &scene, "--json", "--set", "bounds.points=5"], &SMALL[..]].concat();
    let (status, json, trouble) = run(dir.path(), &arguments);
    assert_eq!(status, Some(0), "{trouble}");
    let summary: Value = serde_json::from_str(&json).unwrap();
    assert_eq!((&summary["end"], &summary["path"]["points"]), (&"bound".into(), &5.into()));
    assert!(!dir.path().join("out").exists());
}

/// A sweep over values, one of them that of the scene, and over a plane.
#[test]
fn setae_are_swept() {
    let dir = tempfile::tempdir().unwrap();
    let scene = scene();
    let (status, json, trouble) = run(dir.path(), &[&["run", &scene, "--json"], &SMALL[..]].concat());
    assert_eq!(status, Some(0), "{trouble}");
    let alone: Value = serde_json::from_str(&json).unwrap();
    let vary = ["--vary", "seta.shaft_angle", "--values", "30 deg, 60 deg"];
    let sweep = [&["sweep", &scene], &SMALL[..], &vary[..]].concat();
    let (status, json, trouble) = run(dir.path(), &[&sweep[..], &["--json"]].concat());
    assert_eq!(status, Some(0), "{trouble}");
    let rows = serde_json::from_str::<Value>(&json).unwrap()["rows"].clone();
    assert_eq!((&rows[1]["peak_force_nN"], &rows[1]["end"]), (&alone["peak"]["force_nN"], &"detached".into()));
    assert_eq!(rows[1]["events"], alone["events"]["count"]);
    assert_eq!(rows[1]["work_aJ"], alone["balance"]["work_aJ"]);
    assert_ne!(rows[0]["peak_force_nN"], rows[1]["peak_force_nN"]);

    let vary =
        ["--vary", "seta.shaft_angle", "--values", "30 deg", "--vary", "seta.tip_pitch", "--values", "0.9 um, 1 um"];
    let out = [&["sweep", &scene], &SMALL[..], &vary[..], &["--out", "out"]].concat();
    let (status, text, trouble) = run(dir.path(), &out);
    assert_eq!(status, Some(0), "{trouble}");
    assert!(text.contains("first event"), "{text}");
    let table = || fs::read_to_string(dir.path().join("out/sweep.csv")).unwrap();
    assert_eq!(table().lines().count(), 3);
    assert!(table().starts_with("value,value_2,seta.shaft_angle_deg,seta.tip_pitch_nm,peak_force_nN"), "{}", table());
    assert!(!dir.path().join("out/sweep.partial").exists() && dir.path().join("out/sweep.svg").exists());
}

/// Few samples: their number, and that each is that of the scene with its values.
#[test]
fn an_uncertain_seta_is_sampled() {
    let dir = tempfile::tempdir().unwrap();
    let uncertain = |quantities: &str| {
        let inputs = "[{ key = \"seta.youngs_modulus\", distribution = \"lognormal\", log_deviation = 0.2 }]";
        let table = format!("\n[uncertainty]\ninputs = {inputs}\nsamples = 40\nindices = false\n{quantities}");
        let text = fs::read_to_string(scene()).unwrap() + &table;
        fs::write(dir.path().join("seta.toml"), text).unwrap();
        run(dir.path(), &[&["uncertainty", "seta.toml", "--out", "out", "--force"], &SMALL[..], &UPRIGHT].concat())
    };
    // some pull-offs may stop short, the first one does not
    let (status, _, trouble) = uncertain("");
    assert!(matches!(status, Some(0 | 3)), "{trouble}");
    let summary: Value = serde_json::from_slice(&fs::read(dir.path().join("out/summary.json")).unwrap()).unwrap();
    assert_eq!(summary["derivatives_by"], "differences");
    let samples = fs::read_to_string(dir.path().join("out/samples.csv")).unwrap();
    let column = |name: &str| samples.lines().next().unwrap().split(',').position(|found| found == name).unwrap();
    let (modulus, peak) = (column("seta.youngs_modulus_GPa"), column("peak.force_nN"));
    let first: Vec<&str> = samples.lines().nth(1).unwrap().split(',').collect();
    let set = format!("seta.youngs_modulus={} GPa", first[modulus]);
    let (status, json, trouble) =
        run(dir.path(), &[&["run", &scene(), "--json", "--set", &set], &SMALL[..], &UPRIGHT].concat());
    assert_eq!(status, Some(0), "{trouble}");
    let alone: Value = serde_json::from_str(&json).unwrap();
    let (sampled, alone) = (first[peak].parse::<f64>().unwrap(), alone["peak"]["force_nN"].as_f64().unwrap());
    assert!((sampled / alone - 1.0).abs() < 1e-9, "{sampled} {alone}");
    let (status, _, trouble) = uncertain("quantities = [\"first_jump.work_aJ\"]");
    assert_eq!(status, Some(2), "{trouble}");
    assert!(trouble.contains("which the pull-off of a seta does not have"), "{trouble}");
}

#[test]
fn what_has_no_meaning_is_refused() {
    for option in ["--observed", "--out-of-plane", "--branch", "--sensitivities"] {
        refuses(&[], &["run", &scene(), option], &[&format!("{option} has no meaning for a seta")]);
    }
    let vary = ["--vary", "seta.forks", "--values", "1, 2"];
    for (option, told) in [
        (&["--peak-only"][..], "have no meaning for a seta"),
        (&["--part", "1/2"], "--part divides sweeps of single beams"),
    ] {
        refuses(&[], &[&["sweep", &scene()], &vary[..], option].concat(), &[told]);
    }
    let told =
        "is a table of a scene that `peel run`, `sweep`, `coarsen`, `fit`, `optimise` and `uncertainty` alone compute";
    refuses(&[], &["accuracy", &scene()], &[told]);
}
