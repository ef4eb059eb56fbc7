//! The law of a seta: `peel coarsen` of a scene with a seta makes it, `setae.law` reads it, and `setae.seta` says of which seta it is.
//!
//!      v |    / u·d = c: behind it the seta is detached
//!        |  /
//!        |/____ u
//!
//! Reference: a spring of the numbers of scenes/patch.toml, written as a law of degree 2: arrays have to be those of the numbers, to rounding. A seta
//! with two tips that slide lets go where u_n has one value, at any angle. What a sweep makes of a missing folder is what `peel coarsen` makes of
//! the same seta. Expected: the files agree with one another; a law is made once, and the terminal says so before; a law that does not fit, one of
//! another seta among them, is refused with what would.

use crate::peel::{is_refused, run, scene};
use peelkit::study::coarsening::{ExitPlane, LawSheet, SetaLaw, SetaLawErrors};
use peelkit_report::seta_law_text;
use peelkit_scene::{SETA_LAW, Scene, parse_seta_law};
use serde_json::Value;
use std::fs;
use std::path::Path;

const STIFFNESS: f64 = 0.08837;
const REACH: f64 = 5142.67;

fn json(dir: &Path, arguments: &[&str]) -> Value {
    let (status, text, trouble) = run(dir, &[arguments, &["--json"]].concat());
    assert_eq!(status, Some(0), "{trouble}");
    serde_json::from_str(&text).unwrap()
}

/// A spring along the normal, and as stiff a one along the ground, as a text.
fn spring() -> String {
    let half = 0.5 * STIFFNESS * REACH * REACH;
    let coefficients = vec![0.0, 0.0, 0.0, half, 0.0, half];
    let exit = ExitPlane { direction: [0.0, 1.0], distance: REACH };
    let errors = SetaLawErrors::default();
    let sheets = vec![LawSheet { tips: 256, coefficients, exit }];
    let law = SetaLaw { degree: 2, scale: REACH, sheets, largest_force: STIFFNESS * REACH, errors };
    let path = scene("seta");
    let seta = Scene::parse_any(&path, &fs::read_to_string(&path).unwrap(), &[]).unwrap();
    let text = seta_law_text(&law, &seta);
    let (read, lines) = parse_seta_law(&text).unwrap();
    assert_eq!(read, law);
    assert!(lines.contains(&"seta.forks = 8.0".to_owned()), "{lines:?}");
    text
}

/// A scene of an array without the numbers of its setae, with their law.
fn by_law(name: &str) -> String {
    let text = fs::read_to_string(scene(name)).unwrap();
    let numbers = ["stiffness =", "reach =", "tangential_stiffness ="];
    let kept = text.lines().filter(|line| !numbers.iter().any(|number| line.starts_with(number)));
    kept.collect::<Vec<_>>().join("\n").replace("[setae]", "[setae]\nlaw = \"law\"")
}

#[test]
fn arrays_by_a_law_are_those_by_its_numbers() {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| dir.path().join(name);
    fs::create_dir(at("law")).unwrap();
    fs::write(at("law").join(SETA_LAW), spring()).unwrap();
    for (name, lines) in [("patch", "[setae]\nrows = 20\n"), ("lamella", "[setae]\ncolumns = 20\n")] {
        // as stiff along the ground as off it
        let own = format!("setae.tangential_stiffness={STIFFNESS} N/m");
        let small = lines.lines().nth(1).unwrap().replace(' ', "");
        let smaller = format!("setae.{small}");
        let numbers = json(dir.path(), &["run", &scene(name), "--set", &smaller, "--set", &own]);
        fs::write(at("array.toml"), by_law(name)).unwrap();
        let law = json(dir.path(), &["run", "array.toml", "--set", &smaller, "--out", name]);
        for pointer in ["/peak/load", "/peak/event", "/work_aJ", "/released_aJ", "/closed_forms/equal_sharing_nN"] {
            let number = |of: &Value| of.pointer(pointer).and_then(Value::as_f64).unwrap();
            let (one, other) = (number(&numbers), number(&law));
            assert!((one / other - 1.0).abs() < 1e-9, "{name} {pointer}: {one} {other}");
        }
        // what is written has the law in it, and needs no folder
        fs::rename(at("law"), at("elsewhere")).unwrap();
        let again = json(dir.path(), &["run", at(name).join("parameters.toml").to_str().unwrap()]);
        assert_eq!((&again["peak"], &again["events"]), (&law["peak"], &law["events"]));
        fs::rename(at("elsewhere"), at("law")).unwrap();
    }
    // a folder beside a scene, a number beside the law, and what is no law
    let refused = |set: &str, words: &str| is_refused(dir.path(), &["run", "array.toml", "--set", set], &[words]);
    refused("setae.law=none", "names none/seta_law.toml, which cannot be read");
    refused("setae.reach=5 um", "is given beside `law`, from which it follows");
    refused("setae.law=", "is empty");
    for (from, to, words) in [
        ("exit_nm = 5142.67", "exit_nm = 6142.67", "has been changed: its check sum is"),
        ("degree = 2", "degree = 3", "has been changed"),
        ("check = ", "# check = ", "has no check sum in its last line"),
    ] {
        fs::create_dir_all(at("bad")).unwrap();
        fs::write(at("bad").join(SETA_LAW), spring().replace(from, to)).unwrap();
        refused("setae.law=bad", words);
    }
}

