//! A seta whose spatulae are beams.
//!
//! ```text
//!              ● root, moved up, never turned
//!             /
//!            ●
//!           / \
//!       ===/===/    two spatulae, each a branch of 32 elements
//!      ----------
//! ```
//!
//! Reference: the same seta whose tips follow the table of their spatula, which knows nothing of how a pad rolls, slides or turns about the
//! normal; energies, because work has to be stored, in adhesion or released; the same seta pressed on, which has to be pulled off as one that adheres
//! from the start. Parameters: the last two of the default seta's 256 tips, with the shaft and the branch that carry them. Expected: the same tip lets
//! go first, forces within 3 %, and work that balances to 5e-5; the peak of a finer mesh within 1e-4, that of a pressed seta, whose mesh is another, within 3e-5; stations where
//! their numbers are; what is resumed the same to the last bit. The iterations are pinned.

use peelkit::adhesion::CohesiveShape;
use peelkit::model::{
    Adhesion, Attraction, Body, Grip, PeelModel, Seta, SetaMesh, SetaModel, SetaOfBeams, Sideways, Spatula, TipLaw,
};
use peelkit::solve::{Pace, PathOptions};
use peelkit::study::coarsening::{CoarseningOptions, GrowingTable, PadEnd, TipRange, coarsen, pull_off_by_table};
use peelkit::study::{
    BeamsProgress, BeamsPullOff, Bound, EventAt, EventCause, SetaEnd, SetaLoading, SetaOptions, SetaPullOff, SetaState,
    Stage, StationAt, StationQuantity, StopCriteria, StopReason, peak_of_beams_on_finer_mesh, pull_off_of_beams,
};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

fn seta() -> Seta {
    let brush_height = 28_000.0 * 0.6f64.powi(7);
    Seta {
        forks: 1,
        shaft_diameter: 4000.0 * 0.625f64.powi(7),
        brush_height,
        shaft_length: 2.5 * brush_height,
        height_scatter: 20.0,
        ..Seta::default()
    }
}

fn of_beams() -> SetaOfBeams {
    let spatula = Spatula::default().model().branch().unwrap();
    SetaOfBeams { seta: seta(), mesh: SetaMesh { order: 5, elements: vec![1; 2] }, spatula, elements: 32 }
}

fn options() -> PathOptions {
    PathOptions { pace: Pace::Wary, first_displacement: 0.1, ..PathOptions::default() }
}

fn upwards() -> SetaLoading {
    SetaLoading::pull([0.0, 1.0, 0.0], 1e5)
}

fn pulled(loading: &SetaLoading, stop: &StopCriteria) -> BeamsPullOff {
    pull_off_of_beams(&of_beams(), loading, &options(), stop, None, &mut |_, _| {}).unwrap()
}

fn print(name: &str, of: &SetaPullOff) {
    println!("{name}: {:?}, {} points, {:?}, imbalance {:.1e}", of.end, of.points.len(), of.effort, of.imbalance());
    for event in &of.events {
        let tips: Vec<_> = event.tips.iter().map(|tip| tip.tip).collect();
        let (before, after) = (event.before, event.after);
        println!(
            "  u {:.3} P {:.4} to {:.4} released {:.2} {tips:?}",
            before.displacement, before.force_along, after.force_along, event.released
        );
    }
}

