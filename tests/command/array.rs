//! `peel run` of arrays of setae.
//!
//! Reference: equal sharing of equal setae, N k u_c; the force at the first loss of a band of 60 rows, `verification/toe.csv`, P2. Expected: to 1e-6,
//! as the scene has a stiffness of five digits; work is released energy. What has no meaning is refused.

use crate::peel::{is_refused, json, run};
use serde_json::Value;

fn scene(name: &str) -> String {
    format!("{}/../../scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"))
}

fn printed(name: &str, sets: &[&str]) -> Value {
    let mut arguments = vec!["run".to_owned(), scene(name)];
    sets.iter().for_each(|set| arguments.extend(["--set".to_owned(), (*set).to_owned()]));
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    json(tempfile::tempdir().unwrap().path(), &arguments)
}

fn number(found: &Value, key: &str) -> f64 {
    found.pointer(key).and_then(Value::as_f64).unwrap_or_else(|| panic!("{key}: {found}"))
}

#[test]
fn equal_setae_share_equally() {
    let found = printed("patch", &["setae.strength_scatter=0", "setae.height_scatter=0 nm", "setae.rows=10"]);
    let [peak, all] = ["/peak/load", "/closed_forms/equal_sharing_nN"].map(|key| number(&found, key));
    assert!((peak / all - 1.0).abs() < 1e-12, "{peak} {all}");
    assert_eq!((number(&found, "/events"), found["end"].as_str()), (1.0, Some("detached")));
}

#[test]
fn the_band_of_the_reference() {
    let found =
        printed("lamella", &["setae.strength_scatter=0", "setae.pitch=8.333333333 um", "setae.reach=5.14267 um"]);
    let stiffness = 0.45445 / 5.14267;
    assert!((number(&found, "/peak/load") / 2_395_216.14 - 0.08837 / stiffness).abs() < 1e-4);
    assert!((number(&found, "/closed_forms/critical_angle_deg") - 8.0734).abs() < 1e-3);
    let [work, released] = ["/work_aJ", "/released_aJ"].map(|key| number(&found, key));
    assert!((work / released - 1.0).abs() < 1e-6);
}

#[test]
fn a_small_toe() {
    let found = printed("toe", &["setae.rows=6", "setae.columns=5", "toe.lamellae=3", "toe.joined_at=3"]);
    assert_eq!((number(&found, "/setae"), found["end"].as_str()), (90.0, Some("mechanism")));
    assert!(number(&found, "/imbalance") < 1e-6);
}

#[test]
fn what_has_no_meaning_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let scene = scene("patch");
    for option in ["--observed", "--out-of-plane", "--branch", "--sensitivities", "--animate"] {
        is_refused(folder.path(), &["run", &scene, option], &["has no meaning for an array of setae"]);
    }
    let vary = ["sweep", &scene, "--vary", "setae.reach", "--values", "4 um, 5 um", "--peak-only"];
    is_refused(folder.path(), &vary, &["have no meaning for an array of setae"]);
}

/// Strengths scale with the reach: so does the peak, of a sweep and of what is uncertain. 10 % of deviation are 10 % of it.
#[test]
fn what_varies() {
    let folder = tempfile::tempdir().unwrap();
    let small = ["--set", "setae.rows=5", "--set", "setae.columns=4", "--set", "setae.height_scatter=0 um"];
    let vary = ["sweep", &scene("patch"), "--vary", "setae.reach", "--values", "4 um, 5 um", "--out", "out"];
    let (status, text, trouble) = run(folder.path(), &[&vary[..], &small].concat());
    assert!(status == Some(0) && text.contains("largest load"), "{trouble}{text}");
    let mut rows = csv::Reader::from_path(folder.path().join("out/sweep.csv")).unwrap();
    let loads: Vec<f64> = rows.records().map(|row| row.unwrap()[1].parse().unwrap()).collect();
    assert!((loads[1] / loads[0] - 1.25).abs() < 1e-9 && folder.path().join("out/sweep.png").exists(), "{loads:?}");
    let input = "{ key = \"setae.reach\", distribution = \"normal\", deviation = \"0.5 um\" }";
    let table = format!(
        "\n[uncertainty]\nquantities = [\"peak.force_nN\"]\ninputs = [{input}]\nsamples = 64\nindices = false\n"
    );
    let text = std::fs::read_to_string(scene("patch")).unwrap().replace("5.14267 um", "5 um") + &table;
    std::fs::write(folder.path().join("uncertain.toml"), text).unwrap();
    let (status, text, trouble) =
        run(folder.path(), &[&["uncertainty", "uncertain.toml", "--json"], &small[..]].concat());
    assert_eq!(status, Some(0), "{trouble}");
    let found: Value = serde_json::from_str(&text).unwrap();
    let number = |name: &str| found["results"][0][name]["value"].as_f64().unwrap();
    let ratio = number("deviation") / number("mean");
    assert!((ratio - 0.1).abs() < 0.02, "{ratio} {text}");
}
