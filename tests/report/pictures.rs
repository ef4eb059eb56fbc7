//! Pictures of a peel and of a sweep.
//!
//! Expectation: each picture is written as SVG and PNG, the SVG can be read by an independent reader and carries its axis
//! labels as text, the PNG is twice as large in pixels; nothing to draw is an error that names the file.
//! Reason: pictures are what most users look at first, and a machine without fonts or a failed run must not spoil them
//! silently.

use crate::shared_pictures::check_pictures;
use peelkit::model::StripModel;
use peelkit::solve::LimitPointKind;
use peelkit::study::{Accuracy, Failure, LimitPoint, PathEnd, Peak, Peel, PeelResult, Plateau, StopCriteria, peel};
use peelkit_report::{ReportError, SweepRow, draw_peel, draw_sweep};
use std::path::Path;

const ACCURACY: Accuracy = Accuracy::to(1e-6);
const BOUNDS: StopCriteria = StopCriteria::after_points(20_000);

fn strip() -> StripModel {
    StripModel::of_the_paper(100.0, 1.0)
}

fn run() -> Peel {
    peel(&strip(), &ACCURACY, &BOUNDS)
}

/// A run that reached nothing.
fn nothing() -> Peel {
    let mut peel = run();
    peel.points.clear();
    peel.limit_points.clear();
    (peel.initiation_peak, peel.peak, peel.plateau, peel.snap_off) = (None, None, None, None);
    (peel.pad_detachment, peel.detachment) = (None, None);
    peel.end = PathEnd::Failed(Failure::NothingComputed);
    peel
}

/// Rows with the features of a sweep of the stiffness.
fn factors(values: &[f64]) -> Vec<SweepRow> {
    let row = |&value: &f64| {
        let mut peel = nothing();
        peel.model = StripModel::of_the_paper(100.0, value).into();
        let force = 0.34 * value.powf(0.2);
        peel.peak =
            Some(Peak { displacement: 0.25, force, end_rotation: 0.04, force_error: 1e-9, displacement_error: 1e-9 });
        peel.plateau =
            Some(Plateau { displacement: 20.0, force: 0.031, force_error: None, displacement_error: Some(1e21) });
        peel.snap_off = Some(LimitPoint {
            kind: LimitPointKind::Displacement,
            displacement: 48.0,
            force: 0.037,
            end_rotation: 1.0,
            work: 2.0 - value.log10().powi(2) / 10.0,
            displacement_error: 1e-9,
            force_error: 1e-9,
            work_error: None,
            flat: false,
            after: 0,
        });
        SweepRow { value, second: None, model: peel.model.clone(), found: PeelResult::from(&peel), solve_s: 0.004 }
    };
    values.iter().map(row).collect()
}

/// Names in a directory, sorted.
fn listing(dir: &Path) -> Vec<String> {
    let mut names: Vec<String> =
        std::fs::read_dir(dir).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn a_peel_gives_its_curve_and_its_shapes() {
    let dir = tempfile::tempdir().unwrap();
    let files = draw_peel(&run(), "A strip & its <peel>", dir.path()).unwrap();
    assert_eq!(listing(dir.path()), ["curve.png", "curve.svg", "shapes.png", "shapes.svg"]);
    assert_eq!(files.len(), 4);
    let text = check_pictures(&files);
    for label in
        ["displacement u (nm)", "force P (nN)", "x (nm)", "y (nm)", "snap-off", "A strip &amp; its &lt;peel&gt;"]
    {
        assert!(text.contains(label), "{label} is missing");
    }
}

#[test]
fn a_peel_without_points_is_an_error_that_says_why() {
    let dir = tempfile::tempdir().unwrap();
    match draw_peel(&nothing(), "nothing", dir.path()) {
        Err(ReportError::Draw { path, reason }) => {
            assert!(path.ends_with("curve.svg"));
            assert!(reason.contains("0 points") && reason.contains("nothing was computed"), "{reason}");
        }
        other => panic!("{other:?}"),
    }
    assert!(listing(dir.path()).is_empty());
}

#[test]
fn a_sweep_of_the_stiffness_shows_kendall() {
    let dir = tempfile::tempdir().unwrap();
    let rows = factors(&[0.01, 0.1, 1.0, 10.0]);
    let text =
        check_pictures(&draw_sweep(&rows, "strip.bending_stiffness_factor", "Fig. 10", true, dir.path()).unwrap());
    for label in ["EI / EI₀", "force per width P/b (nN/nm)", "work to snap-off W/b (aJ/nm)", "Kendall", "10⁻²"] {
        assert!(text.contains(label), "{label} is missing");
    }
}

#[test]
fn a_sweep_of_another_key_names_it() {
    let dir = tempfile::tempdir().unwrap();
    let text = check_pictures(&draw_sweep(&factors(&[0.5, 1.0]), "strip.height", "", false, dir.path()).unwrap());
    assert!(text.contains("height of the section h (nm)") && !text.contains("Kendall"));
}

#[test]
fn a_sweep_of_the_angle_shows_kendall() {
    let dir = tempfile::tempdir().unwrap();
    let text = check_pictures(&draw_sweep(&factors(&[0.5, 1.0]), "drive.angle", "", false, dir.path()).unwrap());
    assert!(text.contains("angle of the pull to the substrate α (deg)") && text.contains("Kendall"));
}

#[test]
fn rows_without_a_result_leave_gaps_and_not_panics() {
    let dir = tempfile::tempdir().unwrap();
    let mut rows = factors(&[0.1, 0.2, 0.5, 1.0, 2.0]);
    rows[2].found = PeelResult::from(&nothing());
    check_pictures(&draw_sweep(&rows, "strip.height", "gap", true, dir.path()).unwrap());
    check_pictures(&draw_sweep(&rows[..1], "strip.height", "one", false, dir.path()).unwrap());
    let reason =
        |rows: &[SweepRow]| draw_sweep(rows, "strip.height", "none", true, dir.path()).unwrap_err().to_string();
    assert!(reason(&rows[2..3]).contains("none of the 1 values of strip.height has a peak force"));
    assert!(reason(&[]).contains("sweep.svg"));
    rows[0].value = 0.0;
    assert!(reason(&rows).contains("strip.height = 0 has no place on a logarithmic axis"));
}

#[test]
fn a_file_that_cannot_be_written_is_named() {
    let dir = tempfile::tempdir().unwrap();
    let blocked = dir.path().join("file");
    std::fs::write(&blocked, "in the way").unwrap();
    let message = draw_sweep(&factors(&[1.0]), "strip.height", "", false, &blocked).unwrap_err().to_string();
    assert!(message.contains("cannot write") && message.contains("sweep.svg"), "{message}");
}

#[test]
fn pictures_are_the_same_every_time() {
    let (a, b) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let peel = run();
    draw_peel(&peel, "twice", a.path()).unwrap();
    draw_peel(&peel, "twice", b.path()).unwrap();
    for name in listing(a.path()) {
        assert_eq!(
            std::fs::read(a.path().join(&name)).unwrap(),
            std::fs::read(b.path().join(&name)).unwrap(),
            "{name}"
        );
    }
}
