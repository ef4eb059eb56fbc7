//! Files and objects that a peel is written to.
//!
//! Expected: the keys and columns of the contract (design.md, section 4), every number to its last digit, null and empty
//! cells where a thing does not occur, and an error in place of a NaN. Why: other programs read these files.

use crate::strip::STRIP_SCENE;
use peelkit::solve::LimitPointKind;
use peelkit::study::{
    Bound, Failure, LargestComputedForce, LimitPoint, OutOfPlane, PathEnd, PathPoint, Peak, Peel, PeelResult, Plateau,
    peel,
};
use peelkit_report::{PeelSummary, Record, SweepLine, SweepRow, write_curve, write_limit_points, write_sweep};
use peelkit_scene::{BoundsTable, Scene, find_key};
use serde_json::Value;
use std::fs;

/// Numbers that do not look alike, so that no two can be taken for each other.
fn made_up() -> (Scene, Peel) {
    let scene = Scene::parse("a.toml", &format!("title = \"A strip\"{STRIP_SCENE}"), &[]).unwrap();
    let bounds = BoundsTable { points: 1, ..scene.bounds };
    let mut made_up = peel(&scene.model, &scene.accuracy, &bounds.from_now());
    let peak = Peak {
        displacement: 0.1 + 0.2,
        force: 0.341,
        end_rotation: 0.035,
        force_error: 1e-9,
        displacement_error: 2e-9,
    };
    let snap_off = LimitPoint {
        kind: LimitPointKind::Displacement,
        displacement: 48.2,
        force: 0.0375,
        end_rotation: 0.9,
        work: 3.25,
        displacement_error: 3e-8,
        force_error: 4e-9,
        work_error: Some(5e-7),
        flat: false,
        after: 0,
        in_space: None,
    };
    let point = |displacement: f64, force: f64, work: f64| PathPoint {
        displacement,
        force,
        end_rotation: 0.25,
        work,
        negative_eigenvalues: 1,
        negative_eigenvalues_load: 2,
        front: 77.5,
        iterations: 3,
        in_space: None,
    };
    made_up.points = vec![point(0.0, 0.0, 0.0), point(40.0, 1.0 / 3.0, 2.5)];
    made_up.limit_points = vec![LimitPoint { kind: LimitPointKind::Load, ..snap_off }, snap_off];
    made_up.peak = Some(peak);
    made_up.initiation_peak = Some(Peak { force: 0.3, ..peak });
    made_up.plateau = Some(Plateau {
        displacement: 20.0,
        force: 0.0307,
        force_error: Some(6e-8),
        displacement_error: Some(7e-3),
        stable: true,
        after: 0,
    });
    made_up.snap_off = Some(snap_off);
    made_up.largest_computed_force = None;
    made_up.pad_detachment = Some(LimitPoint { work: 3.5, ..snap_off });
    made_up.detachment = Some(LimitPoint { work: 3.75, work_error: None, ..snap_off });
    made_up.end = PathEnd::Pivoting;
    (scene, made_up)
}

fn row(value: f64, peel: &Peel) -> SweepRow {
    SweepRow { value, second: None, model: peel.model.clone(), found: PeelResult::from(peel), solve_s: 0.004 }
}

fn summary(scene: &Scene, peel: &Peel) -> Value {
    serde_json::from_str(&PeelSummary::new(scene, peel, 0.004).to_json().unwrap()).unwrap()
}

