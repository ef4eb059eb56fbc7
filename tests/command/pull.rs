//! Pulls in any direction, swept and refused.

use crate::peel::refuses;
use serde_json::Value;
use std::process::Command;

const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/strip-100nm.toml");

fn swept(more: &[&str]) -> Vec<Value> {
    let mut command = Command::new(env!("CARGO_BIN_EXE_peel"));
    command.args(["sweep", SCENE, "--vary", "drive.angle", "--from", "60 deg", "--to", "120 deg", "--points", "5"]);
    let output = command.args(more).arg("--json").output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let summary: Value = serde_json::from_slice(&output.stdout).unwrap();
    summary["rows"].as_array().unwrap().clone()
}

/// The peak followed in the angle, through the vertical, is that of whole peels.
#[test]
fn the_peak_is_followed_from_forwards_to_backwards() {
    for (followed, whole) in swept(&["--peak-only"]).iter().zip(&swept(&[])) {
        let [a, b] = [followed, whole].map(|row| row["initiation_peak_nN"].as_f64().unwrap());
        assert!((a / b - 1.0).abs() < 1e-6, "at {} rad: {a} and {b} nN", followed["value"]);
    }
}

#[test]
fn a_strip_is_not_pulled_along_itself() {
    for angle in ["0 deg", "180 deg"] {
        refuses(&[], &["run", SCENE, "--json", "--set", &format!("drive.angle={angle}")], &["along the strip"]);
    }
}
