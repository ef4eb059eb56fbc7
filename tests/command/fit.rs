//! `peel fit`: the parameters of a scene from a measured curve.
//!
//!      P |  .o
//!        | o  `o . o  o   o     o: rows of the CSV
//!        |_|____________________ o o o U
//!
//! Reference: the parameters with which the curve of scenes/strip-fit.csv was computed: A_H = 1e-19 J, E = 2 GPa, k = 0.5 N/m, d = 1.3 nm.
//! Expected: they lie in the intervals; terminal, summary.json and tables say one thing; parameters.toml is a scene with them; what cannot be
//! fitted is refused before anything is computed, with what would be right.

use crate::peel::{is_refused, refuses, run, scene};
use serde_json::Value;
use std::path::Path;

const SCENES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes");

fn fit(dir: &Path, data: &str, more: &[&str]) -> (Option<i32>, String, String) {
    run(dir, &[&["fit", &scene("strip-fit"), "--data", data, "--set", "accuracy.relative=1e-4"], more].concat())
}

/// A fit to this file with this text is refused.
#[track_caller]
fn fit_refuses((data, text): (&str, &str), more: &[&str], parts: &[&str]) {
    let arguments = ["fit", &scene("strip-fit"), "--data", data, "--set", "accuracy.relative=1e-4"];
    let files = [(data, text)];
    refuses(if text.is_empty() { &[] } else { &files }, &[&arguments, more].concat(), parts);
}

#[test]
fn known_parameters_are_found_again() {
    let dir = tempfile::tempdir().unwrap();
    let (status, text, trouble) = fit(dir.path(), &format!("{SCENES}/strip-fit.csv"), &["--out", "fit"]);
    assert_eq!(status, Some(0), "{trouble}");
    let folder = dir.path().join("fit");
    let summary: Value = serde_json::from_slice(&std::fs::read(folder.join("summary.json")).unwrap()).unwrap();
    assert_eq!(summary["end"], "converged");
    let fitted = summary["fitted"].as_array().unwrap();
    assert_eq!(fitted.len(), 4);
    let number = |value: &Value| value.as_f64().unwrap();
    for (row, known) in fitted.iter().zip([0.1, 2.0, 0.5, 1.3]) {
        let (low, high) = (number(&row["interval"][0]), number(&row["interval"][1]));
        assert!(low < known && known < high && high - low < 0.2 * known, "{row}");
        assert!(text.contains(row["key"].as_str().unwrap()), "{text}");
        assert_eq!(row["poorly_determined"], false);
    }
    let jump = &summary["jump"];
    let away = number(&jump["modelled_nm"]) - number(&jump["displacement_nm"]);
    assert!(away.abs() < 3.0 * number(&jump["standard_error_nm"]), "{jump}");
    let rows = std::fs::read_to_string(folder.join("fit.csv")).unwrap().lines().count();
    assert_eq!(rows as u64, 1 + summary["data"]["points"].as_u64().unwrap());
    assert!(folder.join("fit.svg").exists() && folder.join("fit.png").exists());
    // the scene that was found is fitted already
    let again = ["fit", "fit/parameters.toml", "--data", &format!("{SCENES}/strip-fit.csv"), "--json"];
    let (status, text, trouble) = run(dir.path(), &again);
    assert_eq!(status, Some(0), "{trouble}");
    let again: Value = serde_json::from_str(&text).unwrap();
    for (row, other) in fitted.iter().zip(again["fitted"].as_array().unwrap()) {
        let change = (number(&row["value"]) - number(&other["value"])).abs();
        assert!(change < 0.05 * number(&row["standard_error"]), "{row} {other}");
    }
}

/// What is refused: the arguments, the text of the data, and what the message says.
type Case<'c> = (&'c [&'c str], &'c str, &'c [&'c str]);

const GOOD: &str = "u (nm),P (nN)\n0,0\n0.1,0.1\n0.2,0.2\n0.3,0.2\n1,0.1\n2,0.09\n";

