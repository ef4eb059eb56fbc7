//! Pictures of a peel and of a sweep.
//!
//! Expectation: each picture is written as SVG and PNG, the SVG can be read by an independent reader and carries its axis
//! labels as text, the PNG is twice as large in pixels; nothing to draw is an error that names the file.
//! Reason: pictures are what most users look at first, and a machine without fonts or a failed run must not spoil them
//! silently.

use crate::shared_pictures::check_pictures;
use peelkit::model::{Spatula, StripModel};
use peelkit::solve::LimitPointKind;
use peelkit::study::{
    Accuracy, DeformedShape, Failure, LimitPoint, OutOfPlane, OutOfPlaneLoss, PathEnd, Peak, Peel, PeelResult, Plateau,
    StopCriteria, peel,
};
use peelkit_report::pictures::peel::{numbered_points, pose};
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
        peel.plateau = Some(Plateau {
            displacement: 20.0,
            force: 0.031,
            force_error: None,
            displacement_error: Some(1e21),
            stable: true,
            after: 0,
        });
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
            in_space: None,
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
    let files = draw_peel(&run(), None, "A strip & its <peel>", dir.path()).unwrap();
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
fn a_curve_shows_where_its_path_leaves_the_plane() {
    let dir = tempfile::tempdir().unwrap();
    let peel = run();
    let loss = OutOfPlaneLoss {
        displacement: 0.489744,
        force: 0.312662,
        displacement_error: 1e-9,
        force_error: 1e-9,
        after: Some(5),
    };
    let stability = OutOfPlane { negative_eigenvalues: Vec::new(), first_loss: Some(loss) };
    let text = check_pictures(&draw_peel(&peel, Some(&stability), "narrow", dir.path()).unwrap());
    for label in ["leaves the plane", "u = 0.4897 nm", "P = 0.3127 nN"] {
        assert!(text.contains(label), "{label} is missing");
    }
}

#[test]
fn the_warnings_stand_below_the_pictures_of_a_run() {
    let dir = tempfile::tempdir().unwrap();
    let files = draw_peel(&run(), None, "with warnings", dir.path()).unwrap();
    for svg in files.iter().filter(|file| file.extension().is_some_and(|ending| ending == "svg")) {
        let text = std::fs::read_to_string(svg).unwrap();
        assert!(text.contains("Warning: the process zone is 0.217 times"), "{}", svg.display());
        assert!(!text.contains("stopped short"));
    }
}

/// Without the limit points that explain its changes of stability: what is behind the first is drawn neither as stable nor as unstable.
#[test]
fn a_path_that_stopped_short_is_not_drawn_as_stable() {
    let dir = tempfile::tempdir().unwrap();
    let mut failed = run();
    failed.end = PathEnd::Failed(Failure::NothingComputed);
    let text = check_pictures(&draw_peel(&failed, None, "explained", dir.path()).unwrap());
    assert!(text.contains("unstable under displacement control") && !text.contains("not verified"));
    assert!(text.contains("The computation stopped short: "));
    failed.limit_points.clear();
    let text = check_pictures(&draw_peel(&failed, None, "unexplained", dir.path()).unwrap());
    assert!(text.contains("stopped short: stability not verified"));
    assert!(!text.contains("unstable under displacement control"));
}

#[test]
fn shapes_stand_at_the_limit_points() {
    let peel = run();
    let poses: Vec<_> = numbered_points(&peel).into_iter().filter_map(|index| pose(&peel, index)).collect();
    let folds: Vec<f64> =
        peel.limit_points.iter().filter(|l| l.kind == LimitPointKind::Displacement).map(|l| l.displacement).collect();
    assert!(folds.len() > 1);
    let grip = |shape: &DeformedShape| *shape.y.last().unwrap();
    for wanted in folds.into_iter().chain([peel.initiation_peak.unwrap().displacement]) {
        let at = poses.iter().find(|pose| pose.displacement == wanted).unwrap_or_else(|| panic!("none at {wanted}"));
        let lifted = grip(&at.axis) - grip(&peel.shape(0));
        assert!((lifted / wanted - 1.0).abs() < 2e-3, "{lifted} nm at {wanted} nm");
    }
}

#[test]
fn shapes_have_no_corners() {
    let spatula = Spatula::default().model();
    let peel = peel(&spatula, &Accuracy::to(1e-4), &BOUNDS);
    let at_peak = numbered_points(&peel)[1];
    let turned = |shape: &DeformedShape| {
        let slopes: Vec<f64> = (1..shape.x.len())
            .map(|k| (shape.y[k] - shape.y[k - 1]).atan2(shape.x[k] - shape.x[k - 1]).to_degrees())
            .collect();
        slopes.windows(2).map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f64::max)
    };
    let (smooth, coarse) = (turned(&peel.smooth_shape(at_peak)), turned(&peel.shape(at_peak)));
    assert!(smooth < 6.0 && smooth < 0.7 * coarse, "{smooth} and {coarse} degrees");
}

#[test]
fn a_peel_without_points_is_an_error_that_says_why() {
    let dir = tempfile::tempdir().unwrap();
    match draw_peel(&nothing(), None, "nothing", dir.path()) {
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
    for label in ["EI / EI₀", "force per width P/b (N/m)", "work to snap-off W/b (nJ/m)", "Kendall", "10⁻²"] {
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
    draw_peel(&peel, None, "twice", a.path()).unwrap();
    draw_peel(&peel, None, "twice", b.path()).unwrap();
    for name in listing(a.path()) {
        assert_eq!(
            std::fs::read(a.path().join(&name)).unwrap(),
            std::fs::read(b.path().join(&name)).unwrap(),
            "{name}"
        );
    }
}
