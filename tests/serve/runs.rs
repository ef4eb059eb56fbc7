//! A run over the page is the run of the library: the same numbers, bit for bit.

use crate::client::{Running, STRIP, read};
use peelkit::study;
use peelkit_analyses::{Analysis, Asked, Outcome, Run, Session};
use peelkit_scene::Scene;
use serde_json::{Value, json};
use std::io::Write;
use std::time::Duration;

const SLOW: &str = include_str!("../../scenes/strip-friction.toml");

fn number(value: &serde_json::Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// The strip of 100 nm, 8 nm high: initiation peak, first jump and every point of the curve.
#[test]
fn the_numbers_are_those_of_the_library() {
    let set = [("strip.height".to_owned(), "8 nm".to_owned())];
    let scene = Scene::parse("strip", STRIP, &set).unwrap();
    let peel = study::peel(&scene.model, &scene.accuracy, &scene.bounds.from_now());
    let server = Running::usual();
    let request = json!({"name": "strip", "scene": STRIP, "set": set, "parts": ["curve", "poses", "controls", "toml"]});
    let answer = server.post("/api/peel", &request).json();
    let (summary, curve) = (&answer["summary"], &answer["curve"]);
    let peak = peel.initiation_peak.unwrap();
    assert_eq!(number(&summary["initiation_peak"]["force_nN"]), peak.force);
    assert_eq!(number(&summary["initiation_peak"]["error_nN"]), peak.force_error);
    assert_eq!(number(&summary["first_jump"]["displacement_nm"]), peel.snap_off.unwrap().displacement);
    let forces: Vec<f64> = curve["force_nN"].as_array().unwrap().iter().map(number).collect();
    for point in &peel.points {
        assert!(forces.contains(&point.force), "{}", point.force);
    }
    let poses = peelkit_report::poses(&peel);
    let along = answer["poses"]["along"].as_array().unwrap();
    assert_eq!(along.len(), poses.len());
    for (sent, pose) in along.iter().zip(&poses) {
        assert_eq!((number(&sent["force_nN"]), sent["unstable"].as_bool()), (pose.force, Some(pose.unstable)));
    }
    let again = Scene::parse("strip", answer["toml"].as_str().unwrap(), &[]).unwrap();
    assert_eq!(again.model, scene.model);
}

/// A slider goes over what its key takes, and stands at the value of the scene: 10 nm is in the middle of 1 to 100 nm.
#[test]
fn controls_have_the_ranges_of_their_keys() {
    let server = Running::usual();
    let answer = server.post("/api/peel", &json!({"name": "s", "scene": STRIP, "parts": ["controls"]})).json();
    let control = |key: &str| {
        let list = answer["controls"].as_array().unwrap();
        list.iter().find(|control| control["key"] == key).unwrap_or_else(|| panic!("no control of {key}")).clone()
    };
    let height = control("strip.height");
    assert_eq!((number(&height["value"]), height["unit"].as_str()), (10.0, Some("nm")));
    assert_eq!((number(&height["slider"]["low"]), number(&height["slider"]["high"])), (1.0, 100.0));
    let angle = control("drive.angle");
    assert_eq!(
        (number(&angle["slider"]["low"]), number(&angle["slider"]["high"]), angle["unit"].as_str()),
        (0.0, 180.0, Some("deg"))
    );
    assert!(control("adhesion.law")["words"].as_array().unwrap().contains(&json!("bilinear")));
    assert!(control("grip.stiffness")["value"].is_null());
}

#[test]
fn a_test_with_held_displacement_has_its_jumps() {
    let server = Running::usual();
    let request = json!({"name": "s", "scene": STRIP, "parts": ["test"], "set": [["grip.rotation", "fixed"]]});
    let answer = server.post("/api/peel", &request).json();
    assert!(!answer["summary"]["observed"]["jumps"].as_array().unwrap().is_empty());
}

#[test]
fn files_are_those_of_the_command() {
    let server = Running::usual();
    let file = |name: &str| server.post("/api/file", &json!({"name": "s", "scene": STRIP, "file": name}));
    assert!(file("curve.csv").body.starts_with("displacement_nm,force_nN,end_rotation_rad,work_aJ,"));
    assert!(file("curve.svg").body.starts_with("<svg"));
    assert!(file("parameters.toml").body.contains("length = \"100 nm\""));
    assert_eq!(file("summary.json").json()["title"], "Peeling of a strip of 100 nm");
    assert_eq!(file("/etc/passwd").status, 400);
}

/// A server that ends tells whoever waits for a run: 503, with a reason. The run, a friction path of seconds, ends at its next point.
#[test]
fn a_server_that_ends_answers_who_waits() {
    let server = Running::usual();
    let request = json!({"name": "slow", "scene": SLOW, "set": [["drive.angle", "90 deg"]]});
    let mut waiting = server.connect();
    waiting.write_all(&server.request("/api/peel", &request.to_string(), "")).unwrap();
    std::thread::sleep(Duration::from_millis(300));
    server.stop();
    let reply = read(&mut waiting);
    assert_eq!(reply.status, 503, "{reply:?}");
    assert_eq!(reply.json()["error"], "the server is ending");
}

/// A seta of 16 tips, a strip at a rate and a seta at a rate: the summary of the command but for its clock, the curve that leads through its largest
/// force, and the same table as the command writes.
#[test]
fn setae_and_pulls_at_a_rate_are_those_of_the_command() {
    let server = Running::usual();
    for (kind, text, set) in [
        ("seta", include_str!("../../scenes/seta.toml"), vec![["seta.forks", "4"]]),
        ("rate", include_str!("../../scenes/strip-at-a-rate.toml"), vec![]),
        ("rate", include_str!("../../scenes/seta-at-a-rate.toml"), vec![]),
    ] {
        let overrides: Vec<_> = set.iter().map(|[key, value]| (key.to_string(), value.to_string())).collect();
        let scene = Scene::parse_any("s", text, &overrides).unwrap();
        let outcome = Run::of(&scene, Asked::default()).unwrap().run(&Session::PLAIN).unwrap();
        let mut wanted: Value = serde_json::from_str(&outcome.json(&scene, None).unwrap()).unwrap();
        let asked = json!({"name": "s", "scene": text, "set": set, "parts": ["curve", "poses", "controls", "test"]});
        let reply = server.post("/api/peel", &asked);
        assert_eq!(reply.status, 200, "{}", reply.body);
        let mut answer = reply.json();
        for summary in [&mut wanted, &mut answer["summary"]] {
            assert!(summary.as_object_mut().unwrap().remove("timing").is_some());
        }
        assert_eq!((&answer["summary"], &answer["kind"]), (&wanted, &json!(kind)));
        let peak = if kind == "seta" { &wanted["peak"] } else { &wanted["largest_force"] };
        let forces = answer["curve"]["force_nN"].as_array().unwrap();
        let largest = forces.iter().map(number).fold(0.0, f64::max);
        assert!((largest / number(&peak["force_nN"]) - 1.0).abs() < 1e-3, "{largest}: {peak}");
        let along = answer["poses"]["along"].as_array().unwrap();
        let has_shapes = along.iter().all(|pose| pose["branches"].as_array().is_some_and(|all| all.len() == 31));
        assert_eq!((has_shapes, answer["curve"]["equilibria"].is_object()), (kind == "seta", kind == "rate"));
        assert!(
            answer["controls"]
                .as_array()
                .unwrap()
                .iter()
                .any(|control| control["key"] == "spatula.pad_length" || control["key"] == "time.rate")
        );
        let table = server.post("/api/file", &json!({"name": "s", "scene": text, "set": set, "file": "curve.csv"}));
        let folder = tempfile::tempdir().unwrap();
        outcome.write(&scene, folder.path(), "peel").unwrap();
        assert_eq!(table.body, std::fs::read_to_string(folder.path().join("curve.csv")).unwrap());
    }
}
