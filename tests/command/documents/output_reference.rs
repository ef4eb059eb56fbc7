//! The tables of the pages in `docs/reference/outputs/` are made of the records of `peelkit_report`, whose keys are held against what the command writes.

use super::{hold, pages, row, text, with_part};
use peelkit_report::{OutputKey, outputs, paths};
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

#[test]
fn the_output_reference_is_that_of_the_lists() {
    let pages = pages("outputs");
    let mut texts: Vec<String> = pages.iter().map(|page| text(page)).collect();
    for output in outputs() {
        let begin = format!("<!-- {}: begin -->", output.name);
        let mut places = texts.iter_mut().filter(|text| text.contains(&begin));
        let (Some(place), None) = (places.next(), places.next()) else { panic!("not on one page: {begin}") };
        let mut part = row(&[output.parts, "unit", "meaning"]) + "|---|---|---|\n";
        for key in in_order_of_reading(output.keys) {
            let like = key.like.as_ref().map(|other| format!("; keys as of `{other}`")).unwrap_or_default();
            part += &row(&[&format!("`{}`", key.path), key.unit(), &format!("{}{like}", key.about)]);
        }
        *place = with_part(place, output.name, &part);
    }
    for (page, text) in pages.iter().zip(&texts) {
        hold(page, text);
    }
}

/// Of summary.json three objects are described elsewhere than they stand in the file, beside what they belong to: behind which one.
const MOVED: [(&str, &str); 3] =
    [("largest_computed_force", "initiation_peak"), ("derived", "accuracy"), ("observed", "sensitivities")];

fn in_order_of_reading(mut keys: Vec<OutputKey>) -> Vec<OutputKey> {
    for (object, before) in MOVED {
        let is_of = |key: &OutputKey, name: &str| key.path.split(['.', '[']).next() == Some(name);
        if keys.iter().any(|key| is_of(key, before)) {
            let (moved, mut others): (Vec<_>, Vec<_>) = keys.into_iter().partition(|key| is_of(key, object));
            let place = others.iter().rposition(|key| is_of(key, before)).map_or(0, |place| place + 1);
            others.splice(place..place, moved);
            keys = others;
        }
    }
    keys
}

/// The keys of what is called so.
fn keys(name: &str) -> Vec<OutputKey> {
    outputs().into_iter().find(|output| output.name == name).unwrap_or_else(|| panic!("no output {name}")).keys
}

const ROUGHLY: &[&str] = &["--set", "accuracy.relative=1e-3"];
const FIXED: &[&str] = &["--set", "grip.rotation=fixed"];
const SHORT: &[&str] = &["--set", "strip.length=100 nm"];
const STEPS: &[&str] = &["--set", "drive.steps=[\"press 0.1 nm\"]"];
const SOFT: &[&str] = &["--set", "strip.length=200 nm", "--set", "strip.bending_stiffness_factor=0.01"];
const CUT: &[&str] = &["--set", "bounds.displacement=0.1 nm"];
/// Past the peak of the sideways pull, where its limit points are.
const PAST_PEAK: &[&str] = &["--set", "bounds.displacement=12.775 nm"];
/// A step that jumps.
const JUMPING: &[&str] = &["--set", "drive.steps=[\"lift 50 nm\"]", "--set", "bounds.displacement=0.1 nm"];
/// A short pull behind a step.
const LIFTED: &[&str] = &["--set", "drive.steps=[\"lift 0.02 nm\"]", "--set", "bounds.displacement=0.1 nm"];
/// Past a branch point of the symmetric path.
const UPWARD: &[&str] = &["--set", "drive.angle=90 deg", "--set", "bounds.displacement=0.2 nm"];
/// With a peak, a jump, and an end on the planar path.
const BRANCH: &[&str] = &["--branch", "--set", "strip.width=40 nm"];

