//! A seta whose spatulae are beams, from the command.
//!
//! ```text
//!          ● root, pulled up
//!         / \\
//!     ===/===/   two spatulae, each a beam in space
//! ```
//!
//! Parameters: scenes/seta-of-beams.toml. Reference: the same seta whose tips follow the table of their spatula, to 1e-2; the equilibria of the run.
//! Expected: the peak within 1 % of that by the table, the error of the mesh below 1e-4 of it, stations where they were asked for, and files for ParaView
//! with the sections of the spatulae. Why: what the library computes has to reach a user as for every other seta.

use crate::peel::run as peel;
use serde_json::Value;
use tempfile::tempdir;

const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/seta-of-beams.toml");

#[test]
fn spatulae_that_are_beams_are_pulled_off() {
    let dir = tempdir().unwrap();
    let asked = ["--at", "u=100 nm", "--stop-at", "one left: attached < 2", "--states", "3", "--out", "out"];
    let (status, text, trouble) = peel(dir.path(), &[&["run", SCENE], &asked[..]].concat());
    assert_eq!((status, trouble.as_str()), (Some(0), ""), "{text}");
    for part in ["tips               spatulae that are beams", "error of the mesh", "the event \"one left\""] {
        assert!(text.contains(part), "{part:?} is not in {text}");
    }
    let read = |name: &str| std::fs::read_to_string(dir.path().join("out").join(name)).unwrap();
    let summary: Value = serde_json::from_str(&read("summary.json")).unwrap();
    assert_eq!((&summary["tip"]["law"], &summary["end"]), (&"beam".into(), &"event".into()));
    let number = |of: &Value, key: &str| of[key].as_f64().unwrap();
    let peak = number(&summary["peak"], "force_nN");
    assert!(number(&summary["mesh_error"], "force_nN") < 1e-4 * peak, "{summary}");
    let stations = summary["stations"].as_array().unwrap();
    assert!((number(&stations[0], "displacement_nm") - 100.0).abs() < 1e-8, "{stations:?}");
    assert!(stations[1]["jumped"] == true && stations[1]["tips_attached"] == 1, "{stations:?}");
    // three branches of 13, 9 and 9 sections, and two spatulae of 33
    assert!(read("states/state-000.vtu").contains("NumberOfPoints=\"97\""));

    let by_table = ["--json", "--set", "seta.tip_law=table", "--set", "seta.tip_tolerance=1e-2"];
    let (_, text, _) = peel(dir.path(), &[&["run", SCENE], &by_table[..]].concat());
    let wanted = number(&serde_json::from_str::<Value>(&text).unwrap()["peak"], "force_nN");
    assert!((peak / wanted - 1.0).abs() < 0.01, "{peak} {wanted}");
}
