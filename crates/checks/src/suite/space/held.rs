//! Strips in space that their adhesive holds along the ground as well, against collocation of the strong form.

use crate::check::{Check, Measure, Topic};
use crate::suite::reference::{Row, read};
use peelkit::adhesion::CohesiveShape;
use peelkit::model::{Attraction, Hold, PeelModel, Space};
use peelkit::study::{Accuracy, LimitPointKind, Peel, Station, StationAt, StationQuantity, StopCriteria, peel};
use rayon::prelude::*;

pub(in crate::suite) const TOPIC: Topic = Topic {
    name: "held-in-space",
    about: "strips in space that their adhesive holds along the ground: collocation",
    checks,
};

const CASES: &str = include_str!("../../../verification/space_held_cases.csv");
const FORCES: &str = include_str!("../../../verification/space_held.csv");
const COLLOCATION: &str = "verification/space_held.py: Gauss collocation";
const ASKED: f64 = 1e-6;
/// The peaks lie before that point.
const BOUNDS: StopCriteria = StopCriteria::after_points(40);

fn checks() -> Vec<Check> {
    let values = read(FORCES);
    read(CASES).par_iter().flat_map(|case| checks_of(case, &values).unwrap_or_else(|| vec![unread(case)])).collect()
}

fn unread(case: &Row) -> Check {
    let name = format!("the strip {}", case.text("case").unwrap_or_default());
    Check::new(name, COLLOCATION, Err("its row cannot be read".into()), 0.0, Measure::Absolute, 0.0)
}

/// The strip of a row; None where it cannot be read.
fn model(case: &Row) -> Option<PeelModel> {
    let mut strip = case.strip()?;
    strip.adhesion.attraction = Attraction::Cohesive(CohesiveShape::Exponential);
    strip.adhesion.work = Some(case.number("work_J_m2")?);
    strip.adhesion.strength = Some(case.number("strength_GPa")?);
    strip.adhesion.shear_work = case.number("shear_work_J_m2");
    strip.adhesion.mixing_exponent = case.number("mixing_exponent");
    let hold = |column| if case.text(column) == Some("fixed") { Hold::Fixed } else { Hold::Free };
    strip.grip.horizontal = hold("horizontal");
    strip.grip.rotation = hold("rotation");
    let azimuth = case.number("azimuth_deg")?.to_radians();
    let space = Space { azimuth, lateral: hold("lateral"), roll: hold("roll"), yaw: hold("yaw"), ..Space::default() };
    Some(PeelModel { space: Some(space), ..PeelModel::from(strip) })
}

/// A number that was computed, with its bound.
type Found = Result<(f64, f64), String>;

fn checks_of(case: &Row, values: &[Row]) -> Option<Vec<Check>> {
    let (name, peel) = (case.text("case")?, peel(&model(case)?, &Accuracy::to(ASKED), &BOUNDS));
    let mut checks = Vec::new();
    for row in values.iter().filter(|row| row.text("case") == Some(name)) {
        let quantity = row.text("quantity")?;
        let Some(found) = found(&peel, quantity) else { continue };
        let (expected, uncertain) = (row.number("value")?, row.number("estimated_error")?);
        let what = format!("{quantity} of {name}");
        let number = found.as_ref().map(|(number, _)| *number).map_err(Clone::clone);
        let over = found.map(|(number, bound)| (number - expected).abs() / (bound + uncertain));
        checks.push(Check::new(what.clone(), COLLOCATION, number, expected, Measure::Relative, ASKED));
        let over = Check::new(format!("error over bound of {what}"), COLLOCATION, over, 1.0, Measure::AtMost, 0.0);
        checks.push(over);
    }
    Some(checks)
}

/// Of the peel, what a row has: the force at its peak, or at a displacement.
fn found(peel: &Peel, quantity: &str) -> Option<Found> {
    let missing = || "no such point was located".to_owned();
    if quantity == "peak_force_nN" {
        let peak = peel.limit_points.iter().find(|point| point.kind == LimitPointKind::Load);
        return Some(peak.map(|peak| (peak.force, peak.force_error)).ok_or_else(missing));
    }
    let displacement = quantity.strip_prefix("u_")?.strip_suffix("_force_nN")?.parse().ok()?;
    let stations = peel.stations(StationAt { quantity: StationQuantity::Displacement, value: displacement });
    let of = |station: &Station| Some((station.force, station.errors?.force));
    Some(stations.found.first().and_then(of).ok_or_else(missing))
}
