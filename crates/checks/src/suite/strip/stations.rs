//! The equilibria of a strip at exact values of displacement, force and rotation of the grip.

use super::case::DEFAULT;
use crate::suite::check::{Check, Measure};
use crate::suite::reference::{Row, read};
use peelkit::model::StripModel;
use peelkit::study::{Peel, Station, StationAt, StationQuantity, StopCriteria, peel};

const STATIONS: &str = include_str!("../../../verification/stations.csv");
const SOURCE: &str = "verification/stations.py: collocation";

pub(super) fn checks() -> Vec<Check> {
    let peel = peel(&StripModel::of_the_paper(100.0, 1.0), &DEFAULT, &StopCriteria::after_points(20_000));
    read(STATIONS).iter().filter_map(|row| one(&peel, row)).flatten().collect()
}

/// What is not given at the station of a row, and how far its bounds are used up.
fn one(peel: &Peel, row: &Row) -> Option<[Check; 2]> {
    let (name, value, passing) = (row.text("quantity")?, row.number("value")?, row.number("passing")?);
    let (_, quantity) = StationQuantity::NAMED.into_iter().find(|named| named.0 == name)?;
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
