//! Stations of a path: its equilibria at an exact displacement, force, front, rotation of the grip or gap of the free end.
//!
//! ```text
//!        P │   peak
//!          │  /\        · stations at one P: on the way up, and behind the peak
//!          │ /  \____
//!          │/        \___ lp1
//!          │      lp2 ___/    · stations at one u: before lp1, and on the way back
//!          └──────────────── u
//! ```
//!
//! Reference: `verification/stations.csv`, a collocation without finite elements, 12 digits. Strip of the paper, L = 100 nm, grip free to rotate,
//! up to where the displacement turns for the second time.
//!
//! Expected: every number within its bound and within what was asked; bounds no larger than what was asked. The quantity that was asked for has its
//! value to round-off. A value beyond the path has no station, and the range is told.

use super::steady_force::tape;
use crate::common::{paper_strip, whole_peel};
use peelkit::model::{Friction, PeelModel, Spatula};
use peelkit::study::{Accuracy, Peel, Station, StationAt, StationErrors, StationQuantity, StopCriteria, peel};

fn at(peel: &Peel, quantity: StationQuantity, value: f64) -> Vec<Station> {
    let stations = peel.stations(StationAt { quantity, value });
    assert!(stations.missed.is_empty(), "{:?}", stations.missed);
    stations.found
}

fn bounds(station: &Station) -> StationErrors {
    station.errors.unwrap_or_else(|| panic!("no bounds: {station:?}"))
}

/// A number is within its bound and the last digits of a reference, relative.
fn assert_within_digits(what: &str, value: f64, bound: f64, reference: f64, digits: f64) {
    assert!((value - reference).abs() <= bound + digits * reference.abs(), "{what}: {value} ± {bound:e}, {reference}");
}

/// The same of a reference with twelve digits.
fn assert_within(what: &str, value: f64, bound: f64, reference: f64) {
    assert_within_digits(what, value, bound, reference, 1e-12);
}

#[test]
fn stations_are_those_of_a_collocation() {
    let rows = include_str!("../../../verification/stations.csv").lines().filter(|line| !line.starts_with('#')).skip(1);
    let rows: Vec<Vec<&str>> = rows.map(|row| row.split(',').collect()).collect();
    assert_eq!(rows.len(), 15);
    for relative in [1e-3, 1e-4, 1e-6, 1e-8] {
        let peel = whole_peel(&paper_strip(100.0, 1.0), relative);
        for row in &rows {
            let number = |column: usize| row[column].parse::<f64>().unwrap();
            let (_, quantity) = StationQuantity::NAMED.into_iter().find(|named| named.0 == row[0]).unwrap();
            let value = if quantity == StationQuantity::EndRotation { number(1).to_radians() } else { number(1) };
            let found = at(&peel, quantity, value)[number(2) as usize - 1];
            let (name, bounds) = (format!("{row:?} at {relative:e}"), bounds(&found));
            let digits = 10f64.powf(-number(6));
            assert_within_digits(&name, found.displacement, bounds.displacement, number(3), digits);
            assert_within_digits(&name, found.force, bounds.force, number(4), digits);
            assert_within_digits(&name, found.end_rotation, bounds.end_rotation, number(5).to_radians(), digits);
            assert!(
                bounds.force <= relative * found.force && bounds.displacement <= relative * found.displacement,
                "{name} {found:?}"
            );
            // the grip of an unstable equilibrium beyond lp1 cannot be held
            let behind = match quantity {
                StationQuantity::Displacement => number(2) == 2.0,
                StationQuantity::FreeEndGap => value == 0.22,
                _ => false,
            };
            assert_eq!(found.negative_eigenvalues, usize::from(behind), "{name}");
        }
    }
}

