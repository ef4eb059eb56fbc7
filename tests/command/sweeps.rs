//! What a sweep may vary, what its files say of that, and that every folder holds what reproduces it.

use serde_json::Value;
use std::collections::HashMap;
use std::fs;
use std::path::Path;
use std::process::Command;
use tempfile::tempdir;

const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/strip-100nm.toml");
const ROUGHLY: [&str; 2] = ["--set", "accuracy.relative=1e-3"];

/// Runs to a good end; what it printed.
#[track_caller]
fn done(dir: &Path, args: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_peel")).current_dir(dir).args(args).output().unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!((output.status.code(), stderr.as_str()), (Some(0), ""));
    String::from_utf8(output.stdout).unwrap()
}

#[track_caller]
fn refused(dir: &Path, args: &[&str], part: &str) {
    let output = Command::new(env!("CARGO_BIN_EXE_peel")).current_dir(dir).args(args).output().unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{stderr}");
    assert!(stderr.contains(part), "{part:?} is not in\n{stderr}");
}

/// The rows of a table by the names of its columns.
fn table(path: &Path) -> (Vec<String>, Vec<HashMap<String, String>>) {
    let mut reader = csv::Reader::from_path(path).unwrap();
    let names: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    let row = |record: csv::StringRecord| names.iter().cloned().zip(record.iter().map(str::to_owned)).collect();
    let rows = reader.records().map(|record| row(record.unwrap())).collect();
    (names, rows)
}

#[test]
fn a_list_of_values_takes_the_place_of_a_range() {
    let dir = tempdir().unwrap();
    let args =
        [&["sweep", SCENE, "--vary", "strip.height", "--values", "8, 10,12 nm", "--out", "out"][..], &ROUGHLY].concat();
    done(dir.path(), &args);
    let (names, rows) = table(&dir.path().join("out/sweep.csv"));
    assert_eq!(names[..3], ["value", "strip.height_nm", "peak_force_nN"]);
    assert_eq!(rows.iter().map(|row| row["strip.height_nm"].as_str()).collect::<Vec<_>>(), ["8.0", "10.0", "12.0"]);
    for row in &rows {
        assert_eq!(row["value"], row["strip.height_nm"]);
        for name in ["peak_force_nN", "peak_error_nN", "peak_displacement_nm", "snap_off_force_nN", "snap_off_error_nN"]
        {
            assert!(row[name].parse::<f64>().unwrap() > 0.0, "{name}");
        }
    }
}

#[test]
fn angles_come_out_in_the_degrees_in_which_they_are_given() {
    let dir = tempdir().unwrap();
    let vary = ["sweep", SCENE, "--vary", "drive.angle", "--values", "60,75,90 deg", "--out", "out"];
    let text = done(dir.path(), &[&vary[..], &ROUGHLY].concat());
    assert!(text.contains("drive.angle varied, in deg"), "{text}");
    let first = |line: &str| line.split_whitespace().next().map(str::to_owned);
    let shown: Vec<String> = text.lines().filter_map(first).filter(|word| word.parse::<f64>().is_ok()).collect();
    assert_eq!(shown, ["60", "75", "90"]);
    let (names, rows) = table(&dir.path().join("out/sweep.csv"));
    assert_eq!(names[..2], ["value", "drive.angle_deg"]);
    assert_eq!(rows.iter().map(|row| row["drive.angle_deg"].as_str()).collect::<Vec<_>>(), ["60", "75", "90"]);
    let radians: f64 = rows[0]["value"].parse().unwrap();
    assert!((radians.to_degrees() - 60.0).abs() < 1e-12);
    // its own picture and an overlay draw them alike
    done(dir.path(), &["plot", "out", "--out", "both"]);
    let picture = fs::read_to_string(dir.path().join("both/plot.svg")).unwrap();
    assert!(picture.contains("(deg)"), "the axis is in degrees");
    // and so does a map over two keys
    let map = ["sweep", SCENE, "--vary", "drive.angle", "--values", "75,90 deg", "--vary", "strip.height"];
    done(dir.path(), &[&map[..], &["--values", "9 nm,10 nm", "--out", "map"], &ROUGHLY].concat());
    let picture = fs::read_to_string(dir.path().join("map/sweep.svg")).unwrap();
    assert!(picture.contains("(deg)") && !picture.contains("(rad)"), "the axis is in degrees");
}

