//! `peel coarsen` that is stopped before its table is whole.
//!
//!     solving the spatula  o--o--o--o |           Ctrl-C, the signal to end, or bounds.time
//!     the folder           as it was before
//!
//! Parameters: scenes/spatula.toml to 1e-5, which takes minutes. Expected: exit status 3, a message that says why and how far it came, and nothing in
//! the folder; likewise of a seta that computes the table of its tips. Why: a command that takes long has to be heard, and part of a table is none.

use crate::peel::{plain, run as peel, scene};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/spatula.toml");
const LONG: [&str; 6] = ["coarsen", SCENE, "--tolerance", "1e-5", "--out", "tip"];

#[test]
fn the_time_of_the_scene_ends_it() {
    let dir = tempfile::tempdir().unwrap();
    let began = Instant::now();
    let (status, _, trouble) = peel(dir.path(), &[&LONG[..], &["--set", "bounds.time=0.2 s"]].concat());
    let plain = plain(&trouble);
    assert_eq!(status, Some(3), "{plain}");
    assert!(plain.contains("bounds.time = 0.2 s: ") && plain.contains("nothing is written"), "{plain}");
    assert!(began.elapsed() < Duration::from_secs(30), "{:?}", began.elapsed());
    assert!(!dir.path().join("tip/summary.json").exists());
}

#[test]
fn the_time_of_a_seta_ends_the_table_of_its_tips() {
    let dir = tempfile::tempdir().unwrap();
    let sets = ["--set", "seta.tip_law=table", "--set", "seta.tip_tolerance=1e-5", "--set", "bounds.time=0.5 s"];
    let (status, _, trouble) = peel(dir.path(), &[&["run", &scene("seta"), "--json"], &sets[..]].concat());
    let plain = plain(&trouble);
    assert_eq!(status, Some(3), "{plain}");
    assert!(plain.contains("the table of the tips of the seta: bounds.time = 0.5 s: "), "{plain}");
}

#[test]
#[cfg(unix)]
fn a_signal_ends_it() {
    if crate::interrupt::signals_are_ignored() {
        return;
    }
    for name in ["INT", "TERM"] {
        // a machine may be so busy that the command does not listen yet: then once more
        let ended = (0..8).find_map(|attempt| {
            let dir = tempfile::tempdir().unwrap();
            let mut command = Command::new(env!("CARGO_BIN_EXE_peel"));
            command.current_dir(dir.path()).args(LONG).stdout(Stdio::null()).stderr(Stdio::piped());
            let child = command.spawn().unwrap();
            std::thread::sleep(Duration::from_millis(200 << attempt));
            assert!(
                Command::new("kill").args([&format!("-{name}"), &child.id().to_string()]).status().unwrap().success()
            );
            let output = child.wait_with_output().unwrap();
            let left = dir.path().join("tip/summary.json").exists();
            (output.status.code() == Some(3)).then(|| (String::from_utf8(output.stderr).unwrap(), left))
        });
        let (trouble, left) = ended.unwrap();
        let plain = plain(&trouble);
        assert!(plain.contains("interrupted: ") && plain.contains("nothing is written") && !left, "{plain}");
    }
}