#[test]
fn what_cannot_be_fitted_is_refused_with_what_would_be_right() {
    let cases: &[Case] = &[
        (
            &[],
            "u (nm),t (s)\n0,0\n1,1\n",
            &["the columns u (nm), t (s), and none of forces", "displacement_nm,force_nN"],
        ),
        (&[], "u (nm),P (nN),Q (nN)\n0,0,0\n1,1,1\n", &["two columns of forces, `P (nN)` and `Q (nN)`", "fit.columns"]),
        (&["--set", "fit.columns={force=\"F\"}"], GOOD, &["no column `F` of forces", "u (nm), P (nN)"]),
        (&["--set", "fit.columns={force=\"P (mN)\"}"], GOOD, &["with another unit, `P (mN)`"]),
        (
            &["--set", "fit.columns={force=\"P\", displacement=\"x\"}"],
            "x,P (nN)\n0,0\n1,1\n",
            &["without a unit of displacements"],
        ),
        (&["--set", "fit.columns={load=\"P\"}"], GOOD, &["`load`, which is none of displacement, force, force_error"]),
        (&["--set", "fit.displacement_error=nought"], GOOD, &["which is none of its values"]),
        (&["--set", "fit.displacement_error=-1 nm"], GOOD, &["which is not above zero"]),
        (&[], "grip.stiffness,P (nN)\n1,1\n2,2\n", &["whose key takes a unit", "grip.stiffness (N/m)"]),
        (
            &[],
            "grip.stiffness (N/m),P (nN)\n1,1\n2,2\n",
            &["`grip.stiffness` is to be fitted to steady forces", "Remove `grip.stiffness`"],
        ),
        (&[], "u (nm),v (nm)\n0,0\n1,1\n", &["two columns of displacements"]),
        (&[], "u (nm),P error (nN)\n0,0\n1,1\n", &["none of forces"]),
        (&[], "u (nm),P (nN)\n0,0\n1,\n", &["in row 2 no `P (nN)`"]),
        (&[], "u (nm),P (nN),P error (nN)\n0,0,1\n1,1,0\n", &["in row 2 a standard error"]),
        (&[], "u (nm),P (nN)\n0,0\n1,1\n", &["has 2 points", "at least 4"]),
        (&[], "u (nm),P (nN)\n0,0\n1,1\n2,2\n3,3\n2,2\n1,1\n0,0\n", &["back to 0 nm", "retreat alone"]),
        (&[], "u (nm),P (nN)\n0,1\n1,1\n2,1\n3,1\n", &["same force"]),
        (&["--set", "fit.jump=900 nm"], GOOD, &["the jump is said to be at 900 nm"]),
        (&["--set", "fit.parameters=[]"], GOOD, &["no parameter to fit"]),
        (&["--set", "fit.parameters=[\"strip.young\"]"], GOOD, &["strip.young", "is not a key of a scene"]),
        (&["--set", "fit.parameters=[\"strip.youngs_modul\"]"], GOOD, &["did you mean `strip.youngs_modulus`"]),
        (&["--set", "fit.parameters=[\"title\"]"], GOOD, &["not a number of the model"]),
        (&["--set", "fit.parameters=[\"accuracy.relative\"]"], GOOD, &["not a number of the model"]),
        (&["--set", "fit.parameters=[\"spatula.tip_width\"]"], GOOD, &["spatula.tip_width", "peels a [strip]"]),
        (&["--set", "fit.parameters=[\"grip.pretension\"]"], GOOD, &["has no value in the scene"]),
        (
            &["--set", "fit.parameters=[\"strip.height from 11 nm\"]"],
            GOOD,
            &["do not hold its value in the scene, 10 nm"],
        ),
        (&["--set", "fit.parameters=[\"strip.height from 5\"]"], GOOD, &["a number without a unit"]),
        (&["--set", "fit.parameters=[\"strip.height up to 5 nm\"]"], GOOD, &["something else than from A to B"]),
        (&["--set", "fit.parameters=[\"strip.height from 20 nm to 5 nm\"]"], GOOD, &["not below its second"]),
        (&["--set", "fit.parameters=[\"strip.height\", \"strip.height\"]"], GOOD, &["names `strip.height` twice"]),
        (&["--set", "fit.loss=hubert"], GOOD, &["did you mean \"huber\""]),
        (&["--set", "terms=auto"], GOOD, &["terms = \"auto\"", "terms=all"]),
        (&["--set", "friction.strength=20 MPa"], GOOD, &["friction"]),
    ];
    for (arguments, text, expected) in cases {
        fit_refuses(("curve.csv", text), arguments, expected);
    }
    fit_refuses(("nowhere.csv", ""), &[], &["cannot be read"]);
}

