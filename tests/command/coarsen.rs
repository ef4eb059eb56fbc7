//! `peel coarsen`: the law of a tip, from the spatula of a scene.
//!
//!      P |      _--
//!        |  __--   |  snaps off
//!        |/________|____ u
//!
//! Reference: the first displacement limit point of scenes/spatula.toml, 364.418953 nm and 6.4704105 nN.
//! Expected: terminal, summary.json and tables say one thing; what is read back is the same table; bad ranges and scenes of which there is
//! no table are refused before anything is computed, with what would be right.

use crate::peel::{refuses, run, scene};
use peelkit::study::coarsening::{TipPlace, TipSheet};
use peelkit_report::read_tip_law;
use serde_json::Value;
use std::path::Path;

fn coarsen(dir: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    run(dir, &[&["coarsen", &scene("spatula")], arguments].concat())
}

#[test]
fn the_law_is_written_and_read_back() {
    let dir = tempfile::tempdir().unwrap();
    let few = ["--out", "tip", "--tolerance", "1e-2", "--press", "10 nm", "--rotation", "-3 deg,0.05 rad"];
    let (status, text, trouble) = coarsen(dir.path(), &few);
    assert_eq!(status, Some(0), "{trouble}");
    let folder = dir.path().join("tip");
    let summary: Value = serde_json::from_slice(&std::fs::read(folder.join("summary.json")).unwrap()).unwrap();
    assert_eq!(summary["end"], "converged");
    assert_eq!(summary["pad_end"], "sliding");
    let number = |pointer: &str| summary.pointer(pointer).and_then(Value::as_f64).unwrap();
    assert!((number("/attached/limit_nm") - 364.418953).abs() < 1e-6 + number("/attached/limit_error_nm"));
    assert!((number("/attached/limit_force_nN") - 6.4704105).abs() < 1e-2 * number("/largest_force_nN"));
    assert!(text.contains("snaps off at u = 364.41"), "{text}");
    assert!(folder.join("tip_law.svg").exists() && folder.join("tip_law.png").exists());
    let table = read_tip_law(&folder).unwrap();
    assert!(table.is_met());
    let place = TipPlace { normal: 200.0, lateral: 0.0, rotation: 0.01 };
    let found = table.response(TipSheet::Attached, place);
    assert!((found.force[0] - 4.75).abs() < 0.1, "{found:?}");
    let limits = std::fs::read_to_string(folder.join("tip_limits.csv")).unwrap();
    let nodes = number("/attached/rotation_nodes") + number("/detached/rotation_nodes");
    assert_eq!(limits.lines().count() as f64, 1.0 + nodes);
    // a folder without the table is none
    std::fs::remove_file(folder.join("tip_law.csv")).unwrap();
    assert!(read_tip_law(&folder).unwrap_err().to_string().contains("tip_law.csv"));
}

#[test]
fn what_has_no_table_is_refused() {
    for (arguments, words) in [
        (&["--tolerance", "1"][..], "the tolerance 1 is out of range"),
        (&["--press=-1 nm"], "the spatula is pressed by -1 nm"),
        (&["--rotation", "1 deg,2 deg"], "does not hold zero"),
        (&["--rotation", "1 deg"], "which is no range from,to"),
        (&["--press", "1 deg"], "--press has \"1 deg\""),
        (&["--lateral", "-1 nm,1 nm"], "v changes nothing"),
        (&["--set", "drive.steps=[\"press 0.1 nm\"]"], "the grip takes steps"),
        (&["--set", "friction.strength=50 MPa"], "with friction the force depends"),
        (&["--set", "adhesion.line_load=force-only"], "has no potential"),
        (&["--set", "terms=auto"], "all of its terms"),
    ] {
        refuses(&[], &[&["coarsen", &scene("spatula")], arguments].concat(), &[words]);
    }
}
