//! What needs no computation: help, and input that is refused.

use super::{bench, peel, sweep};
use peelkit_scene::{KEYS, Key};
use std::fs;
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;
use tempfile::tempdir;

#[test]
fn help_is_enough_to_work_from() {
    let dir = bench();
    for (args, most) in [(vec!["--help"], 60), (vec!["run", "--help"], 150), (vec!["sweep", "--help"], 140)] {
        let help = peel(dir.path(), &args);
        assert_eq!((help.status, help.stderr.as_str()), (0, ""));
        // the keys stand in `peel keys`, which every help names
        for part in ["strip.length", "GPa", "Exit status", "Examples", "peel keys"] {
            assert!(help.stdout.contains(part), "{part} is not in the help of {args:?}");
        }
        let lines = help.stdout.lines().count();
        assert!(lines <= most, "{args:?}: {lines} lines");
        let widest = help.stdout.lines().map(|line| line.chars().count()).max();
        assert!(widest <= Some(120), "{args:?}: {widest:?} columns");
    }
}

#[test]
fn usage_errors_are_bad_input() {
    let dir = bench();
    peel(dir.path(), &[]).is_bad_input(&["Usage"]);
    peel(dir.path(), &["pull"]).is_bad_input(&["pull"]);
    peel(dir.path(), &["run"]).is_bad_input(&["SCENE"]);
    peel(dir.path(), &["run", "strip.toml", "--colour"]).is_bad_input(&["--colour"]);
    peel(dir.path(), &["run", "strip.toml", "--set", "strip.length"]).is_bad_input(&["KEY=VALUE"]);
    peel(dir.path(), &["sweep", "strip.toml", "--vary", "strip.length"]).is_bad_input(&["--from", "--to", "--points"]);
}

#[test]
fn a_scene_that_cannot_be_read_is_bad_input() {
    let dir = bench();
    peel(dir.path(), &["run", "none.toml"]).is_bad_input(&["none.toml", "peel new"]);
    peel(dir.path(), &["run", "."]).is_bad_input(&["cannot read the scene", "it is a folder", ".toml"]);
    fs::write(dir.path().join("long.toml"), vec![b'#'; 10_000_001]).unwrap();
    peel(dir.path(), &["run", "long.toml"]).is_bad_input(&["it has more than 10 MB"]);
    #[cfg(unix)]
    {
        peel(dir.path(), &["run", "/dev/zero"]).is_bad_input(&["cannot read the scene /dev/zero"]);
        assert!(Command::new("mkfifo").arg(dir.path().join("pipe")).status().unwrap().success());
        peel(dir.path(), &["run", "pipe"]).is_bad_input(&["it is no file", "in 10 s"]);
    }
    fs::write(dir.path().join("latin.toml"), b"# first\ntitle = \"na\xefve\"").unwrap();
    peel(dir.path(), &["run", "latin.toml"]).is_bad_input(&["latin.toml, line 2", "UTF-8"]);
    fs::write(dir.path().join("empty.toml"), "").unwrap();
    peel(dir.path(), &["run", "empty.toml"]).is_bad_input(&["empty.toml, line 1", "[strip]"]);
    assert!(!dir.path().join("out").exists(), "nothing is written for a scene that cannot be used");
}

/// Data, and the folder of a law of tips: what is no file is refused before it is opened.
#[cfg(unix)]
#[test]
fn data_that_are_no_file_are_refused_at_once() {
    let dir = bench();
    for name in ["strip-fit.toml", "seta.toml"] {
        let scene = format!("{}/../../scenes/{name}", env!("CARGO_MANIFEST_DIR"));
        fs::copy(scene, dir.path().join(name)).unwrap();
    }
    fs::create_dir(dir.path().join("tip")).unwrap();
    for pipe in ["pipe", "tip/summary.json"] {
        assert!(Command::new("mkfifo").arg(dir.path().join(pipe)).status().unwrap().success());
    }
    const SAID: &str = "it is no file of at most 67108864 bytes";
    for data in ["pipe", "/dev/zero"] {
        peel(dir.path(), &["fit", "strip-fit.toml", "--data", data]).is_bad_input(&[data, SAID]);
    }
    let by_table = ["run", "seta.toml", "--set", "seta.tip_law=table", "--set", "seta.tip_table=tip"];
    peel(dir.path(), &by_table).is_bad_input(&["summary.json", SAID]);
    let table = ["run", "strip-100nm.toml", "--set", "substrate.shape=profile", "--set", "substrate.table=pipe"];
    peel(dir.path(), &table).is_bad_input(&["pipe, which is no file of at most 1048576 bytes"]);
}

