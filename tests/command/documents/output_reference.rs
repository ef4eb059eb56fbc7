//! The tables of `docs/reference/outputs.md` are made of the lists of `peelkit_report::reference`, and these are held against what the command
//! writes.

use super::{hold, row, text, with_part};
use peelkit_report::reference::{
    CURVE_COLUMNS, FIT_COLUMNS, FIT_SUMMARY, HISTORY_COLUMNS, LIMIT_POINT_COLUMNS, OBSERVED_COLUMNS,
    OPTIMISATION_SUMMARY, OutputKey, PEEL_SUMMARY, PROFILE_COLUMNS, RATE_CURVE_COLUMNS, RATE_SUMMARY,
    RATE_SWEEP_COLUMNS, SAMPLE_COLUMNS, SETA_CURVE_COLUMNS, SETA_EVENT_COLUMNS, SETA_SUMMARY, SETA_SWEEP_COLUMNS,
    SETA_TIP_COLUMNS, SETA_TIP_CURVE_COLUMNS, STATE_COLUMNS, SWEEP_COLUMNS, SWEEP_SUMMARY, TIP_LAW_COLUMNS,
    TIP_LIMIT_COLUMNS, TIP_SUMMARY, UNCERTAINTY_COLUMNS, UNCERTAINTY_SUMMARY, paths,
};
use peelkit_report::{SETA_STATE_FIELDS, SPATIAL_STATE_FIELDS, STATE_FIELDS, StateField};
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

const PATH: &str = "docs/reference/outputs.md";

#[test]
fn the_output_reference_is_that_of_the_lists() {
    let mut reference = text(PATH);
    for (name, keys, first) in [
        ("summary.json", PEEL_SUMMARY, "key"),
        ("peel sweep --json", SWEEP_SUMMARY, "key"),
        ("curve.csv", CURVE_COLUMNS, "column"),
        ("limit_points.csv", LIMIT_POINT_COLUMNS, "column"),
        ("observed.csv", OBSERVED_COLUMNS, "column"),
        ("states.csv", &state_columns(STATE_FIELDS), "column"),
        ("states.csv in space", &state_columns(SPATIAL_STATE_FIELDS), "column"),
        ("sweep.csv", SWEEP_COLUMNS, "column"),
        ("peel optimise --json", OPTIMISATION_SUMMARY, "key"),
        ("history.csv", HISTORY_COLUMNS, "column"),
        ("peel fit", FIT_SUMMARY, "key"),
        ("fit.csv", FIT_COLUMNS, "column"),
        ("profiles.csv", PROFILE_COLUMNS, "column"),
        ("summary.json of peel uncertainty", UNCERTAINTY_SUMMARY, "key"),
        ("statistics.csv and indices.csv", UNCERTAINTY_COLUMNS, "column"),
        ("samples.csv", SAMPLE_COLUMNS, "column"),
        ("sweep.csv of setae", SETA_SWEEP_COLUMNS, "column"),
        ("summary.json of a seta", SETA_SUMMARY, "key"),
        ("curve.csv of a seta", SETA_CURVE_COLUMNS, "column"),
        ("events.csv", SETA_EVENT_COLUMNS, "column"),
        ("tips.csv", SETA_TIP_COLUMNS, "column"),
        ("tip.csv", SETA_TIP_CURVE_COLUMNS, "column"),
        ("states.pvd of a seta", &seta_arrays(), "array"),
        ("summary.json of a rate", RATE_SUMMARY, "key"),
        ("curve.csv of a rate", RATE_CURVE_COLUMNS, "column"),
        ("sweep.csv of rates", RATE_SWEEP_COLUMNS, "column"),
        ("peel coarsen", TIP_SUMMARY, "key"),
        ("tip_law.csv", TIP_LAW_COLUMNS, "column"),
        ("tip_limits.csv", TIP_LIMIT_COLUMNS, "column"),
    ] {
        let mut part = row(&[first, "unit", "meaning"]) + "|---|---|---|\n";
        for key in keys {
            let like = key.like.map(|other| format!("; keys as of `{other}`")).unwrap_or_default();
            part += &row(&[&format!("`{}`", key.path), key.unit(), &format!("{}{like}", key.about)]);
        }
        reference = with_part(&reference, name, &part);
    }
    hold(PATH, &reference);
}

/// The columns of a state, and of each place.
fn state_columns<S>(fields: &[StateField<S>]) -> Vec<OutputKey> {
    let fields = fields.iter().map(|field| OutputKey { path: field.name, about: field.about, like: None });
    STATE_COLUMNS.iter().copied().chain(fields).collect()
}

/// The arrays of a grid of a seta.
fn seta_arrays() -> Vec<OutputKey> {
    SETA_STATE_FIELDS.iter().map(|field| OutputKey { path: field.name, about: field.about, like: None }).collect()
}

