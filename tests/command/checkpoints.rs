//! The files in which analyses keep what they find, torn, changed, and of something else.
//!
//!     frame 1     what the file is of        | another kind, scene, setting or version: refused with what differs
//!     frame 2     a result                   | a changed byte: refused with the frame and its bytes
//!     ...
//!     frame n     a result, torn             | cut off, and computed again
//!
//! Parameters: the file that a killed command has left, of each kind of analysis. Expected: exit status 2 and a message that names the file, what is wrong
//! and what to try, and the file as it was; of a torn file the whole results are taken. Why: results of something else, or changed by a disk, must not
//! land in a table, and nobody should lose what is whole.
#![cfg(unix)]

use crate::frames::{HEAD, framed, frames};
use crate::resume::{ROWS, Row, texts};
use std::fs;
use std::path::Path;

/// The first row with this file.
fn row(partial: &str) -> &'static Row {
    ROWS.iter().find(|row| row.partial == partial).unwrap()
}

const FILES: [&str; 4] = ["run.partial", "sweep.partial", "uncertainty.partial", "optimise.partial"];

/// Refused with a message with these parts, and the file is left.
#[track_caller]
fn refused(row: &Row, dir: &Path, more: &[&str], parts: &[&str]) {
    let before = fs::read(row.file(dir)).ok();
    let output = row.peel(dir, "1", more).output().unwrap();
    let (stdout, stderr) = texts(&output);
    // long messages are drawn with a frame
    let plain = stderr.replace('│', " ").split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!((output.status.code(), stdout.as_str()), (Some(2), ""), "{}: {plain}", row.name);
    for part in [&["--out DIR", "--fresh to discard"], parts].concat() {
        assert!(plain.contains(part), "{}: {part:?} is not in\n{plain}", row.name);
    }
    assert_eq!(fs::read(row.file(dir)).ok(), before, "{}: nothing is lost", row.name);
}

#[test]
fn a_changed_byte_is_named_with_its_frame() {
    for row in FILES.map(row) {
        let (dir, _) = row.stopped("KILL");
        let path = row.file(dir.path());
        let whole = fs::read(&path).unwrap();
        for (number, frame) in frames(&whole).iter().enumerate().take(2) {
            // both lengths, both check sums, and what they are of: of one kind, as all have the same frames
            let places = [0, 4, 8, 12, HEAD].map(|place| frame.place.start + place);
            let places = if row.partial == "sweep.partial" { &places[..] } else { &[] };
            for at in [places, &[frame.place.end - 1]].concat() {
                let mut changed = whole.clone();
                changed[at] ^= 1;
                fs::write(&path, &changed).unwrap();
                let named = format!("frame {} (bytes {} to {})", number + 1, frame.place.start, frame.place.end - 1);
                let file = format!("out/{} is not a checkpoint that this version of peel can read", row.partial);
                refused(row, dir.path(), &[], &[&named, "does not match its check sum", &file, "Put back a copy"]);
            }
        }
        // put back
        fs::write(&path, &whole).unwrap();
        row.goes_on(dir.path());
    }
}

#[test]
fn of_a_torn_file_the_whole_results_are_taken() {
    // all have the same frames: the shortest of many results, and a path
    for row in ["run.partial", "sweep.partial"].map(row) {
        let (dir, _) = row.stopped("KILL");
        let path = row.file(dir.path());
        let whole = fs::read(&path).unwrap();
        let frames = frames(&whole);
        let last = frames.last().unwrap().place.clone();
        // what a crash of the machine may leave behind the last result
        let zeros = [&whole[..last.end], &[0; 100][..]].concat();
        // within its head, its key and its value
        let torn = [last.start + 3, last.start + HEAD + 1, last.end - 1].map(|end| whole[..end].to_vec());
        for bytes in [&[zeros][..], &torn[..if frames.len() > 2 { 3 } else { 0 }]].concat() {
            fs::write(&path, bytes).unwrap();
            row.goes_on(dir.path());
        }
        // one that is torn in its header holds nothing
        for end in [0, HEAD / 2, frames[0].place.end - 1] {
            fs::write(&path, &whole[..end]).unwrap();
            let stdout = row.finish(dir.path(), "2", &[]);
            assert!(!stdout.contains("taken from"), "{}: {stdout}", row.name);
        }
    }
}

