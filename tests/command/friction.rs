//! What `peel run` reports of friction.

use approx::assert_relative_eq;
use std::process::Command;

/// The command reports how the strip has slid.
#[test]
fn the_summary_tells_how_it_has_slid() {
    let output = Command::new(env!("CARGO_BIN_EXE_peel"))
        .args(["run", concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/strip-friction.toml"), "--json"])
        .args(["--set", "bounds.displacement=3 nm", "--set", "accuracy.relative=1e-4"])
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let summary: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let of = |key: &str| summary["sliding"][key].as_f64().unwrap();
    let force = summary["initiation_peak"]["force_nN"].as_f64().unwrap();
    // along the substrate nothing else holds the strip: friction carries P cos α
    assert_relative_eq!(of("friction_force_nN"), force * 30f64.to_radians().cos(), max_relative = 1e-4);
    assert!(of("sliding_length_nm") > 5.0 && of("sliding_length_nm") < of("contact_length_nm"));
    assert!(of("dissipated_aJ") > 0.0);
}
