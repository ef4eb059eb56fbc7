//! Events of the user on the path of a beam: a quantity, or a number of the fields, passes a value.
//!
//! ```text
//!     front │\            · "half off": the front falls past 50 nm
//!           │ \·________
//!           │           \___
//!           └──────────────── path
//! ```
//!
//! Reference: `verification/stations.csv`, a collocation without finite elements; states of the same path. Strip of the paper, L = 100 nm.
//!
//! Expected: rising and falling passings are told apart; a path that an event stops ends there, with the points before as they are; a number of the
//! fields is found where the quantity with a name is that it equals, and its bounds hold.

use crate::common::{paper_strip, whole_peel};
use peelkit::study::{
    Accuracy, BeamState, Bound, EventAction, EventAt, EventQuantity, Events, Passing, PathEnd, Peel, StateSections,
    StationAt, StationQuantity, StopCriteria, TestEnd, observed_retreat, peel,
};

fn event(quantity: StationQuantity, passing: Passing, value: f64) -> EventAt {
    let quantity = EventQuantity::Named(quantity);
    EventAt { name: "event".to_owned(), quantity, value, passing, action: EventAction::Record }
}

fn stopped(events: Vec<EventAt>) -> Peel {
    let stop = StopCriteria { events, ..StopCriteria::after_points(5000) };
    peel(&paper_strip(100.0, 1.0), &Accuracy::to(1e-6), &stop)
}

fn places(events: &Events) -> Vec<f64> {
    assert!(events.missed.is_empty(), "{:?}", events.missed);
    events.found.iter().map(|found| found.displacement).collect()
}

/// The force passes 0.04 nN upwards at 0.006953 nm and downwards at 47.66 nm.
#[test]
fn passings_up_and_down_are_told_apart() {
    let peel = whole_peel(&paper_strip(100.0, 1.0), 1e-6);
    let [up, down] = [0.00695345575897, 47.6567102566];
    let at = |passing| places(&peel.events(&event(StationQuantity::Force, passing, 0.04)));
    for (passing, expected) in
        [(Passing::Rising, vec![up]), (Passing::Falling, vec![down]), (Passing::Either, vec![up, down])]
    {
        let found = at(passing);
        assert_eq!(found.len(), expected.len(), "{passing:?}");
        for (found, expected) in found.iter().zip(expected) {
            assert!((found / expected - 1.0).abs() < 1e-6, "{passing:?}: {found} {expected}");
        }
    }
}

/// The gap of the free end by name, and by what a program reads off the fields.
fn gap(state: &BeamState) -> f64 {
    let StateSections::Planar(sections) = &state.sections else { panic!("in space") };
    sections[0].gap
}

#[test]
fn a_number_of_the_fields_is_passed_where_the_quantity_is_that_it_equals() {
    let peel = whole_peel(&paper_strip(100.0, 1.0), 1e-6);
    let of_fields = peel.events(&EventAt::of_beam("gap", |state| gap(state) - 0.25));
    let named = peel.stations(StationAt { quantity: StationQuantity::FreeEndGap, value: 0.25 });
    assert_eq!((of_fields.found.len(), named.found.len()), (1, 1));
    let (own, named) = (of_fields.found[0], named.found[0]);
    let (bound, other) = (own.errors.unwrap(), named.errors.unwrap());
    assert!((own.displacement - named.displacement).abs() <= bound.displacement + other.displacement);
    assert!((own.force - named.force).abs() <= bound.force + other.force);
    assert!((own.free_end_gap - 0.25).abs() < 1e-9 && (named.free_end_gap - 0.25).abs() < 1e-9);
    // twice the displacement over the force: a number of two observables
    let both = peel.events(&EventAt::of_beam("work", |state| state.force * state.displacement - 1.0));
    for found in &both.found {
        assert!((found.force * found.displacement - 1.0).abs() < 1e-8, "{found:?}");
    }
    assert!(!both.found.is_empty());
}

