//! Which points of a path have names, and that no other number is taken for one.
//!
//! Reference: the definitions. A peak is a limit point of the force that was located, or of the displacement where that is higher; the end of a path,
//! wherever it lies, is none.
//!
//!     P |   o peak                P |     / end of the path:      P |  / \__.   first jump: a fold, whatever jumps
//!       |  / \                      |    /  the largest computed    | |   .-'   pad detachment: behind it at most an edge adheres
//!       | /   \___                  |   /   force, and no peak      | |  '.___/ detachment: behind it nothing adheres
//!       +--------- u                +--------- u                    +--------- u
//!
//! Parameters: the paper's strip of 100 nm as it is, soft, pulled at angles, stopped early, in a grip that rotates fast; a rubber beam of 20 µm.
//!
//! Why: a force with a bound that is the last point of a path that was cut short is a false number with a false bound.

use crate::common::{paper_strip, whole_peel, with_grip, with_load};
use peelkit::adhesion::LineLoad;
use peelkit::model::{Hold, PeelModel, Pull, StripModel};
use peelkit::study::{Accuracy, LimitPoint, LimitPointKind, PathEnd, Peel, Plateau, StopCriteria, peel};

const FREE: StopCriteria = StopCriteria::after_points(5000);

fn at_angle(degrees: f64) -> PeelModel {
    PeelModel { pull: Pull { angle: degrees.to_radians(), ..Pull::UP }, ..paper_strip(100.0, 1.0).into() }
}

fn soft(modulus: f64) -> StripModel {
    let mut model = paper_strip(100.0, 1.0);
    model.strip.material.youngs_modulus = modulus;
    model
}

/// 20 µm × 1 µm × 10 µm, 2 MPa, ν 0.49, A_H 0.4 eV, r0 0.3 nm
fn rubber() -> StripModel {
    let mut model = soft(2e-3);
    (model.strip.length, model.strip.height, model.strip.width) = (2e4, 1e3, 1e4);
    model.strip.material.poissons_ratio = 0.49;
    (model.adhesion.hamaker_constant, model.adhesion.equilibrium_distance) = (0.4 * 0.160_217_663_4, 0.3);
    model
}

/// A peak is a located limit point above the computed curve up to the first jump; without one the largest force of that curve is told.
#[track_caller]
fn assert_peaks_are_located(name: &str, peel: &Peel) {
    let until = peel.snap_off.map_or(peel.points.len(), |at| at.after + 1);
    let before = &peel.points[..until];
    let highest = before.iter().map(|point| point.force).fold(f64::NEG_INFINITY, f64::max);
    let is_located = |force: f64, at: f64| peel.limit_points.iter().any(|p| p.force == force && p.displacement == at);
    for peak in [peel.peak, peel.initiation_peak].into_iter().flatten() {
        assert!(is_located(peak.force, peak.displacement), "{name}: {peak:?} is no limit point");
        assert!(peak.force_error > 0.0 && peak.displacement_error > 0.0, "{name}: {peak:?}");
    }
    if let Some(peak) = peel.peak {
        assert!(peak.force + peak.force_error >= highest, "{name}: {peak:?}, and the curve goes up to {highest} nN");
        assert_eq!(peel.largest_computed_force, None, "{name}");
        let failed = matches!(peel.end, PathEnd::Failed(_));
        assert!(
            !failed || peel.snap_off.is_some() || peel.reached_accuracy() > Some(peel.asked),
            "{name}: {:?}",
            peel.end
        );
    } else if let Some(largest) = peel.largest_computed_force {
        assert_eq!(largest.force, highest, "{name}");
    } else {
        assert!(before.len() < 2 || highest < 1e-3, "{name}: {highest} nN are not told");
    }
}

#[test]
fn no_end_of_a_path_is_a_peak() {
    let bounded = |displacement: f64| StopCriteria { displacement: Some(displacement), ..FREE };
    let runs: Vec<(&str, PeelModel, f64, StopCriteria)> = vec![
        ("to 0.1 nm", paper_strip(100.0, 1.0).into(), 1e-6, bounded(0.1)),
        ("to 10 nm", paper_strip(100.0, 1.0).into(), 1e-6, bounded(10.0)),
        ("2 MPa at 1e-3", soft(2e-3).into(), 1e-3, StopCriteria::after_points(200)),
        ("5 MPa", soft(5e-3).into(), 1e-6, StopCriteria::after_points(200)),
        ("rubber at 1e-3", rubber().into(), 1e-3, StopCriteria::after_points(300)),
        ("at 20 degrees", at_angle(20.0), 1e-6, FREE),
        ("at 170 degrees", at_angle(170.0), 1e-6, FREE),
        ("force-only", with_load(paper_strip(100.0, 1.0), LineLoad::ForceOnly).into(), 1e-6, FREE),
    ];
    for (name, model, relative, stop) in &runs {
        assert_peaks_are_located(name, &peel(model, &Accuracy::to(*relative), stop));
    }
}

#[test]
fn a_path_that_still_rises_has_its_largest_force_and_no_peak() {
    let stop = StopCriteria { displacement: Some(0.1), ..FREE };
    let found = peel(&paper_strip(100.0, 1.0), &Accuracy::to(1e-6), &stop);
    assert_eq!((found.peak, found.initiation_peak, found.snap_off), (None, None, None));
    let (largest, last) = (found.largest_computed_force.unwrap(), found.points[found.points.len() - 1]);
    assert_eq!((largest.force, largest.displacement), (last.force, last.displacement));
    assert_eq!(found.reached_accuracy(), None, "nothing has a bound");
}