/// Every key that is a number, with numbers that no model has: an answer or a refusal in seconds, in 2 GB, and never the end of the program by a
/// signal or a panic.
#[cfg(unix)]
#[test]
fn a_number_of_any_size_in_any_key_is_answered_or_refused() {
    let keys: Vec<&Key> = KEYS.iter().filter(|key| key.is_numeric() || key.is_count()).collect();
    let next = AtomicUsize::new(0);
    let take = || keys.get(next.fetch_add(1, Ordering::Relaxed));
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| std::iter::from_fn(take).for_each(|key| is_answered_or_refused(key)));
        }
    });
}

#[cfg(unix)]
fn is_answered_or_refused(key: &Key) {
    let (command, scene) = match key.table {
        "spatula" => ("run", "spatula"),
        "profile" => ("run", "profile"),
        "seta" => ("run", "seta"),
        "solid" => ("run", "solid-strip"),
        "setae" | "lamella" | "toe" => ("run", "toe"),
        "patch" => ("run", "patch"),
        "time" => ("run", "strip-at-a-rate"),
        "friction" => ("run", "strip-friction"),
        "substrate" => ("run", "strip-rough"),
        "fit" => ("fit", "strip-fit"),
        "optimise" => ("optimise", "strip-optimised"),
        "uncertainty" => ("uncertainty", "strip-uncertain"),
        _ => ("run", "strip-100nm"),
    };
    let scenes = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes");
    for number in ["1e300", "-1e300", "1e-300", "nan", "inf", &"7".repeat(400)] {
        let set = format!("{}={number} {}", key.path(), key.usual_unit());
        let mut limited = Command::new("sh");
        limited.args(["-c", "ulimit -v 2000000; exec \"$@\"", "sh", env!("CARGO_BIN_EXE_peel"), command]);
        limited.arg(format!("{scenes}/{scene}.toml")).args(["--json", "--set", set.trim()]);
        if key.path() != "bounds.time" {
            limited.args(["--set", "bounds.time=1 s"]);
        }
        if command == "fit" {
            limited.args(["--data", &format!("{scenes}/strip-fit.csv")]);
        }
        let began = Instant::now();
        let output = limited.current_dir(std::env::temp_dir()).output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(matches!(output.status.code(), Some(0 | 2 | 3)), "{set}: {:?}: {said}", output.status);
        assert!(!said.contains("panicked"), "{set}: {said}");
        assert!(output.status.code() != Some(2) || said.contains("help: "), "{set} has no remedy: {said}");
        assert!(began.elapsed().as_secs() < 60, "{set} took {:?}", began.elapsed());
    }
}

/// What no computer holds is refused by its key before anything of its size is made: in a second, and where memory is limited.
#[test]
fn lengths_that_no_computer_holds_are_refused_at_once() {
    let dir = bench();
    for (set, parts) in [
        ("strip.length=1e300 nm", ["`strip.length` is 1e300 nm", "out of range: the largest is 1e30"]),
        (
            "strip.length=1e25 nm",
            ["`strip.length` makes the beam 4.6e24 process zones long", "at most 2e6 are resolved"],
        ),
        ("strip.length=1e12 nm", ["`strip.length` makes the beam 4.6e11 process zones long", "shorter beam"]),
        ("strip.height=1e300 nm", ["`strip.height` is 1e300 nm", "out of range: the largest is 1e30"]),
        ("strip.width=1e-300 nm", ["`strip.width` is 1e-300 nm", "out of range: the least is 1e-30"]),
    ] {
        let began = Instant::now();
        peel(dir.path(), &["run", "strip-100nm.toml", "--set", set]).is_bad_input(&parts);
        assert!(began.elapsed().as_secs() < 5, "{set}");
    }
    let thick = peel(dir.path(), &["run", "strip-100nm.toml", "--json", "--set", "strip.height=1e29 nm"]);
    assert!(!thick.stderr.contains("NaN") && !thick.stdout.contains("NaN"), "{}", thick.stderr);
}