/// Comes back before the pull, and what it has opened does not heal.
const CLOSED: &[&str] =
    &["--set", "adhesion.healing=false", "--set", "drive.steps=[\"lift 1.2 mm\", \"press 0.6 mm\"]"];

/// A film that yields, for as long as it takes its front to go on by a process zone
const YIELDING: &[&str] =
    &["--set", "strip.yield_strength=60 MPa", "--set", "accuracy.relative=1e-2", "--set", "bounds.displacement=0.6 mm"];

/// Runs that together have every key.
const RUNS: &[(&str, &[&[&str]])] = &[
    ("strip-100nm", &[&["--observed", "--at", "u=30 nm"]]),
    ("strip-100nm", &[BRANCH]),
    ("strip-100nm", &[&["--at", "u=30 nm", "--event", "P > 0.04 nN"]]),
    ("strip-100nm", &[&["--sensitivities"]]),
    ("strip-100nm", &[FIXED]),
    ("strip-100nm", &[STEPS]),
    ("strip-100nm", &[SOFT]),
    ("strip-100nm", &[CUT]),
    ("strip-rough", &[SHORT]),
    ("strip-sideways", &[PAST_PEAK]),
    ("strip-sideways", &[UPWARD]),
    ("strip-rolled", &[CUT]),
    ("double-cantilever", &[CLOSED]),
    ("strip-100nm", &[JUMPING]),
    ("tape", &[YIELDING]),
    ("strip-auto", &[]),
    ("strip-auto", &[&["--set", "terms=all"]]),
];

fn peel(arguments: &[&str], folder: &Path) -> std::process::Output {
    let output = Command::new(env!("CARGO_BIN_EXE_peel")).args(arguments).current_dir(folder).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    output
}

/// The paths of the keys of an object, `parameters` but for its name left out.
fn keys_of(value: &Value, path: &str, found: &mut BTreeSet<String>) {
    match value {
        Value::Object(entries) => {
            for (name, value) in entries {
                let path = if path.is_empty() { name.clone() } else { format!("{path}.{name}") };
                found.insert(path.clone());
                if path != "parameters" {
                    keys_of(value, &path, found);
                }
            }
        }
        Value::Array(items) => items.iter().for_each(|item| keys_of(item, &format!("{path}[]"), found)),
        _ => {}
    }
}

fn assert_described(found: &BTreeSet<String>, of: &str) {
    let described: BTreeSet<String> = paths(&keys(of)).into_iter().collect();
    let undescribed: Vec<_> = found.difference(&described).collect();
    assert!(undescribed.is_empty(), "{of}: written, and of no record: {undescribed:?}");
    let unseen: Vec<_> = described.difference(found).collect();
    assert!(unseen.is_empty(), "{of}: of a record, and in no output: {unseen:?}");
}

#[test]
fn every_key_of_a_summary_is_described() {
    let folder = tempfile::tempdir().unwrap();
    let mut found = BTreeSet::new();
    for (scene, arguments) in RUNS {
        let scene = format!("{}/scenes/{scene}.toml", super::ROOT);
        let arguments: Vec<&str> = arguments.iter().copied().flatten().copied().collect();
        let arguments = [&["run", &scene, "--json"], ROUGHLY, &arguments].concat();
        let json: Value = serde_json::from_slice(&peel(&arguments, folder.path()).stdout).unwrap();
        keys_of(&json, "", &mut found);
    }
    assert_described(&found, "summary.json");
}

