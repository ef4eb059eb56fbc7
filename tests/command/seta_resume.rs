//! The pull-off of a seta that is interrupted, killed or out of time, and goes on where it stopped.
//!
//!     equilibria:  o--o--o--o--o--o--o--o--o--o
//!     run 1        computed    ^ Ctrl-C, a kill or bounds.time: what was reached is kept in run.partial
//!     run 2        taken        computed
//!
//! Parameters: scenes/seta.toml with 64 tips, pressed on with 0.1 µN, with states. The reference is the same run without an interruption.
//! Expected: exit status 3 and words of a planar run after Ctrl-C; the same files bit for bit behind the last run but for seconds, the command and
//! bounds; another scene is refused, and --fresh starts anew. Why: the pull-off of a large seta takes minutes.

use super::interrupt::signals_are_ignored;
use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};
use tempfile::tempdir;

const PARTIAL: &str = "out/run.partial";
const FILES: [&str; 8] =
    ["curve.csv", "events.csv", "tips.csv", "tip.csv", "curve.svg", "seta.svg", "states.pvd", "states/state-000.vtu"];

fn peel(dir: &Path, more: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_peel"));
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/seta.toml");
    command.current_dir(dir).stdout(Stdio::piped()).stderr(Stdio::piped());
    command.args(["run", scene, "--out", "out", "--states", "4", "--set", "seta.forks=6"]);
    command.args(["--set", "seta.preload=0.1 uN"]).args(more);
    command
}

fn texts(output: &Output) -> (String, String) {
    (String::from_utf8(output.stdout.clone()).unwrap(), String::from_utf8(output.stderr.clone()).unwrap())
}

#[track_caller]
fn finish(dir: &Path, more: &[&str]) -> String {
    let output = peel(dir, more).output().unwrap();
    let (stdout, stderr) = texts(&output);
    assert_eq!((output.status.code(), stderr.as_str()), (Some(0), ""), "{stdout}");
    stdout
}

fn files(dir: &Path) -> Vec<Vec<u8>> {
    let read = |name: &str| fs::read(dir.join("out").join(name)).unwrap();
    let mut files: Vec<Vec<u8>> = FILES.iter().map(|name| read(name)).collect();
    let own = |line: &&[u8]| {
        !["solve_s\"", "tip_s\"", "mesh_error_s\"", "time_s\"", "\"command\""]
            .iter()
            .any(|key| line.windows(key.len()).any(|part| part == key.as_bytes()))
    };
    files.push(read("summary.json").split(|&byte| byte == b'\n').filter(own).collect::<Vec<_>>().join(&b'\n'));
    files
}

/// Sends a signal to a run once it has kept something; nothing where it was over before that.
fn stopped(dir: &Path, signal: &str) -> Option<Output> {
    let _ = fs::remove_file(dir.join(PARTIAL));
    let mut child = peel(dir, &["--force"]).spawn().unwrap();
    let began = Instant::now();
    while !dir.join(PARTIAL).exists() {
        assert!(began.elapsed() < Duration::from_secs(120), "waited in vain for {PARTIAL}");
        if child.try_wait().unwrap().is_some() {
            return None;
        }
        std::thread::sleep(Duration::from_millis(1));
    }
    Command::new("kill").args([&format!("-{signal}"), &child.id().to_string()]).status().unwrap();
    let output = child.wait_with_output().unwrap();
    (output.status.code() != Some(0)).then_some(output)
}

#[test]
fn a_pull_off_that_is_stopped_goes_on_bit_for_bit() {
    let whole = tempdir().unwrap();
    finish(whole.path(), &[]);
    assert!(!whole.path().join(PARTIAL).exists(), "a finished run leaves nothing behind");
    let whole = files(whole.path());

    let dir = tempdir().unwrap();
    let first = finish(dir.path(), &["--set", "bounds.time=0.05 s"]);
    assert!(first.contains("bounds.time = 0.05 s") && first.contains(PARTIAL), "{first}");
    let kept = fs::read(dir.path().join(PARTIAL)).unwrap();
    let other = peel(dir.path(), &["--set", "seta.shaft_angle=50 deg", "--force"]).output().unwrap();
    let (stdout, stderr) = texts(&other);
    assert_eq!((other.status.code(), stdout.as_str()), (Some(2), ""));
    assert!(stderr.contains(PARTIAL) && stderr.contains("another scene") && stderr.contains("--fresh"), "{stderr}");
    assert_eq!(fs::read(dir.path().join(PARTIAL)).unwrap(), kept, "nothing is lost");
    let second = finish(dir.path(), &["--set", "bounds.time=0.1 s"]);
    assert!(second.contains("equilibria taken from an earlier, unfinished run"), "{second}");
    finish(dir.path(), &[]);
    assert!(files(dir.path()) == whole, "the files differ");

    fs::write(dir.path().join(PARTIAL), &kept).unwrap();
    let fresh = finish(dir.path(), &["--fresh", "--force"]);
    assert!(!fresh.contains("taken from") && !dir.path().join(PARTIAL).exists(), "{fresh}");
    assert!(files(dir.path()) == whole, "the files differ");

    // what was torn is named and computed again
    fs::write(dir.path().join(PARTIAL), &kept[..kept.len() - 9]).unwrap();
    let torn = peel(dir.path(), &[]).output().unwrap();
    let (stdout, stderr) = texts(&torn);
    assert_eq!(torn.status.code(), Some(0));
    assert!(stderr.contains("does not match its check sum") && !stdout.contains("taken from"), "{stdout}{stderr}");
}

/// A machine may be so fast that a run is over before the signal: then there is nothing to go on from.
#[test]
fn a_pull_off_ended_by_ctrl_c_or_killed_goes_on() {
    if signals_are_ignored() {
        return;
    }
    let dir = tempdir().unwrap();
    for signal in ["INT", "KILL"] {
        let Some(output) = stopped(dir.path(), signal) else { continue };
        if signal == "INT" {
            let (stdout, stderr) = texts(&output);
            assert_eq!(output.status.code(), Some(3), "{stderr}");
            for part in ["interrupted", PARTIAL, "the same command", "--fresh"] {
                assert!(stderr.contains(part), "{part:?} is not in\n{stderr}");
            }
            assert!(
                stdout.contains("bound: ") && stdout.contains("curve.csv"),
                "what was reached is written: {stdout}"
            );
        }
        let after = finish(dir.path(), &[]);
        assert!(after.contains("equilibria taken from an earlier, unfinished run"), "{after}");
        assert!(!dir.path().join(PARTIAL).exists());
    }
}
