//! A single path that is interrupted or killed, and goes on where it stopped.
//!
//!     mesh 1:    o--o--o--o | o--o--o
//!     mesh 2:               |          o--o--o | o--o--o--o
//!     run 1      computed   ^ left: the points before are kept in run.partial
//!     run 2      taken        computed         ^ left again
//!     run 3      taken                           computed
//!
//! Parameters: strips of 100 and 30 000 nm, free and held in both ways, full and force-only, at 1e-6 and 1e-9, on one mesh or on
//! several. The reference is a run without an interruption. Expected: summary.json but for `solve_s`, curve.csv and
//! limit_points.csv equal to the byte, wherever and however often the runs before were left; every point is computed once; the
//! points of another scene are refused and kept; of a torn file the whole points are taken. With the command: exit status 3 after
//! Ctrl-C and for a killed run what the sweep promises, nothing left behind in the end, and nothing at all kept of a short
//! run. Why: points follow from scene and mesh alone, clock and signals only say where a path is left.

use crate::strip::{STRIP_SCENE, paper_strip, with_grip, with_load};
use peelkit::adhesion::LineLoad;
use peelkit::model::{Hold, StripModel};
use peelkit::solve::{PathOptions, Waypoint};
use peelkit::study::{Accuracy, Checkpoint, Peel, Stage, StopReason, peel, peel_on};
use peelkit_report::{DamagedPart, PartialFile, PartialRun, PeelSummary, ReportError, write_curve, write_limit_points};
use peelkit_scene::{BoundsTable, Scene};
use std::cell::RefCell;
use std::fs;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use tempfile::tempdir;

/// A scene of this model.
fn scene(model: StripModel, relative: f64) -> Scene {
    let plain = Scene::parse("strip.toml", STRIP_SCENE, &[]).unwrap();
    let bounds = BoundsTable { time_s: None, ..plain.bounds };
    Scene { model: model.into(), accuracy: Accuracy::to(relative), bounds, ..plain }
}

fn scenes() -> Vec<Scene> {
    let short = paper_strip(100.0, 1.0);
    vec![
        scene(short, 1e-6),
        scene(paper_strip(30_000.0, 1.0), 1e-6),
        scene(paper_strip(100.0, 1e-3), 1e-9),
        scene(with_grip(short, Hold::Fixed, Hold::Fixed), 1e-8),
        scene(with_load(short, LineLoad::ForceOnly), 1e-6),
    ]
}

/// All that a user gets of a peel, without the time it took.
fn outputs(scene: &Scene, peel: &Peel) -> Vec<Vec<u8>> {
    let dir = tempdir().unwrap();
    let files = [
        PeelSummary::new(scene, peel, 0.0).write(dir.path()).unwrap(),
        write_curve(dir.path(), peel, None).unwrap(),
        write_limit_points(dir.path(), peel).unwrap(),
    ];
    files.iter().map(|file| fs::read(file).unwrap()).collect()
}

/// A run that goes on from what `dir` keeps, is left after `most` further points, and how many it has computed.
fn run(dir: &Path, scene: &Scene, most: usize) -> (Peel, usize) {
    let partial = PartialRun::open(dir, scene).unwrap();
    let computed = Arc::new(AtomicUsize::new(0));
    let checkpoint = Checkpoint {
        taken: &|options| partial.taken(options),
        keep: &|options, waypoint| {
            computed.fetch_add(1, Ordering::Relaxed);
            partial.keep(options, waypoint);
        },
    };
    let so_far = Arc::clone(&computed);
    let stop = scene.bounds.from_now().or_when(move |stage| {
        (stage == Stage::Path && so_far.load(Ordering::Relaxed) >= most).then_some(StopReason::Interrupted)
    });
    let peel = peel_on(&scene.model, &scene.accuracy, &stop, &checkpoint);
    partial.write_all().unwrap();
    (peel, computed.load(Ordering::Relaxed))
}

fn whole(scene: &Scene) -> Peel {
    peel(&scene.model, &scene.accuracy, &scene.bounds.from_now())
}

#[test]
fn a_run_left_anywhere_and_taken_up_again_is_the_uninterrupted_run() {
    for scene in scenes() {
        let reference = whole(&scene);
        assert!(!reference.unfinished);
        let all = run(tempdir().unwrap().path(), &scene, usize::MAX).1;
        for legs in [all / 5, all / 3, all - 1] {
            let dir = tempdir().unwrap();
            let (mut computed, mut last) = (0, None);
            while computed < all {
                let (peel, more) = run(dir.path(), &scene, legs);
                assert!(
                    more > 0 && (peel.unfinished || computed + more == all),
                    "{more} points of {computed} of {all}"
                );
                computed += more;
                last = Some(peel);
            }
            assert_eq!(computed, all, "every point is computed once");
            let last = last.filter(|peel| !peel.unfinished).unwrap_or_else(|| run(dir.path(), &scene, usize::MAX).0);
            assert_eq!(last.effort, reference.effort);
            assert_eq!(outputs(&scene, &last), outputs(&scene, &reference), "{:?}, {legs} points a run", scene.model);
        }
    }
}