/// Held displacements of the end face of a spatula: `verification/spatula_curve.csv`.
#[test]
fn a_spatula_is_read_at_given_displacements() {
    let peel = peel(&Spatula::default().model(), &Accuracy::to(1e-6), &StopCriteria::after_points(5000));
    let rows =
        include_str!("../../../verification/spatula_curve.csv").lines().filter(|line| !line.starts_with('#')).skip(1);
    for row in rows {
        let numbers: Vec<f64> = row.split(',').map(|number| number.parse().unwrap()).collect();
        let found = at(&peel, StationQuantity::Displacement, numbers[0])[0];
        assert_within(row, found.force, bounds(&found).force, numbers[1]);
        assert!(bounds(&found).force <= 1e-6 * found.force, "{row}");
    }
}

/// The work of a station rises by P du, and its front is where it was asked for, once on a path on which the front goes one way.
#[test]
fn work_and_front_of_a_station() {
    let peel = whole_peel(&paper_strip(100.0, 1.0), 1e-8);
    let work = |u: f64| at(&peel, StationQuantity::Displacement, u)[0].work;
    let slope = (work(20.01) - work(19.99)) / 0.02;
    let force = at(&peel, StationQuantity::Displacement, 20.0)[0].force;
    assert!((slope / force - 1.0).abs() < 1e-6, "{slope} {force}");
    let [front] = at(&peel, StationQuantity::Front, 60.0)[..] else { panic!("passed more than once") };
    assert!((front.front - 60.0).abs() < 1e-9, "{front:?}");
    let [same] = at(&peel, StationQuantity::EndRotation, front.end_rotation)[..1] else { panic!("not passed") };
    let known = bounds(&front).displacement + bounds(&same).displacement;
    assert!((same.displacement - front.displacement).abs() <= known, "{front:?} {same:?}");
}

/// Next to a limit point a path passes a force twice, beyond it never. A value that is never passed comes with the range of those that are.
#[test]
fn stations_next_to_a_limit_point() {
    let peel = whole_peel(&paper_strip(100.0, 1.0), 1e-6);
    let peak = peel.peak.unwrap();
    for below in [1e-3, 1e-6, 1e-8] {
        let value = (1.0 - below) * peak.force;
        let [before, behind] = at(&peel, StationQuantity::Force, value)[..] else { panic!("not passed twice") };
        assert!(before.displacement < peak.displacement && peak.displacement < behind.displacement);
        assert!((before.force / value - 1.0).abs() < 1e-11 && (behind.force / value - 1.0).abs() < 1e-11);
        assert_eq!((before.negative_eigenvalues_load, behind.negative_eigenvalues_load), (0, 1));
    }
    let beyond = peel.stations(StationAt { quantity: StationQuantity::Force, value: 1.001 * peak.force });
    assert!(beyond.found.is_empty() && beyond.missed.is_empty());
    assert!((beyond.range[1] / peak.force - 1.0).abs() < 1e-6, "{:?}", beyond.range);
    assert_eq!(at(&peel, StationQuantity::Displacement, 0.0).len(), 1, "where the path begins");
}

/// With friction and where its solutions were dropped a path has no bounds, and no stations.
#[test]
fn what_has_no_bounds_has_none() {
    let friction = Friction { strength: Some(0.05), ..Friction::default() };
    let model = PeelModel { friction, ..paper_strip(100.0, 1.0).into() };
    let rubbed = peel(&model, &Accuracy::to(1e-4), &StopCriteria::after_points(5000));
    let found = at(&rubbed, StationQuantity::Displacement, 10.0)[0];
    assert!(found.errors.is_none() && (found.displacement - 10.0).abs() < 1e-9, "{found:?}");
    assert!(found.work > 0.0);
    let dropped = rubbed.without_solutions().stations(StationAt { quantity: StationQuantity::Force, value: 0.1 });
    assert!(dropped.found.is_empty());
}

/// On the level force of a tape the displacement of a force is known badly, and its bound says so.
#[test]
fn a_station_on_a_plateau() {
    let peel = peel(&tape(), &Accuracy::to(1e-5), &StopCriteria::after_points(5000));
    let found = at(&peel, StationQuantity::Displacement, 0.5 * peel.snap_off.unwrap().displacement)[0];
    assert!(bounds(&found).force <= 1e-5 * found.force, "{found:?}");
}