/// The rubber beam: 1289 nN with a bound were the last point of a path that was cut short.
#[test]
fn a_path_that_is_cut_short_behind_its_peak_keeps_that() {
    let whole = peel(&rubber(), &Accuracy::to(1e-6), &StopCriteria { displacement: Some(50.0), ..FREE });
    let peak = whole.peak.unwrap();
    assert!((peak.force - 1951.118).abs() < 1e-3, "{peak:?}");
    let last = whole.points[whole.points.len() - 1];
    assert!(last.force < peak.force && last.displacement > peak.displacement);
}

/// At 1e4 rad/nm the grip rolls the strip off and pushes all the way. The path ends behind its fold, far from P = 0.
#[test]
fn a_grip_that_pushes_has_not_come_back_to_no_force() {
    let strip: PeelModel = with_grip(paper_strip(100.0, 1.0), Hold::Fixed, Hold::Free).into();
    let found = peel(&PeelModel { pull: Pull { turn: 1e4, ..Pull::UP }, ..strip }, &Accuracy::to(1e-6), &FREE);
    let last = found.points[found.points.len() - 1];
    assert!(last.force < -7.0, "P = {} nN", last.force);
    assert_eq!((found.end.clone(), found.peak), (PathEnd::Pushing, None));
    assert_eq!((found.pad_detachment, found.detachment), (None, None), "nothing is known behind the fold");
}

/// The first jump is another one at 40 degrees than at 45; the pad comes off at about the same work.
#[test]
fn the_work_to_where_the_pad_comes_off_is_continuous_over_the_angle() {
    let [forty, more] = [40.0, 45.0].map(|angle| peel(&at_angle(angle), &Accuracy::to(1e-6), &FREE));
    let work = |at: Option<LimitPoint>| at.unwrap().work;
    assert!(work(more.snap_off) > 6.0 * work(forty.snap_off), "{} {}", work(forty.snap_off), work(more.snap_off));
    let (before, behind) = (work(forty.pad_detachment), work(more.pad_detachment));
    assert!((before - 3.237_06).abs() < 1e-4 && (behind - 3.267_65).abs() < 1e-4, "{before} {behind}");
    // then the edge comes off, a little later
    for peel in [&forty, &more] {
        let (pad, all) = (peel.pad_detachment.unwrap(), peel.detachment.unwrap());
        assert!(all.displacement > pad.displacement && all.force > 0.0, "{pad:?} {all:?}");
        assert_eq!(peel.end, PathEnd::Detached);
    }
}

#[test]
fn a_strip_that_hangs_from_its_edge_is_not_detached() {
    let found = whole_peel(&paper_strip(100.0, 1.0), 1e-6);
    assert_eq!(found.pad_detachment, found.snap_off);
    assert_eq!(found.detachment, None, "the edge still adheres where the path ends");
    let short = peel(&paper_strip(100.0, 1.0), &Accuracy::to(1e-6), &StopCriteria { displacement: Some(40.0), ..FREE });
    assert_eq!((short.pad_detachment, short.detachment), (None, None));
}

/// Bounds of work and plateau hold, against the same at 1e-10.
#[test]
fn works_and_plateaus_stay_within_their_bounds() {
    let (mut judged, mut plateaus) = (0, 0);
    for model in [
        paper_strip(100.0, 1.0).into(),
        paper_strip(100.0, 0.01).into(),
        paper_strip(300.0, 0.1).into(),
        paper_strip(1000.0, 1.0).into(),
        with_grip(paper_strip(100.0, 1.0), Hold::Fixed, Hold::Fixed).into(),
        with_load(paper_strip(500.0, 1.0), LineLoad::AxisGap).into(),
        with_load(paper_strip(700.0, 1.0), LineLoad::AxisGap).into(),
        paper_strip(400.0, 0.3).into(),
        at_angle(30.0),
        at_angle(120.0),
    ] {
        let model: PeelModel = model;
        let exact = peel(&model, &Accuracy::to(1e-10), &FREE);
        for relative in [1e-4, 1e-6] {
            let found = peel(&model, &Accuracy::to(relative), &FREE);
            if found.limit_points.len() == exact.limit_points.len() {
                for (at, true_one) in found.limit_points.iter().zip(&exact.limit_points) {
                    let (bound, error) = (at.work_error.unwrap(), (at.work - true_one.work).abs());
                    assert!(error <= bound + true_one.work_error.unwrap(), "{relative:e}: {at:?}, {true_one:?}");
                    assert!(at.flat || bound <= 100.0 * relative * at.work.abs().max(1.0), "{relative:e}: {at:?}");
                    judged += usize::from(at.kind == LimitPointKind::Displacement);
                }
            }
            if let (Some(at), Some(true_one)) = (found.plateau, exact.plateau) {
                let bounds = |p: Plateau| Some((p.force_error?, p.displacement_error?));
                // which of two places is the least steep depends on the steps: then there is no bound
                let (Some((force, place)), Some((force_there, place_there))) = (bounds(at), bounds(true_one)) else {
                    continue;
                };
                assert!((at.force - true_one.force).abs() <= force + force_there, "{relative:e}: {at:?}, {true_one:?}");
                let away = (at.displacement - true_one.displacement).abs();
                assert!(away <= place + place_there, "{relative:e}: {at:?}, {true_one:?}");
                plateaus += 1;
            }
        }
    }
    assert!(judged > 20 && plateaus > 4, "{judged} {plateaus}");
}

/// Without a potential the work is an integral over the path: it has no bound, and says so.
#[test]
fn without_a_potential_the_work_has_no_bound() {
    let found = whole_peel(&with_load(paper_strip(100.0, 1.0), LineLoad::ForceOnly), 1e-6);
    assert!(found.limit_points.iter().all(|at| at.work_error.is_none()));
}
