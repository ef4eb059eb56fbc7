//! Several results in one picture, and measured points over them.
//!
//! Expected: a table of a run or of a sweep is read back with its stable and unstable pieces; measured points are in the units of the
//! results, whichever their header names; what cannot be drawn is refused with what would be right.

use crate::shared_pictures::check_pictures;
use peelkit_report::overlay::{Kind, Measured, OverlayError, ResultFile, draw_overlay};
use peelkit_scene::find_key;
use std::fs;
use std::path::{Path, PathBuf};

const CURVE: &str = "displacement_nm,force_nN,end_rotation_rad,work_aJ,negative_eigenvalues\n\
                     0,0,0,0,0\n1,0.3,0,0,0\n2,0.2,0,0,0\n1.5,0.1,0,0,1\n3,0,0,0,0\n";

fn folder(dir: &Path, name: &str, file: &str, text: &str) -> PathBuf {
    let folder = dir.join(name);
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join(file), text).unwrap();
    folder
}

fn measured(dir: &Path, text: &str, kind: Kind, key: Option<&str>) -> Result<Vec<(f64, f64)>, OverlayError> {
    let path = dir.join("measured.csv");
    fs::write(&path, text).unwrap();
    Measured::read(&path, kind, key.map(|key| find_key(key).unwrap())).map(|measured| measured.points)
}

#[test]
fn several_curves_stand_in_one_picture_with_measured_points() {
    let dir = tempfile::tempdir().unwrap();
    let paths = ["a/thin", "b/thin", "c/thick"].map(|name| folder(dir.path(), name, "curve.csv", CURVE));
    let mut results: Vec<ResultFile> = paths.iter().map(|path| ResultFile::read(path).unwrap()).collect();
    let kinds: Vec<bool> = results[0].pieces.iter().map(|piece| piece.0).collect();
    assert_eq!(kinds, [false, true, false]);
    assert_eq!(results[0].pieces[1].1, [(2.0, 0.2), (1.5, 0.1)]);
    ResultFile::shorten(&mut results);
    let names: Vec<&str> = results.iter().map(|result| result.name.as_str()).collect();
    assert_eq!(names, ["a/thin", "b/thin", "c/thick"]);
    fs::write(dir.path().join("points.csv"), "u (um);P (pN)\n0,001;300\n0,002;200\n").unwrap();
    let points = Measured::read(&dir.path().join("points.csv"), Kind::Curve, None).unwrap();
    assert_eq!(points.points, [(1.0, 0.3), (2.0, 0.2)]);
    let files = draw_overlay(&results, &[points], "Together", [false; 2], dir.path()).unwrap();
    let text = check_pictures(&files);
    for label in ["Together", "a/thin", "c/thick", "points", "displacement u (nm)", "force P (nN)", "Dashed: unstable"]
    {
        assert!(text.contains(label), "{label}");
    }
}

#[test]
fn a_sweep_names_its_axis_where_its_table_does() {
    let dir = tempfile::tempdir().unwrap();
    let plain = folder(dir.path(), "old", "sweep.csv", "value,peak_force_nN\n1,0.3\n2,\n3,0.5\n");
    let result = ResultFile::read(&plain).unwrap();
    assert_eq!((result.kind, result.key.is_none(), result.pieces.len()), (Kind::Sweep, true, 2));
    let named = folder(dir.path(), "new", "sweep.csv", "value,drive.angle_rad,peak_force_nN\n0.5,0.5,0.3\n1,1,0.4\n");
    let result = ResultFile::read(&named).unwrap();
    assert_eq!(result.key.unwrap().path(), "drive.angle");
    let degrees = measured(dir.path(), "alpha (deg),F_nN\n30,0.3\n", Kind::Sweep, Some("drive.angle")).unwrap();
    assert!((degrees[0].0 - 30f64.to_radians()).abs() < 1e-15);
    let text = check_pictures(&draw_overlay(&[result], &[], "", [false; 2], dir.path()).unwrap());
    assert!(text.contains("angle of the pull to the substrate α (deg)"));
}

#[test]
fn measured_points_may_have_the_force_first() {
    let dir = tempfile::tempdir().unwrap();
    let points = measured(dir.path(), "# of today\nF [µN],displacement_nm\n0.001,5\n", Kind::Curve, None).unwrap();
    assert!((points[0].0, (points[0].1 - 1.0).abs() < 1e-15) == (5.0, true), "{points:?}");
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let refused = |path: &Path| ResultFile::read(path).unwrap_err().to_string();
    assert!(refused(&dir.path().join("none")).contains("neither a curve.csv nor a sweep.csv"));
    let both = folder(dir.path(), "both", "curve.csv", CURVE);
    folder(dir.path(), "both", "sweep.csv", "value,peak_force_nN\n1,1\n");
    assert!(refused(&both).contains("both a curve.csv and a sweep.csv"));
    assert!(ResultFile::read(&both.join("curve.csv")).is_ok());
    let other = folder(dir.path(), "other", "curve.csv", "u,P\n1,2\n");
    assert!(refused(&other).contains("lacks one of the columns displacement_nm and force_nN"));
    let empty = folder(dir.path(), "empty", "curve.csv", "displacement_nm,force_nN\n");
    assert!(refused(&empty).contains("no points"));
    let wrong = |text: &str| measured(dir.path(), text, Kind::Curve, None).unwrap_err().to_string();
    for (text, found) in [
        ("u,P\n1,2\n", "has the columns u and P, which are not a length and a force with their units"),
        ("u_nm,v_nm\n1,2\n", "which are not a length and a force"),
        ("u_mil,P_nN\n1,2\n", "which are not a length and a force"),
        ("u_nm,P_nN,t_s\n1,2,3\n", "has 3 columns"),
        ("u_nm,P_nN\n0,4,2\n", "has 3 cells in row 1 and 2 in its header"),
        ("u_nm,P_nN\n1,x\n", "has in row 1 `P_nN` = x, which is no finite number"),
        ("u_nm,P_nN\n1,inf\n", "no finite number"),
        ("u_nm,P_nN\n1,\n", "an empty cell"),
        ("u_nm,P_nN\n", "a header and no rows"),
        ("", "is empty: it has no header and no rows"),
    ] {
        assert!(wrong(text).contains(found), "{text:?}: {}", wrong(text));
    }
    let gone = Measured::read(&dir.path().join("gone.csv"), Kind::Curve, None).unwrap_err();
    assert!(gone.to_string().contains("gone.csv cannot be read") && gone.remedy.contains("CSV"), "{gone}");
}