#[test]
fn a_mistake_in_a_scene_is_shown_where_it_stands() {
    let dir = bench();
    let text = fs::read_to_string(dir.path().join("strip.toml")).unwrap();
    let line = 1 + text.lines().position(|line| line.starts_with("length")).unwrap();
    let place = format!("bad.toml, line {line}: ");
    for (wrong, parts) in [
        ("length = 200", ["`strip.length` is 200, a number without a unit", "\"200 nm\""]),
        ("length = \"200 GPa\"", ["`strip.length` is \"200 GPa\": GPa measures a pressure", "for example length ="]),
        ("length = 200 nm", ["`length` is not TOML", "length = \"100 nm\""]),
        ("lenght = \"200 nm\"", ["`strip.lenght` is not a key", "Did you mean `length`?"]),
        ("length = \"-1 nm\"", ["`strip.length` is -1 nm", "above zero"]),
        ("length = \"nan nm\"", ["`strip.length` is NaN nm", "above zero"]),
    ] {
        fs::write(dir.path().join("bad.toml"), text.replace("length = \"200 nm\"", wrong)).unwrap();
        for command in [&["run", "bad.toml"][..], &["run", "bad.toml", "--json"]] {
            peel(dir.path(), command).is_bad_input(&[&place, parts[0], parts[1], wrong]);
        }
    }
}

#[test]
fn a_mistake_in_an_override_is_bad_input() {
    let dir = bench();
    let set = |text: &str| peel(dir.path(), &["run", "strip.toml", "--set", text]);
    set("strip.length=100").is_bad_input(&["--set strip.length=100", "without a unit", "\"100 nm\""]);
    set("length=100nm").is_bad_input(&["--set length=100nm", "Did you mean `strip.length`?"]);
    set("strip.poissons_ratio=0.5").is_bad_input(&["`strip.poissons_ratio` is 0.5", "between -1 and 0.5"]);
    set("grip.rotation=fix").is_bad_input(&["`grip.rotation` is \"fix\"", "\"free\" or \"fixed\""]);
}

#[test]
fn a_sweep_that_makes_no_sense_is_bad_input() {
    let dir = bench();
    let dir = dir.path();
    sweep(dir, "strip.lengh", "1 nm", "2 nm", "2").is_bad_input(&["--vary strip.lengh", "`strip.length`"]);
    sweep(dir, "colour", "1 nm", "2 nm", "2").is_bad_input(&["--vary colour", "strip.height"]);
    sweep(dir, "grip.rotation", "1", "2", "2").is_bad_input(&["--vary grip.rotation is not a number", "strip.length"]);
    sweep(dir, "strip.length", "1", "2 nm", "2").is_bad_input(&["--from for strip.length", "without a unit"]);
    sweep(dir, "strip.length", "1 nm", "2 GPa", "2").is_bad_input(&["--to for strip.length", "measures a pressure"]);
    sweep(dir, "strip.length", "0 nm", "2 nm", "2").is_bad_input(&["--from for strip.length", "above zero"]);
    sweep(dir, "strip.length", "1 nm", "nan nm", "2").is_bad_input(&["--to for strip.length", "not a finite number"]);
    sweep(dir, "strip.poissons_ratio", "-0.5", "0.5", "2").is_bad_input(&["--to for strip.poissons_ratio", "0.5"]);
    sweep(dir, "strip.poissons_ratio", "-0.5 nm", "0.4", "2").is_bad_input(&["--from", "not a number"]);
    sweep(dir, "strip.length", "1 nm", "2 nm", "0").is_bad_input(&["--points", "1..="]);
    sweep(dir, "strip.length", "1 nm", "2 nm", "-3").is_bad_input(&["-3"]);
    sweep(dir, "bounds.points", "1", "2", "3").is_bad_input(&["bounds.points between --from and --to", "1.5"]);
    let log = ["sweep", "strip.toml", "--vary", "strip.poissons_ratio", "--from", "-0.5", "--to", "0.4"];
    let log = [&log[..], &["--points", "3", "--log"]].concat();
    peel(dir, &log).is_bad_input(&["--from -0.5 is not above zero", "--log"]);
}