const ROUGHLY: &[&str] = &["--set", "accuracy.relative=1e-3"];
const FIXED: &[&str] = &["--set", "grip.rotation=fixed"];
const SHORT: &[&str] = &["--set", "strip.length=100 nm"];
const STEPS: &[&str] = &["--set", "drive.steps=[\"press 0.1 nm\"]"];
const SOFT: &[&str] = &["--set", "strip.length=200 nm", "--set", "strip.bending_stiffness_factor=0.01"];
const CUT: &[&str] = &["--set", "bounds.displacement=0.1 nm"];
/// Past the peak of the sideways pull, where its limit points are.
const PAST_PEAK: &[&str] = &["--set", "bounds.displacement=12.775 nm"];
/// Past a branch point of the symmetric path.
const UPWARD: &[&str] = &["--set", "drive.angle=90 deg", "--set", "bounds.displacement=0.2 nm"];
/// With a peak, a jump, and an end on the planar path.
const BRANCH: &[&str] = &["--branch", "--set", "strip.width=40 nm"];

/// Runs that together have every key.
const RUNS: &[(&str, &[&[&str]])] = &[
    ("strip-100nm", &[&["--observed"]]),
    ("strip-100nm", &[BRANCH]),
    ("strip-100nm", &[&["--sensitivities"]]),
    ("strip-100nm", &[FIXED]),
    ("strip-100nm", &[STEPS]),
    ("strip-100nm", &[SOFT]),
    ("strip-100nm", &[CUT]),
    ("strip-rough", &[SHORT]),
    ("strip-sideways", &[PAST_PEAK]),
    ("strip-sideways", &[UPWARD]),
    ("strip-rolled", &[CUT]),
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

fn assert_described(found: &BTreeSet<String>, keys: &[OutputKey], of: &str) {
    let described: BTreeSet<String> = paths(keys).into_iter().collect();
    let undescribed: Vec<_> = found.difference(&described).collect();
    assert!(undescribed.is_empty(), "{of}: no meaning in crates/report/src/reference: {undescribed:?}");
    let unseen: Vec<_> = described.difference(found).collect();
    assert!(unseen.is_empty(), "{of}: described and in no output: {unseen:?}");
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
    assert_described(&found, PEEL_SUMMARY, "summary.json");
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
    let branch = std::fs::read_to_string(folder.path().join("branch/branch.csv")).unwrap();
    let of_curve = |column: &str| CURVE_COLUMNS.iter().any(|key| key.path == column);
    assert!(
        branch.lines().next().unwrap().split(',').all(of_curve),
        "the columns of branch.csv are those of curve.csv"
    );
    for (file, keys) in [
        ("sideways/curve.csv", CURVE_COLUMNS),
        ("sideways/limit_points.csv", LIMIT_POINT_COLUMNS),
        ("run/observed.csv", OBSERVED_COLUMNS),
        ("run/states.csv", &state_columns(STATE_FIELDS)),
        ("sideways/states.csv", &state_columns(SPATIAL_STATE_FIELDS)),
        ("sweep/sweep.csv", SWEEP_COLUMNS),
    ] {
        let table = std::fs::read_to_string(folder.path().join(file)).unwrap();
        let columns = table.lines().next().unwrap().split(',').map(str::to_owned);
        // the values once more, under the names of their keys
        let found = columns.filter(|column| !column.starts_with("strip.")).collect();
        assert_described(&found, keys, file);
    }

    let mut found = BTreeSet::new();
    for follow in [&twice[..], &["--follow", "peak"]] {
        let json = peel(&[&vary[..], &["--json"], ROUGHLY, follow].concat(), folder.path()).stdout;
        let json: Value = serde_json::from_slice(&json).unwrap();
        found.extend(json.as_object().unwrap().keys().cloned());
    }
    // one is told of where there is something to tell, the other where the second key has a unit
    found.extend(["remarks", "unit_2"].map(str::to_owned));
    assert_described(&found, SWEEP_SUMMARY, "peel sweep --json");
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
    assert_described(&found, FIT_SUMMARY, "peel fit");
    for (file, keys) in [("fit.csv", FIT_COLUMNS), ("profiles.csv", PROFILE_COLUMNS)] {
        let table = std::fs::read_to_string(folder.path().join("fit").join(file)).unwrap();
        assert_described(&table.lines().next().unwrap().split(',').map(str::to_owned).collect(), keys, file);
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
    assert_described(&found, TIP_SUMMARY, "peel coarsen");
    for (file, keys) in [("tip_law.csv", TIP_LAW_COLUMNS), ("tip_limits.csv", TIP_LIMIT_COLUMNS)] {
        let table = std::fs::read_to_string(folder.path().join("tip").join(file)).unwrap();
        assert_described(&table.lines().next().unwrap().split(',').map(str::to_owned).collect(), keys, file);
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
    assert_described(&found, OPTIMISATION_SUMMARY, "peel optimise --json");
    let history = std::fs::read_to_string(folder.path().join("out/history.csv")).unwrap();
    let columns = history.lines().next().unwrap().split(',').map(str::to_owned).collect();
    assert_described(&columns, HISTORY_COLUMNS, "history.csv");
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
    assert_described(&found, UNCERTAINTY_SUMMARY, "summary.json of peel uncertainty");
    let columns =
        |name: &str| -> Vec<String> { file(name).lines().next().unwrap().split(',').map(str::to_owned).collect() };
    let both = columns("statistics.csv").into_iter().chain(columns("indices.csv")).collect();
    assert_described(&both, UNCERTAINTY_COLUMNS, "statistics.csv and indices.csv");
    let own = |column: &String| !column.contains('.');
    assert_described(&columns("samples.csv").into_iter().filter(own).collect(), SAMPLE_COLUMNS, "samples.csv");
}

/// A small seta, whose tips all detach.
#[test]
fn every_key_and_column_of_a_seta_is_described() {
    let folder = tempfile::tempdir().unwrap();
    let scene = format!("{}/scenes/seta.toml", super::ROOT);
    peel(&[&["run", &scene, "--out", "out"], &crate::seta::SMALL[..]].concat(), folder.path());
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
    assert_described(&found, SETA_SUMMARY, "summary.json of a seta");
    for (name, keys) in [
        ("curve.csv", SETA_CURVE_COLUMNS),
        ("events.csv", SETA_EVENT_COLUMNS),
        ("tips.csv", SETA_TIP_COLUMNS),
        ("tip.csv", SETA_TIP_CURVE_COLUMNS),
    ] {
        let mut columns: BTreeSet<String> = file(name).lines().next().unwrap().split(',').map(str::to_owned).collect();
        if name == "events.csv" {
            columns.extend(["time_s", "loss"].map(str::to_owned));
        }
        assert_described(&columns, keys, name);
    }
    let twice = ["--vary", "seta.tip_pitch", "--values", "1 um", "--vary", "seta.shaft_length", "--values", "7 um"];
    let four = ["seta.forks=2", "seta.brush_height=3 um", "seta.shaft_diameter=240 nm", "seta.height_scatter=20 nm"];
    let four = four.iter().flat_map(|set| ["--set", set]).collect::<Vec<_>>();
    peel(&[&["sweep", &scene, "--out", "sweep"], &twice[..], &four].concat(), folder.path());
    let table = std::fs::read_to_string(folder.path().join("sweep/sweep.csv")).unwrap();
    let columns = table.lines().next().unwrap().split(',').filter(|column| !column.starts_with("seta."));
    assert_described(&columns.map(str::to_owned).collect(), SETA_SWEEP_COLUMNS, "sweep.csv of setae");
}

/// A strip that is pulled over its peak, and a seta of four tips.
#[test]
fn every_key_and_column_of_a_rate_is_described() {
    let folder = tempfile::tempdir().unwrap();
    let scene = format!("{}/scenes/strip-at-a-rate.toml", super::ROOT);
    peel(&["run", &scene, "--out", "out", "--set", "time.displacement=1 nm"], folder.path());
    let file = |name: &str| std::fs::read_to_string(folder.path().join("out").join(name)).unwrap();
    let mut found = BTreeSet::new();
    keys_of(&serde_json::from_str(&file("summary.json")).unwrap(), "", &mut found);
    let seta = format!("{}/scenes/seta-at-a-rate.toml", super::ROOT);
    peel(&[&["run", &seta, "--out", "seta"], &crate::seta::SMALL[..]].concat(), folder.path());
    let of_seta = |name: &str| std::fs::read_to_string(folder.path().join("seta").join(name)).unwrap();
    keys_of(&serde_json::from_str(&of_seta("summary.json")).unwrap(), "", &mut found);
    assert_described(&found, RATE_SUMMARY, "summary.json of a rate");
    let header =
        |table: String| -> Vec<String> { table.lines().next().unwrap().split(',').map(str::to_owned).collect() };
    let both = header(file("curve.csv")).into_iter().chain(header(of_seta("curve.csv"))).collect();
    assert_described(&both, RATE_CURVE_COLUMNS, "curve.csv of a rate");
    let events = header(of_seta("events.csv")).into_iter().chain(["step".to_owned()]).collect();
    assert_described(&events, SETA_EVENT_COLUMNS, "events.csv of a seta at a rate");
    assert_described(&header(of_seta("equilibria.csv")).into_iter().collect(), SETA_CURVE_COLUMNS, "equilibria.csv");
    let twice = ["--vary", "time.rate", "--values", "1 mm/s", "--vary", "time.displacement", "--values", "1 nm"];
    peel(&[&["sweep", &scene, "--out", "sweep"], &twice[..]].concat(), folder.path());
    let table = std::fs::read_to_string(folder.path().join("sweep/sweep.csv")).unwrap();
    let columns = table.lines().next().unwrap().split(',').filter(|column| !column.starts_with("time."));
    assert_described(&columns.map(str::to_owned).collect(), RATE_SWEEP_COLUMNS, "sweep.csv of rates");
}