#[test]
fn every_column_is_described() {
    let folder = tempfile::tempdir().unwrap();
    let scene = format!("{}/scenes/strip-100nm.toml", super::ROOT);
    let vary = ["sweep", &scene, "--vary", "strip.height", "--values", "10 nm, 11 nm"];
    let twice = ["--vary", "strip.length", "--values", "100 nm"];
    peel(&[&["run", &scene, "--out", "run", "--observed", "--states", "0"], ROUGHLY, FIXED].concat(), folder.path());
    peel(&[&vary[..], &twice, &["--out", "sweep"], ROUGHLY].concat(), folder.path());
    // in space the tables of the path have all their columns
    let sideways = format!("{}/scenes/strip-sideways.toml", super::ROOT);
    peel(&[&["run", &sideways, "--out", "sideways", "--states", "0"], ROUGHLY, PAST_PEAK].concat(), folder.path());
    peel(&[&["run", &scene, "--out", "branch"], ROUGHLY, BRANCH].concat(), folder.path());
    peel(&[&["run", &sideways, "--out", "steps"], ROUGHLY, LIFTED].concat(), folder.path());
    let branch = std::fs::read_to_string(folder.path().join("branch/branch.csv")).unwrap();
    let curve = keys("curve.csv");
    let of_curve = |column: &str| curve.iter().any(|key| key.path == column);
    assert!(
        branch.lines().next().unwrap().split(',').all(of_curve),
        "the columns of branch.csv are those of curve.csv"
    );
    for (file, name) in [
        ("sideways/curve.csv", "curve.csv"),
        ("sideways/limit_points.csv", "limit_points.csv"),
        ("steps/steps.csv", "steps.csv"),
        ("run/observed.csv", "observed.csv"),
        ("run/states.csv", "states.csv"),
        ("sideways/states.csv", "states.csv in space"),
        ("sweep/sweep.csv", "sweep.csv"),
    ] {
        let table = std::fs::read_to_string(folder.path().join(file)).unwrap();
        let columns = table.lines().next().unwrap().split(',').map(str::to_owned);
        // the values once more, under the names of their keys
        let found = columns.filter(|column| !column.starts_with("strip.")).collect();
        assert_described(&found, name);
    }

    let mut found = BTreeSet::new();
    for follow in [&twice[..], &["--follow", "peak"]] {
        let json = peel(&[&vary[..], &["--json"], ROUGHLY, follow].concat(), folder.path()).stdout;
        let json: Value = serde_json::from_slice(&json).unwrap();
        found.extend(json.as_object().unwrap().keys().cloned());
    }
    // one is told of where there is something to tell, the other where the second key has a unit
    found.extend(["remarks", "unit_2"].map(str::to_owned));
    assert_described(&found, "peel sweep --json");
}

/// Two parameters that a curve without its peak does not tell apart have a profile.
#[test]
fn every_output_of_a_fit_is_described() {
    let folder = tempfile::tempdir().unwrap();
    let (scene, data) =
        (format!("{}/scenes/strip-fit.toml", super::ROOT), format!("{}/scenes/strip-fit.csv", super::ROOT));
    let lines: Vec<String> = std::fs::read_to_string(data).unwrap().lines().map(str::to_owned).collect();
    let late: Vec<String> = lines[..2].iter().chain(&lines[24..]).cloned().collect();
    std::fs::write(folder.path().join("late.csv"), late.join("\n")).unwrap();
    let both = "fit.parameters=[\"adhesion.hamaker_constant\", \"adhesion.equilibrium_distance\"]";
    let known = ["--set", "strip.youngs_modulus=2 GPa", "--set", "fit.displacement_zero=1.3 nm", "--set", both];
    peel(&[&["fit", &scene, "--data", "late.csv", "--out", "fit"], ROUGHLY, &known].concat(), folder.path());
    let json: Value = serde_json::from_slice(&std::fs::read(folder.path().join("fit/summary.json")).unwrap()).unwrap();
    let mut found = BTreeSet::new();
    keys_of(&json, "", &mut found);
    let curves = format!("fit.curves=[{{ data = \"{}/scenes/strip-fit.csv\" }}]", super::ROOT);
    let json = peel(&[&["fit", &scene, "--json", "--set", &curves], ROUGHLY].concat(), folder.path()).stdout;
    keys_of(&serde_json::from_slice(&json).unwrap(), "", &mut found);
    assert_described(&found, "peel fit");
    for (file, name) in [("fit.csv", "fit.csv"), ("profiles.csv", "profiles.csv")] {
        let table = std::fs::read_to_string(folder.path().join("fit").join(file)).unwrap();
        assert_described(&table.lines().next().unwrap().split(',').map(str::to_owned).collect(), name);
    }
}