#[test]
fn the_summary_has_every_key_at_full_precision() {
    let (scene, peel) = made_up();
    let summary = summary(&scene, &peel);
    let number = |path: &str| summary.pointer(path).and_then(Value::as_f64).unwrap_or_else(|| panic!("{path}"));
    assert_eq!((summary["scene"].as_str(), summary["title"].as_str()), (Some("a.toml"), Some("A strip")));
    assert_eq!((summary["end"].as_str(), &summary["reason"]), (Some("pivoting"), &Value::Null));
    assert_eq!(number("/peak/displacement_nm"), 0.1 + 0.2);
    assert_eq!((number("/peak/force_nN"), number("/initiation_peak/force_nN")), (0.341, 0.3));
    assert_eq!((number("/peak/end_rotation_rad"), number("/peak/error_nN")), (0.035, 1e-9));
    assert_eq!((number("/plateau/force_nN"), number("/plateau/displacement_nm")), (0.0307, 20.0));
    let snap_off = (number("/snap_off/displacement_nm"), number("/snap_off/force_nN"), number("/snap_off/work_aJ"));
    assert_eq!(snap_off, (48.2, 0.0375, 3.25));
    assert_eq!(summary["first_jump"], summary["snap_off"], "under both names");
    assert_eq!((number("/first_jump/error_aJ"), number("/first_jump/error_nN")), (5e-7, 4e-9));
    assert_eq!((number("/pad_detachment/work_aJ"), number("/detachment/work_aJ")), (3.5, 3.75));
    assert_eq!(summary["detachment"]["error_aJ"], Value::Null);
    assert_eq!((number("/plateau/error_nN"), number("/plateau/error_nm")), (6e-8, 7e-3));
    assert_eq!(number("/limit_points/1/error_aJ"), 5e-7);
    assert_eq!(summary["limit_points"][0]["kind"], "load");
    assert_eq!(summary["limit_points"][1]["kind"], "displacement");
    assert_eq!((number("/limit_points/1/error_nm"), number("/limit_points/1/error_nN")), (3e-8, 4e-9));
    assert_eq!(summary["limit_points"][0]["flat"], false);
    assert_eq!(number("/timing/solve_s"), 0.004);
}

#[test]
fn the_summary_says_where_it_comes_from() {
    let (scene, peel) = made_up();
    let summary = summary(&scene, &peel);
    assert_eq!((summary["version"].as_str(), summary["schema"].as_u64()), (Some(env!("CARGO_PKG_VERSION")), Some(1)));
    assert_eq!(summary["command"], Value::Null, "written by no command");
    let commanded = PeelSummary::new(&scene, &peel, 0.004).with_command("peel run a.toml").to_json().unwrap();
    assert_eq!(serde_json::from_str::<Value>(&commanded).unwrap()["command"], "peel run a.toml");
}

/// Closed forms of the paper's strip: w = 15^(1/3) A_H/(16 π r0²), EI = E h³ b/12, EA = E h b, GA_s = k E/(2(1+ν)) h b; P + P²/(2EA) = w b.
#[test]
fn what_follows_from_the_model_alone_is_derived() {
    let (scene, peel) = made_up();
    let derived = summary(&scene, &peel)["derived"].clone();
    let number = |path: &str| derived.pointer(path).and_then(Value::as_f64).unwrap_or_else(|| panic!("{path}"));
    let near = |path: &str, expected: f64| {
        assert!((number(path) / expected - 1.0).abs() < 1e-12, "{path}: {} for {expected}", number(path));
    };
    near("/work_of_adhesion_J_per_m2", 15f64.cbrt() * 0.1 / (16.0 * std::f64::consts::PI * 0.16));
    near("/bending_stiffness_EI_nN_nm2", 2000.0 / 12.0);
    near("/axial_stiffness_EA_nN", 20.0);
    near("/shear_stiffness_GAs_nN", 5.0 / 6.0 * 2.0 / 2.4 * 10.0);
    let (force, work) = (number("/kendall_force_nN"), number("/work_of_adhesion_of_section_J_per_m2"));
    near("/kendall_force_nN", work - force * force / 40.0);
    let process = number("/process_length_nm");
    near("/groups/bending_over_adhesion", 2000.0 / 12.0 / (work * process * process));
    near("/groups/length_over_process_length", 100.0 / process);
    near("/groups/adhesion_over_stretching", work / 20.0);

    let spatula = Scene::parse("s.toml", include_str!("../../scenes/spatula.toml"), &[]).unwrap();
    let derived = serde_json::to_value(summary(&spatula, &peel)["derived"].clone()).unwrap();
    assert!(derived["work_of_adhesion_J_per_m2"].is_f64());
    for path in
        ["/kendall_force_nN", "/bending_stiffness_EI_nN_nm2", "/process_length_nm", "/groups/length_over_height"]
    {
        assert_eq!(derived.pointer(path), Some(&Value::Null), "{path} has no single value");
    }
}