#[test]
fn the_law_of_a_small_seta() {
    let dir = with_a_seta();
    let coarsen = ["coarsen", "seta.toml", "--degree", "4", "--out", "law"];
    let (status, text, trouble) = run(dir.path(), &coarsen);
    assert_eq!(status, Some(0), "{trouble}");
    assert!(text.contains("law of a seta") && text.contains("along 90.000 deg"), "{text}");
    let folder = dir.path().join("law");
    let summary: Value = serde_json::from_slice(&fs::read(folder.join("summary.json")).unwrap()).unwrap();
    let number = |pointer: &str| summary.pointer(pointer).and_then(Value::as_f64).unwrap();
    assert_eq!((&summary["law_of"], summary["paths"].as_u64()), (&Value::from("seta"), Some(7)));
    assert_eq!(summary["errors"], summary["degree_4"]);
    assert!(number("/degree_4/force") < number("/degree_2/force") && number("/exit_deg") - 90.0 < 1e-6);
    let (law, _) = parse_seta_law(&fs::read_to_string(folder.join(SETA_LAW)).unwrap()).unwrap();
    assert_eq!((law.degree, law.first_exit().distance), (4, number("/exit_nm")));
    // two tips, the one behind the other
    assert_eq!(law.sheets.iter().map(|sheet| sheet.tips).collect::<Vec<_>>(), [2, 1]);
    assert!(number("/errors/peak") < 0.02 && number("/errors/work") < 0.02 && number("/sheets/1/tips") == 1.0);
    let brittle = json(dir.path(), &["coarsen", "seta.toml", "--sheets", "1"]);
    assert!(brittle["errors"]["work"].as_f64().unwrap() > 0.1 && brittle["tolerance"].is_null(), "{brittle}");
    // the stated error is the largest of the table
    let mut rows = csv::Reader::from_path(folder.join("seta_paths.csv")).unwrap();
    let rows: Vec<Vec<f64>> = rows.deserialize().map(Result::unwrap).collect();
    // before the first loss both tips adhere; on a sheet is where the root is before its exit
    let whole = rows.iter().filter(|row| row[7] == 2.0);
    let force = |row: &Vec<f64>| law.response(0, [row[1], row[2]]).force;
    let off = |row: &Vec<f64>| (row[3] - force(row)[0]).hypot(row[4] - force(row)[1]);
    let largest = whole.map(off).fold(0.0, f64::max);
    for row in rows.iter().filter(|row| row[8] == 1.0) {
        let [along, normal] = law.response(1, [row[1], row[2]]).force;
        assert!((along - row[9]).abs() < 1e-9 && (normal - row[10]).abs() < 1e-9, "{row:?}");
    }
    assert!((largest / law.largest_force / number("/errors/force") - 1.0).abs() < 1e-9);
    // the picture has its pulls and its sheets
    let picture = fs::read_to_string(folder.join("seta_law.svg")).unwrap();
    assert!(picture.contains("at 15 deg") && picture.contains("at 105 deg") && picture.contains("law of 2 sheets"));
    // a patch takes it, a band does not
    let law = format!("law = \"{}\"", folder.display());
    for name in ["patch", "lamella"] {
        let text = by_law(name).replace("law = \"law\"", &law).replace("= 60", "= 6").replace("= 360", "= 4");
        fs::write(dir.path().join(format!("{name}-of-law.toml")), text.replace("\"1 um\"", "\"10 nm\"")).unwrap();
    }
    assert_eq!(json(dir.path(), &["run", "patch-of-law.toml"])["detached"], 36);
    is_refused(dir.path(), &["run", "lamella-of-law.toml"], &["a band takes a potential of degree 2"]);
    let refused = |arguments: &[&str], words: &str| {
        is_refused(dir.path(), &[&["coarsen", &scene("seta")][..], arguments].concat(), &[words]);
    };
    refused(&["--degree", "5"], "degree 5 is asked");
    refused(&["--sheets", "0"], "0 sheets are asked");
    refused(&["--tolerance", "0"], "a tolerance of 0 is asked");
    refused(&["--press", "1 nm"], "--press is of no use");
    refused(&["--set", "seta.tip_law=table"], "tips that follow the curve");
    for option in ["--degree", "--sheets"] {
        is_refused(dir.path(), &["coarsen", &scene("spatula"), option, "2"], &[&format!("{option} is of no use")]);
    }
    a_missing_law_is_made_once(dir.path());
}

/// A folder with the scenes of a seta of two tips, and of a patch that takes its law of the folder `law`.
fn with_a_seta() -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    let seta = fs::read_to_string(scene("seta")).unwrap().replace("forks = 8 ", "forks = 1 ");
    fs::write(dir.path().join("seta.toml"), seta.replace("# relative = 1e-6", "relative = 1e-3")).unwrap();
    let array = "[setae]\nrows = 3\ncolumns = 2\nlaw = \"law\"\nseta = \"seta.toml\"\n[patch]\n";
    fs::write(dir.path().join("patch.toml"), array).unwrap();
    dir
}