/// The most common mistake: numbers in nm and nN under the heading of µm and µN.
#[test]
fn a_wrong_unit_in_the_heading_is_refused_with_the_likely_one() {
    let text = std::fs::read_to_string(format!("{SCENES}/strip-fit.csv")).unwrap();
    let (_, rows) = text.split_once("force_nN\n").unwrap();
    let parts = ["uN is written there and nN is meant", "um is written there and nm is meant"];
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("um.csv"), format!("displacement_um,force_uN\n{rows}")).unwrap();
    let with_zero = ["--set", "fit.parameters=[\"adhesion.hamaker_constant\", \"fit.displacement_zero\"]"];
    for more in [&[][..], &with_zero] {
        let fit = ["fit", &scene("strip-fit"), "--data", "um.csv", "--set", "accuracy.relative=1e-4"];
        is_refused(dir.path(), &[&fit, more].concat(), &parts);
    }
}

/// Where the displacement zero is free, a search may go there and fit nothing: here displacements are a hundred times too large.
#[test]
fn a_fit_beside_the_measured_points_says_so() {
    let dir = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(format!("{SCENES}/strip-fit.csv")).unwrap();
    let (_, rows) = text.split_once("force_nN\n").unwrap();
    let row = |row: &str| {
        let (displacement, force) = row.split_once(',').unwrap();
        format!("{},{force}\n", 0.1 * displacement.parse::<f64>().unwrap())
    };
    let rows: String = rows.lines().map(row).collect();
    std::fs::write(dir.path().join("um.csv"), format!("displacement_um,force_nN\n{rows}")).unwrap();
    let both = "fit.parameters=[\"adhesion.hamaker_constant\", \"fit.displacement_zero\"]";
    let (_, text, trouble) = fit(dir.path(), "um.csv", &["--set", both, "--out", "fit"]);
    assert!(text.contains("no measured point lies on the path of the model"), "{text}{trouble}");
    let summary = std::fs::read_to_string(dir.path().join("fit/summary.json")).unwrap();
    assert!(summary.contains("\"none-on-path\"") && !summary.contains("\"before-start\""), "{summary}");
}

/// scenes/tape-record.csv is as a machine writes it, with numbers that are known.
#[test]
fn the_record_of_a_machine_is_read_and_fitted_as_it_is() {
    let dir = tempfile::tempdir().unwrap();
    let (scene, record) = (format!("{SCENES}/tape-record.toml"), format!("{SCENES}/tape-record.csv"));
    let (status, text, trouble) = run(dir.path(), &["fit", &scene, "--data", &record, "--json"]);
    assert_eq!(status, Some(0), "{trouble}");
    let summary: Value = serde_json::from_str(&text).unwrap();
    let number = |value: &Value| value.as_f64().unwrap();
    let fitted = summary["fitted"].as_array().unwrap();
    for (row, known) in fitted.iter().zip([120.0, 8e-4, 2e4, 8e5, 1.5e8]) {
        let (low, high) = (number(&row["interval"][0]), number(&row["interval"][1]));
        assert!(low < known && known < high, "{row}");
    }
    let data = &summary["data"];
    assert!((number(&data["estimated_error_nN"]) / 2e7 - 1.0).abs() < 0.3, "{data}");
    assert!((number(&data["estimated_displacement_error_nm"]) / 5e3 - 1.0).abs() < 0.5, "{data}");
}

