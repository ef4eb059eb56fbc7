//! `peel serve` as a user starts and ends it; what the page can be asked is tested in `tests/serve`, the page itself in `tests/browser`.
//!
//! Parameters: the strip of 100 nm, a free port. Expected: the address on the first line, the user's scene first in the list of the page with
//! what `--set` changed, exit status 0 after Ctrl-C; exit status 2 with a reason where another program has the port, and where the scene is
//! wrong, before the page is there. Why: a page that nobody can reach is no page.
#![cfg(unix)]

use std::io::{BufRead, BufReader, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::process::{Command, Output, Stdio};

const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/strip-100nm.toml");

fn serve(args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_peel"));
    command.arg("serve").args(args).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

#[test]
fn a_page_is_there_until_ctrl_c() {
    let mut child = serve(&[SCENE, "--set", "strip.height=8 nm", "--port", "0"]).spawn().unwrap();
    let mut said = BufReader::new(child.stdout.take().unwrap());
    let mut line = String::new();
    said.read_line(&mut line).unwrap();
    let address = line.trim().strip_prefix("The page is at http://127.0.0.1:").and_then(|rest| rest.strip_suffix('/'));
    let port: u16 = address.unwrap_or_else(|| panic!("{line}")).parse().unwrap();
    let mut stream = TcpStream::connect(("127.0.0.1", port)).unwrap();
    stream.write_all(b"GET /api/scenes HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n").unwrap();
    let mut answer = String::new();
    stream.read_to_string(&mut answer).unwrap();
    let scenes: serde_json::Value = serde_json::from_str(answer.split_once("\r\n\r\n").unwrap().1).unwrap();
    assert_eq!(scenes[0]["title"], "Peeling of a strip of 100 nm");
    assert!(scenes[0]["text"].as_str().unwrap().contains("height = \"8 nm\""));
    if crate::interrupt::signals_are_ignored() {
        child.kill().unwrap();
        child.wait().unwrap();
        return;
    }
    Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(0));
}

#[test]
fn a_port_that_is_taken_is_named() {
    let taken = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = taken.local_addr().unwrap().port().to_string();
    let output = serve(&["--port", &port]).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(
        stderr(&output).contains(&format!("the page cannot listen at 127.0.0.1, port {port}: ")),
        "{}",
        stderr(&output)
    );
    assert!(stderr(&output).contains("--port 0"), "{}", stderr(&output));
}

#[test]
fn a_wrong_scene_is_refused_before_the_page_is_there() {
    let output = serve(&[SCENE, "--set", "strip.height=8"]).output().unwrap();
    assert_eq!((output.status.code(), output.stdout.is_empty()), (Some(2), true));
    assert!(stderr(&output).contains("a number without a unit"), "{}", stderr(&output));
}