#[test]
fn the_accuracy_tells_what_was_asked_reached_and_left_out() {
    let (scene, mut peel) = made_up();
    let accuracy = |peel: &Peel| summary(&scene, peel)["accuracy"].clone();
    let all_kept = accuracy(&peel);
    assert_eq!((all_kept["asked"].as_f64(), all_kept["form"].as_str()), (Some(1e-6), Some("two-field")));
    assert_eq!((all_kept["load_limit_points_left_out"].as_u64(), &all_kept["left_out"]), (Some(0), &Value::Null));
    let reached = |accuracy: &Value, bound: f64| (accuracy["reached"].as_f64().unwrap() / bound - 1.0).abs() < 1e-14;
    assert!(reached(&all_kept, 4e-9 / 0.0375), "the worst relative bound, here of a force: {all_kept}");
    assert_eq!(all_kept["met"], true);
    peel.limit_points[0].displacement_error = 0.1;
    assert!(reached(&accuracy(&peel), 0.1 / 48.2));
    assert_eq!(accuracy(&peel)["met"], false);
    peel.limit_points[0].flat = true;
    assert_eq!(accuracy(&peel)["reached"], all_kept["reached"], "of a flat limit point the force alone counts");
    peel.limit_points[0].displacement = 0.0;
    peel.limit_points[0].flat = false;
    assert_eq!(accuracy(&peel)["reached"], all_kept["reached"], "zero has no relative error");
    peel.ripple = 4;
    assert_eq!(accuracy(&peel)["load_limit_points_left_out"], 4);
    assert!(accuracy(&peel)["left_out"].as_str().unwrap().contains("less than the accuracy asked for"));
    (peel.peak, peel.limit_points) = (None, Vec::new());
    assert_eq!((&accuracy(&peel)["reached"], &accuracy(&peel)["met"]), (&Value::Null, &Value::Null));
}

#[test]
fn what_does_not_occur_is_null_or_an_empty_cell() {
    let (scene, mut peel) = made_up();
    (peel.peak, peel.initiation_peak, peel.plateau, peel.snap_off) = (None, None, None, None);
    (peel.pad_detachment, peel.detachment) = (None, None);
    let summary = summary(&scene, &peel);
    for key in [
        "peak",
        "largest_computed_force",
        "initiation_peak",
        "plateau",
        "snap_off",
        "first_jump",
        "pad_detachment",
        "detachment",
    ] {
        assert_eq!(summary.get(key), Some(&Value::Null), "{key}");
    }
    let row: Value = serde_json::to_value(SweepLine::from(&row(2.0, &peel)).object()).unwrap();
    assert_eq!(row["peak_force_nN"], Value::Null);
    assert_eq!(row["work_aJ"], 2.5, "the work to the end of a path without a snap-off");
    assert_eq!((&row["work_to"], &row["work_error_aJ"]), (&Value::from("end of path"), &Value::Null), "and says so");
}

#[test]
fn a_largest_force_that_is_no_peak_has_another_name_and_no_bound() {
    let (scene, mut peel) = made_up();
    peel.peak = None;
    peel.largest_computed_force = Some(LargestComputedForce { displacement: 40.0, force: 1.0 / 3.0 });
    let summary = summary(&scene, &peel);
    assert_eq!(summary["peak"], Value::Null);
    let expected = serde_json::json!({ "force_nN": 1.0 / 3.0, "displacement_nm": 40.0, "located": false });
    assert_eq!(summary["largest_computed_force"], expected);
    let row: Value = serde_json::to_value(SweepLine::from(&row(2.0, &peel)).object()).unwrap();
    assert_eq!((&row["peak_force_nN"], row["largest_computed_force_nN"].as_f64()), (&Value::Null, Some(1.0 / 3.0)));
}

#[test]
fn every_end_has_its_word_and_its_reason() {
    let (scene, mut peel) = made_up();
    for (end, word, reason) in [
        (PathEnd::Detached, "detached", None),
        (PathEnd::Pivoting, "pivoting", None),
        (PathEnd::Pushing, "pushing", None),
        (PathEnd::TurnedBack, "turned-back", None),
        (PathEnd::BackInPlane, "back-in-plane", None),
        (PathEnd::Sliding, "sliding", None),
        (PathEnd::Snapped, "snapped", None),
        (PathEnd::Bound(Bound::Points(20)), "bound", Some("bounds.points = 20")),
        (PathEnd::Failed(Failure::NothingComputed), "failed", Some("nothing was computed")),
    ] {
        peel.end = end;
        let summary = summary(&scene, &peel);
        assert_eq!((summary["end"].as_str(), summary["reason"].as_str()), (Some(word), reason));
    }
}