/// scenes/tape-curves.toml: two tests of one tape, each with its own zeros. What was found is fitted once more from where it is written.
#[test]
fn several_curves_are_fitted_together() {
    let dir = tempfile::tempdir().unwrap();
    let scene = format!("{SCENES}/tape-curves.toml");
    let (status, text, trouble) = run(dir.path(), &["fit", &scene, "--out", "fit"]);
    assert_eq!(status, Some(0), "{trouble}");
    let read = |name: &str| std::fs::read_to_string(dir.path().join("fit").join(name)).unwrap();
    let summary: Value = serde_json::from_str(&read("summary.json")).unwrap();
    let number = |value: &Value| value.as_f64().unwrap();
    let fitted = summary["fitted"].as_array().unwrap();
    for (row, known) in fitted.iter().zip([120.0, 8e-4, 2e4, 8e5, 3.5e5]) {
        let (low, high) = (number(&row["interval"][0]), number(&row["interval"][1]));
        assert!(low < known && known < high, "{row}");
    }
    assert_eq!((fitted.len(), fitted[4]["key"].as_str()), (5, Some("fit.displacement_zero[2]")));
    let curves = summary["curves"].as_array().unwrap();
    assert!(curves[1]["file"].as_str().unwrap().ends_with("tape-60.csv"), "{}", curves[1]);
    assert_eq!(curves[1]["displacement_zero_nm"], fitted[4]["value"]);
    assert!(
        summary["data"]["file"].is_null() && text.contains("tape-90.csv") && text.contains("tape-60.csv"),
        "{text}"
    );
    let table = read("fit.csv");
    assert!(table.contains("\n1,") && table.contains("\n2,"), "{table}");
    // a scene with what was found: the work is found again where all else is known
    let alone = ["fit", "fit/parameters.toml", "--set", "fit.parameters=[\"adhesion.work\"]", "--json"];
    let (status, again, trouble) = run(dir.path(), &alone);
    assert_eq!(status, Some(0), "{trouble}");
    let again: Value = serde_json::from_str(&again).unwrap();
    let change = (number(&fitted[0]["value"]) - number(&again["fitted"][0]["value"])).abs();
    assert!(change < 0.1 * number(&fitted[0]["standard_error"]), "{again}");
}

#[test]
fn curves_that_cannot_be_fitted_together_are_refused() {
    let curves_scene = format!("{SCENES}/tape-curves.toml");
    let with = |curves: &str, parts: &[&str]| {
        let set = format!("fit.curves={curves}");
        refuses(
            &[("a.csv", "drive.angle (deg),force (N)\n60,1\n90,2\n")],
            &["fit", &curves_scene, "--set", &set],
            parts,
        );
    };
    let dir = tempfile::tempdir().unwrap();
    let one = ["fit", &scene("strip-fit")];
    refuses(&[], &one, &["there is nothing to fit to: no data were given, and the scene names none", "--data CSV"]);
    let both = ["fit", &curves_scene, "--data", &format!("{SCENES}/tape-90.csv")];
    refuses(&[], &both, &["data are given beside `fit.curves` of the scene", "Omit --data"]);
    let file = dir.path().join("a.csv");
    std::fs::write(&file, "drive.angle (deg),force (N)\n60,1\n90,2\n").unwrap();
    let steady = format!("[{{ data = \"{}\" }}]", file.display());
    with(&steady, &["has steady forces against `drive.angle`, and `fit.curves` takes curves alone"]);
    with("[{ data = \"nowhere.csv\" }]", &["nowhere.csv"]);
    with("[]", &["has 0 curves; it takes 1 to 50"]);
    with("[{ set = { \"drive.angle\" = \"60 deg\" } }]", &["has in curve 1 no `data`"]);
    let other = |set: &str, parts: &[&str]| with(&format!("[{{ data = \"a.csv\", set = {{ {set} }} }}]"), parts);
    let jump = format!("[{{ data = \"{SCENES}/tape-90.csv\", jump = \"9 mm\" }}]");
    with(&jump, &["tape-90.csv", "9000000"]);
    with("[{ data = \"a.csv\", jump = \"-1 nm\" }]", &["curve 1"]);
    other("\"adhesion.work\" = \"90 J/m2\"", &["sets in curve 1 `adhesion.work`, which is fitted"]);
    other("\"grip.rotation\" = \"fixed\"", &["`set` with `grip.rotation`, which is not a number of the model"]);
    other("\"strip.heigth\" = \"1 um\"", &["strip.heigth"]);
    other("\"drive.angle\" = \"200 deg\"", &["curve 1"]);
    other("\"substrate.radius\" = \"1 um\"", &["sets in curve 1 `substrate.radius`, which"]);
}

