//! Stations and events of the user in a pull at a rate.
//!
//! References: the ramp of the grip in closed form, U = V t - a behind its acceleration on the way a; `verification/stations.csv`, a collocation of the
//! equilibria, in which a slow pull of an elastic strip goes. Parameters: the paper's strip, L = 100 nm, 1300 kg/m³, 0.1 mm/s, a = 0.02 nm.
//! Expected: a displacement at a time to round-off; the force at 0.1 nm to 2e-5, as slow pulls agree with the statics elsewhere; what is recorded leaves
//! every point as it is; what stops is the last point, with a balance of energy as good as that of the whole pull.

use crate::common::paper_strip;
use peelkit::beam::Viscosity;
use peelkit::model::{MovingMaterial, PeelModel};
use peelkit::study::{
    BeamState, Bound, EventAt, PullInTime, PullRate, StationAt, StationQuantity, StopCriteria, TimeAccuracy, Until,
    pull_in_time_with,
};

const RATE: f64 = 1e-4;
const ACCELERATES: f64 = 0.02;

fn pulled(events: &[EventAt]) -> PullInTime {
    let model = PeelModel::from(paper_strip(100.0, 1.0));
    let material = MovingMaterial { density: 1300.0, viscosity: Viscosity::Elastic, opening: None };
    let pull = PullRate { accelerates: Some(ACCELERATES), until: Until::Held(0.0), ..PullRate::new(0.5, RATE) };
    let stop = StopCriteria { events: events.to_vec(), ..StopCriteria::default() };
    pull_in_time_with(&model, &material, &pull, &TimeAccuracy::default(), &stop).unwrap()
}

#[test]
fn stations_and_events_of_a_pull_at_a_rate() {
    let at = |quantity, value| EventAt::from(StationAt { quantity, value });
    let looked_for = [
        at(StationQuantity::Time, 2000.0),
        at(StationQuantity::Displacement, 0.1),
        EventAt::of_beam("0.3 nN", |state: &BeamState| state.force - 0.3),
    ];
    let (plain, found) = (pulled(&[]), pulled(&looked_for));
    assert_eq!((&plain.points, plain.tried), (&found.points, found.tried));
    let of = |event: usize| found.stations.iter().filter(move |station| station.event == event);
    let [time, displacement] = [0, 1].map(|event| of(event).next().unwrap().point);
    let reached = RATE * 2000.0 - ACCELERATES;
    assert!((time.time - 2000.0).abs() < 1e-6 && (time.displacement - reached).abs() < 1e-9, "{time:?}");
    assert!((displacement.displacement - 0.1).abs() < 1e-9, "{displacement:?}");
    assert!((displacement.force / 0.286046624169 - 1.0).abs() < 2e-5, "{displacement:?}");
    assert!(of(2).count() > 0 && of(2).all(|station| (station.point.force - 0.3).abs() < 1e-8));
    let stopped = pulled(&[at(StationQuantity::Displacement, 0.3).stopping()]);
    let last = stopped.last();
    assert_eq!(stopped.stopped, Some(Bound::Event { name: String::new() }));
    assert!((last.displacement - 0.3).abs() < 1e-9, "{last:?}");
    assert!(stopped.balance_error() <= 2.0 * plain.balance_error() + 1e-9, "{:.1e}", stopped.balance_error());
}