#[test]
fn a_sweep_that_would_change_nothing_is_refused() {
    let dir = bench();
    let vary = |vary: &str, [from, to]: [&str; 2], sets: &[&str]| {
        let sets = sets.iter().flat_map(|set| ["--set", set]);
        let args = ["sweep", "strip-100nm.toml", "--vary", vary, "--from", from, "--to", to, "--points", "2"];
        peel(dir.path(), &args.into_iter().chain(sets).collect::<Vec<_>>())
    };
    vary("strip.length", ["50 nm", "60 nm"], &["strip.length=70 nm"])
        .is_bad_input(&["--set strip.length=70 nm sets the key that --vary varies", "Remove the --set"]);
    vary("grip.stiffness", ["1 N/m", "2 N/m"], &[]).is_bad_input(&[
        "--vary grip.stiffness would change no result",
        "only the displacement-controlled test uses the spring",
        "--observed",
    ]);
    let cohesive = ["adhesion.law=bilinear", "adhesion.work=30 mN/m", "adhesion.strength=50 MPa"];
    vary("adhesion.hamaker_constant", ["1e-19 J", "2e-19 J"], &cohesive).is_bad_input(&[
        "--vary adhesion.hamaker_constant would change no result",
        "adhesion.work or adhesion.strength",
    ]);
    vary("friction.coefficient", ["0.1", "0.2"], &[]).is_bad_input(&["friction.coefficient", "has no strength"]);
    assert!(!dir.path().join("out").exists());
}

#[test]
fn a_sweep_that_has_changed_nothing_says_so() {
    let dir = bench();
    let args = ["sweep", "strip-100nm.toml", "--set", "accuracy.relative=1e-3", "--points", "2", "--vary"];
    let sweep = |rest: &[&str]| peel(dir.path(), &[&args[..], rest].concat());
    let none = sweep(&["bounds.points", "--from", "5000", "--to", "6000", "--json"]);
    let remark = "bounds.points has no effect here: all 2 values give the same results, to the last digit";
    assert_eq!((none.status, &none.json()["remarks"][0]), (0, &remark.into()));
    let one = sweep(&["strip.width", "--from", "1 nm", "--to", "2 nm", "--json"]);
    assert_eq!((one.status, one.json().get("remarks")), (0, None));
}

#[test]
fn help_in_layers() {
    let dir = bench();
    for command in [
        "run",
        "sweep",
        "collect",
        "plot",
        "accuracy",
        "verify",
        "new",
        "keys",
        "figures",
        "schema",
        "completions",
        "man",
        "cite",
    ] {
        let help = peel(dir.path(), &[command, "-h"]).stdout;
        let (lines, widest) = (help.lines().count(), help.lines().map(|line| line.chars().count()).max());
        assert!(lines <= 24, "{command} -h has {lines} lines");
        assert!(widest <= Some(100), "{command} -h has {widest:?} columns:\n{help}");
    }
    let long = peel(dir.path(), &["run", "--help"]).stdout;
    assert!(long.lines().count() > 60 && !long.contains("youngs_modulus ="), "{long}");
}

#[test]
fn keys_are_listed_a_line_each() {
    let dir = bench();
    let keys = |args: &[&str]| peel(dir.path(), &[&["keys"], args].concat());
    let all = keys(&[]).stdout;
    for key in peelkit_scene::KEYS {
        assert!(
            all.lines().any(|line| line.starts_with(&format!("{} ", key.name)) && line.ends_with(key.about)),
            "{}",
            key.path()
        );
    }
    let widest = all.lines().map(|line| line.chars().count()).max();
    assert!(widest <= Some(120), "{widest:?} columns");
    let drive = keys(&["drive"]).stdout;
    let angle = drive.lines().find(|line| line.starts_with("angle ")).unwrap();
    assert_eq!(
        angle.split("  ").map(str::trim).filter(|cell| !cell.is_empty()).collect::<Vec<_>>()[..4],
        ["angle", "deg", "90 deg", "0 to 180"]
    );
    assert!(!drive.contains("hamaker_constant"));
    let adhesion = keys(&["[adhesion]"]).stdout;
    assert!(adhesion.contains("law: body-force, surface-traction, bilinear"), "{adhesion}");
    assert!(keys(&["bounds"]).stdout.contains("60 s"));
    assert!(keys(&["top"]).stdout.contains("title"));
    assert!(keys(&["profile"]).stdout.contains("Each piece needs length, width and height"));
    keys(&["stripe"]).is_bad_input(&["stripe is not a table of a scene", "strip, spatula, profile"]);
}