#[test]
fn every_output_of_a_coarsening_is_described() {
    let folder = tempfile::tempdir().unwrap();
    let scene = format!("{}/scenes/spatula.toml", super::ROOT);
    let few = ["--tolerance", "0.05", "--press", "1 nm", "--rotation", "-1 deg,1 deg", "--lateral", "-1 nm,1 nm"];
    peel(&[&["coarsen", &scene, "--out", "tip", "--set", "grip.horizontal=fixed"], &few[..]].concat(), folder.path());
    let json = std::fs::read(folder.path().join("tip/summary.json")).unwrap();
    let mut found = BTreeSet::new();
    keys_of(&serde_json::from_slice(&json).unwrap(), "", &mut found);
    assert_described(&found, "peel coarsen");
    for (file, name) in [("tip_law.csv", "tip_law.csv"), ("tip_limits.csv", "tip_limits.csv")] {
        let table = std::fs::read_to_string(folder.path().join("tip").join(file)).unwrap();
        assert_described(&table.lines().next().unwrap().split(',').map(str::to_owned).collect(), name);
    }
}

#[test]
fn every_key_of_an_optimisation_is_described() {
    let folder = tempfile::tempdir().unwrap();
    let scene = format!("{}/scenes/strip-optimised.toml", super::ROOT);
    let few = [
        "optimise.values=5",
        "optimise.evaluations=3",
        "optimise.neighbours=2",
        "optimise.starts=1",
        "optimise.check=true",
    ];
    let few: Vec<&str> = few.iter().flat_map(|set| ["--set", set]).collect();
    peel(&[&["optimise", &scene, "--out", "out"], ROUGHLY, &few].concat(), folder.path());
    let json = std::fs::read(folder.path().join("out/summary.json")).unwrap();
    let mut found = BTreeSet::new();
    keys_of(&serde_json::from_slice(&json).unwrap(), "", &mut found);
    assert_described(&found, "peel optimise --json");
    let history = std::fs::read_to_string(folder.path().join("out/history.csv")).unwrap();
    let columns = history.lines().next().unwrap().split(',').map(str::to_owned).collect();
    assert_described(&columns, "history.csv");
}

#[test]
fn every_key_and_column_of_an_uncertain_peel_is_described() {
    let folder = tempfile::tempdir().unwrap();
    let scene = format!("{}/scenes/strip-uncertain.toml", super::ROOT);
    let correlated =
        "uncertainty.correlations=[{ keys = [\"strip.height\", \"strip.youngs_modulus\"], coefficient = 0.3 }]";
    let few = ["--set", "uncertainty.samples=240", "--set", correlated];
    // every path is cut short behind its peak
    let cut = [
        "--set",
        "bounds.displacement=1 nm",
        "--set",
        "uncertainty.quantities=[\"initiation_peak.force_nN\", \"peak.force_nN\"]",
    ];
    let arguments = [&["uncertainty", &scene, "--out", "out"], ROUGHLY, &few, &cut].concat();
    let output = Command::new(env!("CARGO_BIN_EXE_peel")).args(arguments).current_dir(folder.path()).output().unwrap();
    assert_eq!(output.status.code(), Some(3), "{}", String::from_utf8_lossy(&output.stderr));
    let file = |name: &str| std::fs::read_to_string(folder.path().join("out").join(name)).unwrap();
    let mut found = BTreeSet::new();
    keys_of(&serde_json::from_str(&file("summary.json")).unwrap(), "", &mut found);
    assert_described(&found, "summary.json of peel uncertainty");
    let columns =
        |name: &str| -> Vec<String> { file(name).lines().next().unwrap().split(',').map(str::to_owned).collect() };
    let both = columns("statistics.csv").into_iter().chain(columns("indices.csv")).collect();
    assert_described(&both, "statistics.csv and indices.csv");
    let own = |column: &String| !column.contains('.');
    assert_described(&columns("samples.csv").into_iter().filter(own).collect(), "samples.csv");
}