#[test]
fn two_spatulae_let_go_as_tips_by_their_table_do() {
    let (loading, stop) = (upwards(), StopCriteria::default());
    let whole = pulled(&loading, &stop);
    let found = &whole.result;
    let model = PeelModel::of(Body::Spatula(Spatula::default()), Adhesion::default(), Grip::FREE);
    let range = TipRange { press: 5.0, rotation: [-0.4, 0.65], ..TipRange::SLIDING };
    let making = CoarseningOptions { range, tolerance: 1e-2, ..CoarseningOptions::of(PadEnd::Sliding) };
    let law = |law: Arc<dyn TipLaw>| SetaModel::new(seta(), law);
    let by = SetaOptions { balance: 1e-6, ..SetaOptions::default() };
    let mut table = GrowingTable::of(&model, Arc::new(coarsen(&model, &making).unwrap()));
    let (by_table, _) = pull_off_by_table(&mut table, (&law, Sideways::Free), (&loading, &by), &stop).unwrap();
    print("beams", found);
    print("table", &by_table);
    assert_eq!(found.end, SetaEnd::Completed);
    assert!(found.imbalance() < 5e-5, "{}", found.imbalance());
    let lose = |of: &SetaPullOff| -> Vec<(usize, f64)> {
        let events = of.events.iter().filter(|event| event.cause == EventCause::Tips);
        events.flat_map(|event| event.tips.iter().map(|tip| (tip.tip, event.before.force_along))).collect()
    };
    let (own, others) = (lose(found), lose(&by_table));
    assert_eq!(own.len(), 2);
    for ((tip, force), (other, wanted)) in own.iter().zip(&others) {
        assert!(tip == other && (force / wanted - 1.0).abs() < 0.03, "{own:?} {others:?}");
    }
    assert!(found.effort.newton_iterations < 4500 && found.points.len() < 260, "{:?}", found.effort);

    let peak = &found.peak.as_ref().unwrap().point;
    let finer = peak_of_beams_on_finer_mesh(&of_beams(), &loading, &options(), &whole, &stop).unwrap().unwrap();
    println!("peak {:.5} nN, on a finer mesh {:.5} nN", peak.force_along, finer.peak.force);
    assert!(finer.mesh.force < 1e-4 * peak.force_along && finer.location.is_some(), "{finer:?}");
    assert_eq!(finer.mesh.force, (finer.peak.force - peak.force_along).abs());
}

#[test]
fn a_seta_that_is_pressed_on_is_pulled_off_as_one_that_adheres() {
    let pressed = SetaLoading::pressed_and_dragged(120.0, 1.0, 0.0, 1e5);
    let [pressed, adhering] = [pressed, upwards()].map(|loading| pulled(&loading, &StopCriteria::default()).result);
    print("pressed", &pressed);
    print("adhering", &adhering);
    assert_eq!(pressed.end, SetaEnd::Completed);
    // each pad snaps on, and each is pulled off
    let tips: Vec<bool> =
        pressed.events.iter().flat_map(|event| &event.tips).map(|change| change.to.adheres()).collect();
    assert_eq!(tips, [true, true, false, false]);
    let [force, wanted] = [&pressed, &adhering].map(|of| of.peak.as_ref().unwrap().point.force_along);
    assert!((force / wanted - 1.0).abs() < 3e-5, "{force} {wanted}");
    let last = pressed.points.last().unwrap();
    assert!(pressed.imbalance() < 5e-5 && last.attached == 0 && last.energy.abs() < 0.1, "{last:?}");
    // what presses it is met
    let before = pressed.points.iter().rfind(|point| point.step == 0).unwrap();
    assert!((before.force_along - 1.0).abs() < 1e-8, "{before:?}");
    assert!(pressed.effort.newton_iterations < 9000, "{:?}", pressed.effort);
}

/// Pads that slide hold 6.8 nN, and nothing along the ground.
#[test]
fn pads_that_are_held_carry_shear_and_hold_more() {
    let mut spatula = Spatula::default().model();
    spatula.adhesion.attraction = Attraction::Cohesive(CohesiveShape::Exponential);
    spatula.adhesion.shear_strength = Some(0.02);
    let held = SetaOfBeams { spatula: spatula.branch().unwrap(), ..of_beams() };
    let stop = StopCriteria { displacement: Some(150.0), ..StopCriteria::default() };
    let found = pull_off_of_beams(&held, &upwards(), &options(), &stop, None, &mut |_, _| {}).unwrap().result;
    print("held", &found);
    assert_eq!(found.end, SetaEnd::Bound(Bound::Displacement(150.0)));
    let last = found.points.last().unwrap();
    let [along, up, aside] = last.force;
    assert!((30.0..30.5).contains(&up) && (37.5..38.5).contains(&along) && aside.abs() < 0.1, "{last:?}");
    assert!(found.imbalance() < 1e-5 && last.attached == 2, "{}", found.imbalance());
    assert!(found.effort.newton_iterations < 1500, "{:?}", found.effort);
}

#[test]
fn a_preload_that_is_not_reached_is_named() {
    let found = pulled(&SetaLoading::pressed_and_dragged(120.0, 1e4, 0.0, 1e5), &StopCriteria::after_points(400));
    print("preload of 10 µN", &found.result);
    assert!(found.result.end.is_failure() && !found.result.events.is_empty(), "{:?}", found.result.end);
}

