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
//! points of another scene are refused and kept; of a torn file the whole points are taken; any changed byte is found and named with its
//! frame. How commands go on is tested in `tests/command/resume.rs`. Why: points follow from scene and mesh alone, clock and signals only say where a path is left.

use crate::frames::frames;
use crate::strip::{STRIP_SCENE, paper_strip, with_grip, with_load};
use peelkit::adhesion::LineLoad;
use peelkit::model::{Hold, StripModel};
use peelkit::solve::{PathOptions, Waypoint};
use peelkit::study::{Accuracy, Checkpoint, Peel, Stage, StopReason, peel, peel_on};
use peelkit_report::{Journal, JournalKind, PeelSummary, ReportError, write_curve, write_limit_points};
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

/// The journal of a run, whose points do not depend on its bounds.
fn open(dir: &Path, scene: &Scene) -> Result<Journal, ReportError> {
    let unbound = Scene { bounds: BoundsTable::default(), ..scene.clone() };
    Journal::open(dir, JournalKind::RUN, &unbound, &[])
}

/// A run that goes on from what `dir` keeps, is left after `most` further points, and how many it has computed.
fn run(dir: &Path, scene: &Scene, most: usize) -> (Peel, usize) {
    let journal = open(dir, scene).unwrap();
    let computed = Arc::new(AtomicUsize::new(0));
    let checkpoint = Checkpoint {
        taken: &|options| journal.sequence(options),
        keep: &|options, waypoint| {
            computed.fetch_add(1, Ordering::Relaxed);
            journal.append(options, &waypoint);
        },
    };
    let so_far = Arc::clone(&computed);
    let stop = scene.bounds.from_now().or_when(move |stage| {
        (stage == Stage::Path && so_far.load(Ordering::Relaxed) >= most).then_some(StopReason::Interrupted)
    });
    let peel = peel_on(&scene.model, &scene.accuracy, &stop, &checkpoint);
    journal.flush().unwrap();
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
    let file = dir.path().join(JournalKind::RUN.name);
    run(dir.path(), &scene, 12);
    let kept = fs::read(&file).unwrap();
    let points = &frames(&kept)[1..];
    assert_eq!(points.len(), 12);
    let torn = |bytes: &[u8], taken: usize| {
        fs::write(&file, bytes).unwrap();
        assert_eq!(open(dir.path(), &scene).unwrap().entries(), taken);
        // what is appended does not continue the torn point
        run(dir.path(), &scene, 3);
        assert_eq!(open(dir.path(), &scene).unwrap().entries(), taken + 3);
        let (peel, _) = run(dir.path(), &scene, usize::MAX);
        assert_eq!(outputs(&scene, &peel), reference);
    };
    for (taken, point) in points.iter().enumerate() {
        let ends = [point.place.start, point.place.start + 1, point.key.start, point.value.start, point.place.end - 1];
        // every place of one point, and the border of each
        for end in ends.into_iter().take(if taken == 5 { ends.len() } else { 1 }) {
            torn(&kept[..end], taken);
        }
    }
    torn(&[kept.as_slice(), &[0; 100]].concat(), 12);
}

/// A file of three points as it may come from a disk: cut anywhere, and any byte changed to anything.
#[test]
fn no_file_is_taken_for_another_and_none_stops_the_program() {
    let scene = scene(paper_strip(100.0, 1.0), 1e-6);
    let dir = tempdir().unwrap();
    let file = dir.path().join(JournalKind::RUN.name);
    run(dir.path(), &scene, 3);
    let whole = fs::read(&file).unwrap();
    let of = frames(&whole);
    for end in (0..whole.len()).step_by(7).chain(of.iter().flat_map(|frame| [frame.place.start, frame.place.end])) {
        fs::write(&file, &whole[..end]).unwrap();
        let taken = of[1..].iter().filter(|frame| frame.place.end <= end).count();
        assert_eq!(open(dir.path(), &scene).unwrap().entries(), taken, "cut behind {end} bytes");
    }
    for at in 0..whole.len() {
        for byte in [0, 0xff, whole[at] ^ 1, whole[at].wrapping_add(1)] {
            let mut changed = whole.clone();
            changed[at] = byte;
            if changed == whole {
                continue;
            }
            fs::write(&file, &changed).unwrap();
            let error = open(dir.path(), &scene).expect_err("a changed byte is found").to_string();
            let (number, frame) = of.iter().enumerate().find(|(_, frame)| frame.place.contains(&at)).unwrap();
            let place = format!("frame {} (bytes {} to {})", number + 1, frame.place.start, frame.place.end - 1);
            assert!(error.contains(&place) && error.contains("run.partial"), "byte {at}: {error}");
        }
    }
}

#[test]
fn a_file_that_is_removed_meanwhile_is_written_again_with_all_of_its_points() {
    let scene = scene(paper_strip(100.0, 1.0), 1e-6);
    let dir = tempdir().unwrap();
    let out = dir.path().join("out");
    run(&out, &scene, 5);
    let journal = open(&out, &scene).unwrap();
    let (options, waypoint) = first_point(&scene);
    assert_eq!(journal.sequence::<Waypoint>(&options).len(), 5);
    for _ in 0..2 {
        journal.append(&options, &waypoint);
        assert!(journal.flush().unwrap());
        fs::remove_dir_all(&out).unwrap();
    }
    journal.append(&options, &waypoint);
    assert!(journal.flush().unwrap());
    assert_eq!(open(&out, &scene).unwrap().entries(), 8);
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
fn the_points_of_another_scene_are_refused_and_kept() {
    let scene = scene(paper_strip(100.0, 1.0), 1e-6);
    let dir = tempdir().unwrap();
    let file = dir.path().join(JournalKind::RUN.name);
    run(dir.path(), &scene, 5);
    let kept = fs::read(&file).unwrap();
    for (other, differs) in [
        (Scene { accuracy: Accuracy::to(1e-7), ..scene.clone() }, "accuracy.relative is 1e-6 there, and 1e-7 here"),
        (
            Scene { model: paper_strip(101.0, 1.0).into(), ..scene.clone() },
            "strip.length_nm is 100.0 there, and 101.0 here",
        ),
    ] {
        let error = open(dir.path(), &other).unwrap_err().to_string();
        assert!(error.contains(differs), "{error}");
        assert_eq!(fs::read(&file).unwrap(), kept);
    }
    JournalKind::RUN.discard(dir.path()).unwrap();
    assert!(!JournalKind::RUN.is_in(dir.path()));
    assert_eq!(open(dir.path(), &scene).unwrap().entries(), 0);
    assert!(!JournalKind::RUN.is_in(dir.path()), "nothing is written before there is a point");
}
