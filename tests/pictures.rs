//! Pictures of a peel, of a sweep and of figures/.
//!
//! Expectation: each picture is written as SVG and PNG, the SVG can be read by an independent reader and carries its axis
//! labels as text, the PNG is twice as large in pixels; nothing to draw is an error that names the file.
//! Reason: pictures are what most users look at first, and a machine without fonts or a failed run must not spoil them
//! silently.

use peelkit::model::StripModel;
use peelkit::report::{ReportError, draw_figures, draw_peel, draw_sweep};
use peelkit::study::{Accuracy, Bounds, End, Found, LimitPoint, Peak, Peel, Plateau, SweepRow, Turn, peel};
use resvg::usvg;
use std::path::{Path, PathBuf};

const ACCURACY: Accuracy = Accuracy::to(1e-6);
const BOUNDS: Bounds = Bounds { points: 20_000, time_s: None, displacement: None };

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
    peel.end = End::Failed("no equilibrium at rest".into());
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
        peel.plateau = Some(Plateau { displacement: 20.0, force: 0.031 });
        peel.snap_off = Some(LimitPoint {
            kind: Turn::Displacement,
            displacement: 48.0,
            force: 0.037,
            end_rotation: 1.0,
            work: 2.0 - value.log10().powi(2) / 10.0,
            displacement_error: 1e-9,
            force_error: 1e-9,
            flat: false,
            after: 0,
        });
        SweepRow { value, model: peel.model.clone(), found: Found::from(&peel) }
    };
    values.iter().map(row).collect()
}

/// Checks every picture among the files; returns the texts of the SVGs.
fn check_pictures(files: &[PathBuf]) -> String {
    let mut texts = String::new();
    for svg in files.iter().filter(|f| f.extension().is_some_and(|e| e == "svg")) {
        let text = std::fs::read_to_string(svg).unwrap();
        let tree = usvg::Tree::from_str(&text, &usvg::Options::default()).unwrap();
        let png = svg.with_extension("png");
        assert!(files.contains(&png), "{} is missing", png.display());
        let size = (tree.size().width() as u32, tree.size().height() as u32);
        assert_eq!(size.0, 800);
        assert_eq!(png_size(&png), (2 * size.0, 2 * size.1));
        assert!(!text.contains("NaN") && !text.contains("inf "), "{} holds no number somewhere", svg.display());
        texts += &text;
    }
    texts
}

/// Width and height from the header of a PNG.
fn png_size(path: &Path) -> (u32, u32) {
    let bytes = std::fs::read(path).unwrap();
    assert_eq!(&bytes[..8], b"\x89PNG\r\n\x1a\n");
    let number = |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap());
    (number(16), number(20))
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
            assert!(reason.contains("0 points") && reason.contains("no equilibrium at rest"), "{reason}");
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
    assert!(text.contains("strip.height (nm)") && !text.contains("Kendall"));
}

#[test]
fn a_sweep_of_the_angle_shows_kendall() {
    let dir = tempfile::tempdir().unwrap();
    let text = check_pictures(&draw_sweep(&factors(&[0.5, 1.0]), "drive.angle", "", false, dir.path()).unwrap());
    assert!(text.contains("drive.angle (rad)") && text.contains("Kendall"));
}

#[test]
fn rows_without_a_result_leave_gaps_and_not_panics() {
    let dir = tempfile::tempdir().unwrap();
    let mut rows = factors(&[0.1, 0.2, 0.5, 1.0, 2.0]);
    rows[2].found = Found::from(&nothing());
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

#[test]
#[ignore = "takes minutes where the program is not optimised: .ci/run draws the figures with the release build"]
fn the_figures_come_with_their_data_and_captions() {
    let dir = tempfile::tempdir().unwrap();
    let counted = std::sync::Mutex::new(Vec::new());
    let files = draw_figures(dir.path(), &|done, total| counted.lock().unwrap().push((done, total))).unwrap();
    check_pictures(&files);
    let readme = std::fs::read_to_string(dir.path().join("README.md")).unwrap();
    for stem in [
        "fig09-peeling",
        "peel-curve",
        "peel-shapes",
        "fig10-bending-stiffness",
        "fig10-three-ways",
        "peeling-work",
        "cost-against-error",
        "cost",
        "against-others",
        "accuracy",
    ] {
        for ending in ["svg", "png", "csv"] {
            assert!(files.contains(&dir.path().join(format!("{stem}.{ending}"))), "{stem}.{ending} is missing");
        }
        assert!(readme.contains(&format!("{stem}.svg")) && readme.contains(&format!("{stem}.csv")));
    }
    assert!(readme.contains("This range is ours"));
    let mut counted = counted.into_inner().unwrap();
    counted.sort_unstable();
    assert_eq!(counted.last().map(|&(done, total)| done == total), Some(true));
}