/// Each key of a scene stands in the schema with its meaning; what it takes and refuses is judged by `python/tests/test_schema.py`.
#[test]
fn schema_describes_every_key() {
    let dir = tempdir().unwrap();
    let made = peel(dir.path(), &["schema"]);
    assert_eq!((made.status, made.stderr.as_str()), (0, ""));
    assert!(made.stdout.contains("#:schema peel.schema.json"), "{}", made.stdout);
    let text = fs::read_to_string(dir.path().join("peel.schema.json")).unwrap();
    let schema: serde_json::Value = serde_json::from_str(&text).unwrap();
    for key in peelkit_scene::KEYS {
        let table = if key.table.is_empty() { &schema } else { &schema["properties"][key.table] };
        let about = table["properties"][key.name]["description"].as_str().unwrap_or_default();
        assert!(about.starts_with(key.about), "{}: {about}", key.path());
    }
    assert_eq!(peel(dir.path(), &["schema", "no/such/folder/x"]).status, 1);
}

/// What the words of the command are is asked of clap; here, that each shell is given them and each command its page.
#[test]
fn shells_and_the_manual_are_served() {
    let dir = tempdir().unwrap();
    for shell in ["bash", "zsh", "fish", "powershell"] {
        let made = peel(dir.path(), &["completions", shell]);
        assert_eq!((made.status, made.stderr.as_str()), (0, ""), "{shell}");
        assert!(["uncertainty", "out-of-plane"].iter().all(|word| made.stdout.contains(word)), "{shell}");
    }
    peel(dir.path(), &["completions", "cmd"]).is_bad_input(&["bash", "powershell"]);
    assert_eq!(peel(dir.path(), &["man", "pages"]).status, 0);
    for page in ["peel.1", "peel-run.1", "peel-uncertainty.1"] {
        let text = fs::read_to_string(dir.path().join("pages").join(page)).unwrap();
        assert!(text.contains(".SH"), "{page}");
    }
    fs::write(dir.path().join("file"), "").unwrap();
    assert_eq!(peel(dir.path(), &["man", "file"]).status, 1);
}

#[test]
fn new_names_its_kinds_and_writes_each() {
    let dir = tempdir().unwrap();
    let list = peel(dir.path(), &["new", "--list"]);
    assert_eq!((list.status, list.stderr.as_str()), (0, ""));
    let kinds: Vec<&str> = list
        .stdout
        .lines()
        .filter_map(|line| line.strip_prefix("  ")?.split_once("  "))
        .map(|(kind, _)| kind)
        .collect();
    assert!(kinds.len() >= 9 && kinds.starts_with(&["strip", "spatula", "profile"]), "{kinds:?}");
    for kind in kinds {
        assert_eq!(peel(dir.path(), &["new", "--kind", kind]).status, 0, "{kind}");
        let text = fs::read_to_string(dir.path().join(format!("{kind}.toml"))).unwrap();
        peelkit_scene::Scene::parse_any(kind, &text, &[]).unwrap();
    }
    assert!(!dir.path().join("out").exists());
    assert_eq!(peel(dir.path(), &["new", "other", "--body", "spatula"]).status, 0);
    peel(dir.path(), &["new", "--kind", "hair"]).is_bad_input(&["--kind hair is no kind of scene", "strip, spatula"]);
}

#[test]
fn new_writes_a_scene_that_is_right_and_overwrites_nothing() {
    let dir = tempdir().unwrap();
    let new = |args: &[&str]| peel(dir.path(), &[&["new"], args].concat());
    for (args, file) in [(&[][..], "strip.toml"), (&["mine"], "mine.toml"), (&["v1.2"], "v1.2.toml")] {
        let made = new(args);
        assert_eq!((made.status, made.stderr.as_str()), (0, ""));
        assert!(made.stdout.contains(file), "{}", made.stdout);
        let text = fs::read_to_string(dir.path().join(file)).unwrap();
        assert_eq!(text, format!("#:schema peel.schema.json\n{}", include_str!("../../../scenes/strip.toml")));
    }
    let schema = fs::read_to_string(dir.path().join("peel.schema.json")).unwrap();
    assert_eq!(schema, peel(dir.path(), &["schema", "-"]).stdout);
    fs::write(dir.path().join("peel.schema.json"), "{}").unwrap();
    assert!(!new(&["another"]).stdout.contains("wrote peel.schema.json"));
    assert_eq!(fs::read_to_string(dir.path().join("peel.schema.json")).unwrap(), "{}");
    fs::write(dir.path().join("mine.toml"), "kept").unwrap();
    for name in ["mine", "mine.toml"] {
        new(&[name]).is_bad_input(&["mine.toml exists", "peel new NAME"]);
    }
    assert_eq!(fs::read_to_string(dir.path().join("mine.toml")).unwrap(), "kept");
    assert_eq!(new(&["no/such/folder/x"]).status, 1);
}