#[test]
fn results_of_something_else_are_refused_with_what_differs() {
    for row in FILES.map(row) {
        let (dir, _) = row.stopped("KILL");
        let path = row.file(dir.path());
        let whole = fs::read(&path).unwrap();
        let kind = match row.partial {
            "run.partial" => "run",
            "sweep.partial" => "sweep",
            "uncertainty.partial" => "sample",
            _ => "optimisation",
        };
        let of = format!("out/{} is the checkpoint of an interrupted {kind} of another", row.partial);
        let finish = format!("Finish that {kind} with its own");

        // --force is for files, not for what is unfinished
        let scene = [&of, " scene: strip.height_nm is ", " there, and 9.0 here"].map(|part| part.trim());
        refused(row, dir.path(), &["--set", "strip.height=9 nm", "--force"], &[scene[0], scene[1], scene[2], &finish]);

        let first = &frames(&whole)[0];
        let with_header = |header: &str| [&framed(&[], header.as_bytes())[..], &whole[first.place.end..]].concat();
        let header = String::from_utf8(whole[first.value.clone()].to_vec()).unwrap();
        let version = env!("CARGO_PKG_VERSION");
        fs::write(&path, with_header(&header.replacen(version, "0.0.9", 1))).unwrap();
        let words = format!("{of} version: version is 0.0.9 there, and {version} here");
        refused(row, dir.path(), &[], &[&words, &format!("{finish} version of peel")]);

        // the file of another kind of analysis under this name
        let other = FILES.map(self::row).into_iter().find(|other| other.partial != row.partial).unwrap();
        let (elsewhere, _) = other.stopped("KILL");
        fs::copy(other.file(elsewhere.path()), &path).unwrap();
        refused(row, dir.path(), &[], &["of another kind: kind is ", &format!("there, and {kind} here")]);

        fs::write(&path, "garbled").unwrap();
        refused(
            row,
            dir.path(),
            &[],
            &["is not a checkpoint that this version of peel can read", "it ends in its first frame"],
        );

        // another setting
        if kind == "sweep" {
            fs::write(&path, &whole).unwrap();
            let words = format!("{of} part: part is not given there, and 1/2 here");
            refused(row, dir.path(), &["--part", "1/2"], &[&words]);
        }

        fs::write(&path, &whole).unwrap();
        let fresh = row.finish(dir.path(), "2", &["--fresh"]);
        assert!(!fresh.contains("taken from") && !path.exists(), "{}: {fresh}", row.name);
    }
}

#[test]
fn what_an_older_version_has_kept_is_refused_with_that_version() {
    for row in FILES.map(row) {
        let dir = tempfile::tempdir().unwrap();
        let out = dir.path().join("out");
        fs::create_dir(&out).unwrap();
        let older =
            if row.partial == "run.partial" { row.partial.to_owned() } else { format!("{}.jsonl", row.partial) };
        let header = r#"{"peelkit":"0.1.0","vary":"strip.length","scene":{}}"#;
        fs::write(out.join(&older), format!("{header}\n[\"1f2e3d4c\",{{}}]\n")).unwrap();
        let words = format!("out/{older} is a checkpoint that peel 0.1.0 has written in another form");
        refused(row, dir.path(), &[], &[&words, "with peel 0.1.0, or give another folder"]);
        assert!(out.join(&older).exists());
        if older != row.partial {
            fs::write(out.join(&older), "").unwrap();
            refused(row, dir.path(), &[], &["that an older version of peel has written in another form"]);
        }
        row.finish(dir.path(), "2", &["--fresh"]);
        assert!(!out.join(&older).exists() && out.join("parameters.toml").exists());
    }
}