#[test]
fn stations_lie_where_their_numbers_are() {
    let station = |quantity, value| EventAt::from(StationAt { quantity, value });
    let mut events = vec![
        station(StationQuantity::Displacement, 100.0),
        station(StationQuantity::Force, 3.0),
        EventAt::of_seta("a work of 500 aJ", |state| state.point.work - 500.0),
    ];
    let stop = StopCriteria { events: events.clone(), ..StopCriteria::up_to(500.0) };
    let found = pulled(&upwards(), &stop).result;
    assert_eq!(found.end, SetaEnd::Bound(Bound::Displacement(500.0)));
    let last = found.points.last().unwrap();
    assert!((last.displacement - 500.0).abs() < 1e-6, "{last:?}");
    let of: Vec<usize> = found.stations.iter().map(|station| station.event).collect();
    assert_eq!(of, [0, 1, 2], "{:?}", found.stations);
    let [place, force, work] = [0, 1, 2].map(|k| found.stations[k].point);
    assert!((place.displacement - 100.0).abs() < 1e-8, "{place:?}");
    assert!((force.force_along - 3.0).abs() < 1e-8, "{force:?}");
    // by the interpolated force the work is not known better than its balance
    assert!((work.work / 500.0 - 1.0).abs() < 1e-5, "{work:?}");
    assert!(place.force_along < force.force_along && force.force_along < work.force_along);

    events[1] = EventAt { name: "3 nN".to_owned(), ..events[1].clone() }.stopping();
    let found = pulled(&upwards(), &StopCriteria { events, ..StopCriteria::default() }).result;
    assert_eq!(found.end, SetaEnd::Bound(Bound::Event { name: "3 nN".to_owned() }));
    assert_eq!(*found.points.last().unwrap(), found.stations.last().unwrap().point);
    assert_eq!(found.last.unwrap().point.force_along, force.force_along);
}

#[test]
fn what_was_reached_is_gone_on_with_to_the_last_bit() {
    let (loading, stop) = (upwards(), StopCriteria::default());
    let mut kept = None;
    let mut states = 0;
    let mut see = |state: &SetaState, reached: Option<&BeamsProgress>| {
        states += 1;
        assert_eq!((state.spatulae.len(), state.tips.len()), (2, 2));
        kept = kept.take().or_else(|| reached.map(|reached| serde_json::to_string(reached).unwrap()));
    };
    let whole = pull_off_of_beams(&of_beams(), &loading, &options(), &stop, None, &mut see).unwrap().result;
    assert_eq!(states, whole.points.len());
    let reached: BeamsProgress = serde_json::from_str(&kept.unwrap()).unwrap();
    assert!(reached.result.points.len() > 50 && reached.result.events.len() == 1);
    let rest = pull_off_of_beams(&of_beams(), &loading, &options(), &stop, Some(reached), &mut |_, _| {}).unwrap();
    assert_eq!(rest.result, whole);
}

#[test]
fn what_stops_it_keeps_what_it_has_reached() {
    let found = pulled(&upwards(), &StopCriteria::after_points(12)).result;
    assert!(found.end.is_cut_short() && !found.end.is_failure() && found.points.len() == 12, "{:?}", found.end);
    assert!(found.peak.is_some_and(|peak| peak.point.attached == 2));
    // the state of the end is that of the last point, on spatulae that stand on the ground
    let last = found.last.unwrap();
    assert_eq!(last.point, *found.points.last().unwrap());
    assert!(last.raised > 100.0 && last.spatulae.iter().all(|own| own.sections.last().unwrap().place[1] < 10.0));
}

/// Wherever on its way a run is told not to go on, inside of a solve as well, the next one finds what it would have found.
#[test]
fn what_is_told_to_stop_is_not_stuck() {
    let whole = pulled(&upwards(), &StopCriteria::after_points(80)).result;
    for asked in [20, 45, 71, 98, 126, 155] {
        let count = AtomicUsize::new(0);
        let stop = StopCriteria::default().or_when(move |stage| {
            let is_time = stage == Stage::Path && count.fetch_add(1, Ordering::Relaxed) >= asked;
            is_time.then_some(StopReason::Interrupted)
        });
        let found = pulled(&upwards(), &stop).result;
        assert_eq!(found.end, SetaEnd::Bound(Bound::Interrupted), "{asked}");
        assert!(found.points.len() < 80 && found.events.is_empty(), "{asked}: {} points", found.points.len());
        assert_eq!(found.points, whole.points[..found.points.len()], "{asked}");
    }
}