#[test]
fn a_path_that_an_event_stops_ends_there() {
    let whole = whole_peel(&paper_strip(100.0, 1.0), 1e-6);
    let half_off = event(StationQuantity::Front, Passing::Falling, 50.0).stopping();
    let later =
        EventAt { name: "later".to_owned(), ..event(StationQuantity::Displacement, Passing::Rising, 40.0) }.stopping();
    let path = stopped(vec![later.clone(), half_off.clone()]);
    assert_eq!(path.end, PathEnd::Bound(Bound::Event { name: "event".to_owned() }));
    let last = path.points.last().unwrap();
    assert!((last.front - 50.0).abs() < 1e-8, "{last:?}");
    let known = whole.events(&half_off).found[0];
    assert!((last.displacement - known.displacement).abs() <= 1e-6 * last.displacement);
    // it is found where the path ends, once
    let found = path.events(&half_off);
    assert_eq!((found.found.len(), path.events(&later).found.len()), (1, 0));
    let both = found.found[0].errors.unwrap().displacement + known.errors.unwrap().displacement;
    assert!((found.found[0].displacement - known.displacement).abs() <= both);
    // a number of the fields stops it as well
    let by_fields = stopped(vec![EventAt::of_beam("30 nm", |state| state.displacement - 30.0).stopping()]);
    assert!((by_fields.points.last().unwrap().displacement - 30.0).abs() < 1e-6);
    assert_eq!(by_fields.end, PathEnd::Bound(Bound::Event { name: "30 nm".to_owned() }));
}

/// What is recorded leaves every point as it is.
#[test]
fn events_that_are_recorded_change_no_point() {
    let asked = vec![event(StationQuantity::Front, Passing::Falling, 50.0)];
    let (recorded, plain) = (stopped(asked), stopped(Vec::new()));
    assert_eq!((recorded.points, recorded.end), (plain.points, plain.end));
}

/// A number that is none is told where it arises.
#[test]
fn an_event_without_a_number_is_missed_and_says_so() {
    let peel = whole_peel(&paper_strip(100.0, 1.0), 1e-3);
    let events = peel.events(&EventAt::of_beam("none", |state| if state.displacement > 30.0 { f64::NAN } else { 1.0 }));
    assert!(events.found.is_empty());
    let missed = events.missed.first().expect("nothing missed").to_string();
    assert!(missed.contains("not a finite number in the quantity of an event"), "{missed}");
}

/// Stations and events of a displacement-controlled test: the equilibria of the path, by what the grip does, behind any spring. What a jump passes
/// over is told behind the jump, and an event that stops is the last point.
#[test]
fn a_test_has_the_stations_of_the_path_on_its_stable_branches() {
    // the force at u = 30 nm, on the way to the first jump: verification/stations.csv
    const FORCE: f64 = 0.0504094198094;
    let at = |quantity, value| EventAt::from(StationAt { quantity, value });
    let half_off = event(StationQuantity::Front, Passing::Falling, 50.0);
    let test_of = |stiffness, events: &[EventAt]| {
        let mut model = paper_strip(100.0, 1.0);
        model.grip.stiffness = stiffness;
        let stop = StopCriteria { events: events.to_vec(), ..StopCriteria::after_points(5000) };
        observed_retreat(&model, &Accuracy::to(1e-6), &stop).unwrap()
    };
    let plain = test_of(None, &[]);
    let jump = plain.jumps[0];
    // no equilibrium before the jump or behind it
    let over = at(StationQuantity::Front, 0.5 * (jump.before.front + jump.after.front));
    let looked_for = [at(StationQuantity::Displacement, 30.0), half_off.clone(), over];
    let (rigid, sprung) = (test_of(None, &looked_for), test_of(Some(0.05), &looked_for[..2]));
    let path = whole_peel(&paper_strip(100.0, 1.0), 1e-6).events(&half_off).found[0];
    for test in [&rigid, &sprung] {
        let of = |event: usize| test.stations.iter().find(|station| station.event == event).unwrap();
        let (first, front) = (of(0), of(1));
        let bound = first.errors.unwrap().force;
        assert!((first.point.displacement - 30.0).abs() < 1e-9, "{first:?}");
        assert!((first.point.force - FORCE).abs() <= bound && bound <= 1e-6 * FORCE, "{first:?}");
        let known = front.errors.unwrap().displacement + path.errors.unwrap().displacement;
        assert!((front.point.displacement - path.displacement).abs() <= known, "{front:?} {path:?}");
    }
    let landed = rigid.stations.iter().find(|station| station.event == 2 && station.point.jumped).unwrap();
    assert_eq!((landed.point.front, landed.errors), (jump.after.front, None));
    // what is recorded changes nothing
    assert_eq!(rigid.points, plain.points);
    let stopped = test_of(None, &[half_off.stopping()]);
    assert_eq!(stopped.end, TestEnd::Bound(Bound::Event { name: "event".to_owned() }));
    assert!((stopped.points.last().unwrap().front - 50.0).abs() < 1e-8);
}