#[test]
fn bounds_may_change_and_the_points_stay() {
    let scene = scene(paper_strip(100.0, 1.0), 1e-6);
    let bounded = Scene { bounds: BoundsTable { points: 17, ..scene.bounds }, ..scene.clone() };
    let dir = tempdir().unwrap();
    assert_eq!(run(dir.path(), &bounded, usize::MAX).1, 17);
    let (peel, computed) = run(dir.path(), &scene, usize::MAX);
    assert_eq!(computed, run(tempdir().unwrap().path(), &scene, usize::MAX).1 - 17);
    assert_eq!(outputs(&scene, &peel), outputs(&scene, &whole(&scene)));
}

#[test]
fn of_a_torn_file_the_whole_points_are_taken() {
    let scene = scene(paper_strip(100.0, 1.0), 1e-6);
    let reference = outputs(&scene, &whole(&scene));
    let dir = tempdir().unwrap();
    let file = dir.path().join(PartialRun::NAME);
    run(dir.path(), &scene, 12);
    let kept = fs::read(&file).unwrap();
    let header = 1 + kept.iter().position(|&byte| byte == b'\n').unwrap();
    let point = (kept.len() - header) / 12;
    let torn = |text: &[u8]| {
        fs::write(&file, text).unwrap();
        let taken = PartialRun::open(dir.path(), &scene).unwrap().points_taken();
        // what is appended does not continue the torn point
        run(dir.path(), &scene, 3);
        assert_eq!(PartialRun::open(dir.path(), &scene).unwrap().points_taken(), taken + 3);
        let (peel, _) = run(dir.path(), &scene, usize::MAX);
        assert_eq!(outputs(&scene, &peel), reference);
        taken
    };
    for (left_out, taken) in [(0, 12), (1, 11), (point - 5, 11), (3 * point / 2, 10), (kept.len() - header - 3, 0)] {
        assert_eq!(torn(&kept[..kept.len() - left_out]), taken, "{left_out} bytes are missing");
    }
    assert_eq!(
        torn(&[kept.as_slice(), &[0; 100]].concat()),
        12,
        "zeros behind the end, as a crash of the machine leaves"
    );
    let mut turned = kept.clone();
    turned[header + 5 * point + point / 2] ^= 1;
    fs::write(&file, &turned).unwrap();
    let opened = PartialRun::open(dir.path(), &scene).unwrap();
    assert_eq!(opened.damaged().map(|damaged| &damaged.what), Some(&DamagedPart::PointsFrom(6)));
    assert_eq!(torn(&turned), 5, "a bit has turned in the sixth point");
}

#[test]
fn a_file_that_is_removed_meanwhile_is_written_again_with_all_of_its_points() {
    let scene = scene(paper_strip(100.0, 1.0), 1e-6);
    let dir = tempdir().unwrap();
    let out = dir.path().join("out");
    run(&out, &scene, 5);
    let partial = PartialRun::open(&out, &scene).unwrap();
    let (options, waypoint) = first_point(&scene);
    for _ in 0..2 {
        partial.keep(&options, waypoint.clone());
        assert!(partial.write_all().unwrap());
        fs::remove_dir_all(&out).unwrap();
    }
    partial.keep(&options, waypoint);
    assert!(partial.write_all().unwrap());
    assert_eq!(PartialRun::open(&out, &scene).unwrap().points_taken(), 8);
}

fn first_point(scene: &Scene) -> (PathOptions, Waypoint) {
    let first = RefCell::new(None);
    let checkpoint = Checkpoint {
        taken: &|_| Vec::new(),
        keep: &|options, waypoint| {
            first.borrow_mut().get_or_insert((*options, waypoint));
        },
    };
    let bounds = BoundsTable { points: 3, ..scene.bounds };
    peel_on(&scene.model, &scene.accuracy, &bounds.from_now(), &checkpoint);
    first.into_inner().unwrap()
}

#[test]
fn the_points_of_another_scene_or_version_are_refused_and_kept() {
    let scene = scene(paper_strip(100.0, 1.0), 1e-6);
    let dir = tempdir().unwrap();
    let file = dir.path().join(PartialRun::NAME);
    run(dir.path(), &scene, 5);
    let kept = fs::read(&file).unwrap();
    let refused = |scene: &Scene, text: &[u8]| {
        fs::write(&file, text).unwrap();
        let error = PartialRun::open(dir.path(), scene).unwrap_err();
        assert!(matches!(&error, ReportError::OtherRun { path } if *path == file), "{error}");
        assert_eq!(fs::read(&file).unwrap(), text);
    };
    refused(&Scene { accuracy: Accuracy::to(1e-7), ..scene.clone() }, &kept);
    refused(&Scene { model: paper_strip(101.0, 1.0).into(), ..scene.clone() }, &kept);
    let version = kept.windows(5).position(|part| part == env!("CARGO_PKG_VERSION").as_bytes()).unwrap();
    let mut other = kept.clone();
    other[version] = b'9';
    refused(&scene, &other);
    refused(&scene, b"garbled");
    refused(&scene, b"");
    PartialRun::discard(dir.path()).unwrap();
    assert!(!PartialRun::is_in(dir.path()));
    assert_eq!(PartialRun::open(dir.path(), &scene).unwrap().points_taken(), 0);
    assert!(!PartialRun::is_in(dir.path()), "nothing is written before there is a point");
}
