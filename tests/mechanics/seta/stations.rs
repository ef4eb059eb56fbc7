//! Stations and events of the user in the pull-off of a seta.
//!
//! Reference: `verification/seta.csv`, shooting of the strong form without elements. The seta is drawn in `setup.rs`: four tips that adhere, pulled
//! along the normal.
//!
//! Expected: forces at the displacements of the table to 1e-7 nN, found on one pull-off; a force is met to round-off; the number of tips, and a number
//! of the seta's state, are passed where the pull-off has them; what is recorded leaves every point as it is, and what stops is the last one.

use super::setup::{along_normal, model, small};
use approx::assert_abs_diff_eq;
use peelkit::model::Sideways;
use peelkit::study::{
    Bound, EventAction, EventAt, EventQuantity, Passing, SetaEnd, SetaLoading, SetaOptions, SetaPullOff, SetaStart,
    SetaState, StationAt, StationQuantity, StepEnd, StopCriteria, pull_off,
};

fn pulled(events: &[EventAt]) -> SetaPullOff {
    let steps = vec![along_normal(1.0, StepEnd::Detached(5000.0))];
    let loading = SetaLoading { start: SetaStart::Adhering, steps };
    let stop = StopCriteria { events: events.to_vec(), ..StopCriteria::default() };
    pull_off(&model(small(), Sideways::Free), &loading, &SetaOptions::default(), &stop).unwrap()
}

fn at(quantity: StationQuantity, value: f64) -> EventAt {
    StationAt { quantity, value }.into()
}

fn event(quantity: StationQuantity, passing: Passing, value: f64) -> EventAt {
    let quantity = EventQuantity::Named(quantity);
    EventAt { name: "event".to_owned(), quantity, value, passing, action: EventAction::Record }
}

#[test]
fn forces_at_exact_displacements_are_those_of_shooting() {
    let table = include_str!("../../../verification/seta.csv");
    let rows = table.lines().map(|line| line.split(',').collect::<Vec<_>>()).filter(|row| row[0] == "free");
    let rows: Vec<(f64, f64)> = rows.map(|row| (row[2].parse().unwrap(), row[4].parse().unwrap())).collect();
    assert!(rows.len() >= 4);
    let displacements = rows.iter().map(|row| at(StationQuantity::Displacement, row.0));
    let found = pulled(&displacements.collect::<Vec<_>>());
    for station in &found.stations {
        let (displacement, force) = rows[station.event];
        assert_abs_diff_eq!(station.point.displacement, displacement, epsilon = 1e-9);
        assert_abs_diff_eq!(station.point.force[1], force, epsilon = 1e-7);
    }
    assert_eq!(found.stations.len(), rows.len());
}

#[test]
fn a_force_and_a_number_of_tips_are_passed_where_the_pull_off_has_them() {
    let plain = pulled(&[]);
    let peak = plain.peak.as_ref().unwrap().point.force_along;
    let asked = [
        at(StationQuantity::Force, 0.5 * peak),
        event(StationQuantity::Attached, Passing::Falling, 4.0),
        event(StationQuantity::Attached, Passing::Falling, 1.0),
        event(StationQuantity::Attached, Passing::Rising, 4.0),
        EventAt::of_seta("root 600 nm up", |state: &SetaState| state.point.root[1] - 600.0),
    ];
    let found = pulled(&asked);
    // what is recorded is computed besides
    assert_eq!((&found.points, &found.events), (&plain.points, &plain.events));
    let of = |event: usize| found.stations.iter().filter(move |station| station.event == event);
    let forces: Vec<_> = of(0).filter(|station| !station.jumped).collect();
    assert!(!forces.is_empty());
    for station in forces {
        assert_abs_diff_eq!(station.point.force_along, 0.5 * peak, epsilon = 1e-9 * peak);
        assert!(station.location.unwrap().force <= 1e-9 * peak);
        let [before, behind] = [station.after, station.after + 1].map(|k| found.points[k].displacement);
        assert!(before <= station.point.displacement && station.point.displacement <= behind);
    }
    assert_eq!(of(1).map(|station| station.point).collect::<Vec<_>>(), [plain.events[0].after]);
    assert_eq!(of(2).map(|station| station.point.attached).collect::<Vec<_>>(), [0]);
    assert_eq!((of(3).count(), of(4).count()), (0, 1));
    let root = of(4).next().unwrap().point;
    assert_abs_diff_eq!(root.root[1], 600.0, epsilon = 1e-6);
    assert_abs_diff_eq!(root.displacement, 600.0, epsilon = 1e-6);
}

#[test]
fn an_event_stops_the_pull_off_where_it_lies() {
    let displacement = event(StationQuantity::Displacement, Passing::Rising, 321.0).stopping();
    let last_tips = event(StationQuantity::Attached, Passing::Falling, 3.0).stopping();
    for (asked, attached) in [(displacement, 4), (last_tips, 2)] {
        let stopped = pulled(std::slice::from_ref(&asked));
        assert_eq!(stopped.end, SetaEnd::Bound(Bound::Event { name: "event".to_owned() }));
        let last = stopped.points.last().unwrap();
        assert_eq!(stopped.stations.last().unwrap().point.displacement, last.displacement);
        assert!(last.attached <= attached, "{last:?}");
        if attached == 4 {
            assert_abs_diff_eq!(last.displacement, 321.0, epsilon = 1e-9);
            assert_eq!(last.attached, 4);
        }
    }
}

/// A number that is none stops the run where it arises.
#[test]
fn an_event_without_a_number_is_a_failure_that_says_so() {
    let none = EventAt::of_seta("none", |_: &SetaState| f64::NAN);
    let SetaEnd::Failed(why) = pulled(&[none]).end else { panic!("no failure") };
    assert!(why.to_string().contains("not a finite number in the quantity of an event"), "{why}");
}