/// A small seta, whose tips all detach.
#[test]
fn every_key_and_column_of_a_seta_is_described() {
    let folder = tempfile::tempdir().unwrap();
    let scene = format!("{}/scenes/seta.toml", super::ROOT);
    peel(&[&["run", &scene, "--out", "out", "--at", "u=10 nm"], &crate::seta::SMALL[..]].concat(), folder.path());
    let file = |name: &str| std::fs::read_to_string(folder.path().join("out").join(name)).unwrap();
    let mut found = BTreeSet::new();
    keys_of(&serde_json::from_str(&file("summary.json")).unwrap(), "", &mut found);
    // on its thin shaft the peak is not found on the finer mesh
    let thicker = peel(&["run", &scene, "--set", "seta.forks=2", "--json"], folder.path());
    keys_of(&serde_json::from_slice(&thicker.stdout).unwrap(), "", &mut found);
    // pressed so far that tips leave their table
    let by_table = ["--set", "seta.tip_law=table", "--set", "seta.tip_tolerance=1e-2", "--set", "seta.preload=4 nN"];
    let small = ["run", &scene, "--json", "--set", "seta.forks=1"];
    let by_table = peel(&[&small[..], &by_table[..]].concat(), folder.path());
    keys_of(&serde_json::from_slice(&by_table.stdout).unwrap(), "", &mut found);
    assert_described(&found, "summary.json of a seta");
    for (file_name, name) in [
        ("curve.csv", "curve.csv of a seta"),
        ("events.csv", "events.csv"),
        ("tips.csv", "tips.csv"),
        ("tip.csv", "tip.csv"),
    ] {
        let mut columns: BTreeSet<String> =
            file(file_name).lines().next().unwrap().split(',').map(str::to_owned).collect();
        if name == "events.csv" {
            columns.extend(["time_s", "loss"].map(str::to_owned));
        }
        assert_described(&columns, name);
    }
    let twice = ["--vary", "seta.tip_pitch", "--values", "1 um", "--vary", "seta.shaft_length", "--values", "7 um"];
    let four = ["seta.forks=2", "seta.brush_height=3 um", "seta.shaft_diameter=240 nm", "seta.height_scatter=20 nm"];
    let four = four.iter().flat_map(|set| ["--set", set]).collect::<Vec<_>>();
    peel(&[&["sweep", &scene, "--out", "sweep"], &twice[..], &four].concat(), folder.path());
    let table = std::fs::read_to_string(folder.path().join("sweep/sweep.csv")).unwrap();
    let columns = table.lines().next().unwrap().split(',').filter(|column| !column.starts_with("seta."));
    assert_described(&columns.map(str::to_owned).collect(), "sweep.csv of setae");
}

/// A strip that is pulled over its peak, and a seta of four tips.
#[test]
fn every_key_and_column_of_an_array_is_described() {
    let folder = tempfile::tempdir().unwrap();
    let scene = format!("{}/scenes/lamella.toml", super::ROOT);
    peel(&["run", &scene, "--out", "out", "--set", "setae.columns=2"], folder.path());
    let json = std::fs::read(folder.path().join("out/summary.json")).unwrap();
    let mut found = BTreeSet::new();
    keys_of(&serde_json::from_slice(&json).unwrap(), "", &mut found);
    assert_described(&found, "summary.json of an array");
    for (file, name) in [
        ("out/curve.csv", "curve.csv of an array"),
        ("out/events.csv", "events.csv of an array"),
        ("out/rows.csv", "rows.csv of an array"),
    ] {
        let table = std::fs::read_to_string(folder.path().join(file)).unwrap();
        let found = table.lines().next().unwrap().split(',').map(str::to_owned).collect();
        assert_described(&found, name);
    }
}

