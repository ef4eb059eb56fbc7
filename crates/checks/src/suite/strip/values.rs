//! Peak, plateau, limit points and their error bounds at six stiffnesses and three line loads; the work of peeling; equilibria at exact values.

use super::case::{Case, DEFAULT};
use crate::check::{Check, Measure};
use crate::suite::reference::{Row, read};
use peelkit::adhesion::LineLoad;
use peelkit::model::StripModel;
use peelkit::study::{LimitPoint, LimitPointKind, Peel, Station, StationAt, StationQuantity, StopCriteria, peel};

pub(super) fn checks(cases: &[Case]) -> Vec<Check> {
    cases.iter().flat_map(one).collect()
}

/// The numbers of one strip.
fn one(case: &Case) -> Vec<Check> {
    let peel = &case.peel;
    let turn = |index| -> Option<&LimitPoint> {
        peel.limit_points.iter().filter(|p| p.kind == LimitPointKind::Displacement).nth(index)
    };
    let (peak, first, second) = (peel.initiation_peak, turn(0), turn(1));
    let values = [
        ("initiation peak, nm", "peak_displacement_nm", peak.map(|p| (p.displacement, p.displacement_error))),
        ("initiation peak, nN", "peak_force_nN", peak.map(|p| (p.force, p.force_error))),
        ("snap-off, nm", "lp1_displacement_nm", first.map(|p| (p.displacement, p.displacement_error))),
        ("snap-off, nN", "lp1_force_nN", first.map(|p| (p.force, p.force_error))),
        ("end of the snap-back, nm", "lp2_displacement_nm", second.map(|p| (p.displacement, p.displacement_error))),
        ("end of the snap-back, nN", "lp2_force_nN", second.map(|p| (p.force, p.force_error))),
    ];
    // what the table has no number for was not reached by its path
    let mut checks: Vec<Check> = values
        .iter()
        .filter(|(_, column, _)| case.row.number(column).is_some())
        .filter_map(|&(what, column, value)| case.against(what, column, value.map(|v| v.0), DEFAULT.relative))
        .collect();
    let ratios = values.iter().filter_map(|&(_, column, value)| {
        let (value, bound) = value?;
        Some((value - case.row.number(column)?).abs() / bound)
    });
    checks.push(Check::new(
        format!("largest error over its bound, {}", case.name()),
        "verification/strip_points.py: collocation; a bound is no smaller than the error",
        Ok(ratios.fold(0.0, f64::max)),
        1.0,
        Measure::AtMost,
        0.0,
    ));
    checks.extend(case.against("plateau, nN", "plateau_force_nN", peel.plateau.map(|p| p.force), DEFAULT.relative));
    checks
}

// -- The work of peeling against the energy that it must pay for --

pub(super) fn paid(cases: &[Case]) -> Vec<Check> {
    cases.iter().flat_map(paid_of).collect()
}

fn paid_of(case: &Case) -> Vec<Check> {
    let mut checks = Vec::new();
    let work = case.peel.snap_off.map(|point| point.work);
    if case.row.number("work_aJ").is_some() {
        checks.extend(case.against("work of the grip up to the snap-off, aJ", "work_aJ", work, DEFAULT.relative));
    }
    if case.load() == LineLoad::ForceOnly {
        let number = |column| case.row.number(column).unwrap_or(f64::NAN);
        checks.push(Check::new(
            format!("work of the grip up to the snap-off over the energy it must pay for, {}", case.name()),
            "verification/strip_points.py: ∫ P du and stored + adhesion energy, both by collocation; 1 where energy is conserved",
            work.map(|work| work / number("energy_aJ")).ok_or_else(|| "no snap-off".to_owned()),
            number("work_aJ") / number("energy_aJ"),
            Measure::Relative,
            DEFAULT.relative,
        ));
    } else {
        let ratio = balance(case);
        checks.push(Check::new(
            format!("∫ P du over the change of stored and adhesion energy, rest to snap-off, {}", case.name()),
            "a load with a potential conserves energy",
            ratio,
            1.0,
            Measure::Relative,
            DEFAULT.relative,
        ));
    }
    checks
}

/// ∫ P du by quadrature, which knows nothing of energies, over the change of energy, both from rest to the last point of
/// the path before the snap-off, or to the end of a path without one.
fn balance(case: &Case) -> Result<f64, String> {
    let last = case.peel.snap_off.map_or(case.peel.points.len().saturating_sub(1), |point| point.after);
    let (paid, change) = case.peel.work_and_energy(last).ok_or("the path was not kept")?;
    Ok(paid / change)
}

// -- The equilibria of a strip at exact values of displacement, force and rotation of the grip --

const STATIONS: &str = include_str!("../../../verification/stations.csv");
const SOURCE: &str = "verification/stations.py: collocation";

pub(super) fn of_stations() -> Vec<Check> {
    let peel = peel(&StripModel::of_the_paper(100.0, 1.0), &DEFAULT, &StopCriteria::after_points(20_000));
    read(STATIONS).iter().filter_map(|row| of_station(&peel, row)).flatten().collect()
}

/// Digits of a reference that a station is judged by.
const LEAST_DIGITS: f64 = 9.0;

/// What is not given at the station of a row, and how far its bounds are used up.
fn of_station(peel: &Peel, row: &Row) -> Option<[Check; 2]> {
    let (name, value, passing) = (row.text("quantity")?, row.number("value")?, row.number("passing")?);
    // where a quantity hardly changes the reference has too few digits to judge by
    let enough = row.number("digits_relative")? >= LEAST_DIGITS;
    let (_, quantity) = StationQuantity::NAMED.into_iter().find(|named| enough && named.0 == name)?;
    let given = if quantity == StationQuantity::EndRotation { value.to_radians() } else { value };
    let stations = peel.stations(StationAt { quantity, value: given });
    let found = stations.found.get((passing as usize).checked_sub(1)?);
    let (displacement, force) = (row.number("displacement_nm")?, row.number("force_nN")?);
    let (what, of, expected): (_, fn(&Station) -> f64, _) = match quantity {
        StationQuantity::Force => ("u, nm", |at| at.displacement, displacement),
        _ => ("P, nN", |at| at.force, force),
    };
    let place = format!("at {name} = {value}, passed for the {passing}. time");
    let missing = || format!("{} found, {} missed", stations.found.len(), stations.missed.len());
    let used = |at: &Station| {
        let errors = at.errors.ok_or("no bounds")?;
        let of_force = (at.force - force).abs() / errors.force;
        Ok(of_force.max((at.displacement - displacement).abs() / errors.displacement))
    };
    let computed = found.map(of).ok_or_else(missing);
    let used = found.ok_or_else(missing).and_then(|at| used(at).map_err(|why: &str| why.to_owned()));
    Some([
        Check::new(format!("{what}, {place}"), SOURCE, computed, expected, Measure::Relative, DEFAULT.relative),
        Check::new(format!("largest error over its bound, {place}"), SOURCE, used, 1.0, Measure::AtMost, 0.0),
    ])
}
