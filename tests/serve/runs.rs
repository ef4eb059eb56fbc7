//! A run over the page is the run of the library: the same numbers, bit for bit.

use crate::client::{Running, STRIP, read};
use peelkit::study;
use peelkit_scene::Scene;
use serde_json::json;
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