/// In a folder that has the law of its seta in `law`: another one is missing, and a sweep makes it.
fn a_missing_law_is_made_once(dir: &Path) {
    let varied = ["sweep", "patch.toml", "--vary", "setae.strength_scatter", "--values", "0.1,0.2", "--json"];
    let (status, text, trouble) = run(dir, &[&varied[..], &["--set", "setae.law=made"]].concat());
    assert_eq!(status, Some(0), "{trouble}");
    let said = "note: the law of the setae is made in made, of degree 4: 7 pulls of";
    assert_eq!(trouble.matches(said).count(), 1, "{trouble}");
    let swept: Value = serde_json::from_str(&text).unwrap();
    // it is that of peel coarsen
    for name in [SETA_LAW, "seta_paths.csv"] {
        let of = |folder: &str| fs::read_to_string(dir.join(folder).join(name)).unwrap();
        assert_eq!(of("law"), of("made"), "{name}");
    }
    // and either is read from now on
    for folder in ["law", "made"] {
        let law = format!("setae.law={folder}");
        let set = ["run", "patch.toml", "--set", "setae.strength_scatter=0.1", "--set", &law, "--json"];
        let (status, text, trouble) = run(dir, &set);
        assert_eq!((status, trouble.as_str()), (Some(0), ""));
        let found: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(found["peak"]["load"], swept["rows"][0]["peak_load"], "{swept}");
    }
    // what is written needs neither folder nor scene
    let out = ["run", "patch.toml", "--out", "out"];
    assert_eq!(run(dir, &out).0, Some(0));
    let alone = tempfile::tempdir().unwrap();
    fs::copy(dir.join("out/parameters.toml"), alone.path().join("alone.toml")).unwrap();
    let before: Value = serde_json::from_slice(&fs::read(dir.join("out/summary.json")).unwrap()).unwrap();
    assert_eq!(json(alone.path(), &["run", "alone.toml"])["peak"], before["peak"]);
    // of another seta it is refused with what differs
    let seta = fs::read_to_string(dir.join("seta.toml")).unwrap().replace("forks = 1 ", "forks = 2 ");
    fs::write(dir.join("seta.toml"), seta.replace("\"70 um\"", "\"71 um\"")).unwrap();
    let other = "`setae.law` is the law of another seta: seta.forks is 1.0 there, and 2.0 in the scene that `seta` names; different too: seta.shaft_length (nm)";
    is_refused(dir, &["run", "patch.toml"], &[other, "Name another folder"]);
}

#[test]
fn a_missing_law_that_cannot_be_made() {
    let dir = with_a_seta();
    let refused = |set: &[&str], words: &[&str]| {
        let sets: Vec<&str> = set.iter().flat_map(|set| ["--set", set]).collect();
        is_refused(dir.path(), &[&["run", "patch.toml"][..], &sets].concat(), words);
        assert!(!dir.path().join("law").exists());
    };
    refused(&["setae.seta=none.toml"], &["`setae.seta` names none.toml, which cannot be read"]);
    refused(&["setae.seta=patch.toml"], &["names patch.toml, which is not the scene of a seta"]);
    refused(&["setae.seta="], &["`setae.seta` is empty"]);
    let write = |name: &str, text: &str| fs::write(dir.path().join(name), text).unwrap();
    let seta = fs::read_to_string(dir.path().join("seta.toml")).unwrap();
    write("bad.toml", &seta.replace("forks = 1 ", "forks = -1 "));
    refused(&["setae.seta=bad.toml"], &["names bad.toml, and there bad.toml, line 7: `seta.forks` is -1"]);
    write("table.toml", &seta.replace("forks = 1 ", "tip_law = \"table\"\nforks = 1 "));
    refused(&["setae.seta=table.toml"], &["made of tips that follow the curve", "Give seta.tip_law = \"curve\"."]);
    let patch = fs::read_to_string(dir.path().join("patch.toml")).unwrap();
    write("patch.toml", &patch.replace("law = \"law\"\n", ""));
    refused(&[], &["`setae.seta` is given, and setae follow numbers"]);
    write("patch.toml", &patch.replace("seta = \"seta.toml\"\n", ""));
    refused(
        &[],
        &[
            "`setae.law` names law/seta_law.toml, which cannot be read",
            "peel coarsen SETA.toml",
            "seta = \"SETA.toml\"",
        ],
    );
    // a folder of something else is left alone
    write("patch.toml", &patch);
    fs::create_dir(dir.path().join("full")).unwrap();
    write("full/notes.txt", "mine");
    let full = ["run", "patch.toml", "--set", "setae.law=full"];
    let (status, _, trouble) = run(dir.path(), &full);
    assert!(
        status != Some(0) && trouble.contains("full exists, is not empty and is not changed"),
        "{status:?} {trouble}"
    );
}