#[test]
fn the_tables_have_a_header_and_a_row_a_point() {
    let (_, mut peel) = made_up();
    let dir = tempfile::tempdir().unwrap();
    let read = |path| fs::read_to_string(path).unwrap();
    let header = "displacement_nm,force_nN,end_rotation_rad,work_aJ,negative_eigenvalues,\
                  negative_eigenvalues_load,front_nm,newton_iterations,negative_eigenvalues_out_of_plane\n";
    let rows = "0.0,0.0,0.25,0.0,1,2,77.5,3,\n40.0,0.3333333333333333,0.25,2.5,1,2,77.5,3,\n";
    assert_eq!(read(write_curve(dir.path(), &peel, None).unwrap()), format!("{header}{rows}"));
    let stability = OutOfPlane { negative_eigenvalues: vec![0, 19], first_loss: None };
    let curve = read(write_curve(dir.path(), &peel, Some(&stability)).unwrap());
    assert!(curve.contains("77.5,3,0\n") && curve.ends_with("77.5,3,19\n"), "{curve}");
    let limit_points = read(write_limit_points(dir.path(), &peel).unwrap());
    assert_eq!(limit_points.lines().nth(1), Some("load,48.2,0.0375,0.9,3.25,3e-8,4e-9,false,0,5e-7"));
    peel.points.clear();
    assert_eq!(read(write_curve(dir.path(), &peel, None).unwrap()), header, "a path without points is a header");
}

#[test]
fn a_row_of_a_sweep_tells_the_work_to_the_snap_off() {
    let (_, peel) = made_up();
    let dir = tempfile::tempdir().unwrap();
    let key = find_key("strip.length").unwrap();
    let table = fs::read_to_string(write_sweep(dir.path(), key, &[row(0.5, &peel)]).unwrap()).unwrap();
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    let names = reader.headers().unwrap().clone();
    let row = reader.records().next().unwrap().unwrap();
    let cell = |name: &str| row[names.iter().position(|found| found == name).expect(name)].to_owned();
    for (name, expected) in [
        ("value", "0.5"),
        ("strip.length_nm", "0.5"),
        ("peak_force_nN", "0.341"),
        ("peak_displacement_nm", "0.30000000000000004"),
        ("initiation_peak_nN", "0.3"),
        ("plateau_force_nN", "0.0307"),
        ("snap_off_displacement_nm", "48.2"),
        ("snap_off_force_nN", "0.0375"),
        ("work_aJ", "3.25"),
        ("work_to", "first jump"),
        ("solve_s", "0.004"),
        ("end", "pivoting"),
    ] {
        assert_eq!(cell(name), expected, "{name}");
    }
    // errors stand behind their numbers
    for (number, error) in [
        ("peak_force_nN", "peak_error_nN"),
        ("peak_displacement_nm", "peak_error_nm"),
        ("plateau_force_nN", "plateau_error_nN"),
        ("snap_off_displacement_nm", "snap_off_error_nm"),
        ("snap_off_force_nN", "snap_off_error_nN"),
        ("work_aJ", "work_error_aJ"),
    ] {
        let place = names.iter().position(|found| found == number).unwrap();
        assert_eq!(names.get(place + 1), Some(error));
    }
}

#[test]
fn a_nan_is_an_error_that_names_its_place_and_leaves_no_file() {
    let (scene, mut peel) = made_up();
    let dir = tempfile::tempdir().unwrap();
    peel.points[1].force = f64::NAN;
    let error = write_curve(dir.path(), &peel, None).unwrap_err().to_string();
    assert!(error.contains("curve.csv") && error.contains("NaN"), "{error}");
    peel.limit_points[1].force_error = f64::INFINITY;
    let error = PeelSummary::new(&scene, &peel, 0.004).write(dir.path()).unwrap_err().to_string();
    assert!(error.contains("summary.json") && error.contains("limit_points[1].error_nN"), "{error}");
    assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 0);
}