#[test]
fn a_range_of_one_value_and_an_empty_list_are_refused() {
    let dir = tempdir().unwrap();
    let sweep = |more: &[&'static str]| [&["sweep", SCENE, "--vary", "strip.length"][..], more].concat();
    let range = ["--from", "100 nm", "--to", "10 nm", "--points", "1"];
    refused(
        dir.path(),
        &sweep(&range),
        "--points 1 for strip.length is one value, and --from 100 nm and --to 10 nm are two",
    );
    refused(dir.path(), &sweep(&["--values", ""]), "has an empty list of --values");
    let same = ["--from", "100 nm", "--to", "100 nm", "--points", "1", "--json"];
    done(dir.path(), &[&sweep(&same)[..], &ROUGHLY].concat());
}

#[test]
fn two_keys_make_a_plane_with_a_map() {
    let dir = tempdir().unwrap();
    let plane = ["--vary", "strip.height", "--values", "9 nm,10 nm,11 nm", "--vary", "strip.youngs_modulus"];
    let range = ["--from", "1 GPa", "--to", "4 GPa", "--points", "3", "--log", "--out", "out", "--json"];
    let args = [&["sweep", SCENE][..], &plane, &range, &ROUGHLY].concat();
    let summary: Value = serde_json::from_str(&done(dir.path(), &args)).unwrap();
    assert_eq!((summary["vary"].as_str(), summary["unit"].as_str()), (Some("strip.height"), Some("nm")));
    assert_eq!((summary["vary_2"].as_str(), summary["unit_2"].as_str()), (Some("strip.youngs_modulus"), Some("GPa")));
    assert_eq!(summary["rows"].as_array().unwrap().len(), 9);
    assert_eq!(summary["rows"][4]["value_2"].as_f64(), Some(2.0));
    let (names, rows) = table(&dir.path().join("out/sweep.csv"));
    assert_eq!(names[..4], ["value", "value_2", "strip.height_nm", "strip.youngs_modulus_GPa"]);
    let pairs: Vec<(&str, &str)> = rows.iter().map(|row| (row["value"].as_str(), row["value_2"].as_str())).collect();
    assert_eq!((pairs.len(), pairs[0], pairs[1], pairs[8]), (9, ("9.0", "1.0"), ("9.0", "2.0"), ("11.0", "4.0")));
    // at the middle, what a single run finds
    let scene = [&["run", SCENE, "--json"][..], &ROUGHLY].concat();
    let alone: Value = serde_json::from_str(&done(dir.path(), &scene)).unwrap();
    assert_eq!(rows[4]["peak_force_nN"].parse::<f64>().unwrap(), alone["peak"]["force_nN"].as_f64().unwrap());
    let picture = fs::read_to_string(dir.path().join("out/sweep.svg")).unwrap();
    for label in ["height of the section h (nm)", "s modulus E (GPa)", "peak force P (nN)", "work to snap-off W (aJ)"] {
        assert!(picture.contains(label), "{label} is missing");
    }
    assert!(dir.path().join("out/sweep.png").exists());
    let follows = [&["sweep", SCENE][..], &plane, &["--values", "1 GPa,2 GPa", "--peak-only"]].concat();
    refused(dir.path(), &follows, "one key only");
}

#[test]
fn what_is_varied_is_said_once_and_whole() {
    let dir = tempdir().unwrap();
    let vary = ["sweep", SCENE, "--vary", "strip.height"];
    refused(dir.path(), &vary, "--values");
    refused(dir.path(), &[&vary[..], &["--from", "1 nm", "--to", "2 nm"]].concat(), "--points");
    refused(dir.path(), &[&vary[..], &["--values", "1 nm", "--points", "2"]].concat(), "as well");
    refused(dir.path(), &[&vary[..], &["--values", "1,2"]].concat(), "without a unit");
    refused(dir.path(), &[&vary[..], &["--values", "1 nm,-2 nm"]].concat(), "--values for strip.height");
    let many = ["--from", "1 nm", "--to", "2 nm", "--points", "2000"];
    let plane = [&vary[..], &many, &["--vary", "strip.width"], &many].concat();
    refused(dir.path(), &plane, "4000000 pairs of values");
    refused(
        dir.path(),
        &[&vary[..], &["--values", "1 nm", "--vary", "strip.height", "--values", "1 nm"]].concat(),
        "twice",
    );
}

/// A summary without what differs from run to run, and from command to command.
fn numbers(mut summary: Value) -> Value {
    for key in ["command", "scene", "timing"] {
        summary.as_object_mut().unwrap().remove(key);
    }
    summary
}

#[test]
fn every_folder_reproduces_its_run() {
    let dir = tempdir().unwrap();
    let set = ["--set", "strip.length=\"0.08 um\"", "--set", "drive.angle=75 deg", "--set", "title=Once more"];
    done(dir.path(), &[&["run", SCENE, "--out", "first"][..], &set, &ROUGHLY].concat());
    done(dir.path(), &["run", "first/parameters.toml", "--out", "second"]);
    let read = |folder: &str, name: &str| fs::read_to_string(dir.path().join(folder).join(name)).unwrap();
    for name in ["curve.csv", "limit_points.csv", "curve.svg", "shapes.svg"] {
        assert_eq!(read("first", name), read("second", name), "{name}");
    }
    let summary = |folder: &str| numbers(serde_json::from_str(&read(folder, "summary.json")).unwrap());
    assert_eq!(summary("first"), summary("second"));
    let parameters = read("first", "parameters.toml");
    assert!(parameters.contains("#   peel run ") && parameters.contains("length = \"80 nm\"\n"), "{parameters}");

    let sweep = ["--vary", "strip.height", "--values", "9 nm,10 nm"];
    done(dir.path(), &[&["sweep", SCENE][..], &sweep, &["--out", "third"], &ROUGHLY].concat());
    done(dir.path(), &[&["sweep", "third/parameters.toml"][..], &sweep, &["--out", "fourth"]].concat());
    let rows = |folder: &str| {
        let (_, mut rows) = table(&dir.path().join(folder).join("sweep.csv"));
        rows.iter_mut().for_each(|row| drop(row.remove("solve_s")));
        rows
    };
    assert_eq!(rows("third"), rows("fourth"));
}

#[test]
fn the_printed_units_fit_or_are_those_that_are_wanted() {
    let dir = tempdir().unwrap();
    let printed = |more: &[&str]| done(dir.path(), &[&["run", SCENE, "--force"][..], &ROUGHLY, more].concat());
    let plain = printed(&[]);
    assert!(plain.contains(" nN at u = 0.24960") && plain.contains(" aJ"), "{plain}");
    let wanted = printed(&["--units", "pN,um,zJ"]);
    assert!(wanted.contains("  peak force         341.12") && wanted.contains(" pN at u = 0.00024960"), "{wanted}");
    assert!(wanted.contains(" µm, work to there 3470.") && wanted.contains(" zJ"), "{wanted}");
    let wide = printed(&["--set", "strip.width=1 mm"]);
    assert!(wide.contains("  peak force         341.12") && wide.contains(" µN at u = 0.24960"), "{wide}");
    // 341.12 µN on 1 mm are 8528 µN on 25 mm
    let over = printed(&["--set", "strip.width=1 mm", "--units", "N/25mm"]);
    assert!(over.contains("  peak force         0.0085280") && over.contains(" N/25mm at u = 0.24960"), "{over}");
    let of_width = ["sweep", SCENE, "--vary", "strip.width", "--from", "1 nm", "--to", "2 nm", "--points", "2"];
    refused(
        dir.path(),
        &[&of_width[..], &["--units", "N/cm"]].concat(),
        "--units has N/cm, a force over the width of a strip, and `strip.width` is varied",
    );
    let table = fs::read_to_string(dir.path().join("out/strip-100nm-accuracy.relative-1e-3/summary.json")).unwrap();
    assert!(table.contains("\"force_nN\": 0.341"), "files keep their units");
    refused(
        dir.path(),
        &["run", SCENE, "--units", "lbf"],
        "--units has \"lbf\", which is no unit of a force, a length, a work or a force over a width",
    );
}

/// Pictures and copies of the tables follow `--units`, or the scene; the tables themselves, the summary and a checkpoint do not.
#[test]
fn pictures_and_copies_of_tables_have_the_units_that_are_wanted() {
    let dir = tempdir().unwrap();
    let of = |more: &[&str], out: &str| done(dir.path(), &[&["run", SCENE, "--out", out][..], &ROUGHLY, more].concat());
    of(&[], "plain");
    let said = of(&["--units", "pN,um"], "wanted");
    assert!(said.contains("wrote wanted/in-units/curve.csv"), "{said}");
    of(&["--set", "output.units=\"pN, um\""], "set");
    let text = |path: &str| fs::read_to_string(dir.path().join(path)).unwrap();
    assert!(!dir.path().join("plain/in-units").exists());
    assert_eq!(text("plain/curve.csv"), text("wanted/curve.csv"));
    for file in ["curve.svg", "shapes.svg", "in-units/curve.csv", "in-units/limit_points.csv"] {
        assert_eq!(text(&format!("wanted/{file}")), text(&format!("set/{file}")), "{file}");
    }
    let picture = text("wanted/curve.svg");
    for part in ["displacement u (µm)", "force P (pN)", "P = 341.1 pN"] {
        assert!(picture.contains(part), "{part}\n{picture}");
    }
    assert!(text("wanted/shapes.svg").contains("x (µm)"));
    let [(_, plain), (header, wanted)] =
        ["plain", "wanted/in-units"].map(|of| table(&dir.path().join(of).join("curve.csv")));
    assert_eq!(header[..2], ["displacement_um", "force_pN"]);
    let number = |row: &HashMap<String, String>, column: &str| row[column].parse::<f64>().unwrap();
    for (plain, wanted) in plain.iter().zip(&wanted) {
        approx::assert_relative_eq!(number(plain, "force_nN"), 1e-3 * number(wanted, "force_pN"), max_relative = 1e-14);
        assert_eq!(plain["work_aJ"], wanted["work_aJ"], "no unit of works is wanted");
    }
}

#[test]
fn states_are_written_where_files_are() {
    let dir = tempdir().unwrap();
    let args = [&["run", SCENE, "--states", "3", "--out", "out"][..], &ROUGHLY].concat();
    let said = done(dir.path(), &args);
    assert!(said.contains("wrote out/states.csv") && said.contains("wrote out/states/ with"), "{said}");
    let grids = fs::read_dir(dir.path().join("out/states")).unwrap().count();
    let listed = fs::read_to_string(dir.path().join("out/states.pvd")).unwrap().matches("<DataSet").count();
    assert!(grids == listed && grids > 3, "{grids} grids, {listed} listed");
    // into a folder that is replaced as well
    done(dir.path(), &[&args[..], &["--force"]].concat());
    refused(dir.path(), &["run", SCENE, "--states", "3", "--json"], "--states writes files");
}