/// The steady force of a tape that slides solves P (1 - cos α) + P² sin² α/2EA = w b: forces of 100 J/m² at three angles, in the unit of the trade.
#[test]
fn steady_forces_against_an_angle_are_fitted() {
    let dir = tempfile::tempdir().unwrap();
    let (axial, width) = (2e9 * 50e-6 * 20e-3, 20e-3);
    let force = |angle: f64| {
        let (sin, cos) = angle.to_radians().sin_cos();
        let (a, b) = (sin * sin / (2.0 * axial), 1.0 - cos);
        (-b + (b * b + 4.0 * a * 100.0 * width).sqrt()) / (2.0 * a)
    };
    let row = |angle: f64| format!("{angle},{}\n", force(angle) / width / 40.0);
    let rows: String = [60.0, 75.0, 90.0, 90.0].map(row).concat();
    std::fs::write(dir.path().join("steady.csv"), format!("drive.angle (deg),force (N/25mm)\n{rows}")).unwrap();
    let scene = format!("{SCENES}/tape.toml");
    let set = ["path.until=end", "fit.parameters=[\"adhesion.work\"]", "adhesion.work=130 J/m2", "strip.length=10 mm"];
    let set: Vec<&str> = set.iter().flat_map(|text| ["--set", text]).collect();
    let data = ["fit", &scene, "--data", "steady.csv", "--out", "fit", "--set", "bounds.displacement=9 mm"];
    let (status, text, trouble) = run(dir.path(), &[&data[..], &set].concat());
    assert_eq!(status, Some(0), "{trouble}");
    assert!(text.contains("4 steady forces against drive.angle of steady.csv"), "{text}");
    let summary: Value = serde_json::from_slice(&std::fs::read(dir.path().join("fit/summary.json")).unwrap()).unwrap();
    let work = summary["fitted"][0]["value"].as_f64().unwrap();
    assert!((work / 100.0 - 1.0).abs() < 1e-4, "{work}");
    let table = std::fs::read_to_string(dir.path().join("fit/fit.csv")).unwrap();
    assert!(table.starts_with("key,value,force_nN,modelled_nN"), "{table}");
}

/// A law with a work of adhesion and a strength of its own takes nothing from the half space.
#[test]
fn a_parameter_without_influence_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let set = [
        "adhesion.law=bilinear",
        "adhesion.work=0.03 J/m2",
        "adhesion.strength=20 MPa",
        "fit.parameters=[\"adhesion.work\", \"adhesion.hamaker_constant\"]",
    ];
    let set: Vec<&str> = set.iter().flat_map(|text| ["--set", text]).collect();
    let (scene, data) = (scene("strip-fit"), format!("{SCENES}/strip-fit.csv"));
    let arguments = [&["fit", &scene, "--data", &data, "--set", "accuracy.relative=1e-4"], &set[..]].concat();
    is_refused(dir.path(), &arguments, &["adhesion.hamaker_constant", "no influence"]);
}