#[test]
fn every_key_and_column_of_a_solid_is_described() {
    let folder = tempfile::tempdir().unwrap();
    let scene = format!("{}/scenes/solid-strip.toml", super::ROOT);
    let coarse = ["--set", "solid.along=4 nm", "--set", "solid.through=3", "--set", "path.until=first-jump"];
    peel(&[&["run", &scene, "--out", "out", "--at", "u=1 nm"], &coarse[..]].concat(), folder.path());
    let json = std::fs::read(folder.path().join("out/summary.json")).unwrap();
    let mut found = BTreeSet::new();
    keys_of(&serde_json::from_slice(&json).unwrap(), "", &mut found);
    assert_described(&found, "summary.json of a solid");
    let twice = ["--vary", "solid.through", "--values", "2, 3", "--vary", "strip.length", "--values", "100 nm"];
    peel(&[&["sweep", &scene, "--out", "sweep"], &twice[..], &coarse[..2], &coarse[4..]].concat(), folder.path());
    for (file, name) in [
        ("out/curve.csv", "curve.csv of a solid"),
        ("out/limit_points.csv", "limit_points.csv of a solid"),
        ("out/stations.csv", "stations.csv of a seta, a solid or at a rate"),
        ("sweep/sweep.csv", "sweep.csv of solids"),
    ] {
        let table = std::fs::read_to_string(folder.path().join(file)).unwrap();
        let columns = table.lines().next().unwrap().split(',').map(str::to_owned);
        let found = columns.filter(|column| !column.starts_with("solid.") && !column.starts_with("strip.")).collect();
        assert_described(&found, name);
    }
}

#[test]
fn every_key_and_column_of_a_rate_is_described() {
    let folder = tempfile::tempdir().unwrap();
    let scene = format!("{}/scenes/strip-at-a-rate.toml", super::ROOT);
    peel(&["run", &scene, "--out", "out", "--at", "u=0.5 nm", "--set", "time.displacement=1 nm"], folder.path());
    let file = |name: &str| std::fs::read_to_string(folder.path().join("out").join(name)).unwrap();
    let mut found = BTreeSet::new();
    keys_of(&serde_json::from_str(&file("summary.json")).unwrap(), "", &mut found);
    let seta = format!("{}/scenes/seta-at-a-rate.toml", super::ROOT);
    peel(&[&["run", &seta, "--out", "seta"], &crate::seta::SMALL[..]].concat(), folder.path());
    let of_seta = |name: &str| std::fs::read_to_string(folder.path().join("seta").join(name)).unwrap();
    keys_of(&serde_json::from_str(&of_seta("summary.json")).unwrap(), "", &mut found);
    assert_described(&found, "summary.json of a rate");
    let header =
        |table: String| -> Vec<String> { table.lines().next().unwrap().split(',').map(str::to_owned).collect() };
    let both = header(file("curve.csv")).into_iter().chain(header(of_seta("curve.csv"))).collect();
    assert_described(&both, "curve.csv of a rate");
    let events = header(of_seta("events.csv")).into_iter().chain(["step".to_owned()]).collect();
    assert_described(&events, "events.csv");
    assert_described(&header(of_seta("equilibria.csv")).into_iter().collect(), "curve.csv of a seta");
    let twice = ["--vary", "time.rate", "--values", "1 mm/s", "--vary", "time.displacement", "--values", "1 nm"];
    peel(&[&["sweep", &scene, "--out", "sweep"], &twice[..]].concat(), folder.path());
    let table = std::fs::read_to_string(folder.path().join("sweep/sweep.csv")).unwrap();
    let columns = table.lines().next().unwrap().split(',').filter(|column| !column.starts_with("time."));
    assert_described(&columns.map(str::to_owned).collect(), "sweep.csv of rates");
}
