//! `peel plot` and `peel run --animate`.

use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn peel(dir: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_peel")).current_dir(dir).args(args).output().unwrap()
}

fn refused(output: Output) -> String {
    assert_eq!(output.status.code(), Some(2));
    assert!(output.stdout.is_empty());
    String::from_utf8(output.stderr).unwrap()
}

/// A folder with two runs and a sweep of the strip of 100 nm, the second run with its page.
fn results() -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    let scene = format!("{}/../../scenes/strip-100nm.toml", env!("CARGO_MANIFEST_DIR"));
    let rough = ["--set", "accuracy.relative=1e-3", "--out"];
    let run = |rest: &[&str], out: &str| {
        let output = peel(dir.path(), &[&["run", &scene], rest, &rough[..], &[out]].concat());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    };
    run(&[], "long");
    run(&["--set", "strip.length=60 nm", "--animate"], "short");
    let vary = ["--vary", "strip.height", "--from", "9 nm", "--to", "10 nm", "--points", "2"];
    let output = peel(dir.path(), &[&["sweep", &scene], &vary[..], &rough[..], &["swept"]].concat());
    assert!(output.status.success());
    dir
}

#[test]
fn results_are_drawn_together_and_refused_where_they_cannot_be() {
    let dir = results();
    let dir = dir.path();
    fs::write(dir.join("measured.csv"), "displacement_nm,force_nN\n5,0.1\n20,0.06\n").unwrap();
    let drawn = peel(dir, &["plot", "long", "short", "--data", "measured.csv"]);
    assert_eq!(String::from_utf8(drawn.stdout).unwrap(), "wrote out/plot/plot.svg\nwrote out/plot/plot.png\n");
    let text = fs::read_to_string(dir.join("out/plot/plot.svg")).unwrap();
    for label in ["long", "short", "measured", "displacement u (nm)"] {
        assert!(text.contains(label), "{label}");
    }
    assert!(refused(peel(dir, &["plot", "long"])).contains("out/plot exists, is not empty"));
    assert!(peel(dir, &["plot", "swept/sweep.csv", "--log-x", "--out", "other"]).status.success());
    assert!(refused(peel(dir, &["plot", "long", "swept"])).contains("long holds a curve.csv, and swept a sweep.csv"));
    assert!(refused(peel(dir, &["plot"])).contains("FOLDER"));
    assert!(refused(peel(dir, &["plot", "nowhere"])).contains("nowhere has neither a curve.csv nor a sweep.csv"));
    fs::write(dir.join("bad.csv"), "u,P\n5,0.1\n").unwrap();
    let message = refused(peel(dir, &["plot", "long", "--data", "bad.csv", "--out", "none"]));
    assert!(
        message.contains("bad.csv has the columns u and P") && message.contains("displacement_nm,force_nN"),
        "{message}"
    );
    assert!(!dir.join("none").exists());

    // the page of the second run
    let page = fs::read_to_string(dir.join("short/animation.html")).unwrap();
    assert!(
        page.starts_with("<!DOCTYPE html>") && !page.contains("http") && page.contains("Warning: the process zone")
    );
    assert!(!dir.join("long/animation.html").exists());
    let data = page.split("id=\"data\">").nth(1).unwrap().split("</script>").next().unwrap();
    let frames: Vec<Value> = serde_json::from_str(data).unwrap();
    assert!(frames.len() > 20, "{}", frames.len());
}
