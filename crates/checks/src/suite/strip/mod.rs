//! The strip against collocation of the strong form, exact relations and limits.

mod case;
mod peaks;
mod steady;
mod values;

use super::check::{Check, Topic};
use case::Case;

pub(super) const TOPIC: Topic = Topic {
    name: "strip",
    about: "the peeling strip: collocation of the strong form, exact relations, limits",
    checks,
};

const POINTS: &str = include_str!("../../../verification/strip_points.csv");

fn checks() -> Vec<Check> {
    let whole = Case::all(POINTS, |_| None);
    let mut checks = values::checks(&whole);
    checks.extend(steady::checks());
    checks.extend(peaks::checks());
    checks.extend(values::paid(&whole));
    checks.extend(values::of_stations());
    checks
}
