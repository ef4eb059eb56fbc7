//! `peel run` and `peel sweep` of a scene with `[seta]` and `[time]`: a small seta of viscous branches whose root is pulled at a rate.
//!
//! Reference: what the command writes in one file against what it writes in another; the equilibria of the same scene.
//!
//! Expected: each tip leaves its branch once, in events.csv and in summary.json; the largest force is that of curve.csv, lies above that of the equilibria,
//! and comes near to it where the pull is slow; work is stored, of adhesion or dissipated; a row of a sweep is what `peel run` gives; what has
//! no meaning is refused by name. Why: a rate that is left out silently gives the force of equilibria.

use crate::peel::{refuses, run};
use crate::seta::SMALL;
use serde_json::Value;
use std::fs;

fn scene() -> String {
    format!("{}/../../scenes/seta-at-a-rate.toml", env!("CARGO_MANIFEST_DIR"))
}

fn number(value: &Value, path: &str) -> f64 {
    path.split('.').fold(value, |value, key| &value[key]).as_f64().unwrap_or_else(|| panic!("{path}: {value}"))
}

#[test]
fn a_seta_is_pulled_at_a_rate_and_written() {
    let dir = tempfile::tempdir().unwrap();
    let (status, text, trouble) = run(dir.path(), &[&["run", &scene(), "--out", "out"], &SMALL[..]].concat());
    assert_eq!(status, Some(0), "{trouble}");
    assert!(text.contains("of 4 tips attached") && text.contains("detached at t ="), "{text}");
    let file = |name: &str| fs::read_to_string(dir.path().join("out").join(name)).unwrap();
    for name in ["equilibria.csv", "tip.csv", "parameters.toml", "curve.svg"] {
        assert!(!file(name).is_empty(), "{name}");
    }
    let summary: Value = serde_json::from_str(&file("summary.json")).unwrap();
    assert_eq!((&summary["end"], &summary["tips"]), (&"detached".into(), &4.into()));
    let events = file("events.csv");
    let mut tips: Vec<&str> = events.lines().skip(1).map(|line| line.split(',').nth(4).unwrap()).collect();
    tips.sort_unstable();
    assert_eq!((tips, &summary["events"]["tips_detached"]), (vec!["0", "1", "2", "3"], &4.into()));
    let curve = file("curve.csv");
    let column = |k: usize| -> Vec<f64> {
        curve.lines().skip(1).map(|line| line.split(',').nth(k).unwrap().parse().unwrap()).collect()
    };
    let (forces, of_tips) = (column(2), column(4));
    let force = number(&summary, "largest_force.force_nN");
    assert_eq!(forces.iter().copied().reduce(f64::max), Some(force));
    assert!(forces.iter().zip(&of_tips).all(|(a, b)| (a - b).abs() < 1e-4 * force));
    assert!(number(&summary, "force_over_equilibria") > 1.0);
    let balance = |key: &str| number(&summary["balance"], key);
    let off = balance("work_aJ") - balance("stored_aJ") - balance("adhesion_aJ") - balance("dissipated_aJ");
    assert!(off.abs() < 1e-4 * balance("work_aJ"), "{off}");
    assert!(balance("released_aJ") < balance("dissipated_aJ"));
    // what was computed is computed again
    let (status, json, trouble) = run(dir.path(), &["run", "out/parameters.toml", "--json"]);
    assert_eq!(status, Some(0), "{trouble}");
    assert_eq!(serde_json::from_str::<Value>(&json).unwrap()["largest_force"], summary["largest_force"]);
}

#[test]
fn rates_of_a_seta_are_swept() {
    let dir = tempfile::tempdir().unwrap();
    let vary = ["--vary", "time.rate", "--values", "1 um/s, 10 mm/s", "--json"];
    let (status, json, trouble) = run(dir.path(), &[&["sweep", &scene()], &SMALL[..], &vary].concat());
    assert_eq!(status, Some(0), "{trouble}");
    let rows = serde_json::from_str::<Value>(&json).unwrap()["rows"].clone();
    let (status, json, trouble) = run(dir.path(), &[&["run", &scene(), "--json"], &SMALL[..]].concat());
    assert_eq!(status, Some(0), "{trouble}");
    let alone: Value = serde_json::from_str(&json).unwrap();
    assert_eq!(
        (&rows[1]["largest_force_nN"], &rows[1]["end"]),
        (&alone["largest_force"]["force_nN"], &"detached".into())
    );
    assert_eq!(rows[1]["contact_lost_s"], alone["contact_lost_s"]);
    // slowly it goes through equilibria
    let slow = number(&rows[0], "largest_force_nN") / number(&alone, "equilibria_peak.force_nN") - 1.0;
    assert!((-1e-6..2e-3).contains(&slow) && slow < number(&alone, "force_over_equilibria") - 1.0, "{slow}");
}

#[test]
fn a_pull_that_does_not_end_is_written_as_far_as_it_goes() {
    let dir = tempfile::tempdir().unwrap();
    let few = ["--json", "--set", "bounds.points=20"];
    let (status, json, trouble) = run(dir.path(), &[&["run", &scene()], &SMALL[..], &few].concat());
    assert_eq!(status, Some(3), "{trouble}");
    let summary: Value = serde_json::from_str(&json).unwrap();
    assert!(summary["reason"].as_str().unwrap().contains("steps were not enough"), "{summary}");
    let rest = ["--json", "--set", "time.displacement=30 nm"];
    let (status, json, trouble) = run(dir.path(), &[&["run", &scene()], &SMALL[..], &rest].concat());
    assert_eq!(status, Some(0), "{trouble}");
    let summary: Value = serde_json::from_str(&json).unwrap();
    assert_eq!((&summary["end"], &summary["events"]["count"]), (&"still-attached".into(), &0.into()));
}

#[test]
fn what_has_no_meaning_is_refused() {
    let vary = ["--vary", "time.rate", "--values", "1 mm/s, 2 mm/s"];
    for (arguments, told) in [
        (&["run", "--states", "3"][..], "--states has no meaning for a pull at a rate"),
        (&["run", "--set", "seta.preload=1 nN"], "`seta.preload` of the scene is not followed in time"),
        (&["run", "--set", "time.held=1 s"], "[time] without `held`"),
        (&["run", "--set", "time.density=1300 kg/m3"], "the mass of a seta is not followed in time"),
        (&["coarsen"], "here equilibria are followed"),
        (&[&["sweep", "--peak-only"], &vary[..]].concat(), "have no meaning for a pull at a rate"),
    ] {
        refuses(&[], &[&[arguments[0], &scene()], &arguments[1..]].concat(), &[told]);
    }
}
